// SPDX-License-Identifier: GPL-3.0-or-later

#include "EdgeLoad.hpp"
#include "EnergyBalance.hpp"
#include "StaticSolver.hpp"
#include "StripModel.hpp"
#include "SurfaceTraction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace shellTest;

// The balance of a large motion under load: closed to second order in the step
TEST(EnergyBalance, closesWithTheWorkOfLoads)
{
    const auto worstMismatch = [](int n)
    {
        Strip strip(5);
        const Loads loads{SurfaceTraction::deadPressure(strip.model, "all", -0.4)};
        Newmark newmark(strip.model);
        ShellState state = strip.model.initialState();
        newmark.initialise(state, loads);
        EnergyBalance balance
        (
            strip.model, state, totalForce(loads, strip.model, state.position, 0)
        );
        double worst = 0;
        double largest = 0;
        for (int k = 0; k < n; ++k)
        {
            const DynamicStep step = newmark.step(state, period/n, loads);
            if (!step.converged) throw std::runtime_error(step.report.describe());
            state = step.state;
            balance.add(step);
            worst = std::max(worst, std::abs(balance.mismatch()));
            largest = std::max(largest, balance.externalWork());
        }
        return worst/largest;
    };
    const double coarse = worstMismatch(250);
    const double fine = worstMismatch(500);
    EXPECT_LT(fine, 2e-5);
    EXPECT_GT(std::log2(coarse/fine), 1.9) << coarse << ' ' << fine;
}

// Work of a driven root: the balance closes with the work of the supports
TEST(EnergyBalance, countsTheWorkOfDrivenSupports)
{
    const ShellMesh mesh = strip(3, 10);
    const ShellModel model
    (
        mesh, {{"all", 0.1, material(1.2e6, 0, 0.01)}},
        Constraints(mesh)
            .planeStrainStrip(Axis::y)
            .prescribed("uMin", Component::z, smoothStep(0, 0.3, 0.5))
            .fixed("uMin", {Component::x, Component::gx, Component::gz})
            .dofMap()
    );
    Newmark newmark(model);
    ShellState state = model.initialState();
    newmark.initialise(state, {});
    EnergyBalance balance(model, state, Vector::Zero(state.position.size()));
    double largest = 0;
    for (int k = 0; k < 400; ++k)
    {
        const DynamicStep step = newmark.step(state, 1e-3, {});
        ASSERT_TRUE(step.converged);
        state = step.state;
        balance.add(step);
        largest = std::max(largest, balance.total());
    }
    EXPECT_GT(balance.supportWork(), 0.1*largest);
    EXPECT_LT(std::abs(balance.mismatch()), 2e-3*largest);
    EXPECT_EQ(balance.externalWork(), 0);
    // Impulse of the supports is the momentum gained
    const Vec3 momentum = model.linearMomentum(state.velocity);
    EXPECT_LT((balance.impulse() - momentum).norm(), 2e-3*std::sqrt(2*0.1*largest));
}

// Released from a large static deflection, without damping: amplitude and energy over
// 20 periods
TEST(EnergyBalance, undampedFreeVibrationKeepsAmplitudeAndEnergy)
{
    Strip strip(4);
    const auto bend = std::make_shared<EdgeLoad>
    (
        strip.model, "uMax", Vec3(0, 0, 0.6), linearInTime(0, 1)
    );
    StaticSolver statics(strip.model);
    const StaticStep bent = statics.run(strip.model.initialState(), 1, 10, {bend});
    ASSERT_TRUE(bent.converged);
    const double start = strip.w(bent.state);
    EXPECT_GT(start, 1.5) << "a nonlinear vibration";

    Newmark newmark(strip.model);
    ShellState state = bent.state;
    state.time = 0;
    newmark.initialise(state, {});
    EnergyBalance balance(strip.model, state, Vector::Zero(state.position.size()));
    const double energy = balance.total();
    const int stepsPerPeriod = 200;
    std::vector<double> w{start};
    double worstEnergy = 0;
    for (int k = 0; k < 20*stepsPerPeriod; ++k)
    {
        const DynamicStep step = newmark.step(state, period/stepsPerPeriod, {});
        ASSERT_TRUE(step.converged) << step.report.describe();
        state = step.state;
        balance.add(step);
        worstEnergy = std::max(worstEnergy, std::abs(balance.total()/energy - 1));
        w.push_back(strip.w(state));
    }
    EXPECT_LT(worstEnergy, 0.01);

    // Amplitude of the first and of the last two periods: half the range of the tip
    const auto amplitude = [&](std::size_t from)
    {
        const auto begin = w.begin() + from;
        const auto [low, high] = std::minmax_element(begin, begin + 2*stepsPerPeriod + 1);
        return 0.5*(*high - *low);
    };
    const double first = amplitude(0);
    const double last = amplitude(w.size() - 1 - 2*stepsPerPeriod);
    EXPECT_NEAR(last/first, 1, 0.01);
    EXPECT_NEAR(first/start, 1, 0.01);
}

// Mass-proportional damping: the envelope of mode 1 falls as exp(-c t/2)
TEST(EnergyBalance, massProportionalDampingDecaysAsItShould)
{
    Strip strip(3);
    NewmarkOptions options;
    options.massDamping = 1.5;
    const auto bend = std::make_shared<EdgeLoad>(strip.model, "uMax", Vec3(0, 0, 0.01));
    const StaticStep bent =
        StaticSolver(strip.model).step(strip.model.initialState(), 1, {bend});
    ASSERT_TRUE(bent.converged);
    Newmark newmark(strip.model, options);
    ShellState state = bent.state;
    state.time = 0;
    newmark.initialise(state, {});
    EnergyBalance balance
    (
        strip.model, state, Vector::Zero(state.position.size()), options.massDamping
    );
    const double energy = balance.total();
    for (int k = 0; k < 5*200; ++k)
    {
        const DynamicStep step = newmark.step(state, period/200, {});
        ASSERT_TRUE(step.converged);
        state = step.state;
        balance.add(step);
    }
    // 97 % of the energy is in mode 1; the others decay at the same rate
    const double decay = std::exp(-options.massDamping*state.time);
    EXPECT_NEAR(balance.total()/energy, decay, 0.02*decay);
    EXPECT_LT(std::abs(balance.mismatch()), 1e-4*energy);
    EXPECT_NEAR(balance.dissipated(), energy - balance.total(), 1e-4*energy);
}

