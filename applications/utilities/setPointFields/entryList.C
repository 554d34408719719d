/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "entryList.H"

namespace
{

void addPrefix(Foam::dictionary& dict, const std::string& prefix)
{
    dict.name() = prefix + dict.name();
    for (Foam::entry& e : dict)
    {
        if (e.isDict())
        {
            addPrefix(e.dict(), prefix);
        }
        else if (e.isStream())
        {
            e.stream().name() = prefix + e.stream().name();
        }
    }
}

} // End namespace


Foam::PtrList<Foam::entry> Foam::readEntryList
(
    const dictionary& dict,
    const word& keyword
)
{
    ITstream& is = dict.lookup(keyword);
    PtrList<entry> entries(is);
    for (entry& e : entries)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(is)
                << "Expected " << e.keyword() << " { ... } in the list "
                << keyword << exit(FatalIOError);
        }
        addPrefix(e.dict(), dict.name() + '.' + keyword + '.');
    }
    return entries;
}
