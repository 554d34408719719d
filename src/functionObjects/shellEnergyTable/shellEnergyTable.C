/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellEnergyTable.H"
#include "addToRunTimeSelectionTable.H"
#include "registeredShell.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(shellEnergyTable, 0);
    addToRunTimeSelectionTable(functionObject, shellEnergyTable, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::shellModel& Foam::functionObjects::shellEnergyTable::shell() const
{
    return registeredShell(time_, name(), typeName);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::shellEnergyTable::shellEnergyTable
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    timeFunctionObject(name, runTime),
    logFiles(runTime, name)
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::shellEnergyTable::execute()
{
    return true;
}


bool Foam::functionObjects::shellEnergyTable::read(const dictionary& dict)
{
    timeFunctionObject::read(dict);
    logFiles::read(dict);
    writePrecision_ = dict.lookupOrDefault<label>("writePrecision", 10);
    shell();

    resetNames(wordList(1, "energies"));
    if (Pstream::master())
    {
        OFstream& os = files(0);
        writeHeader(os, "Energies of the shell [J]");
        writeCommented(os, "Time");
        for
        (
            const char* column :
            {
                "kinetic", "strain", "externalWork", "supportWork",
                "dissipated", "mismatch"
            }
        )
        {
            writeTabbed(os, column);
        }
        os  << endl;
    }
    return true;
}


bool Foam::functionObjects::shellEnergyTable::write()
{
    if (!Pstream::master())
    {
        return true;
    }

    const shellEnergies e(shell().energies());
    OFstream& os = files(0);
    os  << setw(charWidth()) << time_.value();
    for
    (
        const scalar value :
        {
            e.kinetic, e.strain, e.externalWork, e.supportWork, e.dissipated,
            e.mismatch()
        }
    )
    {
        os  << tab << setw(charWidth()) << value;
    }
    os  << endl;
    return true;
}
