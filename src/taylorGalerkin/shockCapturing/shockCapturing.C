/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shockCapturing.H"
#include "pressureLaplacian.H"
#include "dictionaryCheck.H"

template<int dim>
Foam::autoPtr<Foam::shockCapturing<dim>> Foam::shockCapturing<dim>::New
(
    const dictionary& feSchemes
)
{
    const wordList choices({"none", "pressureLaplacian"});

    switch (selectEntry(feSchemes, "shockCapturing", choices))
    {
        case 0:
            return autoPtr<shockCapturing<dim>>(new noShockCapturing<dim>());
        default:
            return autoPtr<shockCapturing<dim>>
            (
                new pressureLaplacian<dim>
                (
                    coeffsDict(feSchemes, "pressureLaplacian")
                )
            );
    }
}


template class Foam::shockCapturing<1>;
template class Foam::shockCapturing<2>;
template class Foam::shockCapturing<3>;
