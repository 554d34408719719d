/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellProbes.H"
#include "addToRunTimeSelectionTable.H"
#include "registeredShell.H"
#include "shellVector.H"

using positionalShell::MotionMap;

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(shellProbes, 0);
    addToRunTimeSelectionTable(functionObject, shellProbes, dictionary);
}
}

static const Foam::wordList validFields
({
    "position", "displacement", "velocity", "acceleration"
});


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::shellModel& Foam::functionObjects::shellProbes::shell() const
{
    return registeredShell(time_, name(), typeName);
}


void Foam::functionObjects::shellProbes::locate(const dictionary& dict)
{
    const positionalShell::SurfaceLocator locator(shell().model());

    places_.clear();
    Info<< type() << " " << name() << nl;

    for (const point& p : points_)
    {
        const positionalShell::Projection found = locator.locate(toShell(p));
        const scalar thickness = shell().thickness(found.point.element);

        if (found.distance > thickness)
        {
            FatalIOErrorInFunction(dict)
                << "Point " << p << " is " << scalar(found.distance)
                << " m away from the shell, more than its thickness of "
                << thickness << " m" << nl << exit(FatalIOError);
        }

        Info<< "    " << p << " in triangle " << label(found.point.element)
            << ", " << scalar(found.distance) << " m from the mid-surface"
            << nl;
        places_.push_back(found.point);
    }
    Info<< endl;
}


void Foam::functionObjects::shellProbes::writeFileHeader
(
    OFstream& os,
    const word& field
) const
{
    const label nPoints = points_.size();

    writeHeader(os, "Shell " + field + " in SI units");
    forAll(points_, i)
    {
        os  << "# Point " << i << "  " << points_[i] << nl;
    }

    writeCommented(os, "Time");
    forAll(points_, i)
    {
        for (const char axis : {'x', 'y', 'z'})
        {
            word column(field + '_' + axis);
            if (nPoints > 1)
            {
                column += '_' + Foam::name(i);
            }
            writeTabbed(os, column);
        }
    }
    os  << endl;
}


Foam::vector Foam::functionObjects::shellProbes::value
(
    const word& field,
    const positionalShell::SurfacePoint& place
) const
{
    const MotionMap map(shell().model());
    const positionalShell::ShellState& state = shell().state();

    if (field == "position")
    {
        return toFoam(map.position(place, state.position));
    }
    if (field == "displacement")
    {
        return toFoam
        (
            map.position(place, state.position)
          - map.position(place, shell().mesh().initialPositions())
        );
    }
    if (field == "velocity")
    {
        return toFoam(map.velocity(place, state.velocity));
    }
    return toFoam(map.velocity(place, state.acceleration));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::shellProbes::shellProbes
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

bool Foam::functionObjects::shellProbes::read(const dictionary& dict)
{
    timeFunctionObject::read(dict);
    logFiles::read(dict);

    // Six digits are too few for the small motion of a stiff shell
    writePrecision_ = dict.lookupOrDefault<label>("writePrecision", 10);

    points_ = dict.get<pointField>("points");
    const wordList fields(dict.get<wordList>("fields"));
    for (const word& field : fields)
    {
        if (!validFields.found(field))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown field " << field << nl
                << "    Valid fields are " << flatOutput(validFields) << nl
                << exit(FatalIOError);
        }
    }
    locate(dict);

    resetNames(fields);
    if (Pstream::master())
    {
        forAll(names(), i)
        {
            writeFileHeader(files(i), names()[i]);
        }
    }
    return true;
}


bool Foam::functionObjects::shellProbes::execute()
{
    return true;
}


bool Foam::functionObjects::shellProbes::write()
{
    if (!Pstream::master())
    {
        return true;
    }

    forAll(names(), i)
    {
        OFstream& os = files(i);
        os  << setw(charWidth()) << time_.value();

        for (const positionalShell::SurfacePoint& place : places_)
        {
            const vector v(value(names()[i], place));
            for (direction d = 0; d < vector::nComponents; ++d)
            {
                os  << tab << setw(charWidth()) << v[d];
            }
        }
        os  << endl;
    }
    return true;
}
