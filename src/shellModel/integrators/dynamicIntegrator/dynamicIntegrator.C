/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "dynamicIntegrator.H"
#include "newtonControls.H"
#include "shellInput.H"

void Foam::shellIntegrators::dynamicIntegrator::readOptions
(
    const dictionary& shellProperties,
    positionalShell::MotionOptions& options
)
{
    shellProperties.readIfPresent("massDamping", options.massDamping);
    options.newton = readNewtonControls(shellProperties, options.newton);
}


Foam::shellIntegrators::dynamicIntegrator::dynamicIntegrator
(
    const dictionary& shellProperties
)
{
    options_.maxCuts = readMaxCuts(shellProperties);
    shellProperties.readIfPresent("errorTolerance", options_.errorTolerance);
}


void Foam::shellIntegrators::dynamicIntegrator::start
(
    const dictionary& shellProperties
)
{
    rejectedIn(shellProperties, [this] { reset(); });
}


void Foam::shellIntegrators::dynamicIntegrator::initialise
(
    positionalShell::ShellState& state,
    const positionalShell::Loads& loads,
    const positionalShell::Vector& fixedForce
)
{
    method_->initialise(state, loads, &fixedForce);
}


std::vector<positionalShell::DynamicStep>
Foam::shellIntegrators::dynamicIntegrator::advance
(
    const positionalShell::ShellState& start,
    const scalar dt,
    const positionalShell::Loads& loads,
    const positionalShell::GivenForce& given,
    positionalShell::Vector& memory
)
{
    // Length of the next step within the interval
    double wanted = memory.size() > 0 ? memory[0] : 0;

    std::vector<positionalShell::DynamicStep> steps
    (
        interval_->advance(start, dt, loads, given, wanted)
    );
    if (options_.errorTolerance > 0)
    {
        memory = positionalShell::Vector::Constant(1, wanted);
    }
    return steps;
}


void Foam::shellIntegrators::dynamicIntegrator::reset()
{
    interval_.reset();
    method_ = make();
    interval_ = std::make_unique<positionalShell::IntervalIntegrator>
    (
        *method_, options_
    );
}
