/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    setPointFields

Description
    Sets initial values of point fields: values in regions of the mesh, in
    setFields' own form, and states of gas.

    system/setPointFieldsDict, every entry optional, applied in this order:

    \verbatim
    defaultFieldValues
    (
        pointScalarFieldValue p 1e5
        pointScalarFieldValue T 293
        pointVectorFieldValue U (0 0 0)
    );
    regions
    (
        boxToPoint
        {
            box (-10 -1 -1) (-0.02 1 1);
            fieldValues ( pointScalarFieldValue T 400 );
        }
    );
    states
    (
        sphericalCharge
        {
            centre  (0 0 0);
            radius  0.5;
            p       2967e3;
            T       1134.85;
        }
    );
    \endverbatim

    Regions are topoSet sources: of points (boxToPoint, sphereToPoint,
    cylinderToPoint, ...), or of cells (boxToCell, ...), whose points are set.
    States set p, U and T together for the gas of
    constant/thermophysicalProperties: planarShock, sphericalCharge and
    mappedProfile, see initialState.H.

    The fields are read from and written to the start time. Values of patches
    (farField, fixedValue) are left as they are. With -parallel, points that
    processors share get the same values.
*/
#include "argList.H"
#include "Time.H"
#include "dictionaryCheck.H"
#include "entryList.H"
#include "fieldValues.H"
#include "regionPoints.H"
#include "setStates.H"

using namespace Foam;

namespace
{

void setRegions
(
    const polyMesh& mesh,
    const dictionary& dict,
    const word& keyword
)
{
    const PtrList<entry> regions(readEntryList(dict, keyword));
    for (const entry& region : regions)
    {
        Info<< "Region " << region.keyword() << endl;
        const labelList points
        (
            regionPoints(mesh, region.keyword(), region.dict())
        );
        setFieldValues(mesh, region.dict(), "fieldValues", &points);
    }
}

} // End namespace


int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Set point fields: values in regions, and states of gas"
    );
    argList::noFunctionObjects();
    #include "addDictOption.H"

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

    const word dictName("setPointFieldsDict");
    #include "setSystemMeshDictionaryIO.H"
    const IOdictionary dict(dictIO);
    checkKeywords(dict, {"defaultFieldValues", "regions", "states"});

    if (dict.found("defaultFieldValues"))
    {
        Info<< "Default values" << endl;
        setFieldValues(mesh, dict, "defaultFieldValues", nullptr);
    }
    if (dict.found("regions"))
    {
        setRegions(mesh, dict, "regions");
    }
    if (dict.found("states"))
    {
        setStates(mesh, dict, "states");
    }
    writeCasePointFields(mesh);

    Info<< nl << "End" << nl << endl;

    return 0;
}
