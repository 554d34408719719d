/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "fieldValues.H"
#include "syncTools.H"
#include "FlatOutput.H"

namespace Foam
{

template<class Type>
using pointFieldType = GeometricField<Type, pointPatchField, pointMesh>;

//- pointScalarFieldValue and so on
template<class Type>
word kindOf()
{
    return pointFieldType<Type>::typeName + "Value";
}


//- Number of these points, shared ones counted once
label countPoints(const polyMesh& mesh, const labelList* points)
{
    const auto master = syncTools::getMasterPoints(mesh);
    label n = 0;
    if (points)
    {
        for (const label pointi : *points)
        {
            n += master[pointi];
        }
    }
    else
    {
        n = master.count();
    }
    return returnReduce(n, sumOp<label>());
}


//- Read name and value and set them if the kind is of this type
template<class Type>
bool setValue
(
    const polyMesh& mesh,
    const word& kind,
    Istream& is,
    const labelList* points
)
{
    if (kind != kindOf<Type>())
    {
        return false;
    }
    const word name(is);
    const Type value = pTraits<Type>(is);
    auto& field = casePointField<Type>(mesh, name);

    Info<< "    " << name << " = " << value << " at "
        << countPoints(mesh, points) << " points" << endl;

    if (points)
    {
        UIndirectList<Type>(field.primitiveFieldRef(), *points) = value;
    }
    else
    {
        field.primitiveFieldRef() = value;
    }
    return true;
}


template<class Type>
void writeFields(const polyMesh& mesh)
{
    for (const word& name : mesh.sortedNames<pointFieldType<Type>>())
    {
        if (!mesh.lookupObject<pointFieldType<Type>>(name).write())
        {
            FatalErrorInFunction
                << "Could not write the field " << name << exit(FatalError);
        }
    }
}

} // End namespace Foam


template<class Type>
Foam::GeometricField<Type, Foam::pointPatchField, Foam::pointMesh>&
Foam::casePointField(const polyMesh& mesh, const word& name)
{
    using FieldType = pointFieldType<Type>;

    if (!mesh.foundObject<FieldType>(name))
    {
        regIOobject::store
        (
            new FieldType
            (
                IOobject
                (
                    name,
                    mesh.time().timeName(),
                    mesh,
                    IOobject::MUST_READ,
                    IOobject::NO_WRITE
                ),
                pointMesh::New(mesh)
            )
        );
    }
    return mesh.lookupObjectRef<FieldType>(name);
}


void Foam::setFieldValues
(
    const polyMesh& mesh,
    const dictionary& dict,
    const word& keyword,
    const labelList* points
)
{
    ITstream& is = dict.lookup(keyword);
    is.readBegin("values");

    for (token t(is); !t.isPunctuation(); is >> t)
    {
        if (!t.isWord())
        {
            FatalIOErrorInFunction(is)
                << "Expected a kind of value such as "
                << kindOf<scalar>() << ", but found " << t
                << exit(FatalIOError);
        }
        const word kind(t.wordToken());
        const bool known =
            setValue<scalar>(mesh, kind, is, points)
         || setValue<vector>(mesh, kind, is, points)
         || setValue<sphericalTensor>(mesh, kind, is, points)
         || setValue<symmTensor>(mesh, kind, is, points)
         || setValue<tensor>(mesh, kind, is, points);

        if (!known)
        {
            FatalIOErrorInFunction(is)
                << "Unknown kind of value " << kind << nl
                << "    Valid kinds are " << flatOutput
                (
                    wordList
                    ({
                        kindOf<scalar>(),
                        kindOf<vector>(),
                        kindOf<sphericalTensor>(),
                        kindOf<symmTensor>(),
                        kindOf<tensor>()
                    })
                )
                << exit(FatalIOError);
        }
    }
}


void Foam::writeCasePointFields(const polyMesh& mesh)
{
    writeFields<scalar>(mesh);
    writeFields<vector>(mesh);
    writeFields<sphericalTensor>(mesh);
    writeFields<symmTensor>(mesh);
    writeFields<tensor>(mesh);
}


template Foam::pointScalarField& Foam::casePointField<Foam::scalar>
(
    const polyMesh&, const word&
);

template Foam::pointVectorField& Foam::casePointField<Foam::vector>
(
    const polyMesh&, const word&
);
