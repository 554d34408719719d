/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellModel.H"
#include "Reactions.hpp"
#include "shellConstraints.H"
#include "shellVector.H"

void Foam::shellModel::writeState(const word& timeName) const
{
    writeShellState
    (
        runTime_,
        timeName,
        {now_.state, now_.externalForce, now_.memory, energies()}
    );

    if (vtk_)
    {
        vtk_->write(now_.state, runTime_.timeIndex());
    }
    writtenSinceStep_ = true;
}


bool Foam::shellModel::writeObject
(
    IOstream::streamFormat,
    IOstream::versionNumber,
    IOstream::compressionType,
    const bool
) const
{
    // Before initialise there is no state that a run could continue from
    if (now_.account)
    {
        writeState(runTime_.timeName());
    }
    return true;
}


void Foam::shellModel::writeOwnTime() const
{
    if (now_.account)
    {
        const word name(Time::timeName(now_.state.time));
        writeState(name);
        Info<< "The shell's last good state is written to " << name
            << "/shell" << endl;
    }
}


void Foam::shellModel::describe(Ostream& os) const
{
    os  << "Shell: " << label(mesh().nElements()) << " cubic triangles, "
        << label(mesh().nNodes()) << " nodes, "
        << label(model_->dofs().nEquations()) << " equations" << nl
        << "    mass " << scalar(model_->totalMass()) << " kg, "
        << (dynamic_ ? "time integrator " : "statics by ")
        << integrator_->type();

    if (planeStrain())
    {
        os  << ", plane strain along " << stripDirection()
            << ", width " << stripWidth() << " m";
    }
    os  << nl
        << (
               now_.account
             ? "    continues from the state in "
             : "    starts undeformed and at rest at time "
           )
        << runTime_.timeName().c_str()
        << (now_.account ? "/shell" : "") << nl << endl;
}


void Foam::shellModel::reportStep(Ostream& os) const
{
    const shellStepReport& r = now_.report;

    os  << "Newton (" << r.solver.c_str() << "):  Solving for shell"
        << ", Initial residual = " << r.initialResidual
        << ", Final residual = " << r.residual
        << ", No Iterations " << r.iterations << nl;
    if (integrator_->ownParameter())
    {
        os  << "Shell: load parameter = " << now_.state.time << nl;
    }
    if (r.steps > 1)
    {
        os  << "Shell: taken in " << r.steps << " steps" << nl;
    }
    const shellEnergies e(energies());

    os  << "Shell: max displacement = " << maxDisplacement()
        << " m, strain energy = " << e.strain
        << " J, kinetic energy = " << e.kinetic << " J" << nl
        << "Shell: work of loads = " << e.externalWork
        << " J, of supports = " << e.supportWork
        << " J, dissipated = " << e.dissipated
        << " J, mismatch = " << e.mismatch() << " J" << nl
        << "Shell: reaction = " << reaction("total", "all", Zero).force
        << " N" << endl;
}


Foam::wordList Foam::shellModel::reactionNames() const
{
    wordList names;
    for (const auto& s : supportSets(properties_.subDict("constraints")))
    {
        names.append(s.first);
    }
    names.append("total");
    return names;
}


Foam::shellReaction Foam::shellModel::reaction
(
    const word& name,
    const word& nodeSet,
    const vector& about
) const
{
    const positionalShell::ResultantForce sum
    (
        positionalShell::resultant
        (
            mesh().nodeSet(nodeSet),
            now_.state.position,
            now_.account->reaction(),
            toShell(about)
        )
    );
    return shellReaction{name, toFoam(sum.force), toFoam(sum.moment)};
}


std::vector<Foam::shellReaction> Foam::shellModel::reactions
(
    const vector& about
) const
{
    std::vector<shellReaction> result;
    if (!now_.account)
    {
        return result;
    }
    for (const auto& s : supportSets(properties_.subDict("constraints")))
    {
        result.push_back(reaction(s.first, s.second, about));
    }
    result.push_back(reaction("total", "all", about));
    return result;
}


void Foam::shellModel::reportEnd(Ostream& os) const
{
    const shellEnergies e(energies());
    const positionalShell::LinearSolverReport& linear =
        integrator_->linearReport();

    os  << "Shell energies [J]" << nl
        << "    strain         " << e.strain << nl
        << "    kinetic        " << e.kinetic << nl
        << "    external work  " << e.externalWork << nl
        << "    support work   " << e.supportWork << nl
        << "    dissipated     " << e.dissipated << nl
        << "    mismatch       " << e.mismatch() << nl
        << "Shell steps" << nl
        << "    steps          " << nSteps_ << nl
        << "    iterations     " << nIterations_ << nl
        << "    factorisations "
        << label(earlierFactors_.nCholesky + linear.nCholesky)
        << " by CHOLMOD, " << label(earlierFactors_.nLU + linear.nLU)
        << " by UMFPACK, of these "
        << label(earlierFactors_.nIndefinite + linear.nIndefinite)
        << " where the tangent was indefinite" << nl
        << "    time in steps  " << stepTime_ << " s" << nl
        << "    rate           "
        << mesh().nNodes()*scalar(nSteps_)/max(stepTime_, VSMALL)
        << " node steps per second" << nl << endl;
}
