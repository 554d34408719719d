/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellVTK.H"
#include "shellVector.H"
#include "OSspecific.H"
#include "foamVtkOutput.H"

#include <fstream>

using positionalShell::Component;
using positionalShell::nodesPerElement;

namespace Foam
{

//- Cell type of VTK's Lagrange triangle; v1912's vtk::cellType has none
constexpr uint8_t lagrangeTriangle = 69;


template<class Type>
static void writeField
(
    vtk::formatter& format,
    const word& name,
    const Field<Type>& values
)
{
    format.beginDataArray<float, pTraits<Type>::nComponents>(name);
    format.writeSize
    (
        vtk::sizeofData<float, pTraits<Type>::nComponents>(values.size())
    );
    vtk::writeList(format, values);
    format.flush();
    format.endDataArray();
}


static void writeLabels
(
    vtk::formatter& format,
    const vtk::dataArrayAttr name,
    const labelList& values
)
{
    format.beginDataArray<label>(name);
    format.writeSize(vtk::sizeofData<label>(values.size()));
    vtk::writeList(format, values);
    format.flush();
    format.endDataArray();
}


static void writeCells
(
    vtk::formatter& format,
    const positionalShell::ShellMesh& mesh
)
{
    labelList nodes(nodesPerElement*mesh.nElements());
    labelList offsets(mesh.nElements());
    forAll(offsets, elementi)
    {
        const auto& triangle = mesh.triangle(elementi);
        std::copy
        (
            triangle.begin(),
            triangle.end(),
            nodes.begin() + nodesPerElement*elementi
        );
        offsets[elementi] = nodesPerElement*(elementi + 1);
    }
    const List<uint8_t> types(mesh.nElements(), lagrangeTriangle);

    format.tag(vtk::fileTag::CELLS);
    writeLabels(format, vtk::dataArrayAttr::CONNECTIVITY, nodes);
    writeLabels(format, vtk::dataArrayAttr::OFFSETS, offsets);

    format.beginDataArray<uint8_t>(vtk::dataArrayAttr::TYPES);
    format.writeSize(vtk::sizeofData<uint8_t>(types.size()));
    vtk::writeList(format, types);
    format.flush();
    format.endDataArray();
    format.endTag(vtk::fileTag::CELLS);
}

} // End namespace Foam


Foam::scalarField Foam::shellVTK::thickness
(
    const positionalShell::Vector& position
) const
{
    const positionalShell::ShellMesh& mesh = model_.mesh();

    scalarField sum(mesh.nNodes(), 0);
    scalarField count(mesh.nNodes(), 0);
    for (label elementi = 0; elementi < mesh.nElements(); ++elementi)
    {
        for (const int node : mesh.triangle(elementi))
        {
            sum[node] += model_.thickness(elementi);
            count[node] += 1;
        }
    }
    return sum/count*mag(nodeVectors(position, Component::gx));
}


void Foam::shellVTK::writeGrid
(
    const fileName& path,
    const positionalShell::ShellState& state
) const
{
    const positionalShell::ShellMesh& mesh = model_.mesh();
    const vectorField points(nodeVectors(state.position, Component::x));
    const vectorField initial
    (
        nodeVectors(mesh.initialPositions(), Component::x)
    );

    std::ofstream os(path);
    autoPtr<vtk::formatter> format
    (
        vtk::newFormatter(os, vtk::formatType::INLINE_BASE64)
    );
    vtk::formatter& f = *format;

    f.xmlHeader();
    f.beginVTKFile(vtk::fileTag::UNSTRUCTURED_GRID, word("1.0"));
    f.openTag(vtk::fileTag::PIECE)
        .xmlAttr(vtk::fileAttr::NUMBER_OF_POINTS, label(mesh.nNodes()))
        .xmlAttr(vtk::fileAttr::NUMBER_OF_CELLS, label(mesh.nElements()))
        .closeTag();

    f.tag(vtk::fileTag::POINTS);
    writeField(f, vtk::dataArrayAttrNames[vtk::dataArrayAttr::POINTS], points);
    f.endTag(vtk::fileTag::POINTS);

    writeCells(f, mesh);

    f.beginPointData();
    writeField(f, "displacement", vectorField(points - initial));
    writeField
    (
        f, "velocity", nodeVectors(state.velocity, Component::x)()
    );
    writeField
    (
        f, "director", nodeVectors(state.position, Component::gx)()
    );
    writeField(f, "thickness", thickness(state.position));
    f.endPointData();

    f.endPiece();
    f.endTag(vtk::fileTag::UNSTRUCTURED_GRID);
    f.endVTKFile();

    if (!os.good())
    {
        FatalErrorInFunction << "Cannot write " << path << exit(FatalError);
    }
}


Foam::shellVTK::shellVTK
(
    const Time& runTime,
    const positionalShell::ShellModel& model,
    const word& name
)
:
    runTime_(runTime),
    model_(model),
    name_(name),
    series_
    (
        runTime.globalPath()/"VTK"/(name + ".pvd"),
        runTime.startTime().value()
    )
{}


void Foam::shellVTK::write
(
    const positionalShell::ShellState& state,
    const label index
)
{
    if (!Pstream::master())
    {
        return;
    }

    const fileName file
    (
        name_/(name_ + "_" + Foam::name(index) + ".vtu")
    );
    const fileName folder(runTime_.globalPath()/"VTK");

    mkDir(folder/name_);
    writeGrid(folder/file, state);
    series_.add(state.time, file);
}
