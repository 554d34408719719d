/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "volumeWatch.H"
#include "dictionaryCheck.H"
#include "emptyPolyPatch.H"
#include "SubField.H"
#include "Time.H"
#include "valuePointPatchField.H"
#include "wedgePolyPatch.H"

namespace
{

using namespace Foam;

//- The entry of all processes with the least key; of equal ones the first
template<class Key, class Value>
Value ofLeast(const Key& key, const Value& value)
{
    List<Tuple2<Key, Value>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = Tuple2<Key, Value>(key, value);
    Pstream::gatherList(all);
    Pstream::scatterList(all);

    label least = 0;
    forAll(all, i)
    {
        if (all[i].first() < all[least].first())
        {
            least = i;
        }
    }
    return all[least].second();
}

} // End namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::volumeWatch::volumeWatch
(
    const polyMesh& mesh,
    const dictionary& dynamicMeshDict,
    const scalarField& undeformed
)
:
    mesh_(mesh),
    warnBelow_(0.1),
    stopBelow_(0),
    warned_(1),
    undeformed_(undeformed)
{
    if (!dynamicMeshDict.found("quality"))
    {
        return;
    }
    const dictionary& dict = dynamicMeshDict.subDict("quality");
    checkKeywords(dict, {"warnBelow", "stopBelow"});
    warnBelow_ = readRatio(dict, "warnBelow", warnBelow_);
    stopBelow_ = readRatio(dict, "stopBelow", stopBelow_);
    if (stopBelow_ > warnBelow_)
    {
        FatalIOErrorInFunction(dict)
            << "stopBelow is " << stopBelow_ << ", warnBelow is "
            << warnBelow_ << nl << "    stopBelow must not be the larger"
            << nl << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::scalar Foam::volumeWatch::readRatio
(
    const dictionary& dict,
    const word& keyword,
    const scalar byDefault
) const
{
    const scalar value = dict.getOrDefault<scalar>(keyword, byDefault);
    if (value < 0 || value > 1)
    {
        FatalIOErrorInFunction(dict)
            << keyword << " is " << value << " (line "
            << dict.lookupEntry(keyword, keyType::LITERAL).startLineNumber()
            << ")" << nl << "    Valid are ratios of volumes, 0 to 1" << nl
            << exit(FatalIOError);
    }
    return value;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::volumeWatch::cellVolumes
(
    const polyMesh& mesh,
    const pointField& points
)
{
    scalarField volumes(mesh.nCells(), Zero);
    const labelList& owner = mesh.faceOwner();
    const labelList& neighbour = mesh.faceNeighbour();

    // By Gauss' theorem, each cell about one of its own points: no
    // cancellation far from the origin
    const auto add = [&](const label celli, const label facei, const scalar s)
    {
        const face& f = mesh.faces()[facei];
        const point& origin = points[mesh.faces()[mesh.cells()[celli][0]][0]];
        volumes[celli] +=
            s*(f.areaNormal(points) & (f.centre(points) - origin))/3;
    };
    forAll(owner, facei)
    {
        add(owner[facei], facei, 1);
        if (facei < neighbour.size())
        {
            add(neighbour[facei], facei, -1);
        }
    }
    return volumes;
}


Foam::volumeWatch::place Foam::volumeWatch::least
(
    const scalarField& volumes,
    const labelUList& cellOf
) const
{
    scalar ratio = GREAT;
    label item = -1;
    forAll(volumes, i)
    {
        const scalar r = volumes[i]/undeformed_[i];
        if (!(r >= ratio))
        {
            ratio = r;
            item = i;
        }
    }

    label cell = -1;
    point position(Zero);
    if (item >= 0)
    {
        cell = cellOf.size() ? cellOf[item] : item;
        position = mesh_.cells()[cell].centre(mesh_.points(), mesh_.faces());
    }
    const Tuple2<label, point> where
    (
        ofLeast(ratio, Tuple2<label, point>(cell, position))
    );
    reduce(ratio, minOp<scalar>());
    return place{ratio, where.first(), where.second()};
}


void Foam::volumeWatch::report(const place& p)
{
    Info<< "Mesh motion: least volume ratio " << p.ratio << ", cell "
        << p.cell << " at " << p.position << endl;

    if (p.ratio < warnBelow_ && p.ratio < 0.5*warned_)
    {
        warned_ = p.ratio;
        WarningInFunction
            << "The mesh motion has reduced a volume in cell " << p.cell
            << " at " << p.position << ", nearest to patch "
            << nearestPatch(p) << "," << nl << "    to " << p.ratio
            << " of that in the undeformed mesh at time "
            << mesh_.time().timeName() << " (warnBelow " << warnBelow_
            << "); the run ends at " << stopBelow_ << endl;
    }
}


Foam::word Foam::volumeWatch::nearestPatch(const place& p) const
{
    scalar distance = GREAT;
    word name("none");
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if
        (
            patch.coupled() || isA<emptyPolyPatch>(patch)
         || isA<wedgePolyPatch>(patch)
        )
        {
            continue;
        }
        for (const point& centre : patch.faceCentres())
        {
            if (mag(centre - p.position) < distance)
            {
                distance = mag(centre - p.position);
                name = patch.name();
            }
        }
    }
    return ofLeast(distance, name);
}


void Foam::volumeWatch::setTimeBack(const polyMesh& mesh)
{
    Time& time = const_cast<Time&>(mesh.time());
    time.setTime
    (
        time.value() - time.deltaTValue(),
        time.timeIndex() - 1
    );
}


void Foam::volumeWatch::setDisplacement
(
    pointVectorField& pointDisplacement,
    const vectorField& values
)
{
    pointDisplacement.primitiveFieldRef() = values;
    for (auto& pf : pointDisplacement.boundaryFieldRef())
    {
        if (isA<valuePointPatchField<vector>>(pf))
        {
            refCast<valuePointPatchField<vector>>(pf) ==
                pf.patchInternalField()();
        }
    }
}


void Foam::volumeWatch::stop(const place& p, const word& time) const
{
    const word patch(nearestPatch(p));
    Time& runTime = const_cast<Time&>(mesh_.time());
    const bool atStart = runTime.timeIndex() <= runTime.startTimeIndex();
    if (!atStart)
    {
        runTime.writeNow();
    }

    // The first process to leave ends the others: let all of them write
    returnReduce(true, andOp<bool>());

    FatalErrorInFunction
        << "The mesh motion would reduce a volume in cell " << p.cell
        << " at " << p.position << "," << nl << "    nearest to patch "
        << patch << ", to " << p.ratio << " of that in the undeformed mesh "
        << "at time " << time << nl
        << "    The run ends at ratios of " << stopBelow_
        << " (stopBelow in quality of constant/dynamicMeshDict) or below" << nl
        << "    The last good state is that of time " << runTime.timeName()
        << (atStart ? ", the start" : ", which is written") << nl
        << "    Continue from it (startFrom latestTime) with other "
        << "coefficients of the motion solver or a" << nl
        << "    smaller motion, or use a mesh with more room at this patch"
        << nl << exit(FatalError);
}
