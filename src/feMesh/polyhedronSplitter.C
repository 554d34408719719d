/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "polyhedronSplitter.H"

#include <algorithm>
#include <functional>

namespace
{
    //- Relative to the mean tetrahedron of a cell: what is large enough, and
    //  what is more than rounding
    const Foam::scalar goodFraction = 1e-3;
    const Foam::scalar positiveFraction = 1e-9;
}


Foam::scalar Foam::polyhedronSplitter::volume(const tetrahedron& t) const
{
    const point& o = x_[t[0]];
    return ((x_[t[1]] - o) & ((x_[t[2]] - o) ^ (x_[t[3]] - o)))/6;
}


Foam::scalar Foam::polyhedronSplitter::least() const
{
    scalar v = GREAT;
    for (const tetrahedron& t : tets_)
    {
        v = min(v, volume(t));
    }
    return v;
}


bool Foam::polyhedronSplitter::good() const
{
    return least() > goodFraction*volume_/tets_.size();
}


void Foam::polyhedronSplitter::coneFrom(const label apex)
{
    tets_.clear();
    for (const triangle& t : surface_)
    {
        if (!t.found(apex))
        {
            tets_.append(tetrahedron({apex, t[0], t[1], t[2]}));
        }
    }
}


void Foam::polyhedronSplitter::bestCone()
{
    label best = points_[0];
    scalar largest = -GREAT;
    for (const label apex : points_)
    {
        coneFrom(apex);
        const scalar v = least();
        if (v > largest)
        {
            largest = v;
            best = apex;
        }
    }
    coneFrom(best);
}


bool Foam::polyhedronSplitter::fiveTets()
{
    DynamicList<label> corners, middle;
    for (const label pointi : points_)
    {
        const label degree = std::count_if
        (
            surface_.begin(), surface_.end(),
            [&](const triangle& t) { return t.found(pointi); }
        );
        (degree == 3 ? corners : middle).append(pointi);
    }
    if (corners.size() != 4)
    {
        return false;
    }

    // Every triangle has one corner and two points of the middle; a corner's
    // tetrahedron ends in the third point of the middle next to it
    tets_.clear();
    triangle towards({0, 0, 0});
    for (const label corner : corners)
    {
        DynamicList<label> round(6);
        for (const triangle& t : surface_)
        {
            const label at = t.find(corner);
            if (at >= 0)
            {
                round.append(t[(at + 1) % 3]);
                round.append(t[(at + 2) % 3]);
            }
        }
        const label last =
            round[2] != round[0] && round[2] != round[1] ? round[2] : round[3];
        tets_.append(tetrahedron({last, corner, round[0], round[1]}));
        towards = triangle({round[0], round[1], last});
    }

    // The last corner cut off leaves this triangle of the middle; its fourth
    // point is the one that is not there
    for (const label pointi : middle)
    {
        if (!towards.found(pointi))
        {
            tets_.append
            (
                tetrahedron({pointi, towards[0], towards[1], towards[2]})
            );
        }
    }
    return tets_.size() == 5;
}


void Foam::polyhedronSplitter::setSurface(const UList<triangle>& surface)
{
    surface_ = surface;
    points_.clear();
    for (triangle& t : surface_)
    {
        const auto smallest =
            std::min_element(t.begin(), t.end(), std::cref(before_));
        const label first = smallest - t.begin();
        std::rotate(t.begin(), t.begin() + first, t.end());
        for (const label pointi : t)
        {
            if (!points_.found(pointi))
            {
                points_.append(pointi);
            }
        }
    }
    std::sort(points_.begin(), points_.end(), std::cref(before_));

    // A decomposition may order a cell's faces in another way; the split must
    // not depend on it, to the last bit of its decisions
    std::sort
    (
        surface_.begin(), surface_.end(),
        [&](const triangle& a, const triangle& b)
        {
            return std::lexicographical_compare
            (
                a.begin(), a.end(), b.begin(), b.end(),
                std::cref(before_)
            );
        }
    );
}


bool Foam::polyhedronSplitter::split
(
    const UList<triangle>& surface,
    const bool isHex,
    splitKind& kind
)
{
    setSurface(surface);

    coneFrom(points_[0]);
    volume_ = 0;
    for (const tetrahedron& t : tets_)
    {
        volume_ += volume(t);
    }

    kind = (tets_.size() == 1 ? untouched : cone);
    if (kind == untouched)
    {
        return volume_ > 0;
    }
    if (isHex && fiveTets() && good())
    {
        kind = fiveTetrahedra;
        return true;
    }
    coneFrom(points_[0]);
    if (good())
    {
        return true;
    }
    kind = otherCone;
    bestCone();
    if (good())
    {
        return true;
    }

    const DynamicList<tetrahedron> best(tets_);
    kind = searched;
    const scalar mean = volume_/tets_.size();
    if (volume_ > 0 && search(goodFraction*mean))
    {
        return true;
    }
    kind = otherCone;
    tets_ = best;
    return volume_ > 0 && least() > positiveFraction*mean;
}
