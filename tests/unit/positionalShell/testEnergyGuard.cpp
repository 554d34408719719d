// SPDX-License-Identifier: GPL-3.0-or-later
//
// Steps that make energy from nothing are refused, whatever the method says of them.

#include "EdgeLoad.hpp"
#include "IntervalIntegrator.hpp"
#include "StripModel.hpp"

#include <gtest/gtest.h>

using namespace shellTest;

namespace
{

//- Newmark's method that finds another root in steps longer than the longest good one:
//  the body is crushed, at the velocity of the true step
class Misled : public Newmark
{
public:

    Misled(const ShellModel& model, double longest, double stretch)
    :
        Newmark(model, {}),
        longest_(longest),
        stretch_(stretch)
    {}

protected:

    DynamicStep doStep
    (
        const ShellState& start, double dt, const Loads& loads, const GivenForce& given
    ) override
    {
        DynamicStep step = Newmark::doStep(start, dt, loads, given);
        if (dt > longest_)
        {
            for (int i = 0; i < step.state.position.size(); i += dofsPerNode)
            {
                step.state.position[i] *= stretch_;
            }
        }
        return step;
    }

private:

    double longest_, stretch_;
};

Loads tipForce(const Strip& strip)
{
    return {std::make_shared<EdgeLoad>(strip.model, "uMax", Vec3(0, 0, 1e-3))};
}

} // namespace

TEST(EnergyGuard, spuriousStepsAreCutUntilTheyAreTrue)
{
    const Strip strip(3);
    const Loads loads = tipForce(strip);
    const double dt = period/50;
    Misled misled(strip.model, 0.3*dt, 0.1);
    ShellState state = strip.model.initialState();
    misled.initialise(state, loads);
    double wanted = 0;
    const auto steps = IntervalIntegrator(misled, {10, 0}).advance
    (
        state, dt, loads, {}, wanted
    );
    ASSERT_TRUE(steps.back().converged) << steps.back().report.describe();
    EXPECT_EQ(steps.size(), 4u);

    Newmark newmark(strip.model, {});
    ShellState expected = state;
    for (int k = 0; k < 4; ++k)
    {
        expected = newmark.step(expected, 0.25*dt, loads).state;
    }
    EXPECT_LT((steps.back().state.position - expected.position).norm(), 1e-12);
}

TEST(EnergyGuard, spuriousStepsThatCannotBeCutStopWithTheirEnergy)
{
    const Strip strip(3);
    const Loads loads = tipForce(strip);
    Misled misled(strip.model, 0, 0.1);
    ShellState state = strip.model.initialState();
    misled.initialise(state, loads);
    double wanted = 0;
    const auto steps = IntervalIntegrator(misled, {3, 0}).advance
    (
        state, period/50, loads, {}, wanted
    );
    EXPECT_FALSE(steps.back().converged);
    EXPECT_NE(steps.back().report.describe().find("from nothing"), std::string::npos)
        << steps.back().report.describe();
}

// Stretch e of the strip, E h b L (e + e^2/2)^2/2 with SVK's energy; from rest no
// work but that of the mean internal force, E h b L (e + e^2/2)(1 + e) e/2
TEST(EnergyGuard, tellsTheEnergyFromNothing)
{
    const Strip strip(3);
    const ShellState rest = strip.model.initialState();
    ShellState start = rest;
    start.velocity = start.acceleration = Vector::Zero(start.position.size());
    DynamicStep step;
    step.state = start;
    step.state.time = start.time + 0.01;
    const double e = -0.9;
    for (int i = 0; i < step.state.position.size(); i += dofsPerNode)
    {
        step.state.position[i] *= 1 + e;
    }
    double length = 0, width = 0;
    for (const auto& x : strip.mesh.nodes())
    {
        length = std::max(length, x[0]);
        width = std::max(width, x[1]);
    }
    const double stiffness = 1.2e6*0.1*width*length;
    const double strain = e + 0.5*e*e;
    const double energy = 0.5*stiffness*strain*strain;
    const double work = 0.5*stiffness*strain*(1 + e)*e;
    EnergyGuard guard(strip.model);
    EXPECT_NEAR(guard.excess(start, step), energy - work, 1e-9*energy);

    // Energy at the start that explains it
    start.velocity[0] = 1;
    const double unit = strip.model.kineticEnergy(start.velocity);
    start.velocity[0] = std::sqrt(1.2*energy/unit);
    EXPECT_EQ(guard.excess(start, step), 0);
    // and a method that conserves energy by construction
    start.velocity[0] = 0;
    step.meanForce = Vector::Zero(start.position.size());
    EXPECT_EQ(guard.excess(start, step), 0);
}

// A body at rest without loads has no energy that rounding could not double
TEST(EnergyGuard, roundingIsNoEnergy)
{
    const Strip strip(3);
    Newmark newmark(strip.model, {});
    ShellState state = strip.model.initialState();
    newmark.initialise(state, {});
    double wanted = 0;
    IntervalIntegrator interval(newmark, {0, 0});
    for (int k = 0; k < 5; ++k)
    {
        const auto steps = interval.advance(state, 1e-3, {}, {}, wanted);
        ASSERT_TRUE(steps.back().converged) << steps.back().report.describe();
        state = steps.back().state;
    }
}
