// SPDX-License-Identifier: GPL-3.0-or-later
//
// Integrators in time: order, conservation, numerical damping, length of the step.

#include "EdgeLoad.hpp"
#include "EnergyBalance.hpp"
#include "EnergyMomentum.hpp"
#include "FollowerPressure.hpp"
#include "GeneralisedAlpha.hpp"
#include "IntervalIntegrator.hpp"
#include "Newmark.hpp"
#include "StripModel.hpp"
#include "SurfaceTraction.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace shellTest;

namespace
{

enum class Method { Newmark, generalisedAlpha, energyMomentum };

std::unique_ptr<TimeIntegrator> make
(
    Method method, const ShellModel& model, const MotionOptions& motion, double radius = 0.8
)
{
    if (method == Method::energyMomentum)
    {
        return std::make_unique<EnergyMomentum>(model, motion);
    }
    if (method == Method::generalisedAlpha)
    {
        GeneralisedAlphaOptions options;
        static_cast<MotionOptions&>(options) = motion;
        options.spectralRadius = radius;
        return std::make_unique<GeneralisedAlpha>(model, options);
    }
    NewmarkOptions options;
    static_cast<MotionOptions&>(options) = motion;
    return std::make_unique<Newmark>(model, options);
}

MotionOptions tight(double residual = 1e-13, double increment = 1e-10)
{
    MotionOptions options;
    options.newton.residualTolerance = residual;
    options.newton.incrementTolerance = increment;
    return options;
}

//- Free strip, 1 x 0.3, thrown with a spin about a skew axis and bending
struct TossedStrip
{
    ShellMesh mesh = rectangleMesh(2, 1, Vec3::Zero(), {1, 0, 0}, {0, 0.3, 0});
    ShellModel model;
    ShellState state;

    TossedStrip(double rate, ElementForm form)
    :
        model
        (
            mesh, {{"all", 0.02, material(1e6, 0.3, 1000)}}, Constraints(mesh).dofMap(), {}, form
        ),
        state(model.initialState())
    {
        const Vec3 spin = rate*Vec3(0.3, 1, 0.2);
        for (int i = 0; i < mesh.nNodes(); ++i)
        {
            const Vec3 r = mesh.nodes()[i] - Vec3(0.5, 0.15, 0);
            state.velocity.segment<3>(7*i) =
                Vec3(1, 2, 3) + spin.cross(r) + Vec3(0, 0, rate*(2*r[0]*r[0] - 0.1));
            state.velocity.segment<3>(7*i + 3) = spin.cross(Vec3(0, 0, 1));
        }
    }

    double energy(const ShellState& s) const
    {
        return model.kineticEnergy(s.velocity) + model.strainEnergy(s.position);
    }
};

//- Greatest relative changes on the way
struct Drift
{
    double energy = 0;
    double linear = 0;
    double angular = 0;
};

Drift fly
(
    Method method, double rate, double dt, int nSteps,
    ElementForm form = ElementForm::displacement
)
{
    TossedStrip strip(rate, form);
    const ShellModel& model = strip.model;
    const auto integrator = make(method, model, tight());
    ShellState state = strip.state;
    integrator->initialise(state, {});
    const double E = strip.energy(state);
    const Vec3 P = model.linearMomentum(state.velocity);
    const Vec3 L = model.angularMomentum(state.position, state.velocity);
    Drift drift;
    for (int k = 0; k < nSteps; ++k)
    {
        const DynamicStep step = integrator->step(state, dt, {});
        if (!step.converged) throw std::runtime_error(step.report.describe());
        state = step.state;
        if (k%10 != 9) continue;
        const Vec3 p = model.linearMomentum(state.velocity);
        const Vec3 l = model.angularMomentum(state.position, state.velocity);
        drift.energy = std::max(drift.energy, std::abs(strip.energy(state)/E - 1));
        drift.linear = std::max(drift.linear, (p - P).norm()/P.norm());
        drift.angular = std::max(drift.angular, (l - L).norm()/L.norm());
    }
    return drift;
}

ShellState march
(
    TimeIntegrator& integrator, ShellState state, const Loads& loads, double dt, int n,
    EnergyBalance* balance = nullptr
)
{
    for (int k = 0; k < n; ++k)
    {
        const DynamicStep step = integrator.step(state, dt, loads);
        if (!step.converged) throw std::runtime_error(step.report.describe());
        if (balance) balance->add(step);
        state = step.state;
    }
    return state;
}

} // namespace

TEST(Integrators, areOfSecondOrder)
{
    const Strip strip(3);
    const Loads loads
    {
        std::make_shared<EdgeLoad>(strip.model, "uMax", Vec3(0, 0, 2), smoothStep(0, 0.4))
    };
    const auto end = [&](Method method, int n)
    {
        const auto integrator = make(method, strip.model, tight(1e-11, 1e-9));
        ShellState state = strip.model.initialState();
        integrator->initialise(state, loads);
        return march(*integrator, state, loads, 0.5/n, n).position;
    };
    const Vector reference = end(Method::energyMomentum, 1600);
    for (Method method : {Method::generalisedAlpha, Method::energyMomentum})
    {
        const double coarse = (end(method, 100) - reference).norm();
        const double fine = (end(method, 200) - reference).norm();
        EXPECT_GT(std::log2(coarse/fine), 1.9) << int(method);
        EXPECT_LT(fine, 0.01) << int(method);
    }
}

// Free flight with tumbling and bending. Newmark's energy drifts at the same step
TEST(Integrators, freeFlight)
{
    for (ElementForm form : {ElementForm::displacement, ElementForm::assumedStrain})
    {
        const Drift kept = fly(Method::energyMomentum, 5, 2e-3, 500, form);
        EXPECT_LT(kept.energy, 1e-11) << elementFormName(form);
        EXPECT_LT(kept.linear, 1e-12) << elementFormName(form);
        EXPECT_LT(kept.angular, 1e-11) << elementFormName(form);
    }

    const Drift newmark = fly(Method::Newmark, 5, 2e-3, 500);
    EXPECT_LT(newmark.linear, 1e-12);
    EXPECT_GT(newmark.energy, 1e-6);
    EXPECT_GT(newmark.angular, 1e-8);
}

class LongFlight : public testing::TestWithParam<ElementForm>
{};

INSTANTIATE_TEST_SUITE_P
(
    Forms, LongFlight,
    testing::Values(ElementForm::displacement, ElementForm::assumedStrain),
    [](const auto& form) { return elementFormName(form.param); }
);

// 1e5 steps; minutes: run with LONG_TESTS set in the environment
TEST_P(LongFlight, energyMomentumKeepsEnergyAndMomenta)
{
    if (!std::getenv("LONG_TESTS")) GTEST_SKIP() << "LONG_TESTS is not set";
    const Drift kept = fly(Method::energyMomentum, 2, 2e-3, 100000, GetParam());
    std::printf
    (
        "energy-momentum: energy %.1e, linear %.1e, angular momentum %.1e\n",
        kept.energy, kept.linear, kept.angular
    );
    EXPECT_LT(kept.energy, 1e-8);
    EXPECT_LT(kept.linear, 1e-9);
    EXPECT_LT(kept.angular, 1e-9);
}

// Its drift is stated in the theory page: bounded
TEST_P(LongFlight, newmarkKeepsLinearMomentum)
{
    if (!std::getenv("LONG_TESTS")) GTEST_SKIP() << "LONG_TESTS is not set";
    const Drift newmark = fly(Method::Newmark, 2, 2e-3, 100000, GetParam());
    std::printf
    (
        "Newmark:         energy %.1e, linear %.1e, angular momentum %.1e\n",
        newmark.energy, newmark.linear, newmark.angular
    );
    EXPECT_LT(newmark.linear, 1e-9);
    EXPECT_LT(newmark.energy, 1e-3);
    EXPECT_LT(newmark.angular, 1e-3);
}

// The account of a clamped strip under a follower, with damping: the works that the
// integrator names close it to the accuracy of the iteration
TEST(EnergyMomentum, theAccountOfEnergiesCloses)
{
    const Strip strip(3);
    const Loads loads{std::make_shared<FollowerPressure>(strip.model, "all", -0.4)};
    MotionOptions options = tight();
    options.massDamping = 3;
    EnergyMomentum integrator(strip.model, options);
    ShellState state = strip.model.initialState();
    integrator.initialise(state, loads);
    EnergyBalance balance
    (
        strip.model, state, totalForce(loads, strip.model, state.position, 0), 3
    );
    march(integrator, state, loads, 4e-3, 50, &balance);
    EXPECT_GT(balance.externalWork(), 1);
    EXPECT_GT(balance.dissipated(), 0.1);
    EXPECT_LT(std::abs(balance.mismatch()), 1e-10*balance.externalWork());
}

// A step far above the period of the highest modes removes them at the rate of the
// spectral radius; the first mode, which it resolves, is kept
TEST(GeneralisedAlpha, dampsWhatTheStepsDoNotResolve)
{
    for (double radius : {0.0, 0.5, 0.9})
    {
        const AlphaParameters p = GeneralisedAlpha::parametersOf(radius);
        EXPECT_NEAR(p.gamma, 0.5 - p.alphaM + p.alphaF, 1e-15);

        // Membrane mode of a strip: its frequency is 1e4 times that of bending
        const ShellMesh mesh = strip(2, 1);
        const ShellModel model
        (
            mesh, {{"all", 0.01, material(1e8, 0, 1)}},
            Constraints(mesh)
                .clamped("uMin").planeStrainStrip(Axis::y)
                .fixed("all", {Component::z, Component::gx}).dofMap()
        );
        const auto integrator =
            make(Method::generalisedAlpha, model, tight(1e-12, 1e-9), radius);
        ShellState state = model.initialState();
        for (int i = 0; i < mesh.nNodes(); ++i)
        {
            state.velocity[7*i] = 1e-3*mesh.nodes()[i][0];
        }
        integrator->initialise(state, {});
        state = march(*integrator, state, {}, 10, 10);
        const double early = model.kineticEnergy(state.velocity);
        state = march(*integrator, state, {}, 10, 10);
        const double late = model.kineticEnergy(state.velocity);
        if (radius < 0.1)
        {
            EXPECT_LT(early, 1e-18);
            continue;
        }
        // A root of multiplicity two or three: amplitudes n radius^n to
        // n^2 radius^n between 10 and 20 steps
        const double perStep = std::pow(late/early, 1.0/20);
        EXPECT_GT(perStep, 0.98*radius) << radius;
        EXPECT_LT(perStep, 1.16*radius) << radius;
    }
}

TEST(GeneralisedAlpha, radiusIsChecked)
{
    const Strip strip(1);
    GeneralisedAlphaOptions options;
    options.spectralRadius = 1.2;
    EXPECT_NE
    (
        errorOf([&] { GeneralisedAlpha(strip.model, options); }).find("spectralRadius 1.2"),
        std::string::npos
    );
}

TEST(EnergyMomentum, materialsThatAreNotLinearAreRejected)
{
    const ShellMesh mesh = strip(1, 1);
    const ShellModel model
    (
        mesh, {{"all", 0.1, std::make_shared<CubicMaterial>(100, 0.3, 50)}},
        Constraints(mesh).dofMap()
    );
    const std::string message = errorOf([&] { EnergyMomentum integrator(model); });
    EXPECT_NE(message.find("CubicMaterial"), std::string::npos) << message;
}

// A step that does not converge is cut; the parts lead to the same instant
TEST(IntervalIntegrator, cutsAStepThatDoesNotConverge)
{
    const Strip strip(3);
    const Loads loads{SurfaceTraction::deadPressure(strip.model, "all", -0.4)};
    MotionOptions few;
    few.newton.maxIterations = 4;
    const auto integrator = make(Method::Newmark, strip.model, few);
    ShellState state = strip.model.initialState();
    integrator->initialise(state, loads);
    double wanted = 0;
    const auto steps = IntervalIntegrator(*integrator, {10, 0}).advance
    (
        state, 0.05, loads, {}, wanted
    );
    ASSERT_TRUE(steps.back().converged) << steps.back().report.describe();
    EXPECT_GT(steps.size(), 1u);
    EXPECT_EQ(steps.back().state.time, 0.05);

    const auto refused = IntervalIntegrator(*integrator, {0, 0}).advance
    (
        state, 0.05, loads, {}, wanted
    );
    EXPECT_FALSE(refused.back().converged);
}

// The local error stays within its bound, and the steps follow it
TEST(IntervalIntegrator, stepsFollowTheErrorEstimate)
{
    const Strip strip(3);
    const Loads loads
    {
        std::make_shared<EdgeLoad>(strip.model, "uMax", Vec3(0, 0, 2), smoothStep(0.2, 0.1))
    };
    const auto integrator = make(Method::generalisedAlpha, strip.model, MotionOptions());
    std::vector<std::size_t> numbers;
    for (double tolerance : {1e-3, 1e-4})
    {
        ShellState state = strip.model.initialState();
        integrator->initialise(state, loads);
        IntervalIntegrator interval(*integrator, {10, tolerance});
        double wanted = 0.01;
        std::size_t number = 0;
        for (int k = 1; k <= 5; ++k)
        {
            const auto steps = interval.advance(state, 0.1, loads, {}, wanted);
            ASSERT_TRUE(steps.back().converged) << steps.back().report.describe();
            ShellState last = state;
            for (const DynamicStep& step : steps)
            {
                EXPECT_LE(integrator->errorEstimate(last, step.state), tolerance);
                last = step.state;
            }
            EXPECT_NEAR(last.time, 0.1*k, 1e-12);
            state = last;
            number += steps.size();
        }
        numbers.push_back(number);
    }
    // Third order: 10^(1/3) as many
    EXPECT_GT(numbers[1], 1.6*numbers[0]);
    EXPECT_LT(numbers[1], 3.2*numbers[0]);
}
