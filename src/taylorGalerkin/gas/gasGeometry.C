/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasGeometry.H"
#include "edgeSumPlaces.H"
#include "simplexTerms.H"

namespace
{

//- Points of Gauss' rule in time and their weight: two integrate a cubic, and
//  every integral over a moving simplex is one at most
const double gaussPoints[2] =
    {0.5 - 0.5/std::sqrt(3.0), 0.5 + 0.5/std::sqrt(3.0)};

} // End namespace


template<int dim>
Foam::gasGeometry<dim>::gasGeometry(feMesh& mesh)
:
    mesh_(mesh),
    moving_(false),
    isPresent_(false),
    nRows_
    (
        gasKernel::groupSize*(mesh.nNodes()/gasKernel::groupSize + 1)
    ),
    w_(mesh.nNodes(), Vec::Zero())
{
    selectEdges();
    nodeVolume_.assign(nRows_, 1.0);
    newNodeVolume_.assign(nRows_, 1.0);
    facets_.setSize(mesh_.patches().size());
    surfaces_.setSize(mesh_.patches().size());
    forAll(facets_, patchi)
    {
        surfaces_[patchi] = patchSurface<dim>(mesh_.patches()[patchi]);
        facets_[patchi].setSize(mesh_.patches()[patchi].facetSimplex.size());
    }
    begin();

    // Steps write those of the part that moves
    newNodeVolume_ = nodeVolume_;
}


template<int dim>
void Foam::gasGeometry<dim>::selectEdges()
{
    DynamicList<label> own(mesh_.nEdges());
    for (label e = 0; e < mesh_.nEdges(); ++e)
    {
        if (mesh_.edgeExchange().owned(e))
        {
            own.append(e);
        }
    }
    nEdges_ = own.size();
    meshEdge_.transfer(own);

    constexpr label group = gasKernel::groupSize;
    const label padded = group*((nEdges_ + group - 1)/group);

    // The edges that fill up join the first row after the nodes to itself
    first_.assign(padded, mesh_.nNodes());
    second_.assign(padded, mesh_.nNodes());
    for (label i = 0; i < nEdges_; ++i)
    {
        first_[i] = mesh_.edges()[meshEdge_[i]][0];
        second_[i] = mesh_.edges()[meshEdge_[i]][1];
    }
    for (int k = 0; k < dim; ++k)
    {
        area_[k].assign(padded, 0.0);
    }
    for
    (
        std::vector<double>* v
      : {&magArea_, &inverseLengthArea_, &mass_, &stiffness_, &sweep_, &side_}
    )
    {
        v->assign(padded, 0.0);
    }
    active_ = activeParts(nRows_, first_);
}


template<int dim>
void Foam::gasGeometry<dim>::addSimplices
(
    const labelUList& simplices,
    const pointField& from,
    const pointField& to,
    const double dt,
    std::vector<double>& volumeAtEnd
)
{
    const bool atRest = (&from == &to);
    const int k = curvature();
    const int radial = this->radial();
    const double depth = mesh_.depth();
    const int nTimes = atRest ? 1 : 2;

    if (!k && !atRest)
    {
        addMovingPlanar(simplices, from, to, dt, volumeAtEnd);
        return;
    }

    for (const label s : simplices)
    {
        const label* corner = mesh_.simplexCorners().cdata() + (dim + 1)*s;
        const label* node = mesh_.simplices().cdata() + (dim + 1)*s;
        const label* edge = mesh_.simplexEdges().cdata() + nPairs*s;
        Vec x0[dim + 1], x1[dim + 1], x[dim + 1];
        for (int a = 0; a <= dim; ++a)
        {
            x0[a] = mesh_.components<dim>(from[corner[a]]);
            x1[a] = mesh_.components<dim>(to[corner[a]]);
        }
        const simplexTerms<dim> end(x1, k, radial);
        if (!(end.volume > 0 && end.plainVolume > 0))
        {
            stopInverted(s, depth*end.volume);
        }
        for (int a = 0; a <= dim; ++a)
        {
            volumeAtEnd[node[a]] += depth*end.nodal[a];
        }

        for (int t = 0; t < nTimes; ++t)
        {
            const double c = atRest ? 1 : gaussPoints[t];
            for (int a = 0; a <= dim; ++a)
            {
                x[a] = (1 - c)*x0[a] + c*x1[a];
            }
            const simplexTerms<dim> now
            (
                atRest ? end : simplexTerms<dim>(x, k, radial)
            );
            const double weight = depth/nTimes;

            double carried[dim + 1];
            if (!atRest)
            {
                Vec sum = Vec::Zero();
                for (int a = 0; a <= dim; ++a)
                {
                    sum += now.nodal[a]*(x1[a] - x0[a]);
                }
                sum /= dt*now.plainVolume*(dim + 1);
                for (int a = 0; a <= dim; ++a)
                {
                    carried[a] = sum.dot(now.B.col(a));
                }
            }

            int e = 0;
            for (int a = 0; a < dim; ++a)
            {
                for (int b = a + 1; b <= dim; ++b, ++e)
                {
                    gasRow& sums = edgeSums_[edge[e]];
                    const double sense = node[a] < node[b] ? weight : -weight;
                    const Vec S = now.dualFace(a, b);
                    for (int i = 0; i < dim; ++i)
                    {
                        sums[i] += sense*S[i];
                    }
                    sums[edgeSum::massAt] +=
                        weight*now.volume/((dim + 1)*(dim + 2));
                    sums[edgeSum::stiffnessAt] -=
                        weight*now.volume*now.B.col(a).dot(now.B.col(b))
                       /(now.plainVolume*now.plainVolume);
                    sums[edgeSum::lengthAt] +=
                        (x[a] - x[b]).squaredNorm()/nTimes;
                    sums[edgeSum::countAt] += 1.0/nTimes;
                    if (!atRest)
                    {
                        sums[edgeSum::sweepAt] +=
                            sense*(carried[b] - carried[a]);
                    }
                }
            }
            for (int a = 0; k && a <= dim; ++a)
            {
                hoop_[node[a]] += weight*now.plainVolume*now.hoopMoment(a);
            }
        }
    }
}


template<int dim>
void Foam::gasGeometry<dim>::reduceSums(std::vector<double>& volumeAtEnd)
{
    mesh_.exchange().sum(volumeAtEnd.data(), 1, 1);
    if (curvature())
    {
        mesh_.exchange().sum(hoop_.data(), 1, 1);
    }

    // Edges with copies on other processors: the sums of all their simplices.
    // What follows the edge's direction must have the same one everywhere.
    const sharedItems& exchange = mesh_.edgeExchange();
    auto turn = [&]
    {
        for (const label e : exchange.shared())
        {
            const label sense = mesh_.edgeSense(e);
            gasRow& sums = edgeSums_[e];
            for (int i = 0; i < dim; ++i)
            {
                sums[i] *= sense;
            }
            sums[edgeSum::sweepAt] *= sense;
        }
    };
    turn();
    exchange.sum(data(edgeSums_), gasKernel::rowSize, gasKernel::rowSize);
    turn();
}


template<int dim>
void Foam::gasGeometry<dim>::setEdge(const label i)
{
    const gasRow& sums = edgeSums_[meshEdge_[i]];
    double square = 0;
    for (int k = 0; k < dim; ++k)
    {
        area_[k][i] = sums[k];
        square += sums[k]*sums[k];
    }
    magArea_[i] = std::sqrt(square);
    mass_[i] = sums[edgeSum::massAt];
    stiffness_[i] = sums[edgeSum::stiffnessAt];
    sweep_[i] = sums[edgeSum::sweepAt];
    const double length =
        std::sqrt(sums[edgeSum::lengthAt]/sums[edgeSum::countAt]);
    side_[i] = length;
    if (!curvature())
    {
        // The mean volume; mass_ is the sum of their shares
        constexpr double factorial[] = {1, 1, 2, 6};
        side_[i] =
            factorial[dim]*(dim + 1)*(dim + 2)*mass_[i]
           /(mesh_.depth()*sums[edgeSum::countAt]);
    }
    inverseLengthArea_[i] =
        magArea_[i] > 1e-12*mass_[i]/length ? 1/(length*magArea_[i]) : 0;
}


template<int dim>
void Foam::gasGeometry<dim>::addFacet
(
    const fePatch& patch,
    const label i,
    const Vec* x,
    const double weight,
    facetIntegrals& f
) const
{
    const int k = curvature();
    double r[dim];
    int n = 0;
    for (int a = 0; a <= dim; ++a)
    {
        if (a != patch.opposite[i])
        {
            r[n++] = k ? x[a][radial()] : 1;
        }
    }
    const simplexTerms<dim> terms(x, 0, 0);
    const Vec S =
        weight*mesh_.depth()
       *simplex::outwardArea<dim>(terms.B, patch.opposite[i]);
    for (int a = 0; a < dim; ++a)
    {
        for (int b = 0; b < dim; ++b)
        {
            f.M[a][b] += facetWeight<dim>(k, r, a, b)*S;
        }
    }
}


template<int dim>
void Foam::gasGeometry<dim>::setFacet
(
    const label patchi,
    const label i,
    const pointField& from,
    const pointField& to
)
{
    const bool atRest = (&from == &to);
    const int nTimes = atRest ? 1 : 2;
    const fePatch& patch = mesh_.patches()[patchi];
    facetIntegrals& facet = facets_[patchi][i];

    facet = facetIntegrals();
    const label* corner =
        mesh_.simplexCorners().cdata() + (dim + 1)*patch.facetSimplex[i];
    for (int t = 0; t < nTimes; ++t)
    {
        const double c = atRest ? 1 : gaussPoints[t];
        Vec x[dim + 1];
        for (int a = 0; a <= dim; ++a)
        {
            x[a] = mesh_.components<dim>
            (
                (1 - c)*from[corner[a]] + c*to[corner[a]]
            );
        }
        addFacet(patch, i, x, 1.0/nTimes, facet);
    }
}


template<int dim>
void Foam::gasGeometry<dim>::computeAll()
{
    const tmp<pointField> tcorners(mesh_.cornerPositions(mesh_.nodes()));
    const pointField& corners = tcorners();
    edgeSums_.assign(mesh_.nEdges(), uniformRow(0));
    std::fill_n(nodeVolume_.begin(), nNodes(), 0.0);
    hoop_.assign(curvature() ? nRows_ : 0, 0.0);

    addSimplices
    (
        identity(mesh_.nSimplices()), corners, corners, 1, nodeVolume_
    );
    reduceSums(nodeVolume_);
    for (label i = 0; i < nEdges_; ++i)
    {
        setEdge(i);
    }
    forAll(facets_, patchi)
    {
        forAll(facets_[patchi], i)
        {
            setFacet(patchi, i, corners, corners);
        }
        surfaces_[patchi].sum(facets_[patchi]);
    }
}


template<int dim>
void Foam::gasGeometry<dim>::begin()
{
    moving_ = false;
    if (!isPresent_)
    {
        std::fill(w_.begin(), w_.end(), Vec::Zero());
        if (part_.found())
        {
            const tmp<pointField> at(mesh_.cornerPositions(mesh_.nodes()));
            computePart(at(), at(), 1, nodeVolume_);
        }
        else
        {
            computeAll();
        }
        isPresent_ = true;
    }
}


template<int dim>
gasKernel::edges Foam::gasGeometry<dim>::edges() const
{
    gasKernel::edges e{};
    e.n = first_.size();
    e.first = first_.data();
    e.second = second_.data();
    for (int k = 0; k < dim; ++k)
    {
        e.area[k] = area_[k].data();
    }
    e.magArea = magArea_.data();
    e.inverseLengthArea = inverseLengthArea_.data();
    e.mass = mass_.data();
    e.stiffness = stiffness_.data();
    e.sweep = isPresent_ ? nullptr : sweep_.data();
    return e;
}


template<int dim>
std::vector<typename Foam::gasGeometry<dim>::Vec>
Foam::gasGeometry<dim>::edgeVectors() const
{
    pointField middle(mesh_.nodes());
    if (moving_)
    {
        middle = 0.5*(middle + newNodes_);
    }
    const tmp<pointField> corners(mesh_.cornerPositions(middle));

    // By the simplices' corners: across cyclic patches an edge joins a node to
    // the image of another
    std::vector<Vec> along(mesh_.nEdges(), Vec::Zero());
    const label* corner = mesh_.simplexCorners().cdata();
    const label* node = mesh_.simplices().cdata();
    const label* edge = mesh_.simplexEdges().cdata();
    for (label s = 0; s < mesh_.nSimplices(); ++s)
    {
        for (int a = 0; a < dim; ++a)
        {
            for (int b = a + 1; b <= dim; ++b, ++edge)
            {
                const Vec x = mesh_.components<dim>
                (
                    corners()[corner[b]] - corners()[corner[a]]
                );
                along[*edge] = node[a] < node[b] ? x : Vec(-x);
            }
        }
        corner += dim + 1;
        node += dim + 1;
    }
    return along;
}


template<int dim>
Foam::facetIntegrals<dim>
Foam::gasGeometry<dim>::presentFacet(const fePatch& patch, const label i) const
{
    const label* corner =
        mesh_.simplexCorners().cdata() + (dim + 1)*patch.facetSimplex[i];
    Vec x[dim + 1];
    for (int a = 0; a <= dim; ++a)
    {
        x[a] = mesh_.components<dim>(mesh_.corners()[corner[a]]);
    }
    facetIntegrals f;
    addFacet(patch, i, x, 1, f);
    return f;
}


template<int dim>
typename Foam::gasGeometry<dim>::Vec
Foam::gasGeometry<dim>::presentFacetArea
(
    const fePatch& patch,
    const label i
) const
{
    const facetIntegrals f(presentFacet(patch, i));
    Vec S = Vec::Zero();
    for (const auto& row : f.M)
    {
        for (const Vec& M : row)
        {
            S += M;
        }
    }
    return S;
}


template class Foam::gasGeometry<1>;
template class Foam::gasGeometry<2>;
template class Foam::gasGeometry<3>;
