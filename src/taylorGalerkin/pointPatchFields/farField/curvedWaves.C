/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "curvedWaves.H"
#include "dictionary.H"

const Foam::Enum<Foam::curvedWaves::kind> Foam::curvedWaves::kindNames
({
    { kind::plane, "plane" },
    { kind::cylindrical, "cylindrical" },
    { kind::spherical, "spherical" },
});


Foam::curvedWaves::curvedWaves()
:
    kind_(plane),
    origin_(Zero)
{}


Foam::curvedWaves::curvedWaves
(
    const dictionary& dict,
    const label size,
    const bool allowed
)
:
    kind_(kindNames.getOrDefault("waves", dict, plane)),
    origin_(Zero)
{
    if (arePlane())
    {
        return;
    }
    if (!allowed)
    {
        FatalIOErrorInFunction(dict)
            << "waves " << name() << " is an entry of p: remove it here"
            << exit(FatalIOError);
    }
    dict.readEntry("origin", origin_);
    afterflow_ =
        dict.found("afterflow")
      ? scalarField("afterflow", dict, size)
      : scalarField(size, Zero);
}


Foam::curvedWaves::curvedWaves
(
    const curvedWaves& other,
    const pointPatchFieldMapper& mapper
)
:
    kind_(other.kind_),
    origin_(other.origin_)
{
    if (!arePlane())
    {
        afterflow_ = scalarField(other.afterflow_, mapper);
    }
}


void Foam::curvedWaves::autoMap(const pointPatchFieldMapper& mapper)
{
    if (!arePlane())
    {
        afterflow_.autoMap(mapper);
    }
}


void Foam::curvedWaves::rmap(const curvedWaves& other, const labelList& addr)
{
    if (!arePlane())
    {
        afterflow_.rmap(other.afterflow_, addr);
    }
}


void Foam::curvedWaves::write(Ostream& os) const
{
    if (arePlane())
    {
        return;
    }
    os.writeEntry("waves", name());
    os.writeEntry("origin", origin_);
    afterflow_.writeEntry("afterflow", os);
}
