/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Directions and coordinates of the scene

#include "feMesh.H"
#include "wedgePolyPatch.H"

namespace
{

using namespace Foam;

//- Component of a unit vector along a coordinate direction; error else
direction coordinateOf(const vector& v, const wedgePolyPatch& wedge)
{
    for (direction d = 0; d < 3; ++d)
    {
        if (mag(v[d]) > 1 - 1e-6)
        {
            return d;
        }
    }
    FatalErrorInFunction
        << "The axis of wedge patch " << wedge.name() << " has direction " << v
        << nl << "    It must be a coordinate axis" << exit(FatalError);
    return 0;
}


//- Patches across which the scene is the same
List<const wedgePolyPatch*> wedgePatches(const polyMesh& mesh)
{
    DynamicList<const wedgePolyPatch*> wedges;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<wedgePolyPatch>(pp) && returnReduce(pp.size(), sumOp<label>()))
        {
            wedges.append(&refCast<const wedgePolyPatch>(pp));
        }
    }
    return List<const wedgePolyPatch*>(std::move(wedges));
}


//- All planes of the wedges hold the origin
void checkOrigin(const polyMesh& mesh, const wedgePolyPatch& wedge)
{
    scalar away = 0;
    for (const point& x : wedge.localPoints())
    {
        away = max(away, mag(x & wedge.n()));
    }
    reduce(away, maxOp<scalar>());
    if (away > 1e-6*mag(mesh.bounds().span()))
    {
        FatalErrorInFunction
            << "The plane of wedge patch " << wedge.name() << " passes the "
            << "origin at a distance of " << away << " m" << nl
            << "    The axis of a wedge must go through the origin: move the "
            << "mesh with transformPoints" << exit(FatalError);
    }
}


//- Angle between the two planes of a pair with outward normals
scalar openingAngle(const wedgePolyPatch& a, const wedgePolyPatch& b)
{
    return std::atan2(mag(a.n() ^ b.n()), -(a.n() & b.n()));
}

} // End namespace


void Foam::feMesh::findDirections()
{
    const List<const wedgePolyPatch*> wedges(wedgePatches(mesh_));
    for (const wedgePolyPatch* wedge : wedges)
    {
        checkOrigin(mesh_, *wedge);
        coordinateOf(wedge->axis(), *wedge);
    }

    const Vector<label> solved(mesh_.solutionD());
    switch (wedges.size())
    {
        case 0: findPlanarDirections(solved); break;
        case 2: findAxisymmetricDirections(wedges, solved); break;
        case 4: findSphericalDirections(wedges, solved); break;
        default:
            FatalErrorInFunction
                << "There are " << wedges.size() << " wedge patches" << nl
                << "    Axisymmetric and cylindrical scenes have two, "
                << "spherical scenes four" << exit(FatalError);
    }
    axisTolerance_ = 1e-9*mag(mesh_.bounds().span());
    dim_ = axes_.size();
}


void Foam::feMesh::findPlanarDirections(const Vector<label>& solved)
{
    const vector span(mesh_.bounds().span());
    DynamicList<direction> axes(3);
    for (direction d = 0; d < 3; ++d)
    {
        if (solved[d] > 0)
        {
            axes.append(d);
        }
        else
        {
            depth_ *= span[d];
        }
    }
    axes_.transfer(axes);
}


void Foam::feMesh::findAxisymmetricDirections
(
    const UList<const wedgePolyPatch*>& wedges,
    const Vector<label>& solved
)
{
    const direction axial = coordinateOf(wedges[0]->axis(), *wedges[0]);
    const direction across =
        coordinateOf(wedges[0]->centreNormal(), *wedges[0]);
    const direction outward = 3 - axial - across;

    if
    (
        axial != coordinateOf(wedges[1]->axis(), *wedges[1])
     || across != coordinateOf(wedges[1]->centreNormal(), *wedges[1])
     || solved[outward] < 0 || solved[across] < 0
    )
    {
        FatalErrorInFunction
            << "The wedge patches " << wedges[0]->name() << " and "
            << wedges[1]->name() << " are not the two sides of one wedge, or "
            << "empty patches are not its ends" << exit(FatalError);
    }

    curvature_ = 1;
    depth_ = openingAngle(*wedges[0], *wedges[1]);
    radialComponent_ = outward;
    acrossComponent_ = across;
    if (solved[axial] < 0)
    {
        depth_ *= mesh_.bounds().span()[axial];
        axes_ = List<direction>(1, outward);
        radial_ = 0;
    }
    else
    {
        axes_ = {min(axial, outward), max(axial, outward)};
        radial_ = (axes_[0] == outward ? 0 : 1);
    }
}


void Foam::feMesh::findSphericalDirections
(
    const UList<const wedgePolyPatch*>& wedges,
    const Vector<label>& solved
)
{
    // The two pairs by the direction across them
    const direction first =
        coordinateOf(wedges[0]->centreNormal(), *wedges[0]);
    direction second = first;
    DynamicList<const wedgePolyPatch*> pairs[2];
    for (const wedgePolyPatch* wedge : wedges)
    {
        const direction d = coordinateOf(wedge->centreNormal(), *wedge);
        pairs[d == first ? 0 : 1].append(wedge);
        second = (d == first ? second : d);
    }

    if (pairs[0].size() != 2 || cmptMin(solved) < 0)
    {
        FatalErrorInFunction
            << "Four wedge patches must be two pairs, across two directions, "
            << "without empty patches" << exit(FatalError);
    }

    curvature_ = 2;
    radialComponent_ = 3 - first - second;
    acrossComponent_ = first;
    axes_ = List<direction>(1, radialComponent_);
    radial_ = 0;

    // Solid angle of the pyramid: eq. (M6) of doc/theory/mesh.md
    depth_ = 4*std::asin
    (
        std::sin(0.5*openingAngle(*pairs[0][0], *pairs[0][1]))
       *std::sin(0.5*openingAngle(*pairs[1][0], *pairs[1][1]))
    );
}


Foam::point Foam::feMesh::scenePosition(const point& x) const
{
    if (curvature_ == 0)
    {
        return x;
    }
    point scene(Zero);
    scalar r = 0;
    if (curvature_ == 1)
    {
        const direction axial = 3 - radialComponent_ - acrossComponent_;
        scene[axial] = x[axial];
        r = std::hypot(x[radialComponent_], x[acrossComponent_]);
    }
    else
    {
        r = mag(x);
    }
    scene[radialComponent_] = (r > axisTolerance_ ? r : 0);
    return scene;
}


Foam::tmp<Foam::pointField> Foam::feMesh::scenePositions
(
    const pointField& x
) const
{
    if (curvature_ == 0)
    {
        return x;
    }
    auto tscene = tmp<pointField>::New(x.size());
    forAll(x, i)
    {
        tscene.ref()[i] = scenePosition(x[i]);
    }
    return tscene;
}


Foam::scalar Foam::feMesh::simplexMeasure(const label s) const
{
    auto measure = [&](auto dimension)
    {
        constexpr int dim = decltype(dimension)::value;
        simplexVec<dim> x[dim + 1];
        for (int a = 0; a <= dim; ++a)
        {
            const label corneri = simplexCorners()[(dim + 1)*s + a];
            x[a] = components<dim>(corners()[corneri]);
        }
        return simplex::volume<dim>(simplex::edges<dim>(x));
    };
    switch (dim_)
    {
        case 1: return measure(std::integral_constant<int, 1>());
        case 2: return measure(std::integral_constant<int, 2>());
        default: return measure(std::integral_constant<int, 3>());
    }
}


Foam::scalar Foam::feMesh::simplexVolume(const label s) const
{
    const label stride = dim_ + 1;
    auto r = [&](const label a)
    {
        return corners()[simplexCorners()[stride*s + a]][radialComponent_];
    };

    // Exact integrals of r^curvature over the simplex: eq. (M5)
    scalar mean = 1;
    if (curvature_ == 1)
    {
        mean = (dim_ == 1 ? r(0) + r(1) : 2*(r(0) + r(1) + r(2))/3)/2;
    }
    else if (curvature_ == 2)
    {
        mean = (sqr(r(0)) + r(0)*r(1) + sqr(r(1)))/3;
    }
    return depth_*mean*simplexMeasure(s);
}


Foam::vector Foam::feMesh::radialDirection(const point& x) const
{
    vector r(x);
    if (curvature_ == 1)
    {
        r[3 - radialComponent_ - acrossComponent_] = 0;
    }
    const scalar distance = mag(r);
    if (distance > axisTolerance_)
    {
        return r/distance;
    }
    vector middle(Zero);
    middle[radialComponent_] = 1;
    return middle;
}
