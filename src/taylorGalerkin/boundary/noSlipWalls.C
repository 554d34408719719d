/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "noSlipWalls.H"
#include "valuePointPatchField.H"

template<int dim>
Foam::noSlipWalls<dim>::noSlipWalls
(
    const gasGeometry<dim>& geometry,
    const gasDynamics::PerfectGas& eos,
    const List<const fePatch*>& patches,
    pointVectorField& U,
    pointScalarField& T
)
:
    geometry_(geometry),
    eos_(eos),
    patches_(patches)
{
    findNodes(T);
    update(U, T);
    checkTangential(U);
}


template<int dim>
void Foam::noSlipWalls<dim>::findNodes(const pointScalarField& T)
{
    const feMesh& mesh = geometry_.mesh();
    placeOfNode_.setSize(mesh.nNodes(), -1);

    // The last patch of each node, on whichever processor it has facets
    std::vector<double> last(2*mesh.nNodes(), -1.0);
    forAll(patches_, patchi)
    {
        const bool hasT = isA<valuePointPatchField<scalar>>
        (
            T.boundaryField()[patches_[patchi]->index]
        );
        for (const label node : patches_[patchi]->nodes)
        {
            last[2*node] = patchi;
            last[2*node + 1] = hasT ? patchi : last[2*node + 1];
        }
    }
    mesh.exchange().max(last.data(), 2, 2);

    DynamicList<label> nodes, decidesU, decidesT;
    for (label a = 0; a < mesh.nNodes(); ++a)
    {
        if (last[2*a] >= 0)
        {
            placeOfNode_[a] = nodes.size();
            nodes.append(a);
            decidesU.append(label(last[2*a]));
            decidesT.append(label(last[2*a + 1]));
        }
    }
    nodes_.transfer(nodes);
    decidesU_.transfer(decidesU);
    decidesT_.transfer(decidesT);
}


template<int dim>
void Foam::noSlipWalls<dim>::read(pointVectorField& U, pointScalarField& T)
{
    const feMesh& mesh = geometry_.mesh();
    forAll(patches_, patchi)
    {
        const label index = patches_[patchi]->index;
        auto& Up = U.boundaryFieldRef()[index];
        auto& Tp = T.boundaryFieldRef()[index];
        Up.evaluate();
        Tp.evaluate();
        const auto& velocity =
            refCast<const valuePointPatchField<vector>>(Up);
        const labelList& points = Up.patch().meshPoints();
        forAll(points, i)
        {
            const label place = placeOfNode_[mesh.nodeOfPoint()[points[i]]];
            if (place < 0)
            {
                continue;
            }
            if (decidesU_[place] == patchi)
            {
                const Vec u = mesh.components<dim>
                (
                    velocity[i], mesh.poly().points()[points[i]]
                );
                std::copy_n(u.data(), dim, values_[place].U);
            }
            if (decidesT_[place] == patchi)
            {
                values_[place].T =
                    refCast<const valuePointPatchField<scalar>>(Tp)[i];
            }
        }
    }
}


template<int dim>
void Foam::noSlipWalls<dim>::update(pointVectorField& U, pointScalarField& T)
{
    if (patches_.empty())
    {
        return;
    }
    const wallValue none{{-GREAT, -GREAT, -GREAT}, -GREAT};
    values_.assign(nodes_.size(), none);
    read(U, T);

    if (Pstream::parRun())
    {
        shared_.assign(geometry_.nNodes(), none);
        forAll(nodes_, i)
        {
            shared_[nodes_[i]] = values_[i];
        }
        static_assert(sizeof(wallValue) == 4*sizeof(double), "no gaps");
        geometry_.mesh().exchange().max(shared_.data()->U, 4, 4);
        forAll(nodes_, i)
        {
            values_[i] = shared_[nodes_[i]];
        }
    }
}


template<int dim>
void Foam::noSlipWalls<dim>::checkTangential(const pointVectorField& U) const
{
    for (const fePatch* patch : patches_)
    {
        forAll(patch->facetSimplex, i)
        {
            Vec mean = Vec::Zero();
            double greatest = 0;
            for (int b = 0; b < dim; ++b)
            {
                const label place = placeOfNode_[patch->facets[dim*i + b]];
                const Vec u(Eigen::Map<const Vec>(values_[place].U));
                mean += u/dim;
                greatest = std::max(greatest, u.norm());
            }
            const Vec n(geometry_.presentFacetArea(*patch, i).normalized());
            const double through = mean.dot(n);
            if (std::abs(through) > 1e-3*greatest)
            {
                const label node = patch->facets[dim*i];
                FatalErrorInFunction
                    << "The wall " << patch->name << " moves through itself: "
                    << "at " << geometry_.mesh().nodes()[node]
                    << " the value of U (" << U.objectPath()
                    << ") has a component of " << through
                    << " m/s along the normal" << nl
                    << "    On a no-slip wall the value is the velocity of a "
                    << "surface that slides along itself." << nl
                    << "    Let constant/dynamicMeshDict move the wall, or "
                    << "make it a patch of type patch for inflow"
                    << exit(FatalError);
            }
        }
    }
}


template<int dim>
void Foam::noSlipWalls<dim>::start(gasRows& states) const
{
    forAll(nodes_, i)
    {
        gasRow& row = states[nodes_[i]];
        const Vec u(velocity(i));
        Eigen::Map<Vec> m(row.v + 1);
        row[dim + 1] +=
            0.5*row[0]*u.squaredNorm() - 0.5*m.squaredNorm()/row[0];
        m = row[0]*u;
    }
}


template class Foam::noSlipWalls<1>;
template class Foam::noSlipWalls<2>;
template class Foam::noSlipWalls<3>;
