/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gmshFile.H"
#include "gmshStream.H"
#include "error.H"

Foam::gmshFile::gmshFile(const fileName& path)
:
    path_(path)
{
    gmshStream is(path);

    if (is.nextSection() != "MeshFormat")
    {
        is.fail("this is no gmsh file: it must start with $MeshFormat");
    }
    readFormat(is);

    for
    (
        std::string section(is.nextSection());
        !section.empty();
        section = is.nextSection()
    )
    {
        if (section == "PhysicalNames")
        {
            readPhysicalNames(is);
        }
        else if (section == "PartitionedEntities")
        {
            is.fail
            (
                "the mesh is partitioned; save it without partitions"
                " (Mesh.NbPartitions = 0, or Unpartition)"
            );
        }
        else if
        (
            version_ < 3 ? !readSection2(is, section)
                         : !readSection4(is, section)
        )
        {
            is.skipSection();
        }
    }

    if (points_.empty() || elements_.empty())
    {
        is.fail
        (
            "the file ends without $Nodes or $Elements: it is truncated, or"
            " saved before meshing (gmsh -2)"
        );
    }
}


void Foam::gmshFile::readFormat(gmshStream& is)
{
    version_ = is.textNumber();
    binary_ = is.textInteger() == 1;
    const label realSize = is.textInteger();

    if (mag(version_ - 2.2) > SMALL && mag(version_ - 4.1) > SMALL)
    {
        std::ostringstream version;
        version << version_;
        is.fail
        (
            "format version " + version.str() + " is not supported; save as"
            " 2.2 or 4.1 (gmsh -format msh22 or msh41)"
        );
    }
    if (realSize != 8)
    {
        is.fail
        (
            "numbers of " + std::to_string(realSize)
          + " bytes are not supported; 8 are"
        );
    }

    if (binary_)
    {
        is.endLine();
        is.setBinary();
        if (is.integer() != 1)
        {
            is.fail
            (
                "the file was written on a machine with another order of"
                " bytes; save it in ASCII (Mesh.Binary = 0)"
            );
        }
    }
    is.endSection();
}


void Foam::gmshFile::readPhysicalNames(gmshStream& is)
{
    const label n = is.textInteger();
    for (label i = 0; i < n; ++i)
    {
        const label dimension = is.textInteger();
        const label group = is.textInteger();
        groupNames_[{dimension, group}] = is.quoted();
    }
    is.endSection();
}


void Foam::gmshFile::addNode
(
    const gmshStream& is,
    const label number,
    const point& position
)
{
    if (!indexOf_.insert(number, points_.size()))
    {
        is.fail
        (
            "node " + std::to_string(number)
          + " occurs twice; renumber the mesh (RenumberMeshNodes;)"
        );
    }
    for (const scalar x : position)
    {
        if (!std::isfinite(x))
        {
            is.fail
            (
                "node " + std::to_string(number)
              + " has a coordinate that is not finite"
            );
        }
    }
    points_.append(position);
    numbers_.append(number);
}


const Foam::gmshElementType* Foam::gmshFile::usable
(
    const gmshStream& is,
    const label type,
    const label number
) const
{
    const gmshElementType* found = gmshElementType::find(type);
    if (!found)
    {
        is.fail
        (
            "element " + std::to_string(number) + " (type "
          + std::to_string(type) + ") is " + gmshElementType::unusable(type)
        );
    }
    return found;
}


void Foam::gmshFile::addElement
(
    gmshStream& is,
    gmshElement&& element,
    const bool wide
)
{
    element.nodes.setSize(element.type->nNodes);
    for (label& node : element.nodes)
    {
        const label number = wide ? is.size() : is.integer();
        const auto index = indexOf_.cfind(number);
        if (!index.found())
        {
            is.fail
            (
                "element " + std::to_string(element.number) + " has node "
              + std::to_string(number) + ", which the file does not hold"
            );
        }
        node = *index;
    }
    elements_.push_back(std::move(element));
}
