/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gmshFile.H"
#include "gmshStream.H"

bool Foam::gmshFile::readSection2
(
    gmshStream& is,
    const std::string& section
)
{
    if (section == "ParametricNodes")
    {
        is.fail("save the mesh without parametric coordinates");
    }
    if (section == "Nodes")
    {
        readNodes2(is);
        return true;
    }
    if (section == "Elements")
    {
        readElements2(is);
        return true;
    }
    return false;
}


void Foam::gmshFile::readNodes2(gmshStream& is)
{
    const label n = is.textInteger();
    if (is.binary())
    {
        is.endLine();
    }
    for (label i = 0; i < n; ++i)
    {
        const label number = is.integer();
        const scalar x = is.number();
        const scalar y = is.number();
        const scalar z = is.number();
        addNode(is, number, point(x, y, z));
    }
    is.endSection();
}


// ASCII: number type nTags tags nodes; binary: blocks of the same type, with
// (type nElements nTags) in front and (number tags nodes) for each
void Foam::gmshFile::readElements2(gmshStream& is)
{
    const label n = is.textInteger();
    if (is.binary())
    {
        is.endLine();
    }

    for (label i = 0; i < n; )
    {
        label number = 0;
        label inBlock = 1;

        if (!is.binary())
        {
            number = is.integer();
        }
        const label type = is.integer();
        if (is.binary())
        {
            inBlock = is.integer();
        }
        const label nTags = is.integer();

        if (inBlock < 1 || inBlock > n - i || nTags < 0)
        {
            is.fail
            (
                "the header of a block of elements is wrong: "
              + std::to_string(inBlock) + " elements of type "
              + std::to_string(type) + " with " + std::to_string(nTags)
              + " tags"
            );
        }
        for (label j = 0; j < inBlock; ++j, ++i)
        {
            if (is.binary())
            {
                number = is.integer();
            }
            const gmshElementType* shape = usable(is, type, number);

            labelList tags(nTags);
            for (label& tag : tags)
            {
                tag = is.integer();
            }

            // Tags: group (0: none), geometric entity, then partitions
            gmshElement element{number, nTags > 1 ? tags[1] : 0, shape, {}, {}};
            if (nTags > 0 && tags[0] != 0)
            {
                // Written as the group turns it round: nothing left to do
                element.groups.insert(mag(tags[0]));
            }
            addElement(is, std::move(element), false);
        }
    }
    is.endSection();
}
