// SPDX-License-Identifier: GPL-3.0-or-later
//
// Dynamic snap-through of a cylindrical panel under a ramped line load at its crown
// (after Kuhl and Ramm; data of a public input deck), in plane strain.

#include "EdgeLoad.hpp"
#include "EnergyMomentum.hpp"
#include "GeneralisedAlpha.hpp"
#include "ShellTestModels.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace shellTest;

namespace
{

//- Half of the arc: R = 5, thickness 0.1, half angle 30 degrees, hinged at mid-surface
struct Panel
{
    ShellMesh mesh;
    ShellModel model;
    int crown;
    Loads loads;

    explicit Panel(int n)
    :
        mesh
        (
            structuredMesh
            (
                n, 1,
                [](double u, double v) -> Vec3
                {
                    const double angle = u*std::acos(-1.0)/6;
                    return {5*std::sin(angle), v, 5*std::cos(angle)};
                }
            )
        ),
        model
        (
            mesh, {{"all", 0.1, material(200e9, 0.25, 1e4)}},
            Constraints(mesh)
                .planeStrainStrip(Axis::y).symmetryPlane("uMin", Axis::x).hinged("uMax")
                .dofMap()
        ),
        crown(mesh.nodeSet("uMin")[0]),
        loads
        {
            // Half of 5e7 per depth after 0.2 s
            std::make_shared<EdgeLoad>
            (
                model, "uMin", Vec3(0, 0, -2.5e7), linearInTime(0, 1/0.2)
            )
        }
    {}
};

} // namespace

// source: plane strain solid elements, 80 along the arc, hinged at mid-surface (deflection
// at times up to the snap; what follows depends on the scheme). Bound: 0.3 %
TEST(DynamicSnapThrough, crownOfThePanel)
{
    const double reference[][2] =
    {
        {0.02, 0.0252}, {0.04, 0.0673}, {0.05, 0.1013}, {0.06, 0.1476}, {0.07, 0.2075},
        {0.08, 0.319}, {0.085, 0.414}, {0.09, 0.555}, {0.095, 0.774}, {0.10, 1.111}
    };
    Panel panel(8);
    EnergyMomentum conserving(panel.model);
    GeneralisedAlpha damping(panel.model);
    for (TimeIntegrator* integrator : {static_cast<TimeIntegrator*>(&conserving),
        static_cast<TimeIntegrator*>(&damping)})
    {
        ShellState state = panel.model.initialState();
        integrator->initialise(state, panel.loads);
        const double top = panel.mesh.nodes()[panel.crown][2];
        std::size_t next = 0;
        for (int k = 1; k <= 400 && next < std::size(reference); ++k)
        {
            const DynamicStep step = integrator->step(state, 2.5e-4, panel.loads);
            ASSERT_TRUE(step.converged) << step.report.describe();
            state = step.state;
            if (std::abs(state.time - reference[next][0]) > 1e-9) continue;
            const double w = top - state.position[7*panel.crown + 2];
            EXPECT_NEAR(w, reference[next][1], 0.003*reference[next][1]) << state.time;
            ++next;
        }
        EXPECT_EQ(next, std::size(reference));
    }
}
