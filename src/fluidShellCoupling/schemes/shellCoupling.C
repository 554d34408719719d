/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellCoupling.H"
#include "shellInterfacePointPatchVectorField.H"
#include "SubField.H"
#include "dictionaryCheck.H"

Foam::shellCoupling::shellCoupling
(
    Time& time,
    polyMesh& mesh,
    taylorGalerkinGas& gas,
    autoPtr<shellSide>&& shell,
    const dictionary& dict
)
:
    fluidShellCoupling
    (
        time, mesh, gas, dict.getOrDefault<label>("subCycles", 1)
    ),
    shell_(std::move(shell)),
    pRef_(dict.getOrDefault<scalar>("pRef", 0)),
    nodes_(gas.mesh(), dict),
    balance_(time)
{
    if (subCycles_ < 1)
    {
        FatalIOErrorInFunction(dict)
            << "subCycles must be at least 1, not " << subCycles_
            << exit(FatalIOError);
    }
    if (dict.found("loadTransfer"))
    {
        selectEntry(dict, "loadTransfer", {"consistent"});
    }

    const auto& U = mesh.lookupObject<pointVectorField>("U");
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
    checkStripWidth();
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
    const pointField& positions,
    const scalar tolerance
)
{
    map_.reset(new interfaceMap(shell_->model(), positions, tolerance));

    // The check of the transpose: the gas's present load on both sides
    const vectorField forces(nodes_.pressureForces(gas_, pRef_));
    const positionalShell::Vector generalised =
        map_->generalisedForce(forces);
    const positionalShell::Vector q =
        shell_->model().initialState().position;
    scalar area = 0;
    for (const fePatch* patch : nodes_.patches())
    {
        area += gSum(mag(mesh_.boundaryMesh()[patch->index].faceAreas()));
    }

    Info<< "Interface: " << nodes_.globalSize() << " gas nodes, " << area
        << " m2 of " << nodes_.patches().size() << " patch(es)" << nl
        << "    worst offset of a node from the shell "
        << map_->worstOffset() << " m, largest |xi3| "
        << map_->largestXi3() << nl
        << "    present load: force on gas nodes " << gSum(forces)
        << " N, on the shell " << interfaceMap::resultant(generalised) << nl
        << "    moment about the origin: gas nodes "
        << gSum(positions ^ forces) << " N m, shell "
        << interfaceMap::moment(generalised, q) << nl << endl;
}


void Foam::shellCoupling::advanceShell(const scalar duration)
{
    vectorField forces;
    positionalShell::Vector load;
    {
        phaseTimes::timer timer(times_, phaseTimes::transfer);
        forces = nodes_.pressureForces(gas_, pRef_);
        load = map_->generalisedForce(forces);
        balance_.begin(gSum(forces), interfaceMap::resultant(load), duration);
    }
    const positionalShell::Vector before = shell_->state().position;
    {
        phaseTimes::timer timer(times_, phaseTimes::shell);
        shell_->advance(duration, load);
    }
    balance_.addShell(load.dot(shell_->state().position - before));
}


void Foam::shellCoupling::report()
{
    shell_->report();
    balance_.report(time_);
    fluidShellCoupling::report();
}


void Foam::shellCoupling::reportEnd()
{
    Info<< nl;
    shell_->reportEnd();
    Info<< "Interface: work given by the gas " << balance_.workGas()
        << " J, received by the shell " << balance_.workShell()
        << " J, relative mismatch " << balance_.mismatch() << nl;
    fluidShellCoupling::reportEnd();
}
