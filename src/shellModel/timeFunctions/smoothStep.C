/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "smoothStep.H"
#include "dictionaryCheck.H"
#include "shellInput.H"

namespace Foam
{
namespace Function1Types
{
    makeScalarFunction1(smoothStep);
}
}


Foam::Function1Types::smoothStep::smoothStep
(
    const word& entryName,
    const dictionary& dict
)
:
    Function1<scalar>(entryName),
    start_(dict.lookupOrDefault<scalar>("start", 0)),
    duration_(dict.get<scalar>("duration")),
    height_(dict.lookupOrDefault<scalar>("height", 1)),
    function_
    (
        rejectedIn(dict, [&]
        {
            return positionalShell::smoothStep(start_, duration_, height_);
        })
    )
{}


Foam::scalar Foam::Function1Types::smoothStep::value(const scalar t) const
{
    return function_->value(t);
}


void Foam::Function1Types::smoothStep::writeData(Ostream& os) const
{
    Function1<scalar>::writeData(os);
    os.endEntry();

    os.beginBlock(word(this->name() + "Coeffs"));
    os.writeEntry("start", start_);
    os.writeEntry("duration", duration_);
    os.writeEntry("height", height_);
    os.endBlock();
}
