/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "radialProfile.H"
#include "Fstream.H"
#include "OSspecific.H"
#include "FlatOutput.H"
#include "wordList.H"
#include "ListOps.H"

#include <sstream>

namespace
{

const Foam::wordList columns({"r", "rho", "u", "p"});

Foam::wordList split(std::string line)
{
    for (char& c : line)
    {
        c = (c == ',' || c == ';' || c == '\r' ? ' ' : c);
    }
    Foam::DynamicList<Foam::word> words;
    std::istringstream is(line);
    for (std::string w; is >> w;)
    {
        words.append(Foam::word(w, false));
    }
    return Foam::wordList(words);
}

bool isNumber(const Foam::word& w)
{
    Foam::scalar value;
    return Foam::readScalar(w, value);
}

//- A table's lines and where they are, for errors
struct tableReader
{
    const Foam::fileName& file;
    const Foam::dictionary& dict;
    Foam::label number;

    void fail(const std::string& problem) const
    {
        using namespace Foam;
        FatalIOErrorInFunction(dict)
            << file << ", line " << number << ": " << problem.c_str() << nl
            << "    Needed are the columns " << flatOutput(columns)
            << ", named in the first line or in this order"
            << exit(FatalIOError);
    }

    void checkNames(const Foam::wordList& names) const
    {
        for (const Foam::word& column : columns)
        {
            if (!names.found(column))
            {
                fail("no column " + column);
            }
        }
    }

    Foam::profileRow row
    (
        const Foam::wordList& names,
        const Foam::wordList& words
    ) const
    {
        if (words.size() != names.size())
        {
            fail("another number of columns");
        }
        Foam::scalar value[4];
        forAll(columns, i)
        {
            if (!Foam::readScalar(words[names.find(columns[i])], value[i]))
            {
                fail("not a number");
            }
        }
        return Foam::profileRow
        {
            value[0], value[1], value[2], value[3],
            "line " + Foam::name(number) + " of " + file
        };
    }
};

} // End namespace


Foam::List<Foam::profileRow> Foam::readTable
(
    const fileName& file,
    const dictionary& dict
)
{
    if (!isFile(file))
    {
        FatalIOErrorInFunction(dict)
            << "There is no file " << file << exit(FatalIOError);
    }

    IFstream is(file);
    wordList names(columns);
    DynamicList<profileRow> rows;
    tableReader table{file, dict, 0};

    while (is.good())
    {
        string line;
        is.getLine(line);
        ++table.number;
        const wordList words(split(line));
        if (words.empty() || words.first()[0] == '#')
        {
            continue;
        }
        if (rows.empty() && !isNumber(words.first()))
        {
            names = words;
            table.checkNames(names);
            continue;
        }
        rows.append(table.row(names, words));
    }
    return List<profileRow>(rows);
}
