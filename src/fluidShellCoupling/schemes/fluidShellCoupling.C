/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "fluidShellCoupling.H"
#include "gasAlone.H"
#include "shellCoupling.H"
#include "shellModelSide.H"
#include "dictionaryCheck.H"

namespace
{

bool present(const Foam::word& name, const Foam::Time& time)
{
    return Foam::IOobject
    (
        name,
        time.constant(),
        time,
        Foam::IOobject::MUST_READ,
        Foam::IOobject::NO_WRITE,
        false
    ).typeHeaderOk<Foam::IOdictionary>(false);
}

} // End namespace


Foam::autoPtr<Foam::fluidShellCoupling> Foam::fluidShellCoupling::New
(
    Time& time,
    polyMesh& mesh,
    taylorGalerkinGas& gas
)
{
    if (!present("couplingProperties", time))
    {
        if (present("shellProperties", time))
        {
            FatalErrorInFunction
                << "The case has constant/shellProperties, but no "
                << "constant/couplingProperties" << nl
                << "    Add it, with coupling none, oneWay or twoWay"
                << exit(FatalError);
        }
        return autoPtr<fluidShellCoupling>(new gasAlone(time, mesh, gas));
    }

    const IOdictionary dict
    (
        IOobject
        (
            "couplingProperties",
            time.constant(),
            time,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    checkKeywords
    (
        dict,
        {
            "coupling", "patches", "subCycles", "shellSteps", "loads",
            "loadTransfer", "pRef", "mapTolerance", "adviceTolerance"
        }
    );
    const wordList schemes(shellCoupling::schemes());
    wordList choices(1, word("none"));
    choices.append(schemes);
    const label choice = selectEntry(dict, "coupling", choices);

    if (choice == 0)
    {
        return autoPtr<fluidShellCoupling>(new gasAlone(time, mesh, gas));
    }
    return autoPtr<fluidShellCoupling>
    (
        shellCoupling::New
        (
            choices[choice], time, mesh, gas,
            autoPtr<shellSide>(new shellModelSide(time)), dict
        ).ptr()
    );
}


Foam::fluidShellCoupling::fluidShellCoupling
(
    Time& time,
    polyMesh& mesh,
    taylorGalerkinGas& gas,
    const label subCycles
)
:
    time_(time),
    mesh_(mesh),
    gas_(gas),
    subCycles_(subCycles),
    nGasSteps_(0),
    nLastSteps_(0),
    courantMax_(0),
    largestStable_(0),
    extrema_{}
{
    if (!subCycles_ && adjustTimeStep())
    {
        FatalIOErrorInFunction(time.controlDict())
            << "subCycles adaptive in constant/couplingProperties takes deltaT"
            << " as the coupling step," << nl
            << "    but adjustTimeStep would change it" << nl
            << "    Set adjustTimeStep no, or a number of subCycles"
            << exit(FatalIOError);
    }
}


const Foam::stableStep& Foam::fluidShellCoupling::stable()
{
    const stableStep& s = gas_.stable();
    if (!followsCourant())
    {
        return s;
    }
    largestStable_ = max(largestStable_, s.deltaT);
    const scalar least = time_.controlDict().getOrDefault<scalar>
    (
        "minDeltaT", 1e-6*largestStable_
    );
    if (s.deltaT >= least)
    {
        return s;
    }

    gas_.writeState();
    returnReduce(true, andOp<bool>());
    FatalErrorInFunction
        << "The stable step of the gas has shrunk to " << s.deltaT
        << " s at time " << time_.timeName() << " s; the largest was "
        << largestStable_ << " s, minDeltaT is " << least << " s" << nl
        << "    It is limited by " << s.limit() << " at node " << s.node
        << " at " << s.position << nl
        << "    (rates there: convection " << s.convection
        << " 1/s, artificial viscosity " << s.diffusion << " 1/s)" << nl
        << "    The state is written to " << time_.timeName() << nl
        << "    Look whether cells collapse there (mesh motion, a gap that"
        << " closes) or the state runs away;" << nl
        << "    if it is meant to be, set a smaller minDeltaT in "
        << time_.controlDict().name() << exit(FatalError);
    return s;
}


bool Foam::fluidShellCoupling::adjustTimeStep() const
{
    return time_.controlDict().getOrDefault<Switch>("adjustTimeStep", false);
}


Foam::scalar Foam::fluidShellCoupling::maxCo() const
{
    const scalar most = gas_.maxCourant();
    const scalar value =
        time_.controlDict().getOrDefault<scalar>("maxCo", min(0.8, 0.9*most));
    if (value <= 0 || value > most)
    {
        FatalIOErrorInFunction(time_.controlDict())
            << "maxCo is " << value << ", but must be in (0, " << most
            << "], where the time scheme of system/feSchemes is stable"
            << exit(FatalIOError);
    }
    return value;
}


Foam::scalar Foam::fluidShellCoupling::timeToWrite() const
{
    const dictionary& control = time_.controlDict();
    const word when(control.getOrDefault<word>("writeControl", "timeStep"));
    if (when != "adjustable" && when != "adjustableRunTime")
    {
        return GREAT;
    }
    // As Time counts the writes
    const scalar interval = control.get<scalar>("writeInterval");
    const scalar since = time_.value() - time_.startTime().value();
    const label passed = label((since + 0.5*time_.deltaTValue())/interval);
    return (passed + 1)*interval - since;
}


void Foam::fluidShellCoupling::setDeltaT()
{
    {
        // Sums that the next gas step uses again
        phaseTimes::timer timer(times_, phaseTimes::gas);
        this->stable();
    }
    const stableStep& stable = this->stable();
    scalar dt = time_.deltaTValue();

    if (adjustTimeStep())
    {
        const scalar wanted = min
        (
            subCycles_*maxCo()*stable.deltaT,
            time_.controlDict().getOrDefault<scalar>("maxDeltaT", GREAT)
        );

        // Growth is damped as in OpenFOAM's setDeltaT,
        // of a restart as well: it knows the last deltaT
        dt = time_.timeIndex() == 0 ? wanted : min(wanted, 1.2*dt);

        // Reach the end time and the next write in even steps, no longer than
        // wanted: Time would round their number down, and the gas would halve
        // each of the longer steps
        const scalar left = time_.endTime().value() - time_.value();
        for (const scalar span : {left, timeToWrite()})
        {
            if (span > 0 && span < GREAT)
            {
                dt = span/std::ceil(span/dt - 1e-6);
            }
        }
        time_.setDeltaT(dt);

        // Reaching a write time may have lengthened the step past the end
        if (time_.deltaTValue() > left)
        {
            time_.setDeltaT(left, false);
        }
        dt = time_.deltaTValue();
    }

    const scalar gasDt = dt/
    (
        subCycles_ ? scalar(subCycles_)
      : std::ceil(dt/(maxCo()*stable.deltaT) - 1e-6)
    );
    Info<< "Courant Number mean: "
        << stable.meanConvection*gasDt << " max: "
        << stable.maxConvection*gasDt << nl
        << "Stable step " << stable.deltaT << " s: " << stable.limit()
        << " at node " << stable.node << " " << stable.position << nl
        << "deltaT = " << dt << endl;
}


void Foam::fluidShellCoupling::write()
{
    // Function objects read the fields at the start of the next step
    if (willWrite() || time_.controlDict().found("functions"))
    {
        gas_.updateFields();
    }
    if (willWrite())
    {
        saveForRestart();
        time_.writeNow();
        gas_.forgetMotion();
    }
}


void Foam::fluidShellCoupling::report()
{
    extrema_ = gas_.extrema();
    const gasExtrema& e = extrema_;
    const scalar done =
        (time_.value() - time_.startTime().value())
       /(time_.endTime().value() - time_.startTime().value());

    Info<< "Gas: " << nLastSteps_ << " step(s), "
        << courantMax_ << " of the stable step; p " << e.minP << " to "
        << e.maxP << " Pa, T " << e.minT << " to " << e.maxT << " K, rho "
        << e.minRho << " to " << e.maxRho << nl
        << "Progress: " << 100*done << " %, remaining "
        << times_.elapsed()*(1 - done)/max(done, SMALL) << " s" << endl;

    if (courantMax_ > 1)
    {
        WarningInFunction
            << "A gas step was " << courantMax_ << " times the stable step: "
            << "use a smaller deltaT, more subCycles, or adjustTimeStep"
            << endl;
    }
}


void Foam::fluidShellCoupling::reportEnd()
{
    const gasTotals totals = gas_.totals();
    Info<< nl << "Gas at the end: mass " << totals.mass << " kg, momentum "
        << totals.momentum << " kg m/s, energy " << totals.energy << " J"
        << endl;
    times_.report(gas_.mesh().nNodes(), nGasSteps_);
}
