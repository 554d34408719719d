/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// One row of the table of inverseDistanceBenchmark.py, numbers apart by blanks:
//     inverseDistance <dimensions> <points> <tolerance>
// prints
//     points, moving and fixed points;
//     weights of an application per point, terms of the fixed points per point;
//     memory per point [bytes];
//     processor time of set-up and of an application per point [us];
//     these over those of the direct sum;
//     largest error of a smooth motion over its largest displacement; its bound

#include "inverseDistanceOperator.H"
#include "DynamicList.H"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

using namespace Foam;

namespace
{

//- Unit square or cube with n intervals along each side, its boundary fixed, a
//  panel two intervals thick that stands on the middle of its floor (in three
//  dimensions over half of the width)
struct panelInBox
{
    attractingPoints moving;
    attractingPoints fixed;
    pointField targets;

    panelInBox(const int dim, const label n)
    {
        const label nz = dim == 3 ? n : 0;
        DynamicList<point> panel, walls, others;
        for (label i = 0; i <= n; ++i)
        {
            for (label j = 0; j <= n; ++j)
            {
                for (label k = 0; k <= nz; ++k)
                {
                    const point p(i, j, k);
                    const label x = std::abs(i - n/2);
                    const label z = dim == 3 ? std::abs(k - n/2) : 0;
                    if (x < 1 && j < n/2 && z < n/4)
                    {
                        continue;
                    }
                    const bool onPanel = x <= 1 && j <= n/2 && z <= n/4;
                    const bool onWall =
                        i % n == 0 || j % n == 0 || (dim == 3 && k % n == 0);
                    (onPanel ? panel : onWall ? walls : others).append(p/n);
                }
            }
        }
        moving = {pointField(panel), scalarField(panel.size(), 1)};
        fixed = {pointField(walls), scalarField(walls.size(), 1)};
        targets = pointField(others);
    }
};


//- Bending and stretching of the panel
vectorField smoothMotion(const pointField& points)
{
    vectorField motion(points.size());
    forAll(points, j)
    {
        const point& p = points[j];
        motion[j] = vector
        (
            0.2*sqr(p.y()),
            -0.02*p.y(),
            0.02*p.z()*std::sin(6*p.z())
        );
    }
    return motion;
}


//- Processor time of this process
double seconds()
{
    return double(std::clock())/CLOCKS_PER_SEC;
}


scalar weight(const point& x, const point& y)
{
    return 1/sqr(magSqr(x - y));
}


scalarField directFixedWeights(const panelInBox& box, const pointField& sample)
{
    scalarField sum(sample.size(), Zero);
    forAll(sample, k)
    {
        for (const point& y : box.fixed.positions)
        {
            sum[k] += weight(sample[k], y);
        }
    }
    return sum;
}


vectorField directDisplacements
(
    const panelInBox& box,
    const vectorField& values,
    const scalarField& fixedWeights,
    const pointField& sample
)
{
    vectorField result(sample.size(), Zero);
    forAll(sample, k)
    {
        scalar all = fixedWeights[k];
        forAll(values, j)
        {
            const scalar w = weight(sample[k], box.moving.positions[j]);
            result[k] += w*values[j];
            all += w;
        }
        result[k] /= all;
    }
    return result;
}

} // End namespace


int main(int argc, char* argv[])
{
    if (argc != 4)
    {
        std::fprintf
        (
            stderr, "Usage: %s dimensions points tolerance\n", argv[0]
        );
        return 1;
    }

    const int dim = std::atoi(argv[1]);
    const label n = label(std::round(std::pow(std::atof(argv[2]), 1.0/dim)));
    const panelInBox box(dim, n);
    const vectorField motion(smoothMotion(box.moving.positions));
    inverseDistanceSettings settings;
    settings.tolerance = std::atof(argv[3]);

    const double start = seconds();
    const auto op = inverseDistanceOperator::New
    (
        dim, box.moving, box.fixed, box.targets, settings
    );
    const double setup = seconds() - start;

    const label nPoints = box.targets.size();
    const label stride = max(nPoints/1000, 1);
    pointField sample((nPoints - 1)/stride + 1);
    forAll(sample, i)
    {
        sample[i] = box.targets[i*stride];
    }
    const scalar sampled = scalar(sample.size())/nPoints;

    // The best of several, alternating, since other work disturbs both
    vectorField moved;
    double apply = VGREAT, directApply = VGREAT, directSetup = VGREAT;
    scalar error = 0;
    for (label trial = 0; trial < 8; ++trial)
    {
        double begin = seconds();
        op->apply(motion, moved);
        apply = min(apply, seconds() - begin);

        begin = seconds();
        const scalarField fixedWeights(directFixedWeights(box, sample));
        directSetup = min(directSetup, (seconds() - begin)/sampled);

        begin = seconds();
        const vectorField exact
        (
            directDisplacements(box, motion, fixedWeights, sample)
        );
        directApply = min(directApply, (seconds() - begin)/sampled);

        forAll(exact, i)
        {
            error = max(error, mag(moved[i*stride] - exact[i]));
        }
    }

    const inverseDistanceStatistics& s = op->statistics();
    std::printf
    (
        "%d %d %d %g %g %g %g %g %g %g %g %g\n",
        nPoints, box.moving.positions.size(), box.fixed.positions.size(),
        double(s.nWeights)/nPoints, double(s.nFixedTerms)/nPoints,
        double(s.nBytes)/nPoints,
        1e6*setup/nPoints, 1e6*apply/nPoints,
        setup/directSetup, apply/directApply,
        error/max(mag(motion)), s.worstBound
    );
    return 0;
}
