/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "feMesh.H"
#include "globalNodes.H"
#include "nodeParity.H"
#include "faceFans.H"
#include "polygonSplit.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"

namespace
{

//- Cells by their lowest node, so that loops over simplices go through nodes
//  and edges as these are ordered
Foam::labelList cellsByNodes
(
    const Foam::polyMesh& mesh,
    const Foam::labelUList& nodeOfPoint
)
{
    using namespace Foam;
    labelList lowest(mesh.nCells(), labelMax);
    forAll(lowest, celli)
    {
        for (const label facei : mesh.cells()[celli])
        {
            for (const label pointi : mesh.faces()[facei])
            {
                lowest[celli] = min(lowest[celli], nodeOfPoint[pointi]);
            }
        }
    }
    return sortedOrder(lowest);
}

} // End namespace


Foam::labelList Foam::feMesh::faceCorners(const label facei) const
{
    DynamicList<label> corners(4);
    for (const label pointi : mesh_.faces()[facei])
    {
        const label corneri = cornerOfPoint_[pointi];
        if (!corners.found(corneri))
        {
            corners.append(corneri);
        }
    }
    return labelList(std::move(corners));
}


Foam::labelList Foam::feMesh::faceFacets(const label facei) const
{
    const labelList corners(faceCorners(facei));
    if (dim_ < 3)
    {
        return corners;
    }
    const label n = corners.size();
    DynamicList<label> facets(3*(n - 2));
    for (label i = 1; i + 1 < n; ++i)
    {
        for (const label step : {label(0), i, i + 1})
        {
            facets.append(corners[(faceFans_[facei] + step) % n]);
        }
    }
    return labelList(std::move(facets));
}


Foam::labelList Foam::feMesh::segment
(
    const label celli,
    const pointField& x
) const
{
    DynamicList<label> points(2);
    for (const label pointi : mesh_.cellPoints(celli))
    {
        if (!points.found(stationOfPoint_[pointi]))
        {
            points.append(stationOfPoint_[pointi]);
        }
    }
    if (points.size() == 2)
    {
        const direction axis = axes_[0];
        if (x[points[0]][axis] > x[points[1]][axis])
        {
            std::swap(points[0], points[1]);
        }
    }
    return labelList(std::move(points));
}


Foam::labelList Foam::feMesh::outline(const label celli) const
{
    for (const label facei : mesh_.cells()[celli])
    {
        if (mesh_.isInternalFace(facei))
        {
            continue;
        }
        const polyPatch& pp =
            mesh_.boundaryMesh()[mesh_.boundaryMesh().whichPatch(facei)];
        if (!isA<emptyPolyPatch>(pp) && !isA<wedgePolyPatch>(pp))
        {
            continue;
        }
        DynamicList<label> points(4);
        for (const label pointi : mesh_.faces()[facei])
        {
            if (!points.found(stationOfPoint_[pointi]))
            {
                points.append(stationOfPoint_[pointi]);
            }
        }
        if (points.size() > 2)
        {
            return labelList(std::move(points));
        }
    }
    FatalErrorInFunction
        << "Cell " << celli << " at " << mesh_.cellCentres()[celli]
        << " has no face on an empty or wedge patch" << exit(FatalError);
    return labelList();
}


bool Foam::feMesh::splitCell
(
    const label celli,
    const pointField& x,
    polyhedronSplitter& splitter,
    const splitOrder& before,
    DynamicList<label>& points,
    splitKind& kind
) const
{
    if (dim_ == 1)
    {
        kind = untouched;
        const labelList ends(segment(celli, x));
        points.append(ends);
        const direction axis = axes_[0];
        return ends.size() == 2 && x[ends[0]][axis] < x[ends[1]][axis];
    }
    if (dim_ == 2)
    {
        vector normal(Zero);
        normal[3 - axes_[0] - axes_[1]] = (axes_[1] - axes_[0] == 1 ? 1 : -1);
        labelList polygon(outline(celli));
        if ((face(polygon).areaNormal(x) & normal) < 0)
        {
            reverse(polygon);
        }
        return splitPolygon(polygon, x, normal, before, points, kind);
    }

    const cell& faces = mesh_.cells()[celli];
    DynamicList<polyhedronSplitter::triangle> surface;
    bool isHex = (faces.size() == 6);
    for (const label facei : faces)
    {
        const face& f = mesh_.faces()[facei];
        const label n = f.size();
        const label start = faceFans_[facei];
        isHex = isHex && n == 4;
        for (label i = 1; i + 1 < n; ++i)
        {
            label a = f[(start + i) % n], b = f[(start + i + 1) % n];
            if (mesh_.faceOwner()[facei] != celli)
            {
                std::swap(a, b);
            }
            surface.append(polyhedronSplitter::triangle({f[start], a, b}));
        }
    }
    const bool done = splitter.split(surface, isHex, kind);
    for (const auto& tet : splitter.tetrahedra())
    {
        points.append(tet);
    }
    return done;
}


void Foam::feMesh::splitCells()
{
    const splitOrder before
    (
        nodeOfPoint_,
        globalNode_,
        nodeParity(mesh_, nodeOfPoint_, globalNode_, exchange_),
        undecomposedLabels(mesh_)
    );
    if (dim_ == 3)
    {
        faceFans_ = faceFans(mesh_, before);
    }

    const tmp<pointField> tx(scenePositions(mesh_.points()));
    polyhedronSplitter splitter(tx(), before);
    DynamicList<label> corners((dim_ == 3 ? 20 : 6)*mesh_.nCells());
    DynamicList<label> cells(corners.capacity()/(dim_ + 1));
    DynamicList<label> points(24), unsplit;

    for (const label celli : cellsByNodes(mesh_, nodeOfPoint_))
    {
        points.clear();
        splitKind kind(untouched);
        if (!splitCell(celli, tx(), splitter, before, points, kind))
        {
            unsplit.append(celli);
            continue;
        }
        ++splitCounts_[kind];
        for (const label pointi : points)
        {
            corners.append(cornerOfPoint_[pointi]);
        }
        while (cells.size()*(dim_ + 1) < corners.size())
        {
            cells.append(celli);
        }
    }
    sort(unsplit);
    reportUnsplit(unsplit);

    simplexCorners_.transfer(corners);
    cellOfSimplex_.transfer(cells);
}


void Foam::feMesh::reportUnsplit(const labelUList& cells) const
{
    const label total = returnReduce(cells.size(), sumOp<label>());
    if (!total)
    {
        return;
    }

    // The same message from every processor
    const label nShown = 10;
    List<List<Tuple2<label, Tuple2<point, scalar>>>> bad(Pstream::nProcs());
    auto& own = bad[Pstream::myProcNo()];
    own.setSize(min(nShown, cells.size()));
    forAll(own, i)
    {
        const label celli = cells[i];
        own[i].first() = celli;
        own[i].second() =
            {mesh_.cellCentres()[celli], mesh_.cellVolumes()[celli]};
    }
    Pstream::gatherList(bad);
    Pstream::scatterList(bad);

    FatalErrorInFunction
        << total << " cell(s) cannot be split into positive simplices on "
        << "their own points:" << nl;
    label shown = 0;
    forAll(bad, ranki)
    {
        for (const auto& item : bad[ranki])
        {
            if (shown++ < nShown)
            {
                FatalError
                    << "    cell " << item.first();
                if (Pstream::parRun())
                {
                    FatalError << " of processor " << ranki;
                }
                FatalError
                    << " at " << item.second().first() << ", volume "
                    << item.second().second() << " m3" << nl;
            }
        }
    }
    FatalError
        << "    Run checkMesh; such cells are inverted, degenerate or too "
        << "concave" << exit(FatalError);
}
