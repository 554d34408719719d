/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "dictionaryCheck.H"
#include "error.H"
#include "ListOps.H"
#include "FlatOutput.H"

void Foam::checkKeywords(const dictionary& dict, const wordList& valid)
{
    for (const entry& e : dict)
    {
        const keyType& key = e.keyword();

        if
        (
            key == "FoamFile"
         || (e.isDict() && key.endsWith("Coeffs"))
         || valid.found(key)
        )
        {
            continue;
        }

        FatalIOErrorInFunction(dict)
            << "Unknown keyword " << key << " (line " << e.startLineNumber()
            << ")" << nl
            << "    Valid keywords are " << flatOutput(valid) << nl
            << exit(FatalIOError);
    }
}


Foam::label Foam::selectEntry
(
    const dictionary& dict,
    const word& keyword,
    const wordList& choices
)
{
    const word chosen(dict.get<word>(keyword));
    const label i = choices.find(chosen);

    if (i < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Unknown " << keyword << " " << chosen << nl
            << "    Valid choices are " << flatOutput(choices) << nl
            << exit(FatalIOError);
    }
    return i;
}


Foam::dictionary Foam::coeffsDict(const dictionary& dict, const word& type)
{
    const word name(type + "Coeffs");
    if (dict.isDict(name))
    {
        return dict.subDict(name);
    }
    dictionary empty;
    empty.name() = dict.name() + '.' + name;
    return empty;
}
