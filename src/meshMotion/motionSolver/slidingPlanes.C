/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "slidingPlanes.H"
#include "ListListOps.H"

namespace
{

using namespace Foam;

//- Largest sine of the angle between normals of one plane: faces of a mesh
//  that was written with six digits
constexpr scalar sameNormal = 1e-3;


//- Area vectors of a patch's faces in the directions of the scene
vectorField sceneAreas
(
    const polyPatch& patch,
    const sceneNodes& scene,
    const pointField& points
)
{
    vectorField areas(patch.size());
    forAll(patch, i)
    {
        // On the axis of a wedge there is no radial direction
        vector inScene(Zero);
        const vector area(patch[i].areaNormal(points));
        for (const label pointi : patch[i])
        {
            const vector v(scene.toScene(pointi, area));
            inScene = magSqr(v) > magSqr(inScene) ? v : inScene;
        }
        areas[i] = inScene;
    }
    return areas;
}

} // End namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slidingPlanes::slidingPlanes
(
    const polyMesh& mesh,
    const sceneNodes& scene,
    const pointField& points,
    const labelList& patches
)
{
    List<vectorField> areas(patches.size());
    forAll(patches, k)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patches[k]];
        areas[k] = sceneAreas(patch, scene, points);
        add(patch, areas[k]);
    }

    faces_.setSize(size(), bitSet(mesh.nFaces()));
    vectorField sums(size(), Zero);
    forAll(patches, k)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patches[k]];
        forAll(patch, i)
        {
            const vector& area = areas[k][i];
            const label p = find(area/mag(area));
            faces_[p].set(patch.start() + i);
            sums[p] += sign(area & normals_[p])*area;
        }
    }

    // Means do not depend on which face comes first
    Pstream::listCombineGather(sums, plusEqOp<vector>());
    Pstream::listCombineScatter(sums);
    forAll(sums, p)
    {
        normals_[p] = sums[p]/mag(sums[p]);
    }
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::label Foam::slidingPlanes::find(const vector& normal) const
{
    forAll(normals_, p)
    {
        if (mag(normal ^ normals_[p]) < sameNormal)
        {
            return p;
        }
    }
    return -1;
}


void Foam::slidingPlanes::add
(
    const polyPatch& patch,
    const UList<vector>& areas
)
{
    const label nBefore = size();
    for (const vector& area : areas)
    {
        const vector normal(area/mag(area));
        if (find(normal) < 0 && size() <= nBefore + maxPlanes)
        {
            normals_.append(normal);
        }
    }

    List<List<vector>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] =
        SubList<vector>(normals_, size() - nBefore, nBefore);
    Pstream::gatherList(all);
    Pstream::scatterList(all);

    normals_.setSize(nBefore);
    for (const List<vector>& normals : all)
    {
        for (const vector& normal : normals)
        {
            if (find(normal) < 0)
            {
                normals_.append(normal);
            }
        }
    }
    if (size() > nBefore + maxPlanes)
    {
        FatalErrorInFunction
            << "The faces of patch " << patch.name() << " have more than "
            << maxPlanes << " normals:" << nl
            << "    inverseDistance slides points along planes, not along"
            << " curved patches" << nl
            << "    Give pointDisplacement type fixedValue there, with value"
            << " uniform (0 0 0)" << nl << exit(FatalError);
    }
}
