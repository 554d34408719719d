/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "pressureSwitch.H"
#include "dictionaryCheck.H"

template<int dim>
Foam::pressureSwitch<dim>::pressureSwitch(const dictionary& coeffs)
:
    q_(coeffs.getOrDefault<scalar>("q", 1)),
    noise_(coeffs.getOrDefault<scalar>("noise", 0.01))
{
    checkKeywords(coeffs, {"q", "noise"});
    if (q_ < 0 || q_ > 2)
    {
        FatalIOErrorInFunction(coeffs)
            << "q is " << q_ << ", but must be between 0 and 2"
            << exit(FatalIOError);
    }
    if (noise_ <= 0)
    {
        FatalIOErrorInFunction(coeffs)
            << "noise is " << noise_ << ", but must be positive"
            << exit(FatalIOError);
    }
}


template<int dim>
void Foam::pressureSwitch<dim>::correct
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state
)
{
    const gasKernel::edges e = geometry.edges();
    const activeParts& active = geometry.active();

    sums_.resize(2*geometry.nRows(), 0.0);
    active.forRows([&](const long a) { sums_[2*a] = sums_[2*a + 1] = 0; });
    active.forEdges([&](const long k)
    {
        double* atI = &sums_[2*e.first[k]];
        double* atJ = &sums_[2*e.second[k]];
        const double pi = state.p(e.first[k]), pj = state.p(e.second[k]);
        const double flow = e.magArea[k]*(pj - pi);
        const double size = std::abs(flow) + noise_*e.magArea[k]*(pi + pj);
        atI[0] += flow;
        atJ[0] -= flow;
        atI[1] += size;
        atJ[1] += size;
    });
    geometry.mesh().exchange().sum(sums_.data(), 2, 2);
    active.forRows([&](const long a)
    {
        // No edge: padding, or gas about to wake
        const double size = sums_[2*a + 1];
        sums_[2*a] = size > 0 ? std::abs(sums_[2*a])/size : 0;
    });

    this->nu_.resize(e.n, 0.0);
    active.forEdges([&](const long k)
    {
        const int i = e.first[k], j = e.second[k];
        double fluxI = 0, fluxJ = 0;
        for (int c = 0; c < dim; ++c)
        {
            fluxI += state.rows[i][1 + c]*e.area[c][k];
            fluxJ += state.rows[j][1 + c]*e.area[c][k];
        }
        const double sweep = e.sweep ? e.sweep[k] : 0;
        const double d = 0.5*std::max
        (
            std::abs(fluxI/state.rho(i) - sweep)
          + state.soundSpeed(i)*e.magArea[k],
            std::abs(fluxJ/state.rho(j) - sweep)
          + state.soundSpeed(j)*e.magArea[k]
        );
        this->nu_[k] = q_*std::max(sums_[2*i], sums_[2*j])*d;
    });
    this->sumAtNodes(geometry);
}


template class Foam::pressureSwitch<1>;
template class Foam::pressureSwitch<2>;
template class Foam::pressureSwitch<3>;
