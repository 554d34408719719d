/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
//  What the geometry does in a step in which the nodes move

#include "gasGeometry.H"
#include "edgeSumPlaces.H"
#include "simplexTerms.H"
#include "Time.H"

template<int dim>
void Foam::gasGeometry<dim>::stopInverted
(
    const label simplexi,
    const double volume
) const
{
    const label celli = mesh_.cellOfSimplex()[simplexi];
    FatalErrorInFunction
        << "The mesh motion has inverted a simplex of cell " << celli
        << " at " << mesh_.nodes()[mesh_.simplices()[(dim + 1)*simplexi]]
        << ": its volume is " << volume << " m3" << nl
        << "    at time " << mesh_.poly().time().timeName() << nl
        << "    Use a finer write interval to see the mesh before, "
        << "and change the motion solver's coefficients or the mesh"
        << exit(FatalError);
}


template<int dim>
void Foam::gasGeometry<dim>::addMovingPlanar
(
    const labelUList& simplices,
    const pointField& from,
    const pointField& to,
    const double dt,
    std::vector<double>& volumeAtEnd
)
{
    constexpr int nCorners = dim + 1;
    const double depth = mesh_.depth();

    for (const label s : simplices)
    {
        const label* corner = mesh_.simplexCorners().cdata() + nCorners*s;
        const label* node = mesh_.simplices().cdata() + nCorners*s;
        const label* edge = mesh_.simplexEdges().cdata() + nPairs*s;
        Vec x0[nCorners], x1[nCorners], mid[nCorners];
        Vec way = Vec::Zero();
        for (int a = 0; a < nCorners; ++a)
        {
            x0[a] = mesh_.components<dim>(from[corner[a]]);
            x1[a] = mesh_.components<dim>(to[corner[a]]);
            mid[a] = 0.5*(x0[a] + x1[a]);
            way += x1[a] - x0[a];
        }
        const double atEnd =
            depth*simplex::volume<dim>(simplex::edges<dim>(x1));
        if (!(atEnd > 0))
        {
            stopInverted(s, atEnd);
        }
        for (int a = 0; a < nCorners; ++a)
        {
            volumeAtEnd[node[a]] += atEnd/nCorners;
        }

        const simplexTerms<dim> mean(x0, x1);
        const double mass =
            depth*mean.plainVolume/(nCorners*(nCorners + 1));
        const double perVolume = depth/mean.plainVolume;
        const double share = depth/nCorners;
        const Vec w = way/(dt*nCorners);

        for (int a = 0; a < dim; ++a)
        {
            for (int b = a + 1; b < nCorners; ++b, ++edge)
            {
                // (G7), (G9)
                const Vec S =
                    (node[a] < node[b] ? share : -share)
                   *(mean.B.col(b) - mean.B.col(a));
                gasRow add = uniformRow(0);
                for (int i = 0; i < dim; ++i)
                {
                    add[i] = S[i];
                }
                add[edgeSum::massAt] = mass;
                add[edgeSum::stiffnessAt] =
                    -perVolume*mean.B.col(a).dot(mean.B.col(b));
                add[edgeSum::sweepAt] = S.dot(w);
                add[edgeSum::lengthAt] = (mid[a] - mid[b]).squaredNorm();
                add[edgeSum::countAt] = 1;
                gasRow& sums = edgeSums_[*edge];
                for (int i = 0; i < gasKernel::rowSize; ++i)
                {
                    sums[i] += add[i];
                }
            }
        }
    }
}


template<int dim>
void Foam::gasGeometry<dim>::sumStill()
{
    const tmp<pointField> tcorners(mesh_.cornerPositions(mesh_.nodes()));
    const pointField& corners = tcorners();

    DynamicList<label> still(mesh_.nSimplices());
    for (label s = 0; s < mesh_.nSimplices(); ++s)
    {
        if (!part_.moves(s))
        {
            still.append(s);
        }
    }
    std::fill(edgeSums_.begin(), edgeSums_.end(), uniformRow(0));
    std::vector<double> volume(nRows_, 0.0);
    std::vector<double> hoop(hoop_.size(), 0.0);
    hoop_.swap(hoop);
    addSimplices(still, corners, corners, 1, volume);
    hoop_.swap(hoop);

    const auto select = [](const labelList& places, const auto& values)
    {
        typename std::decay<decltype(values)>::type selected;
        for (const label i : places)
        {
            selected.push_back(values[i]);
        }
        return selected;
    };
    stillEdgeSums_ = select(part_.edges(), edgeSums_);
    stillVolume_ = select(part_.nodes(), volume);
    if (curvature())
    {
        stillHoop_ = select(part_.nodes(), hoop);
    }
}


template<int dim>
void Foam::gasGeometry<dim>::computePart
(
    const pointField& from,
    const pointField& to,
    const double dt,
    std::vector<double>& volumeAtEnd
)
{
    forAll(part_.edges(), k)
    {
        edgeSums_[part_.edges()[k]] = stillEdgeSums_[k];
    }
    forAll(part_.nodes(), k)
    {
        volumeAtEnd[part_.nodes()[k]] = stillVolume_[k];
        if (curvature())
        {
            hoop_[part_.nodes()[k]] = stillHoop_[k];
        }
    }
    addSimplices(part_.simplices(), from, to, dt, volumeAtEnd);
    reduceSums(volumeAtEnd);
    for (const label i : partEdges_)
    {
        setEdge(i);
    }
    forAll(facets_, patchi)
    {
        const labelList& facets = part_.facets()[patchi];
        for (const label i : facets)
        {
            setFacet(patchi, i, from, to);
        }
        if (facets.size())
        {
            surfaces_[patchi].sum(facets_[patchi]);
        }
    }
}


template<int dim>
void Foam::gasGeometry<dim>::begin
(
    const double dt,
    const pointField& newNodes
)
{
    if (part_.add(mesh_, mesh_.nodes(), newNodes))
    {
        sumStill();
        DynamicList<label> own(part_.edges().size());
        for (label i = 0, k = 0; i < nEdges_; ++i)
        {
            while (k < part_.edges().size() && part_.edges()[k] < meshEdge_[i])
            {
                ++k;
            }
            if (k < part_.edges().size() && part_.edges()[k] == meshEdge_[i])
            {
                own.append(i);
            }
        }
        partEdges_.transfer(own);
    }

    moving_ = true;
    isPresent_ = false;
    newNodes_ = newNodes;
    for (const label a : part_.nodes())
    {
        w_[a] = mesh_.components<dim>(newNodes[a] - mesh_.nodes()[a])/dt;
    }
    const tmp<pointField> from(mesh_.cornerPositions(mesh_.nodes()));
    const tmp<pointField> to(mesh_.cornerPositions(newNodes));
    computePart(from(), to(), dt, newNodeVolume_);
}


template<int dim>
void Foam::gasGeometry<dim>::end()
{
    if (moving_)
    {
        mesh_.moveNodes(newNodes_);
        std::swap(nodeVolume_, newNodeVolume_);
        moving_ = false;
    }
}


template<int dim>
void Foam::gasGeometry<dim>::store(instant& i) const
{
    i.nodes = mesh_.nodes();
    i.parts = parts(*this);
}


template<int dim>
void Foam::gasGeometry<dim>::restore(const instant& i)
{
    moving_ = false;
    mesh_.moveNodes(i.nodes);
    parts(*this) = i.parts;
}


template class Foam::gasGeometry<1>;
template class Foam::gasGeometry<2>;
template class Foam::gasGeometry<3>;
