/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "interfaceBalance.H"
#include "OSspecific.H"

Foam::interfaceBalance::interfaceBalance(const Time& runTime)
:
    stepGas_(0),
    stepShell_(0),
    workGas_(0),
    workShell_(0),
    forceGas_(Zero),
    forceShell_(Zero),
    impulse_(Zero)
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
        << " impulse_x impulse_y impulse_z workGas workShell" << endl;
    file_().precision(16);
}


void Foam::interfaceBalance::begin
(
    const vector& forceGas,
    const vector& forceShell,
    scalar dt
)
{
    forceGas_ = forceGas;
    forceShell_ = forceShell;
    impulse_ += forceShell*dt;
    stepGas_ = 0;
    stepShell_ = 0;
}


void Foam::interfaceBalance::addGas
(
    const vectorField& forces,
    const vectorField& displacement
)
{
    const scalar work = gSum(forces & displacement);
    stepGas_ += work;
    workGas_ += work;
}


void Foam::interfaceBalance::addShell(const scalar work)
{
    stepShell_ = work;
    workShell_ += work;
}


Foam::scalar Foam::interfaceBalance::mismatch() const
{
    return
        mag(workGas_ - workShell_)
       /max(max(mag(workGas_), mag(workShell_)), VSMALL);
}


void Foam::interfaceBalance::report(const Time& runTime)
{
    Info<< "Interface: force " << forceShell_ << " N, mismatch "
        << mag(forceGas_ - forceShell_)/max(mag(forceGas_), VSMALL)
        << ", impulse " << impulse_ << " N s" << nl
        << "    work this step: gas " << stepGas_ << " J, shell "
        << stepShell_ << " J; accumulated: gas " << workGas_
        << " J, shell " << workShell_ << " J, mismatch " << mismatch() << nl;

    if (!file_.valid())
    {
        return;
    }
    auto write = [&](const vector& v)
    {
        file_() << ' ' << v.x() << ' ' << v.y() << ' ' << v.z();
    };
    file_() << runTime.value();
    write(forceGas_);
    write(forceShell_);
    write(impulse_);
    file_() << ' ' << workGas_ << ' ' << workShell_ << endl;
}
