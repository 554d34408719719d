/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "phaseTimes.H"

Foam::scalar Foam::phaseTimes::elapsed() const
{
    return std::chrono::duration<double>
    (
        std::chrono::steady_clock::now() - start_
    ).count();
}


void Foam::phaseTimes::report
(
    const label nNodes,
    const label nGasSteps
) const
{
    const char* names[] = {"gas", "shell", "mesh motion", "transfer"};
    const scalar total = elapsed();
    scalar rest = total;

    Info<< nl << "Time by phase" << nl;
    for (int p = 0; p < nPhases; ++p)
    {
        rest -= seconds_[p];
        Info<< "    " << names[p] << ": " << seconds_[p] << " s, "
            << 100*seconds_[p]/total << " %" << nl;
    }
    Info<< "    output and function objects: " << rest << " s, "
        << 100*rest/total << " %" << nl;

    const scalar updates = scalar(nNodes)*nGasSteps;
    Info<< "Figure of merit: " << updates/total/1e6
        << " million node updates per second (" << nNodes << " nodes, "
        << nGasSteps << " gas steps, " << total << " s); gas alone "
        << updates/max(seconds_[gas], SMALL)/1e6 << endl;
}
