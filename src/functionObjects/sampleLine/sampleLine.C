/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "sampleLine.H"
#include "dictionaryCheck.H"
#include "fvMesh.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(sampleLine, 0);
    addToRunTimeSelectionTable(functionObject, sampleLine, dictionary);
}
}


Foam::functionObjects::sampleLine::sampleLine
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    precision_(10)
{
    read(dict);
    if (time_.timeIndex() == 0)
    {
        write();
    }
}


Foam::pointField Foam::functionObjects::sampleLine::pointsOf
(
    const dictionary& dict
)
{
    checkKeywords(dict, {"start", "end", "nPoints", "points"});
    if (dict.found("points"))
    {
        if (dict.found("start") || dict.found("end"))
        {
            FatalIOErrorInFunction(dict)
                << "A line has either points, or start, end and nPoints"
                << exit(FatalIOError);
        }
        return dict.get<pointField>("points");
    }
    const point start(dict.get<point>("start"));
    const point end(dict.get<point>("end"));
    const label n = dict.get<label>("nPoints");
    if (n < 2)
    {
        FatalIOErrorInFunction(dict)
            << "nPoints is " << n << ", but a line has at least 2 points"
            << exit(FatalIOError);
    }
    pointField points(n);
    forAll(points, i)
    {
        points[i] = start + (scalar(i)/(n - 1))*(end - start);
    }
    return points;
}


bool Foam::functionObjects::sampleLine::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);

    dict.readEntry("fields", fields_);
    nodalPlaces::checkFields(fields_, mesh_, dict);
    precision_ = dict.getOrDefault<label>("writePrecision", 10);

    const dictionary& lines = dict.subDict("lines");
    names_ = lines.toc();
    lines_.clear();
    lines_.setSize(names_.size());
    const feMesh& mesh = feMesh::New(mesh_);
    forAll(names_, i)
    {
        const dictionary& lineDict = lines.subDict(names_[i]);
        lines_.set(i, new nodalPlaces(pointsOf(lineDict)));
        lines_[i].locate(mesh);
        bool isInside = false;
        for (label j = 0; j < lines_[i].size(); ++j)
        {
            isInside = isInside || !lines_[i].outside(j);
        }
        if (!isInside)
        {
            FatalIOErrorInFunction(lineDict)
                << "No point of the line " << names_[i] << " of " << name()
                << " is in the gas mesh, which spans " << mesh_.bounds()
                << exit(FatalIOError);
        }
    }
    if (names_.empty())
    {
        FatalIOErrorInFunction(lines)
            << "No line in the dictionary lines of " << name() << nl
            << "    A line is a dictionary, as floor { start (0 0 0); "
            << "end (1 0 0); nPoints 101; }" << exit(FatalIOError);
    }
    return true;
}


template<class Type>
bool Foam::functionObjects::sampleLine::add
(
    const feMesh& mesh,
    const nodalPlaces& line,
    const word& field,
    wordList& columns,
    List<DynamicList<scalar>>& rows
) const
{
    using FieldType = GeometricField<Type, pointPatchField, pointMesh>;
    const auto* found = mesh_.findObject<FieldType>(field);
    if (!found)
    {
        return false;
    }
    const List<Type> values(line.values(mesh, *found));
    const direction n = pTraits<Type>::nComponents;
    for (direction d = 0; d < n; ++d)
    {
        columns.append
        (
            n == 1
          ? field : word(field + "_" + pTraits<Type>::componentNames[d])
        );
        forAll(values, i)
        {
            rows[i].append(component(values[i], d));
        }
    }
    return true;
}


void Foam::functionObjects::sampleLine::sample
(
    const feMesh& mesh,
    const nodalPlaces& line,
    wordList& columns,
    List<DynamicList<scalar>>& rows
) const
{
    rows.setSize(line.size());
    for (const word& field : fields_)
    {
        add<scalar>(mesh, line, field, columns, rows)
     || add<vector>(mesh, line, field, columns, rows);
    }
}


void Foam::functionObjects::sampleLine::writeLine
(
    const feMesh& mesh,
    const label linei
)
{
    nodalPlaces& line = lines_[linei];
    line.locate(mesh);
    wordList columns;
    List<DynamicList<scalar>> rows;
    sample(mesh, line, columns, rows);
    if (!Pstream::master())
    {
        return;
    }

    const fileName folder
    (
        time_.globalPath()/"postProcessing"/name()/time_.timeName()
    );
    mkDir(folder);
    OFstream os(folder/(names_[linei] + ".csv"));
    os.precision(precision_);
    os  << "distance,x,y,z";
    for (const word& column : columns)
    {
        os  << ',' << column;
    }
    os  << nl;
    scalar distance = 0;
    forAll(rows, i)
    {
        const point& x = line[i];
        distance += i > 0 ? mag(x - line[i - 1]) : 0;
        os  << distance << ',' << x.x() << ',' << x.y() << ',' << x.z();
        for (const scalar value : rows[i])
        {
            os  << ',';
            if (line.outside(i))
            {
                os  << "nan";
            }
            else
            {
                os  << value;
            }
        }
        os  << nl;
    }
}


bool Foam::functionObjects::sampleLine::execute()
{
    return true;
}


bool Foam::functionObjects::sampleLine::write()
{
    const feMesh& mesh = feMesh::New(mesh_);
    forAll(lines_, i)
    {
        writeLine(mesh, i);
    }
    return true;
}
