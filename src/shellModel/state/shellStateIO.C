/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellStateIO.H"
#include "shellFile.H"
#include "shellVector.H"
#include "IOdictionary.H"
#include "scalarIOField.H"
#include "vectorIOField.H"

using positionalShell::Component;

namespace Foam
{

static fileName stateFolder(const word& timeName)
{
    return fileName(timeName)/"shell";
}


typedef positionalShell::Vector fullVector;

static fullVector& position(shellRestart& r)
{
    return r.state.position;
}

static fullVector& velocity(shellRestart& r)
{
    return r.state.velocity;
}

static fullVector& acceleration(shellRestart& r)
{
    return r.state.acceleration;
}

static fullVector& force(shellRestart& r)
{
    return r.externalForce;
}


//- A file of the state: the full vector that it belongs to, and the first of
//  the three components of it, or the one, that it holds
struct statePart
{
    word file;
    fullVector& (*full)(shellRestart&);
    Component first;
};


static const std::vector<statePart>& vectorParts()
{
    static const std::vector<statePart> parts
    {
        {"position", position, Component::x},
        {"director", position, Component::gx},
        {"velocity", velocity, Component::x},
        {"directorVelocity", velocity, Component::gx},
        {"acceleration", acceleration, Component::x},
        {"directorAcceleration", acceleration, Component::gx},
        {"force", force, Component::x},
        {"directorForce", force, Component::gx}
    };
    return parts;
}


static const std::vector<statePart>& scalarParts()
{
    static const std::vector<statePart> parts
    {
        {"thicknessStrain", position, Component::a},
        {"thicknessForce", force, Component::a}
    };
    return parts;
}


//- Contents of stateDict. Not a dictionary: that would round its numbers to
//  the default precision
struct stateEntries
{
    scalar time;
    const shellEnergies& energies;
};


static void writeContents(Ostream& os, const stateEntries& entries)
{
    os.writeEntry("time", entries.time);
    entries.energies.writeEntries(os);
}


template<class Type>
static void checkSize(const IOField<Type>& field, const fullVector& full)
{
    const label nNodes = full.size()/positionalShell::dofsPerNode;

    if (field.size() != nNodes)
    {
        FatalErrorInFunction
            << field.objectPath() << " holds " << field.size()
            << " values, but the shell mesh has " << nNodes << " nodes" << nl
            << "    Restart with the mesh of the earlier run, or remove the"
            << " folder to start from rest" << nl
            << exit(FatalError);
    }
}

} // End namespace Foam


bool Foam::shellStateExists(const Time& runTime, const word& timeName)
{
    return shellFileExists(runTime, stateFolder(timeName), "stateDict");
}


Foam::shellRestart Foam::readShellState
(
    const Time& runTime,
    const word& timeName,
    const label nDofs
)
{
    const fileName folder(stateFolder(timeName));

    shellRestart restart;
    restart.state.position = fullVector::Zero(nDofs);
    restart.state.velocity = fullVector::Zero(nDofs);
    restart.state.acceleration = fullVector::Zero(nDofs);
    restart.externalForce = fullVector::Zero(nDofs);

    for (const statePart& part : vectorParts())
    {
        const vectorIOField values(shellFile(runTime, folder, part.file));
        checkSize(values, part.full(restart));
        setNodeVectors(values, part.first, part.full(restart));
    }
    for (const statePart& part : scalarParts())
    {
        const scalarIOField values(shellFile(runTime, folder, part.file));
        checkSize(values, part.full(restart));
        setNodeScalars(values, part.first, part.full(restart));
    }

    if (shellFileExists(runTime, folder, "integratorMemory"))
    {
        const scalarIOField values
        (
            shellFile(runTime, folder, "integratorMemory")
        );
        restart.memory = Eigen::Map<const fullVector>
        (
            values.cdata(), values.size()
        );
    }

    const IOdictionary dict(shellFile(runTime, folder, "stateDict"));
    restart.state.time = dict.get<scalar>("time");
    restart.energies = shellEnergies::read(dict);
    return restart;
}


void Foam::writeShellState
(
    const Time& runTime,
    const word& timeName,
    const shellRestart& restart
)
{
    const fileName folder(stateFolder(timeName));
    shellRestart values(restart);

    for (const statePart& part : vectorParts())
    {
        writeShellFile
        (
            runTime,
            folder,
            part.file,
            vectorIOField::typeName,
            nodeVectors(part.full(values), part.first)()
        );
    }
    for (const statePart& part : scalarParts())
    {
        writeShellFile
        (
            runTime,
            folder,
            part.file,
            scalarIOField::typeName,
            nodeScalars(part.full(values), part.first)()
        );
    }

    if (restart.memory.size() > 0)
    {
        const label n = restart.memory.size();
        const UList<scalar> memory
        (
            const_cast<scalar*>(restart.memory.data()), n
        );
        writeShellFile
        (
            runTime,
            folder,
            "integratorMemory",
            scalarIOField::typeName,
            scalarField(memory)
        );
    }

    writeShellFile
    (
        runTime,
        folder,
        "stateDict",
        dictionary::typeName,
        stateEntries{restart.state.time, restart.energies}
    );
}
