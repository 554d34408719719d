/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shockCapturing.H"
#include "pressureLaplacian.H"
#include "pressureSwitch.H"
#include "dictionaryCheck.H"

template<int dim>
Foam::autoPtr<Foam::shockCapturing<dim>> Foam::shockCapturing<dim>::New
(
    const dictionary& feSchemes
)
{
    const wordList choices
    (
        {"fluxCorrected", "pressureSwitch", "pressureLaplacian", "none"}
    );
    if (!feSchemes.found("shockCapturing"))
    {
        return autoPtr<shockCapturing<dim>>(new fluxCorrected<dim>());
    }

    switch (selectEntry(feSchemes, "shockCapturing", choices))
    {
        case 0:
            return autoPtr<shockCapturing<dim>>(new fluxCorrected<dim>());
        case 1:
            return autoPtr<shockCapturing<dim>>
            (
                new pressureSwitch<dim>
                (
                    coeffsDict(feSchemes, "pressureSwitch")
                )
            );
        case 3:
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


template<int dim>
void Foam::shockCapturing<dim>::sumAtNodes(const gasGeometry<dim>& geometry)
{
    const gasKernel::edges e = geometry.edges();
    nodalNu_.resize(geometry.nRows(), 0.0);
    geometry.active().fill(nodalNu_, 0.0);
    geometry.active().forEdges([&](const long k)
    {
        nodalNu_[e.first[k]] += nu_[k];
        nodalNu_[e.second[k]] += nu_[k];
    });
    geometry.mesh().exchange().sum(nodalNu_.data(), 1, 1);
}


template class Foam::shockCapturing<1>;
template class Foam::shockCapturing<2>;
template class Foam::shockCapturing<3>;
