/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    setPointFields

Description
    Sets values of point fields in regions of the mesh: setFields for fields on
    points. Reads system/setPointFieldsDict in setFields' own form, with the
    topoSet sources that select points:

    \verbatim
    defaultFieldValues
    (
        pointScalarFieldValue p 1e5
        pointVectorFieldValue U (0 0 0)
    );
    regions
    (
        boxToPoint
        {
            box (-10 -1 -1) (-0.02 1 1);
            fieldValues ( pointScalarFieldValue p 154145 );
        }
    );
    \endverbatim

    The fields are read from and written to the start time.
*/
#include "argList.H"
#include "Time.H"
#include "polyMesh.H"
#include "pointFields.H"
#include "pointSet.H"
#include "topoSetSource.H"
#include "dictionaryCheck.H"

using namespace Foam;

//- Set one field's values at the given points; a null list means all
template<class Type>
void setValues
(
    const polyMesh& mesh,
    const word& fieldName,
    const Type& value,
    const labelList* points
)
{
    using FieldType = GeometricField<Type, pointPatchField, pointMesh>;

    FieldType field
    (
        IOobject
        (
            fieldName,
            mesh.time().timeName(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        ),
        pointMesh::New(mesh)
    );

    Info<< "    " << fieldName << " = " << value << " at "
        << (points ? points->size() : field.size()) << " points" << endl;

    if (points)
    {
        UIndirectList<Type>(field.primitiveFieldRef(), *points) = value;
    }
    else
    {
        field.primitiveFieldRef() = value;
    }
    field.write();
}


//- Read and apply a list of "type name value"
void applyValues
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
        const word type(t.wordToken());
        const word fieldName(is);

        if (type == "pointScalarFieldValue")
        {
            setValues(mesh, fieldName, readScalar(is), points);
        }
        else if (type == "pointVectorFieldValue")
        {
            setValues(mesh, fieldName, vector(is), points);
        }
        else
        {
            FatalIOErrorInFunction(is)
                << "Unknown kind of value " << type << nl
                << "    Valid kinds are "
                << "(pointScalarFieldValue pointVectorFieldValue)"
                << exit(FatalIOError);
        }
    }
}


int main(int argc, char *argv[])
{
    argList::addNote("Set values of point fields in regions of the mesh");
    argList::noParallel();

    #include "setRootCase.H"
    #include "createTime.H"
    const polyMesh mesh
    (
        IOobject
        (
            polyMesh::defaultRegion,
            runTime.timeName(),
            runTime,
            IOobject::MUST_READ
        )
    );

    const IOdictionary dict
    (
        IOobject
        (
            "setPointFieldsDict",
            runTime.system(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    checkKeywords(dict, {"defaultFieldValues", "regions"});

    if (dict.found("defaultFieldValues"))
    {
        Info<< "Default values" << endl;
        applyValues(mesh, dict, "defaultFieldValues", nullptr);
    }

    const PtrList<entry> regions(dict.lookup("regions"));
    for (const entry& region : regions)
    {
        Info<< "Region " << region.keyword() << endl;
        autoPtr<topoSetSource> source =
            topoSetSource::New(region.keyword(), mesh, region.dict());

        if (source->setType() != topoSetSource::POINTSETSOURCE)
        {
            FatalIOErrorInFunction(region.dict())
                << "The source " << region.keyword()
                << " does not select points" << nl
                << "    Use one such as boxToPoint, sphereToPoint or "
                << "cylinderToPoint" << exit(FatalIOError);
        }

        pointSet selected(mesh, "selected", mesh.nPoints()/10 + 1);
        source->applyToSet(topoSetSource::NEW, selected);
        const labelList points(selected.sortedToc());
        applyValues(mesh, region.dict(), "fieldValues", &points);
    }

    Info<< nl << "End" << nl << endl;

    return 0;
}
