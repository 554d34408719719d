/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "regionPoints.H"
#include "cellSet.H"
#include "pointSet.H"
#include "topoSetSource.H"

Foam::labelList Foam::regionPoints
(
    const polyMesh& mesh,
    const word& source,
    const dictionary& dict
)
{
    autoPtr<topoSetSource> selector =
        topoSetSource::New(source, mesh, dict);

    pointSet points(mesh, "selectedPoints", mesh.nPoints()/10 + 1);

    switch (selector->setType())
    {
        case topoSetSource::POINTSET_SOURCE:
        {
            selector->applyToSet(topoSetSource::NEW, points);
            break;
        }
        case topoSetSource::CELLSET_SOURCE:
        {
            cellSet cells(mesh, "selectedCells", mesh.nCells()/10 + 1);
            selector->applyToSet(topoSetSource::NEW, cells);
            for (const label celli : cells)
            {
                points.insert(mesh.cellPoints(celli));
            }
            break;
        }
        default:
        {
            FatalIOErrorInFunction(dict)
                << "The source " << source
                << " selects neither points nor cells" << nl
                << "    Use a source of points such as boxToPoint, "
                << "sphereToPoint, cylinderToPoint, or of cells such as "
                << "boxToCell" << exit(FatalIOError);
        }
    }
    points.sync(mesh);

    return points.sortedToc();
}
