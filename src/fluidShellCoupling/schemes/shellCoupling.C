/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellCoupling.H"
#include "shellInterfacePointPatchVectorField.H"
#include "dictionaryCheck.H"
#include "SubField.H"

namespace Foam
{
    defineTypeNameAndDebug(shellCoupling, 0);
    defineRunTimeSelectionTable(shellCoupling, dictionary);
}

const Foam::word Foam::shellCoupling::stateName("interface");


static Foam::label readSubCycles(const Foam::dictionary& dict)
{
    using namespace Foam;

    if (!dict.found("subCycles"))
    {
        return 1;
    }
    const token first(dict.lookup("subCycles")[0]);
    if (first.isWord() && first.wordToken() == "adaptive")
    {
        return 0;
    }
    if (!first.isLabel() || first.labelToken() < 1)
    {
        FatalIOErrorInFunction(dict)
            << "subCycles must be a number of at least 1, or adaptive"
            << exit(FatalIOError);
    }
    return first.labelToken();
}


static Foam::label readShellSteps(const Foam::dictionary& dict)
{
    using namespace Foam;

    const label n = dict.getOrDefault<label>("shellSteps", 1);
    if (n < 1)
    {
        FatalIOErrorInFunction(dict)
            << "shellSteps must be at least 1, not " << n
            << exit(FatalIOError);
    }
    return n;
}


static bool readAverages(const Foam::dictionary& dict)
{
    return
        dict.found("loads")
     && Foam::selectEntry(dict, "loads", {"end", "average"}) == 1;
}


static bool readTakesClosest(const Foam::dictionary& dict)
{
    using namespace Foam;

    const bool takes =
        dict.found("loadTransfer")
     && selectEntry(dict, "loadTransfer", {"consistent", "closestPoint"}) == 1;
    if (takes && readAverages(dict))
    {
        FatalIOErrorInFunction(dict)
            << "loads average keeps forces, but loadTransfer closestPoint "
            << "takes pressures" << nl
            << "    Set loads end, or loadTransfer consistent"
            << exit(FatalIOError);
    }
    return takes;
}


Foam::wordList Foam::shellCoupling::schemes()
{
    return dictionaryConstructorTablePtr_->sortedToc();
}


Foam::autoPtr<Foam::shellCoupling> Foam::shellCoupling::New
(
    const word& scheme,
    Time& time,
    polyMesh& mesh,
    taylorGalerkinGas& gas,
    autoPtr<shellSide>&& shell,
    const dictionary& dict
)
{
    const auto constructor = dictionaryConstructorTablePtr_->cfind(scheme);
    if (!constructor.found())
    {
        FatalIOErrorInFunction(dict)
            << "Unknown coupling " << scheme << nl
            << "    Valid choices are " << flatOutput(schemes())
            << exit(FatalIOError);
    }
    return constructor()(time, mesh, gas, std::move(shell), dict);
}


Foam::shellCoupling::shellCoupling
(
    Time& time,
    polyMesh& mesh,
    taylorGalerkinGas& gas,
    autoPtr<shellSide>&& shell,
    const dictionary& dict
)
:
    fluidShellCoupling(time, mesh, gas, readSubCycles(dict)),
    shell_(std::move(shell)),
    pRef_(dict.getOrDefault<scalar>("pRef", 0)),
    shellSteps_(readShellSteps(dict)),
    averages_(readAverages(dict)),
    nodes_(gas.mesh(), dict),
    takesClosest_(readTakesClosest(dict)),
    balance_(time),
    indicators_
    (
        gas, nodes_, shell_->model().totalMass(),
        dict.getOrDefault<scalar>("adviceTolerance", 0.05)
    ),
    warned_(false)
{
    checkPatches(dict);
    checkStripWidth();
    gas_.beforeStop
    (
        [this]()
        {
            shell_->restoreOldState();
            shell_->writeState();
        }
    );

    Info<< "Coupling: " << dict.get<word>("coupling").c_str() << ", ";
    if (subCycles_)
    {
        Info<< subCycles_ << " gas step(s) per coupling step";
    }
    else
    {
        Info<< "gas steps by the Courant number";
    }
    if (shellSteps_ > 1)
    {
        Info<< ", " << shellSteps_ << " steps of the shell";
    }
    Info<< (averages_ ? ", loads averaged" : "") << endl;
}


void Foam::shellCoupling::checkPatches(const dictionary& dict) const
{
    const auto& U = mesh_.lookupObject<pointVectorField>("U");
    for (const fePatch* patch : nodes_.patches())
    {
        const auto& pf = U.boundaryField()[patch->index];
        if (!isA<shellInterfacePointPatchVectorField>(pf))
        {
            FatalIOErrorInFunction(dict)
                << "U has type " << pf.type() << " on the interface patch "
                << patch->name << nl << "    It must be shellInterface"
                << exit(FatalIOError);
        }
    }
}


void Foam::shellCoupling::checkStripWidth() const
{
    const feMesh& mesh = gas_.mesh();
    const auto& shellNodes = shell_->model().mesh().nodes();

    scalar width = 1;
    for (direction d = 0; d < 3; ++d)
    {
        if (!mesh.axes().found(d))
        {
            scalar low = GREAT, high = -GREAT;
            for (const auto& x : shellNodes)
            {
                low = min(low, x[d]);
                high = max(high, x[d]);
            }
            width *= high - low;
        }
    }

    if (mag(width - mesh.depth()) > 1e-6*mesh.depth())
    {
        FatalErrorInFunction
            << "The shell is " << width << " wide in the direction(s) that "
            << "the gas mesh does not resolve, the gas mesh is "
            << mesh.depth() << " deep there" << nl
            << "    Make them equal: loads are per true area"
            << exit(FatalError);
    }
}


void Foam::shellCoupling::findMap
(
    const pointField& places,
    const scalar tolerance
)
{
    const pointField positions(nodes_.gather(places));
    map_.reset(new interfaceMap(shell_->model(), positions, tolerance));

    // The check of the transpose: the gas's present load on both sides
    const vectorField forces(nodes_.pressureForces(gas_, pRef_));
    positionalShell::Vector q = shell_->model().initialState().position;
    positionalShell::Vector generalised = map_->generalisedForce(forces);
    if (takesClosest_)
    {
        closestLoads_.reset
        (
            new closestPointLoads
            (
                shell_->model(), gas_.mesh(), nodes_, places, tolerance
            )
        );
        q = shell_->state().position;
        generalised = shellLoad(forces);
    }
    scalar area = 0;
    for (const fePatch* patch : nodes_.patches())
    {
        area += gSum(mag(mesh_.boundaryMesh()[patch->index].faceAreas()));
    }

    Info<< "Interface: " << nodes_.globalSize() << " gas nodes, " << area
        << " m2 of " << nodes_.patches().size() << " patch(es)" << nl
        << "    worst offset of a node from the shell "
        << map_->worstOffset() << " m, largest |xi3| "
        << map_->largestXi3() << nl;
    if (closestLoads_.valid())
    {
        Info<< "    loads of the closest points at "
            << closestLoads_->nWetted() << " of "
            << shell_->model().mesh().nNodes() << " shell nodes" << nl;
    }
    Info<< "    present load: force on gas nodes " << gSum(forces)
        << " N, on the shell " << interfaceMap::resultant(generalised) << nl
        << "    moment about the origin: gas nodes "
        << gSum(positions ^ forces) << " N m, shell "
        << interfaceMap::moment(generalised, q) << nl << endl;
}


void Foam::shellCoupling::report()
{
    shell_->report();
    balance_.report(time_);
    indicators_.report(moves());
    fluidShellCoupling::report();
    indicators_.addGasSpeed(extrema_.maxSpeed);
}


void Foam::shellCoupling::reportEnd()
{
    Info<< nl;
    shell_->reportEnd();
    balance_.reportEnd();
    indicators_.reportEnd(moves(), leastMassRatio(), meanIterations());
    fluidShellCoupling::reportEnd();
}
