/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "sourceTree.H"
#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<int dim>
Foam::sourceTree<dim>::sourceTree
(
    const pointField& positions,
    const scalarField& strengths,
    const label leafSize
)
:
    leafSize_(leafSize),
    order_(identity(positions.size())),
    positions_(positions.size()),
    strengths_(strengths)
{
    forAll(positions, i)
    {
        positions_[i] = toCoordinates(positions[i]);
    }
    if (order_.empty())
    {
        return;
    }

    addCluster(0, order_.size());

    const List<coordinates> unsorted(positions_);
    forAll(order_, i)
    {
        positions_[i] = unsorted[order_[i]];
        strengths_[i] = strengths[order_[i]];
    }

    moments_.setSize(clusters_.size(), terms(Zero));
    forAll(clusters_, clusteri)
    {
        const cluster& c = clusters_[clusteri];
        for (label i = c.begin; i < c.end; ++i)
        {
            const terms m = pointMoments(c, i);
            for (int k = 0; k < expansion::nTerms; ++k)
            {
                moments_[clusteri][k] += m[k];
            }
        }
    }
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

template<int dim>
Foam::label Foam::sourceTree<dim>::addCluster
(
    const label begin,
    const label end
)
{
    cluster c;
    c.begin = begin;
    c.end = end;
    c.firstHalf = c.secondHalf = -1;
    measure(c);

    const label index = clusters_.size();
    clusters_.append(c);

    // Points that coincide would never get into different halves
    if (c.size() > leafSize_ && c.radius > 0)
    {
        const label middle = halve(begin, end);
        const label first = addCluster(begin, middle);
        const label second = addCluster(middle, end);
        clusters_[index].firstHalf = first;
        clusters_[index].secondHalf = second;
    }
    return index;
}


template<int dim>
void Foam::sourceTree<dim>::measure(cluster& c) const
{
    c.mass = 0;
    c.centre = scalar(0);
    for (label i = c.begin; i < c.end; ++i)
    {
        const label source = order_[i];
        c.mass += strengths_[source];
        for (int a = 0; a < dim; ++a)
        {
            c.centre[a] += strengths_[source]*positions_[source][a];
        }
    }
    for (int a = 0; a < dim; ++a)
    {
        c.centre[a] /= c.mass;
    }

    c.radius = c.meanRadius = c.thirdMoment = 0;
    for (label i = c.begin; i < c.end; ++i)
    {
        const label source = order_[i];
        const scalar r = sqrt
        (
            expansion::square
            (
                expansion::difference(positions_[source], c.centre)
            )
        );
        c.radius = max(c.radius, r);
        c.meanRadius += strengths_[source]*r;
        c.thirdMoment += strengths_[source]*r*r*r;
    }
    c.meanRadius /= c.mass;
}


template<int dim>
Foam::label Foam::sourceTree<dim>::halve(const label begin, const label end)
{
    coordinates low(positions_[order_[begin]]);
    coordinates high(low);
    for (label i = begin; i < end; ++i)
    {
        for (int a = 0; a < dim; ++a)
        {
            low[a] = min(low[a], positions_[order_[i]][a]);
            high[a] = max(high[a], positions_[order_[i]][a]);
        }
    }

    int axis = 0;
    for (int a = 1; a < dim; ++a)
    {
        if (high[a] - low[a] > high[axis] - low[axis])
        {
            axis = a;
        }
    }

    const label middle = begin + (end - begin)/2;
    std::nth_element
    (
        order_.begin() + begin,
        order_.begin() + middle,
        order_.begin() + end,
        [&](const label i, const label j)
        {
            const scalar x = positions_[i][axis], y = positions_[j][axis];
            return x < y || (x == y && i < j);
        }
    );
    return middle;
}


template<int dim>
typename Foam::sourceTree<dim>::terms Foam::sourceTree<dim>::pointMoments
(
    const cluster& c,
    const label i
) const
{
    terms m = expansion::monomials
    (
        expansion::difference(positions_[i], c.centre)
    );
    for (scalar& mk : m)
    {
        mk *= strengths_[i];
    }
    return m;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int dim>
Foam::List<typename Foam::sourceTree<dim>::coordinates>
Foam::sourceTree<dim>::rows(const UList<vector>& values) const
{
    List<coordinates> result
    (
        size() + clusters_.size()*expansion::nTerms,
        coordinates(Zero)
    );
    forAll(order_, i)
    {
        result[i] = toCoordinates(values[order_[i]]);
    }

    forAll(clusters_, clusteri)
    {
        const cluster& c = clusters_[clusteri];
        coordinates* moments = result.data() + momentRow(clusteri);

        for (label i = c.begin; i < c.end; ++i)
        {
            const terms m = pointMoments(c, i);
            for (int k = 0; k < expansion::nTerms; ++k)
            {
                for (int a = 0; a < dim; ++a)
                {
                    moments[k][a] += m[k]*result[i][a];
                }
            }
        }
    }
    return result;
}


template<int dim>
typename Foam::sourceTree<dim>::coordinates
Foam::sourceTree<dim>::toCoordinates(const vector& v)
{
    coordinates x;
    for (int a = 0; a < dim; ++a)
    {
        x[a] = v[a];
    }
    return x;
}


template class Foam::sourceTree<1>;
template class Foam::sourceTree<2>;
template class Foam::sourceTree<3>;
