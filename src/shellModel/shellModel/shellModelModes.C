/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellModel.H"
#include "EigenFrequencies.hpp"
#include "untrappedFpe.H"

using positionalShell::EigenModes;

//- Modes are drawn with this part of the mesh's length as greatest displacement
static const Foam::scalar drawnSize = 0.1;


static EigenModes findModes
(
    const positionalShell::ShellModel& model,
    const positionalShell::Vector& position,
    const Foam::label n,
    const Foam::scalar shift
)
{
    using namespace Foam;

    positionalShell::EigenOptions options;
    options.shift = shift;
    try
    {
        const untrappedFpe untrapped;
        const EigenModes modes
        (
            positionalShell::lowestModes(model, position, n, options)
        );
        if (!modes.converged)
        {
            FatalErrorInFunction
                << "The " << n << " lowest modes of the shell are not found in "
                << label(modes.iterations) << " iterations" << nl
                << "    Ask for fewer" << nl << exit(FatalError);
        }
        return modes;
    }
    catch (const positionalShell::SingularMatrix&)
    {
        FatalErrorInFunction
            << "The shell can move without resistance" << nl
            << "    Give a negative -shift [1/s2], small beside the square of"
            << " the first angular frequency" << nl << exit(FatalError);
    }
    catch (const std::invalid_argument& problem)
    {
        FatalErrorInFunction
            << problem.what() << nl << exit(FatalError);
    }
    return EigenModes();
}


void Foam::shellModel::writeModes
(
    const label n,
    const scalar shift,
    Ostream& os
) const
{
    const EigenModes modes(findModes(*model_, now_.state.position, n, shift));

    shellVTK vtk
    (
        runTime_, *model_, "modes", shellResultFields(*model_)
    );
    os  << "Shell frequencies [Hz]" << nl;
    for (label i = 0; i < n; ++i)
    {
        os  << "    " << i + 1 << "  " << scalar(modes.frequency[i]) << nl;

        const positionalShell::Vector mode(modes.mode.col(i));
        const scalar largest =
            positionalShell::greatestEntries(mode).position;
        positionalShell::ShellState drawn(now_.state);
        drawn.time = i + 1;
        drawn.velocity = mode;
        drawn.position += drawnSize*mesh().lengthScale()/largest*mode;
        vtk.write(drawn, i + 1);
    }
    os  << "    written to VTK/modes.pvd" << nl << endl;
}
