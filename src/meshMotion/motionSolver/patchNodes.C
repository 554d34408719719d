/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "patchNodes.H"
#include "globalIndex.H"
#include "ListListOps.H"
#include "pointConstraints.H"
#include "valuePointPatchField.H"

#include <algorithm>

namespace
{

using namespace Foam;

//- The least key of the points of each node, of all processes that have it
labelList leastKeys
(
    const polyMesh& mesh,
    const sceneNodes& scene,
    const labelList& keys
)
{
    labelList synced(keys);
    pointConstraints::syncUntransformedData
    (
        mesh,
        synced,
        minEqOp<label>()
    );

    labelList least(scene.size(), labelMax);
    forAll(synced, pointi)
    {
        label& key = least[scene.nodeOfPoint()[pointi]];
        key = min(key, synced[pointi]);
    }
    return least;
}

} // End namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::patchNodes::patchNodes
(
    const polyMesh& mesh,
    const sceneNodes& scene,
    const labelList& patches,
    const bitSet& without,
    const bitSet& faces
)
:
    scene_(scene),
    patches_(patches),
    faces_(faces)
{
    findSources(mesh, without);
    sortPositions(mesh);
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

template<class Type>
Foam::List<Type> Foam::patchNodes::gathered(const List<Type>& local)
{
    List<List<Type>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = local;
    Pstream::gatherList(all);
    Pstream::scatterList(all);

    return ListListOps::combine<List<Type>>(all, accessOp<List<Type>>());
}


Foam::labelList Foam::patchNodes::pointsOf(const polyPatch& patch) const
{
    bitSet found(patch.nPoints());
    forAll(patch, i)
    {
        if (counts(patch.start() + i))
        {
            found.set(patch.localFaces()[i]);
        }
    }
    return found.sortedToc();
}


void Foam::patchNodes::findSources(const polyMesh& mesh, const bitSet& without)
{
    // The first patch, then the first process that has a face of it at the
    // node, delivers: any of the points there has that key
    const auto key = [](const label patchi)
    {
        return patchi*Pstream::nProcs() + Pstream::myProcNo();
    };

    labelList keys(mesh.nPoints(), labelMax);
    for (const label patchi : patches_)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        for (const label i : pointsOf(patch))
        {
            label& least = keys[patch.meshPoints()[i]];
            least = min(least, key(patchi));
        }
    }

    labelList wanted(leastKeys(mesh, scene_, keys));
    for (const label patchi : patches_)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        for (const label i : pointsOf(patch))
        {
            const label pointi = patch.meshPoints()[i];
            const label node = scene_.nodeOfPoint()[pointi];
            if (wanted[node] == key(patchi) && !without.test(node))
            {
                sources_.append(source{patchi, i, pointi});
                wanted[node] = labelMax;
            }
        }
    }
}


void Foam::patchNodes::sortPositions(const polyMesh& mesh)
{
    pointField delivered(sources_.size());
    forAll(sources_, i)
    {
        const label node = scene_.nodeOfPoint()[sources_[i].pointi];
        delivered[i] = scene_.position(node);
    }
    const pointField all(gathered<point>(delivered));

    order_ = identity(all.size());
    std::sort
    (
        order_.begin(),
        order_.end(),
        [&](const label i, const label j)
        {
            return std::lexicographical_compare
            (
                all[i].begin(), all[i].end(),
                all[j].begin(), all[j].end()
            );
        }
    );
    positions_ = pointField(all, order_);

    // Tell every process that has a node where it went
    const globalIndex offset(sources_.size());
    const labelList placeOf(invert(order_.size(), order_));
    labelList place(mesh.nPoints(), labelMax);
    forAll(sources_, i)
    {
        place[sources_[i].pointi] = placeOf[offset.toGlobal(i)];
    }
    gatheredOfNode_ = leastKeys(mesh, scene_, place);
    for (label& i : gatheredOfNode_)
    {
        i = (i == labelMax ? -1 : i);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vectorField Foam::patchNodes::values(const pointVectorField& field) const
{
    vectorField delivered(sources_.size());
    forAll(sources_, k)
    {
        const source& s = sources_[k];
        delivered[k] = scene_.toScene
        (
            s.pointi,
            refCast<const valuePointPatchField<vector>>
            (
                field.boundaryField()[s.patchi]
            )[s.i]
        );
    }
    return vectorField(gathered<vector>(delivered), order_);
}


Foam::scalarField Foam::patchNodes::areas
(
    const polyMesh& mesh,
    const pointField& points
) const
{
    scalarField ofPoint(mesh.nPoints(), Zero);
    for (const label patchi : patches_)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        forAll(patch, i)
        {
            if (!counts(patch.start() + i))
            {
                continue;
            }
            const face& f = patch[i];
            const scalar share = f.mag(points)/f.size();
            for (const label pointi : f)
            {
                ofPoint[pointi] += share;
            }
        }
    }
    pointConstraints::syncUntransformedData
    (
        mesh,
        ofPoint,
        plusEqOp<scalar>()
    );

    scalarField ofNode(scene_.size(), Zero);
    forAll(ofPoint, pointi)
    {
        ofNode[scene_.nodeOfPoint()[pointi]] += ofPoint[pointi];
    }

    scalarField delivered(sources_.size());
    forAll(sources_, k)
    {
        delivered[k] = ofNode[scene_.nodeOfPoint()[sources_[k].pointi]];
    }
    return scalarField(gathered<scalar>(delivered), order_);
}
