/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "twoStep.H"
#include "threeStep.H"
#include "dictionaryCheck.H"

template<int dim>
Foam::autoPtr<Foam::timeScheme<dim>> Foam::timeScheme<dim>::New
(
    const dictionary& feSchemes,
    const gasGeometry<dim>& geometry,
    const shockCapturing<dim>& capturing
)
{
    const wordList choices({"twoStep", "threeStep"});

    switch (selectEntry(feSchemes, "timeScheme", choices))
    {
        case 0:
            return autoPtr<timeScheme<dim>>
            (
                new twoStep<dim>
                (
                    coeffsDict(feSchemes, "twoStep"), geometry, capturing
                )
            );
        default:
            if (capturing.limits())
            {
                FatalIOErrorInFunction(feSchemes)
                    << "shockCapturing fluxCorrected needs timeScheme twoStep"
                    << nl << "    Choose it, or pressureLaplacian, "
                    << "pressureSwitch or none" << exit(FatalIOError);
            }
            return autoPtr<timeScheme<dim>>
            (
                new threeStep<dim>
                (
                    coeffsDict(feSchemes, "threeStep"), geometry
                )
            );
    }
}


template class Foam::timeScheme<1>;
template class Foam::timeScheme<2>;
template class Foam::timeScheme<3>;
