/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "pressureLaplacian.H"
#include "dictionaryCheck.H"

template<int dim>
Foam::pressureLaplacian<dim>::pressureLaplacian(const dictionary& coeffs)
:
    qDif_(coeffs.getOrDefault<scalar>("qDif", 0.5))
{
    checkKeywords(coeffs, {"qDif"});
    if (qDif_ < 0 || qDif_ > 2)
    {
        FatalIOErrorInFunction(coeffs)
            << "qDif is " << qDif_ << ", but must be between 0 and 2"
            << exit(FatalIOError);
    }
}


template<int dim>
void Foam::pressureLaplacian<dim>::correct
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state
)
{
    const gasKernel::edges e = geometry.edges();
    const activeParts& active = geometry.active();

    laplacian_.resize(geometry.nRows(), 0.0);
    active.fill(laplacian_, 0.0);
    active.forEdges([&](const long k)
    {
        const int i = e.first[k], j = e.second[k];
        const double flow = e.stiffness[k]*(state.p(j) - state.p(i));
        laplacian_[i] += flow;
        laplacian_[j] -= flow;
    });
    geometry.mesh().exchange().sum(laplacian_.data(), 1, 1);

    // All of eq. (10) but the side
    active.forRows([&](const long a)
    {
        if (a >= geometry.nNodes())
        {
            return;
        }
        const double speed =
            (state.velocity(a) - geometry.w(a)).norm() + state.soundSpeed(a);
        laplacian_[a] =
            qDif_*speed/state.p(a)
           *std::abs(laplacian_[a])/geometry.nodeVolume(a);
    });

    this->nu_.resize(e.n, 0.0);
    active.forEdges([&](const long k)
    {
        const double h = geometry.side(k);
        this->nu_[k] =
            0.5*h*h*h*(laplacian_[e.first[k]] + laplacian_[e.second[k]])
           *e.stiffness[k];
    });
    this->sumAtNodes(geometry);
}


template class Foam::pressureLaplacian<1>;
template class Foam::pressureLaplacian<2>;
template class Foam::pressureLaplacian<3>;
