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
    const dictionary& feSchemes
)
{
    const wordList choices({"twoStep", "threeStep"});

    switch (selectEntry(feSchemes, "timeScheme", choices))
    {
        case 0:
            return autoPtr<timeScheme<dim>>
            (
                new twoStep<dim>(coeffsDict(feSchemes, "twoStep"))
            );
        default:
            return autoPtr<timeScheme<dim>>
            (
                new threeStep<dim>(coeffsDict(feSchemes, "threeStep"))
            );
    }
}


template<int dim>
void Foam::timeScheme<dim>::addArtificialDiffusion
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    const double dt,
    std::vector<State>& residual
)
{
    for (label s = 0; s < geometry.nSimplices(); ++s)
    {
        if (state.mu[s] == 0)
        {
            continue;
        }
        const label* nodes = geometry.nodes(s);
        const auto& B = geometry.areas(s);

        gasDynamics::Flux<dim> gradient = gasDynamics::Flux<dim>::Zero();
        for (int a = 0; a <= dim; ++a)
        {
            gradient += state.U[nodes[a]]*B.col(a).transpose();
        }
        gradient *= dt*state.mu[s]/geometry.volume(s);
        for (int a = 0; a <= dim; ++a)
        {
            residual[nodes[a]] -= gradient*B.col(a);
        }
    }
}


template class Foam::timeScheme<1>;
template class Foam::timeScheme<2>;
template class Foam::timeScheme<3>;
