/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "planeResistance.H"
#include "ListOps.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<int dim>
Foam::planeResistance<dim>::planeResistance
(
    const UList<slidingPoints>& sliding,
    const scalar exponent,
    const scalar tolerance
)
:
    points_(sliding.size()),
    normals_(sliding.size()),
    clusterTolerance_(tolerance/(2*max(sliding.size(), label(1)))),
    weight_(0),
    resistances_(sliding.size(), Zero),
    nTerms_(0),
    bound_(0)
{
    forAll(sliding, p)
    {
        points_.set
        (
            p,
            new attractor<dim>
            (
                sliding[p].positions,
                sliding[p].strengths,
                exponent,
                leafOfSums
            )
        );
        normals_[p] = sourceTree<dim>::toCoordinates(sliding[p].normal);
    }
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

template<int dim>
void Foam::planeResistance<dim>::sum
(
    const label p,
    const label clusteri,
    const coordinates& x,
    clusterSum& result
)
{
    const attractor<dim>& points = points_[p];
    const auto& cluster = points[clusteri];
    const scalar error = points.error(cluster, x);
    const scalar low = points.low(cluster, x);

    if (!cluster.isLeaf() && error <= clusterTolerance_*low)
    {
        result.weight += points.expandedWeight(clusteri, x);
        result.low += low;
        result.error += error;
        ++nTerms_;
    }
    else if (cluster.isLeaf())
    {
        const scalar weight = points.summedWeight(clusteri, x);
        result.weight += weight;
        result.low += weight;
        nTerms_ += cluster.size();
    }
    else
    {
        sum(p, cluster.firstHalf, x, result);
        sum(p, cluster.secondHalf, x, result);
    }
}


template<int dim>
Foam::scalar Foam::planeResistance<dim>::dot
(
    const scalar* u,
    const coordinates& v
)
{
    scalar sum = 0;
    for (int a = 0; a < dim; ++a)
    {
        sum += u[a]*v[a];
    }
    return sum;
}


template<int dim>
typename Foam::planeResistance<dim>::matrix
Foam::planeResistance<dim>::basis(List<coordinates>& components) const
{
    labelList order(identity(normals_.size()));
    std::stable_sort
    (
        order.begin(),
        order.end(),
        [&](const label p, const label q)
        {
            return resistances_[p] > resistances_[q];
        }
    );

    matrix Q(Zero);
    int size = 0;
    const auto orthogonalise =
        [&](coordinates v, const scalar least, coordinates& inBasis)
    {
        // Twice, against round-off
        inBasis = scalar(0);
        for (int pass = 0; pass < 2; ++pass)
        {
            for (int i = 0; i < size; ++i)
            {
                const scalar along = dot(&Q[i*dim], v);
                inBasis[i] += along;
                for (int a = 0; a < dim; ++a)
                {
                    v[a] -= along*Q[i*dim + a];
                }
            }
        }
        const scalar rest = Foam::sqrt(expansion::square(v));
        if (size < dim && rest > least)
        {
            for (int a = 0; a < dim; ++a)
            {
                Q[size*dim + a] = v[a]/rest;
            }
            inBasis[size++] = rest;
        }
    };

    components.setSize(normals_.size());
    for (const label p : order)
    {
        // What is left of a normal in the span of others is round-off
        orthogonalise(normals_[p], 1e-6, components[p]);
    }
    for (int a = 0; a < dim; ++a)
    {
        // Of the unit vectors, enough have this much outside of any span
        coordinates unit(Zero), unused;
        unit[a] = 1;
        orthogonalise(unit, 0.5, unused);
    }
    return Q;
}


template<int dim>
typename Foam::planeResistance<dim>::matrix
Foam::planeResistance<dim>::gradedInverse(const matrix& G)
{
    // G = L diag(d) L^T; columns of the inverse of L by substitution
    matrix L(Zero), inverseL(Zero);
    coordinates d;
    for (int j = 0; j < dim; ++j)
    {
        for (int i = j; i < dim; ++i)
        {
            scalar g = G[i*dim + j];
            for (int k = 0; k < j; ++k)
            {
                g -= L[i*dim + k]*L[j*dim + k]*d[k];
            }
            if (i == j)
            {
                d[j] = g;
            }
            L[i*dim + j] = g/d[j];
        }
        for (int i = j; i >= 0; --i)
        {
            scalar g = (i == j ? 1 : 0);
            for (int k = i; k < j; ++k)
            {
                g -= L[j*dim + k]*inverseL[k*dim + i];
            }
            inverseL[j*dim + i] = g;
        }
    }

    matrix K(Zero);
    for (int a = 0; a < dim; ++a)
    {
        for (int b = 0; b < dim; ++b)
        {
            for (int k = max(a, b); k < dim; ++k)
            {
                K[a*dim + b] +=
                    inverseL[k*dim + a]*inverseL[k*dim + b]/d[k];
            }
        }
    }
    return K;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int dim>
void Foam::planeResistance<dim>::sum
(
    const coordinates& x,
    const scalar weight,
    const scalar weightError
)
{
    weight_ = weight;
    nTerms_ = 0;
    bound_ = 0;
    forAll(points_, p)
    {
        clusterSum s{0, 0, 0};
        if (!points_[p].tree().empty())
        {
            sum(p, 0, x, s);
        }
        resistances_[p] = s.weight;

        // Least values of what is summed and of what is meant
        bound_ +=
            Foam::sqrt(1 + weightError)*s.error
           /((1 - weightError)*weight + s.low - s.error);
    }
}


template<int dim>
typename Foam::planeResistance<dim>::matrix
Foam::planeResistance<dim>::inverse() const
{
    List<coordinates> c;
    const matrix Q(basis(c));

    matrix G(Zero);
    for (int i = 0; i < dim; ++i)
    {
        for (int j = 0; j < dim; ++j)
        {
            G[i*dim + j] = (i == j ? weight_ : 0);
            forAll(c, p)
            {
                G[i*dim + j] += resistances_[p]*c[p][i]*c[p][j];
            }
        }
    }
    const matrix K(gradedInverse(G));

    matrix result(Zero);
    for (int i = 0; i < dim; ++i)
    {
        for (int j = 0; j < dim; ++j)
        {
            for (int a = 0; a < dim; ++a)
            {
                for (int b = 0; b < dim; ++b)
                {
                    result[a*dim + b] +=
                        Q[i*dim + a]*K[i*dim + j]*Q[j*dim + b];
                }
            }
        }
    }
    return result;
}


template class Foam::planeResistance<1>;
template class Foam::planeResistance<2>;
template class Foam::planeResistance<3>;
