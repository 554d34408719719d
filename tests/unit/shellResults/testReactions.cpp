// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reactions of supports, and section forces against statics, at large deflections.

#include "EdgeLoad.hpp"
#include "EnergyBalance.hpp"
#include "EnergyMomentum.hpp"
#include "FollowerPressure.hpp"
#include "Reactions.hpp"
#include "ShellResults.hpp"
#include "StaticSolver.hpp"
#include "StripModel.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

using namespace shellTest;

namespace
{

//- All nodes
std::vector<int> everywhere(const ShellModel& model)
{
    return model.mesh().nodeSet("all");
}

StaticStep solved(const ShellModel& model, const Loads& loads)
{
    NewtonOptions tight;
    tight.residualTolerance = 1e-12;
    const StaticStep end = StaticSolver(model, tight).run(model.initialState(), 1, 4, loads);
    EXPECT_TRUE(end.converged) << end.report.describe();
    return end;
}

class Statics : public testing::TestWithParam<ElementForm>
{};

INSTANTIATE_TEST_SUITE_P
(
    Forms, Statics,
    testing::Values(ElementForm::displacement, ElementForm::assumedStrain),
    [](const auto& form) { return elementFormName(form.param); }
);

} // namespace

// Strip under a dead end force, deflected to 0.67 of its length: the root carries the
// force and its moment to the accuracy of the iteration, every section to that of the mesh
TEST_P(Statics, cantileverUnderAnEndForce)
{
    const double length = 10;
    const double width = 1;
    const ShellMesh mesh = strip(8, length, width);
    const ShellModel model
    (
        mesh, {{"all", 0.1, material(1.2e6, 0)}}, Constraints(mesh).clamped("uMin").dofMap(),
        {}, GetParam()
    );
    const Vec3 line(0, 0, 4);
    const Loads loads
    {
        std::make_shared<EdgeLoad>(model, "uMax", line, linearInTime(0, 1))
    };
    const ShellState state = solved(model, loads).state;
    const Vector external = totalForce(loads, model, state.position, 1);
    const Vector support = reactions(model, state, external);

    const ResultantForce load = resultant(everywhere(model), state.position, external);
    const ResultantForce root =
        resultant(mesh.nodeSet("uMin"), state.position, support);
    EXPECT_LT((load.force - width*line).norm(), 1e-12);
    EXPECT_GT(load.moment.norm(), 20);
    EXPECT_LT((root.force + load.force).norm(), 1e-9*load.force.norm());
    EXPECT_LT((root.moment + load.moment).norm(), 1e-9*load.moment.norm());

    // About another point: moved by the force
    const Vec3 about(1, 2, 3);
    const ResultantForce moved =
        resultant(mesh.nodeSet("uMin"), state.position, support, about);
    EXPECT_LT((moved.moment - (root.moment - about.cross(root.force))).norm(), 1e-9);

    const Vec3 tip = state.position.segment<3>(7*mesh.nearestNode({10, 0.5, 0}));
    const std::vector<PointResult> results = ShellResults(model).at(state.position);
    for (int i = 0; i < mesh.nNodes(); ++i)
    {
        const Vec3& X = mesh.nodes()[i];
        // Beside a clamp there is a layer of the thickness, and corners
        if (X[0] < 1 || X[0] > 9 || std::abs(X[1] - 0.5) > 0.4) continue;
        const PointResult& r = results[i];
        const Vec3 force = r.section.N(0, 0)*r.axis1 + r.section.Q[0]*r.axis3;
        // The displacement form is as bad in these as it is in the strains that lock
        const double bound = GetParam() == ElementForm::assumedStrain ? 0.05 : 1.5;
        EXPECT_LT((force - line).norm(), bound*line.norm()) << X.transpose();
        const double arm = tip[0] - state.position[7*i];
        EXPECT_NEAR(r.section.M(0, 0), -line[2]*arm, 0.01*4*7) << X.transpose();
    }
}

// Follower pressure on a plate with hinged edges: the supports carry its resultant
TEST_P(Statics, supportsCarryTheResultantOfAFollower)
{
    const ShellMesh mesh = rectangleMesh(3, 3, Vec3::Zero(), {1, 0, 0}, {0, 1, 0});
    const ShellModel model
    (
        mesh, {{"all", 0.02, material(1e6, 0.3)}},
        Constraints(mesh).hinged("uMin").clamped("uMax").hinged("vMin").dofMap(), {}, GetParam()
    );
    const Loads loads
    {
        std::make_shared<FollowerPressure>(model, "all", 30, linearInTime(0, 1))
    };
    const ShellState state = solved(model, loads).state;
    const Vector external = totalForce(loads, model, state.position, 1);
    const Vector support = reactions(model, state, external);
    const ResultantForce load = resultant(everywhere(model), state.position, external);
    const ResultantForce carried = resultant(everywhere(model), state.position, support);
    EXPECT_GT(load.force.head<2>().norm(), 0.01);
    EXPECT_LT((carried.force + load.force).norm(), 1e-9*load.force.norm());
    EXPECT_LT((carried.moment + load.moment).norm(), 1e-9*load.force.norm());
}

// In motion: loads and reactions together change the momentum
TEST(Reactions, changeTheMomentumWithTheLoads)
{
    const Strip strip(4);
    const Loads loads{std::make_shared<FollowerPressure>(strip.model, "all", -0.4)};
    const ShellState state = march(strip, loads, 0.2, 100);
    const Vector external = totalForce(loads, strip.model, state.position, state.time);
    const Vector support = reactions(strip.model, state, external);
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < strip.mesh.nNodes(); ++i)
    {
        sum += support.segment<3>(7*i) + external.segment<3>(7*i);
    }
    const Vec3 rate = strip.model.linearMomentum(state.acceleration);
    EXPECT_GT(rate.norm(), 0.1);
    EXPECT_LT((sum - rate).norm(), 1e-7*rate.norm());
}

// The account keeps the reaction of the step, which the integrator may name: its impulse
// with that of the loads is the change of momentum
TEST(Reactions, ofTheAccountAreThoseOfTheStep)
{
    const Strip strip(4);
    const Loads loads{std::make_shared<FollowerPressure>(strip.model, "all", -0.4)};
    MotionOptions tight;
    tight.newton.residualTolerance = 1e-12;
    EnergyMomentum integrator(strip.model, tight);
    ShellState state = strip.model.initialState();
    integrator.initialise(state, loads);
    EnergyBalance account
    (
        strip.model, state, totalForce(loads, strip.model, state.position, 0)
    );
    for (int k = 0; k < 20; ++k)
    {
        const DynamicStep step = integrator.step(state, 5e-3, loads);
        ASSERT_TRUE(step.converged);
        account.add(step);
        Vec3 impulse = Vec3::Zero();
        for (int i = 0; i < strip.mesh.nNodes(); ++i)
        {
            impulse += 5e-3*(account.reaction().segment<3>(7*i) + step.meanForce.segment<3>(7*i));
        }
        const Vec3 change = strip.model.linearMomentum(step.state.velocity - state.velocity);
        EXPECT_LT((impulse - change).norm(), 1e-9*change.norm()) << k;
        state = step.state;
    }
}
