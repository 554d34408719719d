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
using positionalShell::ResultPoints;

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


//- In double precision. The formatter itself rounds numbers to single
//  precision, but passes bytes on as they are
static void writeArray(vtk::formatter& format, const shellResultArray& array)
{
    format.openDataArray<double>(array.name);
    if (array.nComponents > 1)
    {
        format.xmlAttr
        (
            vtk::fileAttr::NUMBER_OF_COMPONENTS, array.nComponents
        );
    }
    format.closeTag();
    format.writeSize(array.values.byteSize());

    const auto* bytes =
        reinterpret_cast<const uint8_t*>(array.values.cdata());
    for (std::streamsize i = 0; i < array.values.byteSize(); ++i)
    {
        format.write(bytes[i]);
    }
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
    const ResultPoints& points,
    const label nElements
)
{
    labelList nodes(nodesPerElement*nElements);
    labelList offsets(nElements);
    forAll(offsets, elementi)
    {
        const auto& triangle = points.ofElement(elementi);
        std::copy
        (
            triangle.begin(),
            triangle.end(),
            nodes.begin() + nodesPerElement*elementi
        );
        offsets[elementi] = nodesPerElement*(elementi + 1);
    }
    const List<uint8_t> types(nElements, lagrangeTriangle);

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


//- Values of the nodes at the points
static vectorField atPoints
(
    const ResultPoints& points,
    const positionalShell::Vector& full,
    const Component first
)
{
    const vectorField values(nodeVectors(full, first));
    vectorField result(points.size());
    forAll(result, pointi)
    {
        result[pointi] = values[points.node(pointi)];
    }
    return result;
}

} // End namespace Foam


Foam::scalarField Foam::shellVTK::thickness
(
    const positionalShell::Vector& position
) const
{
    const ResultPoints& points = results_.points();

    scalarField result
    (
        mag(atPoints(points, position, Component::gx))
    );
    scalarField initial(points.size());
    for (label elementi = 0; elementi < model_.mesh().nElements(); ++elementi)
    {
        for (const int point : points.ofElement(elementi))
        {
            initial[point] = model_.thickness(elementi);
        }
    }
    return initial*result;
}


void Foam::shellVTK::writeGrid
(
    const fileName& path,
    const positionalShell::ShellState& state,
    const std::vector<shellResultArray>& more
) const
{
    const ResultPoints& points = results_.points();
    const label nElements = model_.mesh().nElements();
    const vectorField places(atPoints(points, state.position, Component::x));
    const vectorField initial
    (
        atPoints(points, model_.mesh().initialPositions(), Component::x)
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
        .xmlAttr(vtk::fileAttr::NUMBER_OF_POINTS, label(points.size()))
        .xmlAttr(vtk::fileAttr::NUMBER_OF_CELLS, nElements)
        .closeTag();

    f.tag(vtk::fileTag::POINTS);
    writeField(f, vtk::dataArrayAttrNames[vtk::dataArrayAttr::POINTS], places);
    f.endTag(vtk::fileTag::POINTS);

    writeCells(f, points, nElements);

    f.beginPointData();
    writeField(f, "displacement", vectorField(places - initial));
    writeField
    (
        f, "velocity", atPoints(points, state.velocity, Component::x)
    );
    writeField
    (
        f, "director", atPoints(points, state.position, Component::gx)
    );
    writeField(f, "thickness", thickness(state.position));
    for (const shellResultArray& array : results_.at(state.position))
    {
        writeArray(f, array);
    }
    for (const shellResultArray& array : more)
    {
        writeArray(f, array);
    }
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
    const word& name,
    shellResultFields results
)
:
    runTime_(runTime),
    model_(model),
    name_(name),
    results_(std::move(results)),
    series_
    (
        runTime.globalPath()/"VTK"/(name + ".pvd"),
        runTime.startTime().value()
    )
{}


void Foam::shellVTK::write
(
    const positionalShell::ShellState& state,
    const label index,
    const std::vector<shellResultArray>& more
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
    writeGrid(folder/file, state, more);
    series_.add(state.time, file);
}
