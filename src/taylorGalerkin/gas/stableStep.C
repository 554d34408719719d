/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "stableStep.H"

template<int dim>
Foam::stableStep Foam::findStableStep
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state
)
{
    const label nNodes = geometry.nNodes();
    std::vector<double> convection(nNodes, 0.0);
    std::vector<double> diffusion(nNodes, 0.0);

    std::vector<double> speed(nNodes);
    for (label a = 0; a < nNodes; ++a)
    {
        speed[a] =
            (state.velocity[a] - geometry.w(a)).norm() + state.soundSpeed[a];
    }

    for (label s = 0; s < geometry.nSimplices(); ++s)
    {
        const label* nodes = geometry.nodes(s);
        const auto& B = geometry.areas(s);
        double fastest = 0;
        const double diffusivity = state.mu[s]/geometry.volume(s);
        for (int a = 0; a <= dim; ++a)
        {
            fastest = std::max(fastest, speed[nodes[a]]);
            diffusion[nodes[a]] += diffusivity*B.col(a).squaredNorm();
        }

        // Eq. (G10)
        const double rate = fastest*geometry.inverseHeight(s);
        for (int a = 0; a <= dim; ++a)
        {
            convection[nodes[a]] = std::max(convection[nodes[a]], rate);
        }
    }

    stableStep result{GREAT, -1, 0, 0, 0, 0};
    for (label a = 0; a < nNodes; ++a)
    {
        const double c = convection[a];
        const double d = diffusion[a]/geometry.nodeVolume(a);

        // Root of (dt c)^2 + dt d = 1, eq. (G12)
        const double dt = 2/(d + std::sqrt(d*d + 4*c*c));
        if (dt < result.deltaT)
        {
            result.deltaT = dt;
            result.node = a;
            result.convection = c;
            result.diffusion = d;
        }
        result.maxConvection = max(result.maxConvection, c);
        result.meanConvection += c/nNodes;
    }
    return result;
}


namespace Foam
{
    template stableStep findStableStep<1>
    (
        const gasGeometry<1>&, const gasState<1>&
    );
    template stableStep findStableStep<2>
    (
        const gasGeometry<2>&, const gasState<2>&
    );
    template stableStep findStableStep<3>
    (
        const gasGeometry<3>&, const gasState<3>&
    );
}
