/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "pointProbes.H"
#include "pointFields.H"
#include "fvMesh.H"
#include "dictionaryCheck.H"
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
    fvMeshFunctionObject(name, runTime, dict)
{
    read(dict);
}


bool Foam::functionObjects::pointProbes::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);

    dict.readEntry("points", places_);
    dict.readEntry("fields", fields_);
    simplices_.setSize(places_.size(), -1);
    weights_.setSize(places_.size());
    holder_.setSize(places_.size(), -1);

    const feMesh& mesh = feMesh::New(mesh_);
    locate(mesh);
    forAll(places_, i)
    {
        if (holder_[i] < 0)
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


void Foam::functionObjects::pointProbes::locate(const feMesh& mesh)
{
    forAll(places_, i)
    {
        // Most often the place is where it was
        bool isThere =
            holder_[i] == Pstream::myProcNo()
         && mesh.inSimplex(simplices_[i], places_[i], weights_[i]);
        reduce(isThere, orOp<bool>());
        if (isThere)
        {
            continue;
        }
        simplices_[i] = mesh.findSimplex(places_[i], weights_[i]);

        // Of several processors at whose boundary it lies the lowest
        label holder = simplices_[i] >= 0 ? Pstream::myProcNo() : labelMax;
        reduce(holder, minOp<label>());
        holder_[i] = holder == labelMax ? -1 : holder;
    }
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
        forAll(places_, i)
        {
            os  << "# point " << i << ": " << places_[i] << nl;
        }
        os  << "# time";
        forAll(places_, i)
        {
            os  << ' ' << fields_[fieldi] << '_' << i;
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

    const label stride = mesh.dim() + 1;
    List<Type> values(places_.size(), Zero);
    forAll(places_, i)
    {
        for (label a = 0; holder_[i] == Pstream::myProcNo() && a < stride; ++a)
        {
            const label node = mesh.simplices()[stride*simplices_[i] + a];
            values[i] += weights_[i][a]*(*field)[mesh.pointOfNode()[node]];
        }
        reduce(values[i], sumOp<Type>());
    }
    if (!Pstream::master())
    {
        return true;
    }

    OFstream& os = files_[fieldi];
    os  << time_.value();
    forAll(places_, i)
    {
        for (direction d = 0; d < pTraits<Type>::nComponents; ++d)
        {
            if (holder_[i] < 0)
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
    locate(mesh);

    forAll(fields_, fieldi)
    {
        if (!writeRow<scalar>(mesh, fieldi) && !writeRow<vector>(mesh, fieldi))
        {
            FatalErrorInFunction
                << "There is no point field " << fields_[fieldi] << nl
                << "    Point fields are "
                << flatOutput(mesh_.sortedNames<pointScalarField>()) << ' '
                << flatOutput(mesh_.sortedNames<pointVectorField>())
                << exit(FatalError);
        }
    }
    return true;
}


bool Foam::functionObjects::pointProbes::write()
{
    return true;
}
