/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "faceFans.H"
#include "syncTools.H"

#include <algorithm>

namespace
{

using namespace Foam;

//- Area of the fan's least triangle along the face's unit normal
scalar leastArea
(
    const face& f,
    const pointField& x,
    const vector& normal,
    const label start
)
{
    const point& apex = x[f[start]];
    scalar least = GREAT;
    for (label i = 1; i + 1 < f.size(); ++i)
    {
        const vector a(x[f[(start + i) % f.size()]] - apex);
        const vector b(x[f[(start + i + 1) % f.size()]] - apex);
        least = min(least, 0.5*((a ^ b) & normal));
    }
    return least;
}


label fanStart(const face& f, const pointField& x, const splitOrder& before)
{
    // Relative to the mean triangle
    const scalar degenerate = 1e-3;

    labelList places(identity(f.size()));
    std::sort
    (
        places.begin(), places.end(), [&](const label a, const label b)
        {
            return before(f[a], f[b]);
        }
    );
    if (f.size() == 3)
    {
        return places[0];
    }

    const vector area(f.areaNormal(x));
    const vector normal(area/(mag(area) + VSMALL));
    const scalar enough = degenerate*mag(area)/(f.size() - 2);

    // Points in the middle of a straight side first
    std::stable_partition
    (
        places.begin(), places.end(), [&](const label i)
        {
            const vector a(x[f[i]] - x[f[f.rcIndex(i)]]);
            const vector b(x[f[f.fcIndex(i)]] - x[f[i]]);
            return 0.5*((a ^ b) & normal) < enough;
        }
    );

    label best = places[0];
    scalar largest = -GREAT;
    for (const label start : places)
    {
        const scalar least = leastArea(f, x, normal, start);
        if (least > enough)
        {
            return start;
        }
        if (least > largest)
        {
            largest = least;
            best = start;
        }
    }
    return best;
}

} // End namespace


Foam::labelList Foam::faceFans(const polyMesh& mesh, const splitOrder& before)
{
    labelList starts(mesh.nFaces());
    forAll(starts, facei)
    {
        starts[facei] = fanStart(mesh.faces()[facei], mesh.points(), before);
    }

    // Coupled faces: the two sides have their points in opposite order from
    // the same first point
    const bitSet decides(syncTools::getMasterFaces(mesh));
    SubList<label> own
    (
        starts, mesh.nBoundaryFaces(), mesh.nInternalFaces()
    );
    labelList other(own);
    syncTools::swapBoundaryFaceList(mesh, other);
    forAll(own, i)
    {
        const label facei = mesh.nInternalFaces() + i;
        if (!decides.test(facei))
        {
            const label n = mesh.faces()[facei].size();
            own[i] = (n - other[i]) % n;
        }
    }
    return starts;
}
