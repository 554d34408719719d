/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "conservation.H"
#include "fvMesh.H"
#include "OSspecific.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(conservation, 0);
    addToRunTimeSelectionTable(functionObject, conservation, dictionary);
}
}


namespace
{

const Foam::wordList amountNames
({
    "mass", "momentum_x", "momentum_y", "momentum_z", "energy"
});

void writeRow(Foam::Ostream& os, const Foam::scalarList& values)
{
    for (const Foam::scalar value : values)
    {
        os  << ',' << value;
    }
}

} // End namespace


Foam::functionObjects::conservation::conservation
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    account_(mesh_)
{
    if (!account_.checkIn())
    {
        FatalIOErrorInFunction(dict)
            << "The case has more than one function object of type "
            << typeName << nl << "    Keep one of them" << exit(FatalIOError);
    }
    read(dict);
    continueAccount();
}


bool Foam::functionObjects::conservation::read(const dictionary& dict)
{
    return fvMeshFunctionObject::read(dict);
}


void Foam::functionObjects::conservation::continueAccount()
{
    scalarList opening, sources, held;
    List<scalarList> entered;
    if
    (
        getProperty("opening", opening)
     && getProperty("entered", entered)
     && getProperty("sources", sources)
     && getProperty("held", held)
    )
    {
        account_.continueFrom(opening, entered, sources, held);
        Info<< type() << ' ' << name() << ": goes on with the account of the"
            << " run before this one" << nl << endl;
    }
}


void Foam::functionObjects::conservation::keep
(
    const List<scalarList>& entered,
    const scalarList& sources,
    const scalarList& held
)
{
    setProperty("opening", account_.opening());
    setProperty("entered", entered);
    setProperty("sources", sources);
    setProperty("held", held);
}


void Foam::functionObjects::conservation::openFiles()
{
    const fileName folder
    (
        time_.globalPath()/"postProcessing"/name()
       /Time::timeName(time_.startTime().value())
    );
    mkDir(folder);
    file_.reset(new OFstream(folder/"conservation.csv"));
    file_().precision(16);
    file_() << "time";
    for (const char* prefix : {"", "entered_", "sources_", "held_", "error_"})
    {
        for (const word& amount : amountNames)
        {
            file_() << ',' << prefix << amount;
        }
    }
    file_() << endl;

    const wordList& patches = account_.patches();
    patchFiles_.setSize(patches.size());
    forAll(patches, i)
    {
        patchFiles_.set(i, new OFstream(folder/(patches[i] + ".csv")));
        patchFiles_[i].precision(16);
        patchFiles_[i] << "time";
        for (const word& amount : amountNames)
        {
            patchFiles_[i] << ',' << amount;
        }
        patchFiles_[i] << endl;
    }
}


void Foam::functionObjects::conservation::report
(
    const scalarList& now,
    const scalarList& error
) const
{
    if (log && time_.writeTime())
    {
        Info<< type() << ' ' << name() << ": mass " << now[0]
            << " kg, off by " << error[0]/now[0] << " of it; energy " << now[4]
            << " J, off by " << error[4]/now[4] << " of it" << nl << endl;
    }
}


bool Foam::functionObjects::conservation::execute()
{
    if (!account_.isOpen())
    {
        FatalErrorInFunction
            << "Function object " << name() << " of type " << typeName
            << ": the application has not computed a gas"
            << exit(FatalError);
    }
    if (Pstream::master() && !file_.valid())
    {
        openFiles();
    }

    const scalarList now(account_.totals());
    const scalarList sources(account_.sources());
    const scalarList held(account_.held());
    List<scalarList> entered(account_.patches().size());
    scalarList sum(gasAccount::nAmounts, Zero);
    forAll(entered, patchi)
    {
        entered[patchi] = account_.entered(patchi);
        forAll(sum, i)
        {
            sum[i] += entered[patchi][i];
        }
    }
    scalarList error(now);
    forAll(error, i)
    {
        error[i] -= account_.opening()[i] + sum[i] + sources[i] + held[i];
    }
    keep(entered, sources, held);
    report(now, error);

    if (Pstream::master())
    {
        file_() << time_.value();
        for (const scalarList& values : {now, sum, sources, held, error})
        {
            writeRow(file_(), values);
        }
        file_() << endl;
        forAll(entered, patchi)
        {
            patchFiles_[patchi] << time_.value();
            writeRow(patchFiles_[patchi], entered[patchi]);
            patchFiles_[patchi] << endl;
        }
    }
    return true;
}


bool Foam::functionObjects::conservation::write()
{
    return true;
}
