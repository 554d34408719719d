// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rigid ties in motion, free and given.

#include "EnergyBalance.hpp"
#include "EnergyMomentum.hpp"
#include "GeneralisedAlpha.hpp"
#include "Newmark.hpp"
#include "Reactions.hpp"
#include "ShellTestModels.hpp"
#include "TieLoad.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

using namespace shellTest;

namespace
{

MotionOptions tight(double residual = 1e-12, double increment = 1e-10)
{
    MotionOptions options;
    options.newton.residualTolerance = residual;
    options.newton.incrementTolerance = increment;
    return options;
}

NewmarkOptions newmarkOptions()
{
    NewmarkOptions options;
    static_cast<MotionOptions&>(options) = tight();
    return options;
}

//- Free strip, one end tied, thrown with a spin about a skew axis
struct Tossed
{
    ShellMesh mesh = rectangleMesh(2, 1, Vec3::Zero(), {1, 0, 0}, {0, 0.3, 0});
    ShellModel model;
    ShellState state;
    Vec3 spin;

    Tossed(const std::string& tied, ElementForm form, double rate)
    :
        model
        (
            mesh, {{"all", 0.02, material(1e6, 0.3, 1000)}},
            Constraints(mesh).rigidTie(tied, Vec3::Zero()).dofMap(), {}, form
        ),
        state(model.initialState()),
        spin(rate*Vec3(0.3, 1, 0.2))
    {
        for (int i = 0; i < mesh.nNodes(); ++i)
        {
            const Vec3 r = mesh.nodes()[i] - Vec3(0.5, 0.15, 0);
            state.velocity.segment<3>(7*i) = Vec3(1, 2, 3) + spin.cross(r);
            state.velocity.segment<3>(7*i + 3) = spin.cross(Vec3(0, 0, 1));
        }
    }

    double energy(const ShellState& s) const
    {
        return model.kineticEnergy(s.velocity) + model.strainEnergy(s.position);
    }

    //- Greatest change of a distance between tied nodes or of a director's length
    double distortion(const ShellState& s) const
    {
        const RigidTie& tie = model.dofs().ties()[0];
        double worst = 0;
        for (int i : tie.nodes())
        {
            worst = std::max(worst, std::abs(s.position.segment<3>(7*i + 3).norm() - 1));
            for (int j : tie.nodes())
            {
                const double now =
                    (s.position.segment<3>(7*i) - s.position.segment<3>(7*j)).norm();
                worst = std::max(worst, std::abs(now - (mesh.nodes()[i] - mesh.nodes()[j]).norm()));
            }
        }
        return worst;
    }
};

DynamicStep step(TimeIntegrator& integrator, const ShellState& s, double dt, const Loads& loads)
{
    DynamicStep next = integrator.step(s, dt, loads);
    if (!next.converged) throw std::runtime_error(next.report.describe());
    return next;
}

//- Cantilever strip in motion under a force at an arm beyond its tied end
struct Driven
{
    ShellMesh mesh = strip(3, 10);
    ShellModel model
    {
        mesh, {{"all", 0.1, material(1.2e6, 0.3, 0.01)}},
        Constraints(mesh).clamped("uMin").rigidTie("uMax", Vec3(11, 0.8, 0)).dofMap(),
        {}, ElementForm::assumedStrain
    };
    Loads loads
    {
        std::make_shared<TieLoad>
        (
            model, "uMax", Vec3(0, 0, 2), Vec3(1, 0, 0), smoothStep(0, 0.3)
        )
    };

    ShellState after(TimeIntegrator& integrator, double time, int n) const
    {
        ShellState state = model.initialState();
        integrator.initialise(state, loads);
        for (int k = 0; k < n; ++k) state = step(integrator, state, time/n, loads).state;
        return state;
    }
};

} // namespace

// The tie does no work: energy and momenta of a free body are kept as without it
TEST(TieDynamics, energyMomentumKeepsAFreeBody)
{
    for (ElementForm form : {ElementForm::displacement, ElementForm::assumedStrain})
    {
        const Tossed body("uMin", form, 5);
        const ShellModel& model = body.model;
        EnergyMomentum integrator(model, tight(1e-13));
        ShellState state = body.state;
        integrator.initialise(state, {});
        const double E = body.energy(state);
        const Vec3 P = model.linearMomentum(state.velocity);
        const Vec3 L = model.angularMomentum(state.position, state.velocity);
        for (int k = 0; k < 400; ++k) state = step(integrator, state, 2e-3, {}).state;
        EXPECT_LT(std::abs(body.energy(state)/E - 1), 1e-10);
        EXPECT_LT((model.linearMomentum(state.velocity) - P).norm(), 1e-11*P.norm());
        EXPECT_LT
        (
            (model.angularMomentum(state.position, state.velocity) - L).norm(), 1e-10*L.norm()
        );
        EXPECT_LT(body.distortion(state), 1e-11);
        EXPECT_GT((model.dofs().ties()[0].rotation(state.position)
            - Eigen::Matrix3d::Identity()).norm(), 1);
    }
}

// A body tied as a whole starts with the accelerations of a rigid one: those of the spin,
// and what the moment of inertia makes of its change
TEST(TieDynamics, startsWithTheAccelerationsOfARigidBody)
{
    const Tossed body("all", ElementForm::assumedStrain, 5);
    const ShellModel& model = body.model;
    ShellState state = body.state;
    EnergyMomentum(model, tight()).initialise(state, {});
    EXPECT_LT(model.linearMomentum(state.acceleration).norm(), 1e-9*model.totalMass());
    EXPECT_LT(model.angularMomentum(state.position, state.acceleration).norm(), 1e-9);

    // a = alpha x r + omega x (omega x r) with one alpha
    const RigidTie& tie = model.dofs().ties()[0];
    Vector own = state.acceleration;
    Vector centripetal = Vector::Zero(own.size());
    tie.addCentripetal(state.velocity, body.spin, centripetal);
    own -= centripetal;
    const RigidTie::Six alpha = tie.rigidPart(state.position, own);
    EXPECT_GT(alpha.angular.norm(), 1);
    for (int i = 0; i < body.mesh.nNodes(); ++i)
    {
        const Vec3 r = state.position.segment<3>(7*i) - tie.centre(state.position);
        const Vec3 expected = alpha.linear + alpha.angular.cross(r);
        EXPECT_LT((own.segment<3>(7*i) - expected).norm(), 1e-8);
    }
}

TEST(TieDynamics, integratorsAreOfSecondOrder)
{
    const Driven strip;
    EnergyMomentum exact(strip.model, tight());
    const Vector reference = strip.after(exact, 0.3, 400).position;
    const auto error = [&](TimeIntegrator& integrator, int n)
    {
        return (strip.after(integrator, 0.3, n).position - reference).norm();
    };
    Newmark newmark(strip.model, newmarkOptions());
    GeneralisedAlphaOptions damped;
    static_cast<MotionOptions&>(damped) = tight();
    damped.spectralRadius = 0.6;
    GeneralisedAlpha alpha(strip.model, damped);
    for (TimeIntegrator* integrator : {static_cast<TimeIntegrator*>(&newmark),
        static_cast<TimeIntegrator*>(&alpha)})
    {
        const double coarse = error(*integrator, 40);
        const double fine = error(*integrator, 80);
        EXPECT_GT(std::log2(coarse/fine), 1.85);
        EXPECT_LT(fine, 0.05);
    }
    EXPECT_GT((reference - strip.mesh.initialPositions()).norm(), 1);
}

// The account of works closes for a force with an arm and a moment
TEST(TieDynamics, accountOfEnergiesCloses)
{
    const Driven strip;
    Newmark integrator(strip.model, newmarkOptions());
    ShellState state = strip.model.initialState();
    integrator.initialise(state, strip.loads);
    EnergyBalance account
    (
        strip.model, state, totalForce(strip.loads, strip.model, state.position, 0)
    );
    for (int k = 0; k < 150; ++k)
    {
        const DynamicStep next = step(integrator, state, 2e-3, strip.loads);
        account.add(next);
        state = next.state;
    }
    EXPECT_GT(account.externalWork(), 0.5);
    EXPECT_LT(std::abs(account.mismatch()), 1e-3*account.externalWork());
}

// Positions, rates and directors of a given motion against each other and the rotation
TEST(RigidMotion, isARotationWithItsRates)
{
    RigidMotion motion;
    motion.point = Vec3(1, 2, 3);
    motion.direction = Vec3(0.5, 1, 0);
    motion.displacement = smoothStep(0, 2, 0.7);
    motion.axis = Vec3(1, -1, 2);
    motion.angle = sine(1.3, 0.2, 0.4);
    const double t = 0.9;
    const Vec3 arm(0.3, -0.8, 0.5);
    const Eigen::AngleAxisd turn(motion.angle->value(t), motion.axis.normalized());
    const Vec3 moved = motion.displacement->value(t)*motion.direction + turn*arm - arm;
    for (int c = 0; c < 3; ++c)
    {
        const TimeFunctionPtr x = motion.ofPosition(arm, c);
        EXPECT_NEAR(x->value(t), moved[c], 1e-14);
        EXPECT_NEAR(motion.ofDirector(arm, c)->value(t), (turn*arm - arm)[c], 1e-14);
        const double rate = polynomialDerivative<double>
        (
            [&](double s) { return x->value(t + s); }, 0.01
        );
        const double second = polynomialDerivative<double>
        (
            [&](double s) { return x->firstDerivative(t + s); }, 0.01
        );
        EXPECT_NEAR(x->firstDerivative(t), rate, 1e-10);
        EXPECT_NEAR(x->secondDerivative(t), second, 1e-10);
    }
    motion.axis = Vec3::Zero();
    EXPECT_EQ
    (
        errorOf([&] { motion.ofPosition(arm, 0); }), "rigid motion: the axis is zero"
    );
}

// A shell driven as a whole has no strain; what it takes is its momentum's change
TEST(RigidMotion, drivesAShellWithoutStrain)
{
    const ShellMesh mesh = curvedPatch();
    RigidMotion motion;
    motion.point = Vec3(0.5, 0, 0);
    motion.displacement = smoothStep(0, 1);
    motion.axis = Vec3(1, 2, 3);
    motion.angle = smoothStep(0, 1, 2.5);
    const ShellModel model
    (
        mesh, {{"all", 0.1, material(100, 0.3)}},
        Constraints(mesh).rigidMotion("all", motion).dofMap()
    );
    Newmark integrator(model, newmarkOptions());
    ShellState state = model.initialState();
    integrator.initialise(state, {});
    for (int k = 0; k < 20; ++k) state = step(integrator, state, 0.03, {}).state;
    EXPECT_LT(model.strainEnergy(state.position), 1e-20);
    EXPECT_GT((state.position - mesh.initialPositions()).norm(), 1);
    const ResultantForce drive = resultant
    (
        mesh.nodeSet("all"), state.position,
        reactions(model, state, Vector::Zero(state.position.size()))
    );
    EXPECT_GT(drive.force.norm(), 0.01);
    EXPECT_LT
    (
        (drive.force - model.linearMomentum(state.acceleration)).norm(), 1e-11
    );
    EXPECT_LT
    (
        (drive.moment - model.angularMomentum(state.position, state.acceleration)).norm(), 1e-11
    );
}
