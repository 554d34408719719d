/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
//  What the schemes do in a coupling step, and what a restart needs of it

#include "shellCoupling.H"
#include "IFstream.H"
#include "IOdictionary.H"
#include "shellFile.H"

namespace
{

//- What writeShellFile takes: entries written by a function
struct stateEntries
{
    std::function<void(Foam::Ostream&)> write;
};

Foam::Ostream& operator<<(Foam::Ostream& os, const stateEntries& entries)
{
    entries.write(os);
    return os;
}

} // End namespace


Foam::vectorField Foam::shellCoupling::presentForces() const
{
    return vectorField(nodes_.pressureForces(gas_, pRef_));
}


Foam::vectorField Foam::shellCoupling::lastForces() const
{
    return averages_ && meanForces_.size() ? meanForces_ : presentForces();
}


positionalShell::Vector Foam::shellCoupling::shellLoad
(
    const vectorField& forces
) const
{
    if (!closestLoads_.valid())
    {
        return map_->generalisedForce(forces);
    }
    return closestLoads_->generalisedForce
    (
        closestLoads_->pressures(gas_, pRef_), shell_->state().position
    );
}


positionalShell::Vector Foam::shellCoupling::transfer
(
    const vectorField& forces
)
{
    const positionalShell::Vector load = shellLoad(forces);
    const pointField places(nodes_.gather(gas_.mesh().nodes()));
    balance_.setLoads
    (
        {gSum(forces), gSum(places ^ forces)},
        {
            interfaceMap::resultant(load),
            interfaceMap::moment(load, shell_->state().position)
        }
    );
    return load;
}


void Foam::shellCoupling::stepShell
(
    const scalar duration,
    const positionalShell::Vector& start,
    const positionalShell::Vector& end
)
{
    positionalShell::Vector before = start;
    for (label k = 1; k <= shellSteps_; ++k)
    {
        const scalar dt = duration/shellSteps_;
        const positionalShell::Vector load =
            k == shellSteps_ ? end
          : start + (scalar(k)/shellSteps_)*(end - start);
        const positionalShell::Vector q = shell_->state().position;
        {
            phaseTimes::timer timer(times_, phaseTimes::shell);
            shell_->advance(dt, load);
        }
        const positionalShell::Vector mean = 0.5*(before + load);
        balance_.addShell
        (
            interfaceMap::resultant(mean),
            mean.dot(shell_->state().position - q),
            dt
        );
        before = load;
    }
}


void Foam::shellCoupling::advanceShell(const scalar duration)
{
    positionalShell::Vector load;
    {
        phaseTimes::timer timer(times_, phaseTimes::transfer);
        load = transfer(lastForces());
    }
    stepShell(duration, load, load);
}


void Foam::shellCoupling::advanceGas
(
    const scalar duration,
    const bool meanOfEnds,
    const gasStep& step
)
{
    vectorField forces(presentForces());
    vectorField sumOfForces(forces.size(), Zero);
    subCycle
    (
        duration,
        [&](const scalar, const scalar to, const scalar dt)
        {
            const pointField before(nodes_.gather(gas_.mesh().nodes()));
            step(to, dt);
            vectorField after(presentForces());
            const vectorField mean(0.5*(forces + after));
            balance_.addGas
            (
                meanOfEnds ? mean : forces,
                nodes_.gather(gas_.mesh().nodes()) - before,
                dt
            );
            sumOfForces += dt*mean;
            forces.swap(after);
        }
    );
    meanForces_ = sumOfForces/duration;
}


void Foam::shellCoupling::beginStep(const scalar duration)
{
    balance_.begin();
    shell_->storeOldState();
    indicators_.update
    (
        map_->velocity(shell_->state().velocity), duration
    );
    if (!warned_ && indicators_.massRatio() < leastMassRatio())
    {
        warned_ = true;
        WarningInFunction
            << "The mass ratio of shell to gas moved in a coupling step is "
            << indicators_.massRatio() << ": below " << leastMassRatio()
            << " a staggered scheme is not safe, (C20)" << nl
            << "    Use coupling iterated, or a coupling step smaller by "
            << leastMassRatio()/indicators_.massRatio() << " (deltaT, "
            << "subCycles)" << endl;
    }
}


void Foam::shellCoupling::writeAccounts(Ostream& os) const
{
    os.writeEntry("impulseGas", balance_.gas().impulse);
    os.writeEntry("workGas", balance_.gas().work);
    os.writeEntry("impulseShell", balance_.shell().impulse);
    os.writeEntry("workShell", balance_.shell().work);
}


void Foam::shellCoupling::readAccounts(const dictionary& dict)
{
    balance_.resume
    (
        {dict.get<vector>("impulseGas"), dict.get<scalar>("workGas")},
        {dict.get<vector>("impulseShell"), dict.get<scalar>("workShell")}
    );
}


void Foam::shellCoupling::writeNodeMemory(Ostream& os) const
{
    os.writeEntry("nodes", nodes_.size());
    if (averages_)
    {
        meanForces_.writeEntry("meanForces", os);
    }
}


void Foam::shellCoupling::readNodeMemory(const dictionary& dict)
{
    if (averages_ && dict.found("meanForces"))
    {
        meanForces_ = vectorField("meanForces", dict, nodes_.size());
    }
}


void Foam::shellCoupling::resumeNodes(const dictionary& dict)
{
    const bool own = dict.getOrDefault<label>("nodes", -1) == nodes_.size();
    if (returnReduce(own, andOp<bool>()))
    {
        readNodeMemory(dict);
    }
    else
    {
        Info<< "Interface: the last step is not known on this decomposition; "
            << "the first one is as at a start" << nl << endl;
    }
}


void Foam::shellCoupling::resume()
{
    const fileName folder(time_.timeName()/"shell");
    if (!shellFileExists(time_, folder, stateName))
    {
        return;
    }
    const IOdictionary state(shellFile(time_, folder, stateName));
    readAccounts(state);
    if (!Pstream::parRun())
    {
        resumeNodes(state);
        return;
    }
    const fileName own(time_.path()/folder/stateName);
    dictionary memory;
    if (isFile(own))
    {
        IFstream is(own);
        memory.read(is);
    }
    resumeNodes(memory);
}


void Foam::shellCoupling::saveForRestart()
{
    const fileName folder(time_.timeName()/"shell");
    writeShellFile
    (
        time_, folder, stateName, "dictionary",
        stateEntries
        {
            [this](Ostream& os)
            {
                writeAccounts(os);
                if (!Pstream::parRun())
                {
                    writeNodeMemory(os);
                }
            }
        }
    );
    if (Pstream::parRun())
    {
        mkDir(time_.path()/folder);
        OFstream os(time_.path()/folder/stateName);
        os.precision(fullPrecision);
        IOobject(stateName, folder, time_).writeHeader(os, "dictionary");
        writeNodeMemory(os);
        IOobject::writeEndDivider(os);
    }
}
