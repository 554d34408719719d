// SPDX-License-Identifier: GPL-3.0-or-later

#include "BodyForce.hpp"
#include "EdgeLoad.hpp"
#include "FollowerPressure.hpp"
#include "StripModel.hpp"
#include "SurfaceTraction.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace shellTest;

namespace
{

struct Peak
{
    double time;
    double value;
};

//- Local extremes of the tip, by the parabola through three samples
std::vector<Peak> peaks(const std::vector<double>& w, double dt, double separation)
{
    std::vector<Peak> found;
    for (std::size_t k = 1; k + 1 < w.size(); ++k)
    {
        const double before = w[k] - w[k - 1];
        const double after = w[k + 1] - w[k];
        if (before*after >= 0) continue;
        const double slope = 0.5*(before + after);
        const double bend = after - before;
        const Peak peak{dt*(double(k) - slope/bend), w[k] - 0.5*slope*slope/bend};
        const double last = found.empty() ? 0 : found.back().time;
        if (peak.time > last + separation) found.push_back(peak);
    }
    return found;
}

std::vector<double> tipHistory(Strip& strip, const Loads& loads, double dt, int n)
{
    Newmark newmark(strip.model);
    ShellState state = strip.model.initialState();
    newmark.initialise(state, loads);
    std::vector<double> w{0};
    for (int k = 0; k < n; ++k)
    {
        const DynamicStep step = newmark.step(state, dt, loads);
        if (!step.converged) throw std::runtime_error(step.report.describe());
        state = step.state;
        w.push_back(strip.w(state));
    }
    return w;
}

} // namespace

// A free shell under gravity falls: the first acceleration and the motion are exact
TEST(Newmark, freeFallIsExact)
{
    const ShellMesh mesh = curvedPatch();
    const ShellModel model(mesh, {{"all", 0.1, material(100, 0.3, 2)}}, Constraints(mesh).dofMap());
    const Vec3 g(1, -2, 3);
    const Loads loads{std::make_shared<BodyForce>(model, g)};
    Newmark newmark(model);
    ShellState state = model.initialState();
    newmark.initialise(state, loads);
    for (int i = 0; i < mesh.nNodes(); ++i)
    {
        EXPECT_LT((state.acceleration.segment<3>(7*i) - g).norm(), 1e-9);
        EXPECT_LT(state.acceleration.segment<4>(7*i + 3).norm(), 1e-9);
    }
    for (int k = 0; k < 5; ++k)
    {
        const DynamicStep step = newmark.step(state, 0.1, loads);
        ASSERT_TRUE(step.converged) << step.report.describe();
        state = step.state;
    }
    Vector exact = mesh.initialPositions();
    for (int i = 0; i < mesh.nNodes(); ++i) exact.segment<3>(7*i) += 0.5*0.5*0.5*g;
    EXPECT_LT((state.position - exact).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((model.linearMomentum(state.velocity) - 0.5*model.totalMass()*g).norm(), 1e-9);
}

// The end of a step satisfies the equation of motion with Newmark's rates, damping
// included: recomputed here from the state alone
TEST(Newmark, theStepSolvesItsEquation)
{
    Strip strip(3);
    NewmarkOptions options;
    options.beta = 0.3025;
    options.gamma = 0.6;
    options.massDamping = 5;
    options.newton.residualTolerance = 1e-11;
    const Loads loads{SurfaceTraction::deadPressure(strip.model, "all", -0.4)};
    const ShellState start = march(strip, loads, 0.05, 10, options);
    Newmark newmark(strip.model, options);
    const double dt = 0.004;
    const DynamicStep step = newmark.step(start, dt, loads);
    ASSERT_TRUE(step.converged);
    const ShellState& end = step.state;

    const double beta = options.beta;
    const double gamma = options.gamma;
    const Vector d = end.position - start.position;
    Vector acceleration =
        d/(beta*dt*dt) - start.velocity/(beta*dt) - (0.5/beta - 1)*start.acceleration;
    Vector velocity =
        start.velocity + dt*((1 - gamma)*start.acceleration + gamma*acceleration);
    for (int i = 6; i < velocity.size(); i += 7) velocity[i] = acceleration[i] = 0;
    EXPECT_LT((acceleration - end.acceleration).norm(), 1e-7*acceleration.norm());
    EXPECT_LT((velocity - end.velocity).norm(), 1e-8*velocity.norm());

    const Vector residual = totalForce(loads, strip.model, end.position, end.time)
        - strip.model.internalForce(end.position)
        - strip.model.massTimes(acceleration + 5*velocity);
    const double scale = strip.model.internalForce(end.position).norm();
    EXPECT_LT(strip.model.dofs().reduce(residual).norm(), 1e-8*scale);
}

// Inertia, damping, elastic and follower parts of the tangent together: increments
// square from one iteration to the next only if all are exact
TEST(Newmark, theTangentOfAStepIsExact)
{
    const ShellMesh mesh = strip(3, 10);
    const ShellModel model
    (
        mesh, {{"all", 2, material(150, 0.3, 0.05)}},
        Constraints(mesh).clamped("uMin").planeStrainStrip(Axis::y).dofMap()
    );
    const Loads loads{std::make_shared<FollowerPressure>(model, "all", -0.1)};
    NewmarkOptions options;
    options.massDamping = 3;
    options.newton.tangentUpdate = TangentUpdate::everyIteration;
    Newmark newmark(model, options);
    ShellState state = model.initialState();
    newmark.initialise(state, loads);
    const DynamicStep step = newmark.step(state, 1.5, loads);
    ASSERT_TRUE(step.converged) << step.report.describe();
    std::vector<double> increments;
    for (const NewtonIteration& iteration : step.report.history)
    {
        if (iteration.factorisation == Factorisation::none) break;
        increments.push_back(std::max(iteration.increment.position, iteration.increment.director));
    }
    double best = 0;
    for (std::size_t k = 2; k < increments.size(); ++k)
    {
        if (increments[k] < 1e-12) break;
        best = std::max
        (
            best,
            std::log(increments[k]/increments[k - 1])/std::log(increments[k - 1]/increments[k - 2])
        );
    }
    EXPECT_GT(best, 1.8) << step.report.describe();
}

TEST(Newmark, aStepCanBeRepeatedFromItsStart)
{
    Strip strip(3);
    const Loads loads{SurfaceTraction::deadPressure(strip.model, "all", -0.4)};
    const Loads other{SurfaceTraction::deadPressure(strip.model, "all", 0.4)};
    Newmark newmark(strip.model);
    ShellState start = strip.model.initialState();
    newmark.initialise(start, loads);
    const DynamicStep first = newmark.step(start, 1e-3, loads);
    newmark.step(start, 1e-3, other);
    newmark.step(start, 2e-3, loads);
    const DynamicStep again = newmark.step(start, 1e-3, loads);
    EXPECT_LT((first.state.position - again.state.position).norm(), 1e-10);

    // A given generalised force is a load like any other
    const Vector force = totalForce(loads, strip.model, start.position, 0);
    const DynamicStep given = newmark.step(start, 1e-3, {}, &force);
    EXPECT_LT((first.state.position - given.state.position).norm(), 1e-10);
    EXPECT_LT((given.externalForce - force).norm(), 1e-15);
}

TEST(Newmark, isOfSecondOrder)
{
    Strip strip(3);
    // Smooth start, so that only what the steps resolve is set in motion
    const auto factor = smoothStep(0, 0.4);
    const Loads loads
    {
        std::make_shared<EdgeLoad>(strip.model, "uMax", Vec3(0, 0, 2), factor)
    };
    NewmarkOptions options;
    options.newton.residualTolerance = 1e-11;
    options.newton.incrementTolerance = 1e-9;
    const double endTime = 0.5;
    const Vector reference = march(strip, loads, endTime, 3200, options).position;
    std::vector<double> errors;
    for (int n : {100, 200, 400})
    {
        errors.push_back((march(strip, loads, endTime, n, options).position - reference).norm());
    }
    EXPECT_GT(reference[7*strip.tip + 2], 3) << "the deflection is large";
    EXPECT_GT(std::log2(errors[0]/errors[1]), 1.9) << errors[0] << ' ' << errors[1];
    EXPECT_GT(std::log2(errors[1]/errors[2]), 1.9) << errors[1] << ' ' << errors[2];
}

// source: two independent codes agree on these peaks to 0.06 % (geometrically exact
// beam; CalculiX S8R): dead 7.2761 at 0.2538, -0.1445 at 0.5065, 7.2757 at 0.7599,
// follower 7.7702 at 0.2712, -0.0840 at 0.5431, 7.790 at 0.821.
// Tolerances: 0.1 % of the first peak in value (mesh of 10 and dt of 1e-3), 0.5 % of a
// period in time (higher modes make the top of a peak flat).
TEST(Newmark, suddenlyLoadedStrip)
{
    struct Case
    {
        const char* name;
        bool follower;
        std::vector<Peak> expected;
    };
    const Case cases[] =
    {
        {"dead", false, {{0.2538, 7.2761}, {0.5065, -0.1445}, {0.7599, 7.2757}}},
        {"follower", true, {{0.2712, 7.7702}, {0.5431, -0.0840}, {0.821, 7.790}}}
    };
    for (const Case& c : cases)
    {
        Strip strip(10);
        Loads loads;
        loads.push_back
        (
            c.follower
          ? std::make_shared<FollowerPressure>(strip.model, "all", -0.4)
          : SurfaceTraction::deadPressure(strip.model, "all", -0.4)
        );
        const double dt = 1e-3;
        const auto found = peaks(tipHistory(strip, loads, dt, 850), dt, 0.15);
        ASSERT_GE(found.size(), 3u) << c.name;
        for (int k = 0; k < 3; ++k)
        {
            EXPECT_NEAR(found[k].value, c.expected[k].value, 0.001*7.2761) << c.name << k;
            EXPECT_NEAR(found[k].time, c.expected[k].time, 0.005*period) << c.name << k;
        }
    }
}

// A driven root is the same as gravity in the frame of the root
TEST(Newmark, drivenRootEqualsInertialForce)
{
    const double amplitude = 0.5;
    const auto motion = smoothStep(0, 0.3, amplitude);
    const ShellMesh mesh = strip(3, 10);
    const std::vector<Section> sections{{"all", 0.1, material(1.2e6, 0, 0.01)}};
    const ShellModel driven
    (
        mesh, sections,
        Constraints(mesh)
            .planeStrainStrip(Axis::y)
            .prescribed("uMin", Component::z, motion)
            .fixed("uMin", {Component::x, Component::gx, Component::gz})
            .dofMap()
    );
    const ShellModel held
    (
        mesh, sections, Constraints(mesh).clamped("uMin").planeStrainStrip(Axis::y).dofMap()
    );
    const Loads inertial
    {
        std::make_shared<BodyForce>
        (
            held, Vec3(0, 0, -1),
            timeFunction([=](double t) { return motion->secondDerivative(t); })
        )
    };
    const int tip = mesh.nodeSet("uMax")[0];
    const auto relativeTip = [&](const ShellModel& model, const Loads& loads, int n)
    {
        Newmark newmark(model);
        ShellState state = model.initialState();
        newmark.initialise(state, loads);
        for (int k = 0; k < n; ++k) state = newmark.step(state, 0.4/n, loads).state;
        return state.position[7*tip + 2] - state.position[2];
    };
    const double exact = relativeTip(held, inertial, 1600);
    EXPECT_GT(std::abs(exact), 0.05);
    const double coarse = std::abs(relativeTip(driven, {}, 200) - exact);
    const double fine = std::abs(relativeTip(driven, {}, 400) - exact);
    EXPECT_LT(fine, 2e-3*std::abs(exact));
    EXPECT_GT(coarse/fine, 3) << "second order in the step";
}

// Accelerations at the start, recomputed from the state: moving, damped, and with a
// root that is driven with an acceleration of its own
TEST(Newmark, accelerationsAtTheStartSatisfyTheEquationOfMotion)
{
    const ShellMesh mesh = strip(2, 4);
    const double driven = 30;
    const ShellModel model
    (
        mesh, {{"all", 0.1, material(1200, 0.3, 0.01)}},
        Constraints(mesh)
            .prescribed
            (
                "uMin", Component::z,
                timeFunction
                (
                    [=](double t) { return 0.5*driven*t*t; },
                    [=](double t) { return driven*t; },
                    [=](double) { return driven; }
                )
            )
            .dofMap()
    );
    NewmarkOptions options;
    options.massDamping = 7;
    Newmark newmark(model, options);
    ShellState state = model.initialState();
    state.velocity = randomVector(state.velocity.size(), 8);
    const Loads loads{std::make_shared<BodyForce>(model, Vec3(1, 2, 3))};
    newmark.initialise(state, loads);

    const int root = fullIndex(mesh.nodeSet("uMin")[0], Component::z);
    EXPECT_EQ(state.acceleration[root], driven);
    EXPECT_EQ(state.velocity[root], 0);
    const Vector residual = totalForce(loads, model, state.position, 0)
        - model.internalForce(state.position)
        - model.massTimes(state.acceleration + 7*state.velocity);
    const double scale = model.massTimes(7*state.velocity).norm();
    EXPECT_LT(model.dofs().reduce(residual).norm(), 1e-10*scale);
}

// Driven unknowns have the rates of their function, not those of the difference scheme
TEST(Newmark, drivenUnknownsTakeTheRatesOfTheirFunction)
{
    const ShellMesh mesh = strip(2, 10);
    const auto motion = smoothStep(0, 0.1, 0.2);
    const ShellModel model
    (
        mesh, {{"all", 0.1, material(1.2e6, 0, 0.01)}},
        Constraints(mesh)
            .planeStrainStrip(Axis::y)
            .prescribed("uMin", Component::z, motion)
            .fixed("uMin", {Component::x, Component::gx, Component::gz})
            .dofMap()
    );
    Newmark newmark(model);
    ShellState state = model.initialState();
    newmark.initialise(state, {});
    const int root = fullIndex(mesh.nodeSet("uMin")[0], Component::z);
    for (int k = 0; k < 5; ++k)
    {
        const DynamicStep step = newmark.step(state, 0.01, {});
        ASSERT_TRUE(step.converged) << step.report.describe();
        state = step.state;
        EXPECT_EQ(state.position[root], motion->value(state.time));
        EXPECT_EQ(state.velocity[root], motion->firstDerivative(state.time));
        EXPECT_EQ(state.acceleration[root], motion->secondDerivative(state.time));
    }
}

// While nothing changes much one factorisation serves many steps; another step length
// is another matrix
TEST(Newmark, factorsAreKeptUntilTheStepLengthChanges)
{
    Strip strip(3);
    const Loads loads{SurfaceTraction::deadPressure(strip.model, "all", -1e-4)};
    Newmark newmark(strip.model);
    ShellState state = strip.model.initialState();
    newmark.initialise(state, loads);
    bool severalIterations = false;
    for (int k = 0; k < 30; ++k)
    {
        const DynamicStep step = newmark.step(state, 1e-3, loads);
        ASSERT_TRUE(step.converged) << step.report.describe();
        severalIterations = severalIterations || step.report.iterations > 1;
        state = step.state;
    }
    EXPECT_TRUE(severalIterations) << "the rate of convergence was looked at";
    EXPECT_EQ(newmark.linearReport().nCholesky, 1);
    EXPECT_FALSE(newmark.step(state, 1e-3, loads).report.history[0].newTangent);
    EXPECT_TRUE(newmark.step(state, 1.1e-3, loads).report.history[0].newTangent);
}

// Start from positions that are not in equilibrium through the thickness
TEST(Newmark, theThicknessStrainStartsInEquilibrium)
{
    const double nu = 0.3;
    const double h = 0.05;
    const double k = 0.02;
    const ShellMesh mesh = strip(2, 1, 0.5);
    const ShellModel model(mesh, {{"all", h, material(200, nu)}}, Constraints(mesh).dofMap());
    ShellState state = model.initialState();
    for (int i = 0; i < mesh.nNodes(); ++i)
    {
        const double x = mesh.nodes()[i][0];
        state.position[7*i + 2] = 0.5*k*x*x;
        state.position[7*i + 3] = -k*x;
    }
    Newmark newmark(model);
    newmark.initialise(state, {});
    // a = nu h k/(4(1-nu)) up to terms of higher order in k
    const double a = nu*h*k/(4*(1 - nu));
    for (int i = 0; i < mesh.nNodes(); ++i) EXPECT_NEAR(state.position[7*i + 6], a, 0.02*a);
    const Vector f = model.internalForce(state.position);
    for (int i = 0; i < mesh.nNodes(); ++i) EXPECT_LT(std::abs(f[7*i + 6]), 1e-12);
}

TEST(Newmark, parametersAreChecked)
{
    const Strip strip(1);
    NewmarkOptions o;
    o.gamma = 0.4;
    EXPECT_NE
    (
        errorOf([&] { Newmark(strip.model, o); }).find("gamma 0.4"), std::string::npos
    );
    o.gamma = 0.6;
    EXPECT_NE(errorOf([&] { Newmark(strip.model, o); }).find("beta 0.25"), std::string::npos);
    o = NewmarkOptions();
    o.massDamping = -1;
    EXPECT_NE(errorOf([&] { Newmark(strip.model, o); }).find("massDamping"), std::string::npos);
    Newmark fine(strip.model);
    EXPECT_NE
    (
        errorOf([&] { fine.step(strip.model.initialState(), 0, {}); }).find("not positive"),
        std::string::npos
    );
}
