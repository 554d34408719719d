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


void Foam::functionObjects::shellEnergyTable::writeFileHeader
(
    OFstream& os,
    const string& title,
    const wordList& columns
) const
{
    writeHeader(os, title);
    writeCommented(os, "Time");
    for (const word& column : columns)
    {
        writeTabbed(os, column);
    }
    os  << endl;
}


void Foam::functionObjects::shellEnergyTable::writeRow
(
    OFstream& os,
    const std::initializer_list<scalar>& values
) const
{
    os  << setw(charWidth()) << time_.value();
    for (const scalar value : values)
    {
        os  << tab << setw(charWidth()) << value;
    }
    os  << endl;
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

    resetNames({"energies", "momenta"});
    if (Pstream::master())
    {
        writeFileHeader
        (
            files(0),
            "Energies of the shell [J]",
            {
                "kinetic", "strain", "externalWork", "supportWork",
                "dissipated", "mismatch"
            }
        );
        writeFileHeader
        (
            files(1),
            "Momenta of the shell [kg m/s], [kg m2/s]",
            {
                "linear_x", "linear_y", "linear_z",
                "angular_x", "angular_y", "angular_z"
            }
        );
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
    writeRow
    (
        files(0),
        {
            e.kinetic, e.strain, e.externalWork, e.supportWork, e.dissipated,
            e.mismatch()
        }
    );

    const positionalShell::ShellModel& model = shell().model();
    const positionalShell::ShellState& state = shell().state();
    const positionalShell::Vec3 P(model.linearMomentum(state.velocity));
    const positionalShell::Vec3 L
    (
        model.angularMomentum(state.position, state.velocity)
    );
    writeRow(files(1), {P[0], P[1], P[2], L[0], L[1], L[2]});
    return true;
}
