/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "pointProbes.H"
#include "pointFields.H"
#include "fvMesh.H"
#include "OSspecific.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(pointProbes, 0);
    addToRunTimeSelectionTable(functionObject, pointProbes, dictionary);
}
}


Foam::functionObjects::pointProbes::pointProbes
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    places_(dict.get<pointField>("points"))
{
    read(dict);
}


bool Foam::functionObjects::pointProbes::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);

    places_ = nodalPlaces(dict.get<pointField>("points"));
    dict.readEntry("fields", fields_);
    nodalPlaces::checkFields(fields_, mesh_, dict);

    places_.locate(feMesh::New(mesh_));
    for (label i = 0; i < places_.size(); ++i)
    {
        if (places_.outside(i))
        {
            FatalIOErrorInFunction(dict)
                << "The place " << places_[i] << " of " << name()
                << " is outside the gas mesh, which spans "
                << mesh_.bounds() << exit(FatalIOError);
        }
    }
    openFiles();

    return true;
}


Foam::wordList Foam::functionObjects::pointProbes::columns
(
    const word& field
) const
{
    const bool isVector = mesh_.foundObject<pointVectorField>(field);
    wordList names;
    for (label i = 0; i < places_.size(); ++i)
    {
        if (!isVector)
        {
            names.append(field + "_" + Foam::name(i));
            continue;
        }
        for (const char axis : {'x', 'y', 'z'})
        {
            names.append(field + "_" + axis + "_" + Foam::name(i));
        }
    }
    return names;
}


void Foam::functionObjects::pointProbes::openFiles()
{
    const fileName folder
    (
        time_.globalPath()/"postProcessing"/name()/time_.timeName()
    );
    if (!Pstream::master())
    {
        return;
    }
    mkDir(folder);

    files_.setSize(fields_.size());
    forAll(fields_, fieldi)
    {
        files_.set(fieldi, new OFstream(folder/(fields_[fieldi] + ".dat")));
        OFstream& os = files_[fieldi];
        os.precision(10);
        os  << "# " << fields_[fieldi] << " at points, SI units" << nl;
        for (label i = 0; i < places_.size(); ++i)
        {
            os  << "# point " << i << ": " << places_[i] << nl;
        }
        os  << "# time";
        for (const word& column : columns(fields_[fieldi]))
        {
            os  << ' ' << column;
        }
        os  << endl;
    }
}


template<class Type>
bool Foam::functionObjects::pointProbes::writeRow
(
    const feMesh& mesh,
    const label fieldi
)
{
    using FieldType = GeometricField<Type, pointPatchField, pointMesh>;
    const auto* field = mesh_.findObject<FieldType>(fields_[fieldi]);
    if (!field)
    {
        return false;
    }

    const List<Type> values(places_.values(mesh, *field));
    if (!Pstream::master())
    {
        return true;
    }

    OFstream& os = files_[fieldi];
    os  << time_.value();
    for (label i = 0; i < places_.size(); ++i)
    {
        for (direction d = 0; d < pTraits<Type>::nComponents; ++d)
        {
            if (places_.outside(i))
            {
                os  << " nan";
            }
            else
            {
                os  << ' ' << component(values[i], d);
            }
        }
    }
    os  << endl;
    return true;
}


bool Foam::functionObjects::pointProbes::execute()
{
    const feMesh& mesh = feMesh::New(mesh_);
    places_.locate(mesh);

    forAll(fields_, fieldi)
    {
        writeRow<scalar>(mesh, fieldi) || writeRow<vector>(mesh, fieldi);
    }
    return true;
}


bool Foam::functionObjects::pointProbes::write()
{
    return true;
}
