/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "feMesh.H"
#include "emptyPolyPatch.H"
#include "ListOps.H"

namespace
{

//- Position of the smallest entry
Foam::label smallest(const Foam::labelUList& list)
{
    Foam::label at = 0;
    forAll(list, i)
    {
        if (list[i] < list[at])
        {
            at = i;
        }
    }
    return at;
}

template<int dim>
Foam::scalar signedMeasure
(
    const Foam::feMesh& mesh,
    const Foam::label* corners
)
{
    Foam::simplexVec<dim> x[dim + 1];
    for (int a = 0; a <= dim; ++a)
    {
        x[a] = mesh.components<dim>(mesh.corners()[corners[a]]);
    }
    return Foam::simplex::volume<dim>(Foam::simplex::edges<dim>(x));
}

Foam::scalar signedMeasure(const Foam::feMesh& mesh, const Foam::label* corners)
{
    switch (mesh.dim())
    {
        case 1: return signedMeasure<1>(mesh, corners);
        case 2: return signedMeasure<2>(mesh, corners);
        default: return signedMeasure<3>(mesh, corners);
    }
}

} // End namespace


Foam::labelList Foam::feMesh::faceCorners(const label facei) const
{
    DynamicList<label> nodes(4);
    for (const label pointi : mesh_.faces()[facei])
    {
        const label nodei = cornerOfPoint_[pointi];
        if (!nodes.found(nodei))
        {
            nodes.append(nodei);
        }
    }
    return labelList(std::move(nodes));
}


void Foam::feMesh::splitPolygon
(
    const label celli,
    DynamicList<label>& simplices
) const
{
    // The cell's outline is its face on an empty side
    labelList outline;
    for (const label facei : mesh_.cells()[celli])
    {
        if (mesh_.isInternalFace(facei))
        {
            continue;
        }
        const label patchi = mesh_.boundaryMesh().whichPatch(facei);
        const labelList nodes(faceCorners(facei));
        if
        (
            nodes.size() > 2
         && isA<emptyPolyPatch>(mesh_.boundaryMesh()[patchi])
        )
        {
            outline = nodes;
            break;
        }
    }

    const label n = outline.size();
    if (n < 3)
    {
        FatalErrorInFunction
            << "Cell " << celli << " at " << mesh_.cellCentres()[celli]
            << " has no face on an empty patch" << exit(FatalError);
    }

    const label start = smallest(outline);
    for (label i = 1; i + 1 < n; ++i)
    {
        simplices.append(outline[start]);
        simplices.append(outline[(start + i) % n]);
        simplices.append(outline[(start + i + 1) % n]);
    }
}


void Foam::feMesh::splitPolyhedron
(
    const label celli,
    DynamicList<label>& simplices
) const
{
    const cell& faces = mesh_.cells()[celli];
    label apex = labelMax;
    for (const label facei : faces)
    {
        for (const label pointi : mesh_.faces()[facei])
        {
            apex = min(apex, cornerOfPoint_[pointi]);
        }
    }

    for (const label facei : faces)
    {
        labelList nodes(faceCorners(facei));
        if (nodes.found(apex))
        {
            continue;
        }
        if (mesh_.faceOwner()[facei] != celli)
        {
            reverse(nodes);
        }
        const label n = nodes.size();
        const label start = smallest(nodes);
        for (label i = 1; i + 1 < n; ++i)
        {
            simplices.append(apex);
            simplices.append(nodes[start]);
            simplices.append(nodes[(start + i) % n]);
            simplices.append(nodes[(start + i + 1) % n]);
        }
    }
}


void Foam::feMesh::orient
(
    const label celli,
    DynamicList<label>& simplices,
    label start
) const
{
    const label stride = dim_ + 1;
    scalar sum = 0;
    for (label i = start; i < simplices.size(); i += stride)
    {
        sum += signedMeasure(*this, &simplices[i]);
    }

    // All simplices of a cell have the same sense by construction; one of the
    // other sense leaves the cell or overlaps with its neighbours. In space
    // it must be the positive one, elsewhere it is that of the empty side.
    const scalar sense = (dim_ < 3 && sum < 0 ? -1 : 1);

    for (label i = start; i < simplices.size(); i += stride)
    {
        const scalar measure = sense*signedMeasure(*this, &simplices[i]);
        if (!(measure > 1e-12*mag(sum)))
        {
            FatalErrorInFunction
                << "Cell " << celli << " at " << mesh_.cellCentres()[celli]
                << " cannot be split into positive simplices on its own "
                << "points:" << nl << "    its volume is " << depth_*mag(sum)
                << " m3, one of its simplices has " << depth_*measure << nl
                << "    Run checkMesh; the cell is concave or degenerate"
                << exit(FatalError);
        }
        if (sense < 0)
        {
            std::swap(simplices[i + dim_ - 1], simplices[i + dim_]);
        }
    }
}


void Foam::feMesh::splitCells()
{
    DynamicList<label> simplices((dim_ == 3 ? 24 : 6)*mesh_.nCells());
    DynamicList<label> cells(simplices.capacity()/(dim_ + 1));

    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        const label start = simplices.size();
        if (dim_ == 3)
        {
            splitPolyhedron(celli, simplices);
        }
        else if (dim_ == 2)
        {
            splitPolygon(celli, simplices);
        }
        else
        {
            for (const label pointi : mesh_.cellPoints(celli))
            {
                const label nodei = cornerOfPoint_[pointi];
                bool isNew = true;
                for (label i = start; i < simplices.size(); ++i)
                {
                    isNew = isNew && simplices[i] != nodei;
                }
                if (isNew)
                {
                    simplices.append(nodei);
                }
            }
        }
        orient(celli, simplices, start);

        while (cells.size()*(dim_ + 1) < simplices.size())
        {
            cells.append(celli);
        }
    }

    simplexCorners_.transfer(simplices);
    cellOfSimplex_.transfer(cells);
}
