/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "stableStep.H"
#include "PstreamReduceOps.H"

template<int dim>
Foam::blockStep Foam::findBlockStep
(
    const gasGeometry<dim>& geometry,
    const std::vector<double>& speed,
    const std::vector<double>& viscosity,
    const activeParts::range& rows,
    const bool positive
)
{
    const sharedItems& exchange = geometry.mesh().exchange();
    const bool viscous = viscosity.size();
    const label end = min(label(rows.to), geometry.nNodes());

    blockStep result{GREAT, -1, 0, 0, 0, 0, 0};
    for (label a = rows.from; a < end; ++a)
    {
        // Sums over the edges per volume, eqs. (G10), (G11)
        const double c = speed[a]/geometry.nodeVolume(a);
        const double d =
            viscous ? viscosity[a]/geometry.nodeVolume(a) : 0;

        // Root of (dt c)^2 + dt d = 1, eq. (G12), or of dt c + dt d = 1
        const double dt =
            positive ? 1/(c + d) : 2/(d + std::sqrt(d*d + 4*c*c));
        if (dt < result.deltaT)
        {
            result.deltaT = dt;
            result.node = a;
            result.convection = c;
            result.diffusion = d;
        }
        result.maxConvection = max(result.maxConvection, c);
        if (exchange.owned(a))
        {
            result.sum += c;
            ++result.count;
        }
    }
    return result;
}


template<int dim>
Foam::stableStep Foam::findStableStep
(
    const gasGeometry<dim>& geometry,
    const std::vector<double>& speed,
    const std::vector<double>& viscosity,
    std::vector<blockStep>& blocks,
    const bool positive
)
{
    const feMesh& mesh = geometry.mesh();
    const activeParts& active = geometry.active();
    stableStep result{GREAT, -1, point::zero, 0, 0, 0, 0};
    scalar sum = 0;
    label count = 0;
    label least = -1;

    blocks.resize(active.nBlocks());
    for (label b = 0; b < active.nBlocks(); ++b)
    {
        if (!active.blockAsleep(b))
        {
            blocks[b] = findBlockStep
            (
                geometry, speed, viscosity, active.rows(b), positive
            );
        }
        const blockStep& block = blocks[b];
        if (block.deltaT < result.deltaT)
        {
            result.deltaT = block.deltaT;
            result.convection = block.convection;
            result.diffusion = block.diffusion;
            least = block.node;
        }
        result.maxConvection = max(result.maxConvection, block.maxConvection);
        sum += block.sum;
        count += block.count;
    }
    if (least >= 0)
    {
        result.node = mesh.globalNode()[least];
        result.position = mesh.nodes()[least];
    }

    if (Pstream::parRun())
    {
        // The processor with the least step tells the others
        const scalar own = result.deltaT;
        reduce(result.deltaT, minOp<scalar>());
        label teller =
            own == result.deltaT ? Pstream::myProcNo() : labelMax;
        reduce(teller, minOp<label>());
        if (teller != Pstream::myProcNo())
        {
            result.node = -1;
            result.position = point::min;
            result.convection = result.diffusion = -1;
        }
        reduce(result.node, maxOp<label>());
        reduce(result.position, maxOp<point>());
        reduce(result.convection, maxOp<scalar>());
        reduce(result.diffusion, maxOp<scalar>());
        reduce(result.maxConvection, maxOp<scalar>());
        reduce(sum, sumOp<scalar>());
        reduce(count, sumOp<label>());
    }
    result.meanConvection = sum/max(count, label(1));
    return result;
}


namespace Foam
{
    template stableStep findStableStep<1>
    (
        const gasGeometry<1>&,
        const std::vector<double>&,
        const std::vector<double>&,
        std::vector<blockStep>&,
        const bool
    );
    template stableStep findStableStep<2>
    (
        const gasGeometry<2>&,
        const std::vector<double>&,
        const std::vector<double>&,
        std::vector<blockStep>&,
        const bool
    );
    template stableStep findStableStep<3>
    (
        const gasGeometry<3>&,
        const std::vector<double>&,
        const std::vector<double>&,
        std::vector<blockStep>&,
        const bool
    );
}
