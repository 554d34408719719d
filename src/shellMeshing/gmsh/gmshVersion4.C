/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gmshFile.H"
#include "gmshStream.H"

bool Foam::gmshFile::readSection4
(
    gmshStream& is,
    const std::string& section
)
{
    const bool known =
        section == "Entities" || section == "Nodes" || section == "Elements";

    if (known && is.binary())
    {
        is.endLine();  // Numbers follow at once
    }

    if (section == "Entities")
    {
        readEntities4(is);
    }
    if (section == "Nodes")
    {
        readNodes4(is);
    }
    if (section == "Elements")
    {
        readElements4(is);
    }
    return known;
}


// Of each entity: tag, bounding box (points: position), groups, boundary
void Foam::gmshFile::readEntities4(gmshStream& is)
{
    label n[4];
    for (label& count : n)
    {
        count = is.size();
    }
    for (label dimension = 0; dimension < 4; ++dimension)
    {
        for (label i = 0; i < n[dimension]; ++i)
        {
            const label tag = is.integer();
            const label nReals = dimension == 0 ? 3 : 6;
            for (label real = 0; real < nReals; ++real)
            {
                is.number();
            }
            const label nGroups = is.size();
            for (label group = 0; group < nGroups; ++group)
            {
                entityGroups_[{dimension, tag}].insert(is.integer());
            }
            const label nBounds = dimension == 0 ? 0 : is.size();
            for (label bound = 0; bound < nBounds; ++bound)
            {
                is.integer();
            }
        }
    }
    is.endSection();
}


void Foam::gmshFile::readNodes4(gmshStream& is)
{
    const label nBlocks = is.size();
    for (label skipped = 0; skipped < 3; ++skipped)
    {
        is.size();  // Number of nodes, smallest and largest tag
    }
    for (label block = 0; block < nBlocks; ++block)
    {
        const label dimension = is.integer();
        is.integer();
        const bool parametric = is.integer();
        const label n = is.size();

        if (n < 0 || dimension < 0 || dimension > 3)
        {
            is.fail("the header of a block of nodes is wrong");
        }
        DynamicList<label> tags;
        for (label i = 0; i < n; ++i)
        {
            tags.append(is.size());
        }
        for (const label tag : tags)
        {
            const scalar x = is.number();
            const scalar y = is.number();
            const scalar z = is.number();
            for (label i = 0; parametric && i < dimension; ++i)
            {
                is.number();
            }
            addNode(is, tag, point(x, y, z));
        }
    }
    is.endSection();
}


void Foam::gmshFile::readElements4(gmshStream& is)
{
    const label nBlocks = is.size();
    for (label skipped = 0; skipped < 3; ++skipped)
    {
        is.size();  // Number of elements, smallest and largest tag
    }
    for (label block = 0; block < nBlocks; ++block)
    {
        const label dimension = is.integer();
        const label entity = is.integer();
        const label type = is.integer();
        const label n = is.size();

        for (label i = 0; i < n; ++i)
        {
            const label number = is.size();
            const gmshElementType* shape = usable(is, type, number);

            const auto groups = entityGroups_.find({dimension, entity});
            gmshElement element{number, entity, shape, {}, {}};
            if (groups != entityGroups_.end())
            {
                element.groups = groups->second;
            }
            addElement(is, std::move(element), true);
        }
    }
    is.endSection();
}
