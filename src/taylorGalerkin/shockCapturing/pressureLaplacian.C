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
    gasState<dim>& state
)
{
    const label nNodes = geometry.nNodes();
    const label nSimplices = geometry.nSimplices();
    constexpr double factorial[] = {1, 1, 2, 6};
    const double scale = factorial[dim]/geometry.mesh().depth();

    laplacian_.assign(nNodes, 0.0);
    for (label s = 0; s < nSimplices; ++s)
    {
        const label* nodes = geometry.nodes(s);
        const auto& B = geometry.areas(s);
        simplexVec<dim> VgradP = simplexVec<dim>::Zero();
        for (int a = 0; a <= dim; ++a)
        {
            VgradP += state.p[nodes[a]]*B.col(a);
        }
        const simplexVec<dim> gradP = VgradP/geometry.volume(s);
        for (int a = 0; a <= dim; ++a)
        {
            laplacian_[nodes[a]] -= B.col(a).dot(gradP);
        }
    }
    for (label a = 0; a < nNodes; ++a)
    {
        laplacian_[a] = std::abs(laplacian_[a])/geometry.nodeVolume(a);
    }

    for (label s = 0; s < nSimplices; ++s)
    {
        const label* nodes = geometry.nodes(s);
        double sumLaplacian = 0;
        double sumP = 0;
        double sumSpeed = 0;
        for (int a = 0; a <= dim; ++a)
        {
            const label i = nodes[a];
            sumLaplacian += laplacian_[i];
            sumP += state.p[i];
            sumSpeed +=
                (state.velocity[i] - geometry.w(i)).norm()
              + state.soundSpeed[i];
        }
        // Not pow, which costs as much as the rest
        const double hd = scale*geometry.volume(s);
        const double h =
            dim == 1 ? hd : dim == 2 ? std::sqrt(hd) : std::cbrt(hd);
        state.mu[s] =
            qDif_*h*h*h*sumSpeed/(dim + 1)*sumLaplacian/sumP;
    }
}


template class Foam::pressureLaplacian<1>;
template class Foam::pressureLaplacian<2>;
template class Foam::pressureLaplacian<3>;
