/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "inverseDistanceMotionSolver.H"
#include "cyclicPolyPatch.H"
#include "dictionaryCheck.H"
#include "processorPolyPatch.H"
#include "basicSymmetryPointPatchField.H"
#include "slidingPlanes.H"
#include "valuePointPatchField.H"
#include "wordRes.H"

namespace
{

using namespace Foam;

//- Names of the patches that a user can mean
wordList patchNames(const polyMesh& mesh)
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    return SubList<word>(patches.names(), patches.nNonProcessor());
}


//- Indices of the patches that an entry of the dictionary names
labelList findPatches
(
    const polyMesh& mesh,
    const dictionary& dict,
    const word& keyword
)
{
    labelHashSet found;
    for (const wordRe& name : dict.get<wordRes>(keyword))
    {
        const labelList matching
        (
            findStrings(wordRes(one(), name), patchNames(mesh))
        );
        if (matching.empty())
        {
            FatalIOErrorInFunction(dict)
                << "Unknown patch " << name << " in " << keyword
                << " (line " << dict.lookupEntry(keyword, keyType::LITERAL)
                   .startLineNumber() << ")" << nl
                << "    Valid patches are " << flatOutput(patchNames(mesh))
                << nl << exit(FatalIOError);
        }
        found.insert(matching);
    }
    return found.sortedToc();
}


//- An optional number, checked
scalar readNumber
(
    const dictionary& dict,
    const word& keyword,
    const scalar byDefault,
    const char* range,
    const std::function<bool(scalar)>& inRange
)
{
    const scalar value = dict.getOrDefault<scalar>(keyword, byDefault);
    if (!inRange(value))
    {
        FatalIOErrorInFunction(dict)
            << keyword << " is " << value << " (line "
            << dict.lookupEntry(keyword, keyType::LITERAL).startLineNumber()
            << ")" << nl
            << "    Valid are " << range << nl << exit(FatalIOError);
    }
    return value;
}

} // End namespace


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::inverseDistanceMotionSolver::readSettings(const dictionary& dict)
{
    checkKeywords
    (
        dict,
        {
            "movingPatches", "fixedPatches", "e1", "e2", "tolerance",
            "weights", "referenceLength", "innerDistance", "outerDistance"
        }
    );
    scale_ = distanceScale(dict);

    const auto exponent = [](const scalar e) { return e > 0 && e <= 20; };
    const char* exponents = "exponents above 0, up to 20";
    settings_.e1 = readNumber(dict, "e1", settings_.e1, exponents, exponent);
    settings_.e2 = readNumber(dict, "e2", settings_.e2, exponents, exponent);

    settings_.tolerance = readNumber
    (
        dict,
        "tolerance",
        settings_.tolerance,
        "0 (no approximation) to 0.5",
        [](const scalar t) { return t >= 0 && t <= 0.5; }
    );

    settings_.referenceLength = readNumber
    (
        dict,
        "referenceLength",
        settings_.referenceLength,
        "lengths above 0 [m]",
        [](const scalar length) { return length > 0; }
    );

    byArea_ =
        dict.found("weights")
     && selectEntry(dict, "weights", {"uniform", "area"}) == 1;

    if (!moveAllCells())
    {
        FatalIOErrorInFunction(*this)
            << "inverseDistance moves the whole mesh" << nl
            << "    Remove cellZone or cellSet" << nl << exit(FatalIOError);
    }
}


void Foam::inverseDistanceMotionSolver::readPatches(const dictionary& dict)
{
    movingPatches_ = findPatches(mesh(), dict, "movingPatches");

    if (dict.found("fixedPatches"))
    {
        fixedPatches_ = findPatches(mesh(), dict, "fixedPatches");
    }
    else
    {
        DynamicList<label> others;
        for (const polyPatch& patch : mesh().boundaryMesh())
        {
            if
            (
                !polyPatch::constraintType(patch.type())
             && !slides(patch.index())
             && !movingPatches_.found(patch.index())
            )
            {
                others.append(patch.index());
            }
        }
        fixedPatches_.transfer(others);
    }

    DynamicList<label> sliding;
    for (const polyPatch& patch : mesh().boundaryMesh())
    {
        if (slides(patch.index()) && !fixedPatches_.found(patch.index()))
        {
            sliding.append(patch.index());
        }
    }
    slidingPatches_.transfer(sliding);
    checkPatches(dict);
}


bool Foam::inverseDistanceMotionSolver::slides(const label patchi) const
{
    return isA<basicSymmetryPointPatchField<vector>>
    (
        pointDisplacement_.boundaryField()[patchi]
    );
}


void Foam::inverseDistanceMotionSolver::checkPatches
(
    const dictionary& dict
) const
{
    for (const polyPatch& patch : mesh().boundaryMesh())
    {
        const bool moving = movingPatches_.found(patch.index());
        const bool fixed = fixedPatches_.found(patch.index());

        if (moving && fixed)
        {
            FatalIOErrorInFunction(dict)
                << "Patch " << patch.name()
                << " is in movingPatches and in fixedPatches" << nl
                << exit(FatalIOError);
        }
        if ((moving || fixed) && polyPatch::constraintType(patch.type()))
        {
            FatalIOErrorInFunction(dict)
                << "Patch " << patch.name() << " is of type " << patch.type()
                << ": it can neither move nor be fixed" << nl
                << "    Remove it from " << (moving ? "moving" : "fixed")
                << "Patches" << nl << exit(FatalIOError);
        }
        if (patch.coupled() && !isA<processorPolyPatch>(patch))
        {
            FatalIOErrorInFunction(dict)
                << "Patch " << patch.name() << " is of type " << patch.type()
                << ": the weights of inverseDistance are not periodic" << nl
                << "    Use another motionSolver" << nl << exit(FatalIOError);
        }
    }
}


void Foam::inverseDistanceMotionSolver::checkPatchFields
(
    const dictionary& dict
) const
{
    for (const polyPatch& patch : mesh().boundaryMesh())
    {
        const auto& pf = pointDisplacement_.boundaryField()[patch.index()];
        const bool hasValue = isA<valuePointPatchField<vector>>(pf);
        const bool moving = movingPatches_.found(patch.index());
        const bool fixed = fixedPatches_.found(patch.index());

        if (moving && !hasValue)
        {
            FatalIOErrorInFunction(dict)
                << "pointDisplacement has type " << pf.type()
                << " on the moving patch " << patch.name() << " ("
                << pointDisplacement_.objectPath() << ")" << nl
                << "    Valid are types with a value, such as fixedValue" << nl
                << exit(FatalIOError);
        }
        if (!moving && !fixed && hasValue)
        {
            FatalIOErrorInFunction(dict)
                << "pointDisplacement has a value (type " << pf.type()
                << ") on patch " << patch.name()
                << ", which is neither moving nor fixed" << nl
                << "    Add it to movingPatches or fixedPatches, or give it "
                << "type calculated in" << nl << "    "
                << pointDisplacement_.objectPath() << nl
                << exit(FatalIOError);
        }
        if (fixed && slides(patch.index()))
        {
            FatalIOErrorInFunction(dict)
                << "pointDisplacement has type " << pf.type()
                << " on the fixed patch " << patch.name() << " ("
                << pointDisplacement_.objectPath() << ")" << nl
                << "    Remove the patch from fixedPatches, so that its points "
                << "slide, or give it" << nl
                << "    type fixedValue with value uniform (0 0 0)" << nl
                << exit(FatalIOError);
        }
    }
}


void Foam::inverseDistanceMotionSolver::makeSetUp()
{
    setUp_.reset(new setUp(mesh(), points0()));
    setUp& s = *setUp_;

    s.moving.reset
    (
        new patchNodes(mesh(), s.scene, movingPatches_, bitSet())
    );
    if (s.moving->size() == 0)
    {
        FatalIOErrorInFunction(coeffDict())
            << "The moving patches have no points" << nl << exit(FatalIOError);
    }

    bitSet taken(s.scene.size());
    const auto take = [&](const patchNodes& nodes)
    {
        forAll(nodes.gatheredOfNode(), node)
        {
            if (nodes.gatheredOfNode()[node] >= 0)
            {
                taken.set(node);
            }
        }
    };
    take(*s.moving);
    s.fixed.reset(new patchNodes(mesh(), s.scene, fixedPatches_, taken));
    take(*s.fixed);

    const bitSet takenBoundary(taken);
    taken.flip();
    const pointField positions(selectTargets(taken));
    s.weights = inverseDistanceOperator::New
    (
        s.scene.dim(),
        makeAttractingPoints(*s.moving),
        makeAttractingPoints(*s.fixed),
        positions,
        settings_,
        makeSlidingPoints(takenBoundary)
    );

    watch_.reset
    (
        new volumeWatch
        (
            mesh(), *this, volumeWatch::cellVolumes(mesh(), points0())
        )
    );
}


Foam::pointField Foam::inverseDistanceMotionSolver::selectTargets
(
    const bitSet& nodes
)
{
    setUp& s = *setUp_;
    labelList targets(nodes.sortedToc());
    pointField positions(targets.size());
    forAll(positions, i)
    {
        positions[i] = s.scene.position(targets[i]);
    }
    scalarField scales(scale_.at(positions, s.moving->positions()));

    label n = 0;
    forAll(targets, i)
    {
        if (scales[i] > 0)
        {
            targets[n] = targets[i];
            scales[n] = scales[i];
            positions[n] = positions[i];
            ++n;
        }
    }
    targets.setSize(n);
    scales.setSize(n);
    positions.setSize(n);
    s.targets.transfer(targets);
    s.scales.transfer(scales);
    return positions;
}


Foam::List<Foam::slidingPoints>
Foam::inverseDistanceMotionSolver::makeSlidingPoints
(
    const bitSet& taken
)
{
    setUp& s = *setUp_;
    const slidingPlanes planes(mesh(), s.scene, points0(), slidingPatches_);

    s.nSliding = 0;
    List<slidingPoints> sliding(planes.size());
    forAll(sliding, p)
    {
        const patchNodes nodes
        (
            mesh(), s.scene, slidingPatches_, taken, planes.faces(p)
        );
        attractingPoints points(makeAttractingPoints(nodes));
        sliding[p].positions.transfer(points.positions);
        sliding[p].strengths.transfer(points.strengths);
        sliding[p].normal = planes.normal(p);
        s.nSliding += nodes.size();
    }
    return sliding;
}


Foam::attractingPoints Foam::inverseDistanceMotionSolver::makeAttractingPoints
(
    const patchNodes& nodes
) const
{
    return
    {
        nodes.positions(),
        byArea_
      ? nodes.areas(mesh(), points0())
      : scalarField(nodes.size(), 1)
    };
}


void Foam::inverseDistanceMotionSolver::report() const
{
    const inverseDistanceStatistics& local = setUp_->weights->statistics();
    const auto sum = [](const scalar x)
    {
        return returnReduce(x, sumOp<scalar>());
    };
    const scalar nTargets = max(sum(setUp_->targets.size()), scalar(1));

    Info<< "inverseDistance: " << label(nTargets) << " points follow "
        << setUp_->moving->size() << " moving, " << setUp_->fixed->size()
        << " fixed and " << setUp_->nSliding << " sliding points" << nl;
    if (scale_.fades())
    {
        Info<< "    fading from " << scale_.innerDistance() << " m to "
            << scale_.outerDistance() << " m, where the mesh is at rest" << nl;
    }
    Info
        << "    e1 " << settings_.e1 << ", e2 " << settings_.e2
        << ", tolerance " << settings_.tolerance << " (worst bound "
        << returnReduce(local.worstBound, maxOp<scalar>()) << ")" << nl
        << "    weights per point: " << sum(local.nWeights)/nTargets
        << ", memory: " << sum(local.nBytes)/sqr(1024.0) << " MB" << nl << endl;
}
