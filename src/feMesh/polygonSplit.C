/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "polygonSplit.H"
#include "SquareMatrix.H"

#include <algorithm>
#include <functional>

namespace
{

using namespace Foam;

//- Relative to the mean triangle: large enough, and more than rounding
const scalar goodFraction = 1e-3;
const scalar positiveFraction = 1e-9;

//- The polygon's points from the first in the split order
labelList fromFirst(const labelUList& outline, const splitOrder& before)
{
    labelList points(outline);
    std::rotate
    (
        points.begin(),
        std::min_element(points.begin(), points.end(), std::cref(before)),
        points.end()
    );
    return points;
}


//- The split whose least triangle is largest, built up from shorter parts of
//  the outline: the part from i to j is one triangle (i, k, j) and two parts
struct bestSplit
{
    SquareMatrix<scalar> least;
    SquareMatrix<label> middle;

    template<class Area>
    bestSplit(const label n, const Area& area)
    :
        least(n, GREAT),
        middle(n, label(-1))
    {
        for (label length = 2; length < n; ++length)
        {
            for (label i = 0; i + length < n; ++i)
            {
                const label j = i + length;
                least(i, j) = -GREAT;
                for (label k = i + 1; k < j; ++k)
                {
                    const scalar a =
                        min(area(i, k, j), min(least(i, k), least(k, j)));
                    if (a > least(i, j))
                    {
                        least(i, j) = a;
                        middle(i, j) = k;
                    }
                }
            }
        }
    }

    template<class Visit>
    void visit(const label i, const label j, const Visit& triangle) const
    {
        const label k = middle(i, j);
        if (k >= 0)
        {
            triangle(i, k, j);
            visit(i, k, triangle);
            visit(k, j, triangle);
        }
    }
};

} // End namespace


bool Foam::splitPolygon
(
    const labelUList& outline,
    const pointField& x,
    const vector& normal,
    const splitOrder& before,
    DynamicList<label>& triangles,
    splitKind& kind
)
{
    const label n = outline.size();
    if (n < 3)
    {
        return false;
    }
    const labelList points(fromFirst(outline, before));
    auto area = [&](label i, label j, label k)
    {
        const point& o = x[points[i]];
        return 0.5*(((x[points[j]] - o) ^ (x[points[k]] - o)) & normal);
    };
    auto append = [&](label i, label j, label k)
    {
        triangles.append(points[i]);
        triangles.append(points[j]);
        triangles.append(points[k]);
    };

    scalar sum = 0, least = GREAT;
    for (label i = 1; i + 1 < n; ++i)
    {
        const scalar a = area(0, i, i + 1);
        sum += a;
        least = min(least, a);
    }
    const scalar mean = sum/(n - 2);

    if (least > goodFraction*mean)
    {
        kind = (n == 3 ? untouched : cone);
        for (label i = 1; i + 1 < n; ++i)
        {
            append(0, i, i + 1);
        }
        return sum > 0;
    }

    kind = otherCone;
    const bestSplit best(n, area);
    best.visit(0, n - 1, append);
    return sum > 0 && best.least(0, n - 1) > positiveFraction*mean;
}
