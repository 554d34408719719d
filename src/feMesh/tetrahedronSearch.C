/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// The exhaustive way to split a polyhedron: tetrahedra are set on one open
// triangle after the other until none is open

#include "polyhedronSplitter.H"

#include <algorithm>
#include <vector>

namespace
{

using namespace Foam;
using triangle = polyhedronSplitter::triangle;
using tetrahedron = polyhedronSplitter::tetrahedron;

//- A cell is given up after this many tetrahedra were tried
const label maxSteps = 20000;

//- The same points in the same sense
bool same(const triangle& a, const triangle& b)
{
    const label at = b.find(a[0]);
    return
        at >= 0 && a[1] == b[(at + 1) % 3] && a[2] == b[(at + 2) % 3];
}

triangle opposite(const triangle& t)
{
    return triangle({t[0], t[2], t[1]});
}

label findSame(const UList<triangle>& list, const triangle& t)
{
    forAll(list, i)
    {
        if (same(list[i], t))
        {
            return i;
        }
    }
    return -1;
}


//- Take a tetrahedron on the open triangle (1, 2, 3) away: false when a facet
//  is open already in the same sense, so that tetrahedra would overlap
bool takeAway(DynamicList<triangle>& open, const tetrahedron& t)
{
    // The facets as seen from outside the tetrahedron. What they cancel is
    // closed; the others are open from the other side
    const triangle facets[] =
    {
        {t[1], t[2], t[3]}, {t[0], t[3], t[2]},
        {t[0], t[1], t[3]}, {t[0], t[2], t[1]}
    };
    for (const triangle& facet : facets)
    {
        const label closed = findSame(open, facet);
        if (closed >= 0)
        {
            open[closed] = open.last();
            open.remove();
        }
        else if (findSame(open, opposite(facet)) >= 0)
        {
            return false;
        }
        else
        {
            open.append(opposite(facet));
        }
    }
    return true;
}

} // End namespace


std::vector<std::pair<Foam::scalar, tetrahedron>>
Foam::polyhedronSplitter::standingOn
(
    const DynamicList<triangle>& open,
    const triangle& base,
    const scalar leastVolume,
    const scalar mostVolume
) const
{
    std::vector<std::pair<scalar, tetrahedron>> result;
    for (const label pointi : points_)
    {
        const tetrahedron t({pointi, base[0], base[1], base[2]});
        const scalar v = volume(t);
        if (base.found(pointi) || v < leastVolume || v > mostVolume)
        {
            continue;
        }
        DynamicList<triangle> rest(open);
        if (takeAway(rest, t))
        {
            // Roundness: volume over the cube of the longest edge
            scalar longest = 0;
            for (label a = 0; a < 4; ++a)
            {
                for (label b = 0; b < a; ++b)
                {
                    longest = max(longest, mag(x_[t[a]] - x_[t[b]]));
                }
            }
            result.push_back({v/pow3(longest), t});
        }
    }
    return result;
}


bool Foam::polyhedronSplitter::search(const scalar leastVolume)
{
    tets_.clear();
    DynamicList<triangle> open(surface_);
    label steps = 0;
    return searchFrom(open, leastVolume, steps);
}


bool Foam::polyhedronSplitter::searchFrom
(
    DynamicList<triangle>& open,
    const scalar leastVolume,
    label& steps
)
{
    if (open.empty())
    {
        return true;
    }

    scalar left = (1 + 1e-9)*volume_;
    for (const tetrahedron& t : tets_)
    {
        left -= volume(t);
    }

    // The open triangle with the fewest tetrahedra that may stand on it
    std::vector<std::pair<scalar, tetrahedron>> fewest;
    forAll(open, i)
    {
        auto candidates = standingOn(open, open[i], leastVolume, left);
        if (i == 0 || candidates.size() < fewest.size())
        {
            fewest.swap(candidates);
        }
        if (fewest.empty())
        {
            return false;
        }
    }
    std::stable_sort
    (
        fewest.begin(), fewest.end(),
        [](const auto& a, const auto& b) { return a.first > b.first; }
    );

    for (const auto& candidate : fewest)
    {
        if (++steps > maxSteps)
        {
            return false;
        }
        DynamicList<triangle> rest(open);
        takeAway(rest, candidate.second);
        tets_.append(candidate.second);
        if (searchFrom(rest, leastVolume, steps))
        {
            return true;
        }
        tets_.remove();
    }
    return false;
}
