/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "interfaceBalance.H"

Foam::interfaceBalance::interfaceBalance(const Time& runTime)
:
    largestDifference_(0),
    largestWork_(0)
{
    if (!Pstream::master())
    {
        return;
    }
    const fileName folder
    (
        runTime.globalPath()/"postProcessing"/"interface"/runTime.timeName()
    );
    mkDir(folder);
    file_.reset(new OFstream(folder/"balance.dat"));
    file_()
        << "# Balance at the interface of gas and shell, SI units" << nl
        << "# time forceGas_x forceGas_y forceGas_z"
        << " forceShell_x forceShell_y forceShell_z"
        << " impulseShell_x impulseShell_y impulseShell_z workGas workShell"
        << " impulseGas_x impulseGas_y impulseGas_z"
        << " momentGas_x momentGas_y momentGas_z"
        << " momentShell_x momentShell_y momentShell_z"
        << " stepWorkGas stepWorkShell" << endl;
    file_().precision(16);
}


void Foam::interfaceBalance::begin()
{
    stepGas_ = side();
    stepShell_ = side();
}


void Foam::interfaceBalance::setLoads(const load& gas, const load& shell)
{
    loadGas_ = gas;
    loadShell_ = shell;
}


void Foam::interfaceBalance::addGas
(
    const vectorField& forces,
    const vectorField& displacement,
    const scalar dt
)
{
    stepGas_.work += gSum(forces & displacement);
    stepGas_.impulse += gSum(forces)*dt;
}


void Foam::interfaceBalance::addShell
(
    const vector& force,
    const scalar work,
    const scalar dt
)
{
    stepShell_.work += work;
    stepShell_.impulse += force*dt;
}


void Foam::interfaceBalance::end()
{
    gas_ += stepGas_;
    shell_ += stepShell_;
    largestDifference_ =
        max(largestDifference_, mag(stepGas_.work - stepShell_.work));
    largestWork_ = max(largestWork_, mag(stepShell_.work));
}


void Foam::interfaceBalance::resume(const side& gas, const side& shell)
{
    gas_ = gas;
    shell_ = shell;
}


void Foam::interfaceBalance::report(const Time& runTime)
{
    auto relative = [](const vector& a, const vector& b)
    {
        return mag(a - b)/max(mag(a), VSMALL);
    };
    Info<< "Interface: force " << loadShell_.force << " N, mismatch "
        << relative(loadGas_.force, loadShell_.force)
        << ", of moment " << relative(loadGas_.moment, loadShell_.moment)
        << ", impulse " << shell_.impulse << " N s" << nl
        << "    work this step: gas " << stepGas_.work << " J, shell "
        << stepShell_.work << " J, mismatch " << stepMismatch()
        << "; accumulated: gas " << gas_.work << " J, shell " << shell_.work
        << " J, mismatch " << mismatch() << nl;

    if (!file_.valid())
    {
        return;
    }
    auto write = [&](const vector& v)
    {
        file_() << ' ' << v.x() << ' ' << v.y() << ' ' << v.z();
    };
    file_() << runTime.value();
    write(loadGas_.force);
    write(loadShell_.force);
    write(shell_.impulse);
    file_() << ' ' << gas_.work << ' ' << shell_.work;
    write(gas_.impulse);
    write(loadGas_.moment);
    write(loadShell_.moment);
    file_() << ' ' << stepGas_.work << ' ' << stepShell_.work << endl;
}


void Foam::interfaceBalance::reportEnd() const
{
    Info<< "Interface: work given by the gas " << gas_.work
        << " J, received by the shell " << shell_.work
        << " J, relative mismatch " << mismatch() << nl
        << "    impulse of the gas " << gas_.impulse << " N s, on the shell "
        << shell_.impulse << " N s; largest mismatch of a step's work "
        << worstStep() << nl;
}
