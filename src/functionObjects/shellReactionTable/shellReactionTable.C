/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellReactionTable.H"
#include "addToRunTimeSelectionTable.H"
#include "registeredShell.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(shellReactionTable, 0);
    addToRunTimeSelectionTable(functionObject, shellReactionTable, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::shellModel& Foam::functionObjects::shellReactionTable::shell() const
{
    return registeredShell(time_, name(), typeName);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::shellReactionTable::shellReactionTable
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    timeFunctionObject(name, runTime),
    logFiles(runTime, name),
    about_(Zero)
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::shellReactionTable::execute()
{
    return true;
}


bool Foam::functionObjects::shellReactionTable::read(const dictionary& dict)
{
    timeFunctionObject::read(dict);
    logFiles::read(dict);
    writePrecision_ = dict.lookupOrDefault<label>("writePrecision", 10);
    about_ = dict.lookupOrDefault<point>("CofR", Zero);

    resetNames(shell().reactionNames());
    if (Pstream::master())
    {
        forAll(names(), i)
        {
            OFstream& os = files(i);
            writeHeader(os, "Forces [N] of " + names()[i] + " on the shell");
            writeHeaderValue(os, "CofR", about_);
            writeCommented(os, "Time");
            for (const char* quantity : {"force", "moment"})
            {
                for (const char axis : {'x', 'y', 'z'})
                {
                    writeTabbed(os, word(quantity) + '_' + axis);
                }
            }
            os  << endl;
        }
    }
    return true;
}


bool Foam::functionObjects::shellReactionTable::write()
{
    if (!Pstream::master())
    {
        return true;
    }

    label i = 0;
    for (const shellReaction& reaction : shell().reactions(about_))
    {
        OFstream& os = files(i++);
        os  << setw(charWidth()) << time_.value();
        for (const vector& v : {reaction.force, reaction.moment})
        {
            for (direction d = 0; d < vector::nComponents; ++d)
            {
                os  << tab << setw(charWidth()) << v[d];
            }
        }
        os  << endl;
    }
    return true;
}
