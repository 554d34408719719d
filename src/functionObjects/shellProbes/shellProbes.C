/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellProbes.H"
#include "addToRunTimeSelectionTable.H"
#include "registeredShell.H"
#include "shellResultFields.H"
#include "shellVector.H"
#include "CubicTriangle.hpp"

using positionalShell::MotionMap;

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(shellProbes, 0);
    addToRunTimeSelectionTable(functionObject, shellProbes, dictionary);
}
}

namespace
{

const Foam::wordList motionFields
({
    "position", "displacement", "velocity", "acceleration"
});

//- Suffixes of the columns of a result array
Foam::wordList componentsOf(const Foam::shellResultArray& array)
{
    if (array.name == "shearForce")
    {
        return {"_1", "_2"};
    }
    switch (array.nComponents)
    {
        case 1: return {""};
        case 3: return {"_x", "_y", "_z"};
        case 4: return {"_11", "_22", "_12", "_21"};
        default: return {"_xx", "_yy", "_zz", "_xy", "_yz", "_xz"};
    }
}

} // End namespace


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
    const word& field,
    const wordList& components
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
        for (const word& component : components)
        {
            word column(field + component);
            if (nPoints > 1)
            {
                column += '_' + Foam::name(i);
            }
            writeTabbed(os, column);
        }
    }
    os  << endl;
}


Foam::wordList Foam::functionObjects::shellProbes::setResults
(
    const dictionary& dict,
    const wordList& fields
)
{
    wordList valid(motionFields);
    valid.append(shellResultFields::validFields());
    wordList results;
    motions_.clear();
    for (const word& field : fields)
    {
        if (!valid.found(field))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown field " << field << nl
                << "    Valid fields are " << flatOutput(valid) << nl
                << exit(FatalIOError);
        }
        (motionFields.found(field) ? motions_ : results).append(field);
    }

    wordList names(motions_);
    results_.reset();
    if (results.size())
    {
        dictionary options(shell().properties().subOrEmptyDict("results"));
        options.set("fields", results);
        results_.reset(new shellResultFields(options, shell().model()));
        for (const auto& array : results_->at(shell().state().position))
        {
            names.append(array.name);
        }
    }
    return names;
}


Foam::scalarList Foam::functionObjects::shellProbes::valuesOf
(
    const shellResultArray& array
) const
{
    const label n = array.nComponents;
    scalarList values(n*places_.size(), Zero);
    label next = 0;
    for (const positionalShell::SurfacePoint& place : places_)
    {
        const auto& points = results_->points().ofElement(place.element);
        const auto weights =
            positionalShell::CubicTriangle::values(place.xi1, place.xi2);
        for (int j = 0; j < positionalShell::nodesPerElement; ++j)
        {
            for (label k = 0; k < n; ++k)
            {
                values[next + k] += weights[j]*array.values[n*points[j] + k];
            }
        }
        next += n;
    }
    return values;
}


void Foam::functionObjects::shellProbes::writeRow
(
    OFstream& os,
    const scalarList& values
) const
{
    os  << setw(charWidth()) << time_.value();
    for (const scalar value : values)
    {
        os  << tab << setw(charWidth()) << value;
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


// Here, where the result fields are known
Foam::functionObjects::shellProbes::~shellProbes() = default;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::shellProbes::read(const dictionary& dict)
{
    timeFunctionObject::read(dict);
    logFiles::read(dict);

    // Six digits are too few for the small motion of a stiff shell
    writePrecision_ = dict.lookupOrDefault<label>("writePrecision", 10);

    points_ = dict.get<pointField>("points");
    const wordList columns
    (
        setResults(dict, dict.get<wordList>("fields"))
    );
    locate(dict);

    resetNames(columns);
    if (!Pstream::master())
    {
        return true;
    }
    forAll(motions_, i)
    {
        writeFileHeader(files(i), motions_[i], {"_x", "_y", "_z"});
    }
    if (results_)
    {
        label i = motions_.size();
        for (const auto& array : results_->at(shell().state().position))
        {
            writeFileHeader(files(i++), array.name, componentsOf(array));
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

    forAll(motions_, i)
    {
        DynamicList<scalar> values;
        for (const positionalShell::SurfacePoint& place : places_)
        {
            const vector v(value(motions_[i], place));
            values.append(scalarList({v.x(), v.y(), v.z()}));
        }
        writeRow(files(i), values);
    }
    if (results_)
    {
        label i = motions_.size();
        for (const auto& array : results_->at(shell().state().position))
        {
            writeRow(files(i++), valuesOf(array));
        }
    }
    return true;
}
