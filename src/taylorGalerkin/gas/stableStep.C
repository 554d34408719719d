/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "stableStep.H"
#include "PstreamReduceOps.H"
#include "FixedList.H"

namespace
{

using namespace Foam;

//- A processor's stable step and sums as numbers: one reduction for all
enum place
{
    step, node, x, y, z, convection, diffusion, greatest, sumOfAll, countOfAll,
    size
};

using stepNumbers = FixedList<scalar, size>;

//- Whether node a with its step comes before b: the shorter step or, of steps
//  that differ by rounding, the lower node, so that any decomposition of a
//  symmetric scene names the same one
bool isFirst
(
    const scalar stepA,
    const scalar a,
    const scalar stepB,
    const scalar b
)
{
    const scalar rounding = 1e-10*min(stepA, stepB);
    return
        stepA < stepB - rounding || (stepA <= stepB + rounding && a < b);
}

//- The least step, with its place
struct leastStep
{
    stepNumbers operator()(const stepNumbers& a, const stepNumbers& b) const
    {
        const bool first = isFirst(a[step], a[node], b[step], b[node]);
        stepNumbers result(first ? a : b);
        result[step] = min(a[step], b[step]);
        result[greatest] = max(a[greatest], b[greatest]);
        result[sumOfAll] = a[sumOfAll] + b[sumOfAll];
        result[countOfAll] = a[countOfAll] + b[countOfAll];
        return result;
    }
};

void reduceOverProcessors(stableStep& s, scalar& sum, label& count)
{
    stepNumbers n;
    n[step] = s.deltaT;
    n[node] = s.node < 0 ? GREAT : s.node;
    n[x] = s.position.x();
    n[y] = s.position.y();
    n[z] = s.position.z();
    n[convection] = s.convection;
    n[diffusion] = s.diffusion;
    n[greatest] = s.maxConvection;
    n[sumOfAll] = sum;
    n[countOfAll] = count;
    reduce(n, leastStep());
    s.deltaT = n[step];
    s.node = label(n[node]);
    s.position = point(n[x], n[y], n[z]);
    s.convection = n[convection];
    s.diffusion = n[diffusion];
    s.maxConvection = n[greatest];
    sum = n[sumOfAll];
    count = label(n[countOfAll]);
}

} // End namespace

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
    const labelList& name = geometry.mesh().globalNode();
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
        if
        (
            result.node < 0
         || isFirst(dt, name[a], result.deltaT, name[result.node])
        )
        {
            result.node = a;
            result.convection = c;
            result.diffusion = d;
        }
        result.deltaT = min(result.deltaT, dt);
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
        if
        (
            block.node >= 0
         && (
                least < 0
             || isFirst
                (
                    block.deltaT, mesh.globalNode()[block.node],
                    result.deltaT, mesh.globalNode()[least]
                )
            )
        )
        {
            result.convection = block.convection;
            result.diffusion = block.diffusion;
            least = block.node;
        }
        result.deltaT = min(result.deltaT, block.deltaT);
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
        reduceOverProcessors(result, sum, count);
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
