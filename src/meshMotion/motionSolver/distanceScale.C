/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "distanceScale.H"
#include "indexedOctree.H"
#include "mathematicalConstants.H"
#include "treeDataPoint.H"

Foam::distanceScale::distanceScale(const dictionary& coeffs)
:
    inner_(coeffs.getOrDefault<scalar>("innerDistance", 0)),
    outer_(coeffs.getOrDefault<scalar>("outerDistance", GREAT))
{
    if (coeffs.found("innerDistance") && !coeffs.found("outerDistance"))
    {
        FatalIOErrorInFunction(coeffs)
            << "innerDistance without outerDistance" << nl
            << "    Add outerDistance, from which on the mesh is at rest"
            << nl << exit(FatalIOError);
    }
    if (inner_ < 0 || outer_ <= inner_)
    {
        const word keyword(inner_ < 0 ? "innerDistance" : "outerDistance");
        FatalIOErrorInFunction(coeffs)
            << keyword << " is " << coeffs.get<scalar>(keyword) << " (line "
            << coeffs.lookupEntry(keyword, keyType::LITERAL).startLineNumber()
            << ")" << nl << "    Valid are lengths [m] with 0 <= innerDistance"
            << " < outerDistance" << nl << exit(FatalIOError);
    }
}


Foam::scalar Foam::distanceScale::at(const scalar distance) const
{
    if (distance <= inner_ || distance >= outer_)
    {
        return distance <= inner_ ? 1 : 0;
    }
    const scalar s = (distance - inner_)/(outer_ - inner_);
    return 0.5*(1 + cos(constant::mathematical::pi*s));
}


Foam::scalarField Foam::distanceScale::at
(
    const pointField& points,
    const pointField& moving
) const
{
    scalarField scale(points.size(), 1);
    if (!fades())
    {
        return scale;
    }

    // Scenes of one and two directions have flat clouds of points
    treeBoundBox box(moving);
    box.inflate(0.01);
    box.min() -= vector::uniform(SMALL + 1e-3*box.mag());
    box.max() += vector::uniform(SMALL + 1e-3*box.mag());
    const indexedOctree<treeDataPoint> tree
    (
        treeDataPoint(moving), box, 8, 10, 3
    );
    const scalar farthest = sqr(outer_);
    forAll(points, i)
    {
        const pointIndexHit nearest(tree.findNearest(points[i], farthest));
        scale[i] = nearest.hit() ? at(mag(points[i] - nearest.hitPoint())) : 0;
    }
    return scale;
}
