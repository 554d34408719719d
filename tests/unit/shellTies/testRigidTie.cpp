// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rigid ties in statics: geometry, elimination and its tangent, loads at the point.

#include "EdgeLoad.hpp"
#include "EigenFrequencies.hpp"
#include "Reactions.hpp"
#include "ShellTestModels.hpp"
#include "StaticProblem.hpp"
#include "StaticSolver.hpp"
#include "TieElimination.hpp"
#include "TieLoad.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

using namespace shellTest;

namespace
{

using Mat3 = RigidTie::Mat3;

const Vec3 point(0.3, 0.2, 0.7);

//- Doubly curved patch, one edge tied
struct TiedPatch
{
    ShellMesh mesh = curvedPatch();
    ShellModel model
    {
        mesh, {{"all", 0.1, material(100, 0.3)}},
        Constraints(mesh).clamped("uMin").rigidTie("uMax", point).dofMap(),
        {}, ElementForm::assumedStrain
    };
    TieElimination ties{model.dofs()};

    const RigidTie& tie() const { return model.dofs().ties()[0]; }

    //- A state far from special in which the tie is rigid
    Vector state() const
    {
        Vector q = randomState(mesh, 0.03, 3);
        tie().move(mesh.initialPositions(), {Vec3(0.1, -0.2, 0.1), Vec3(0.4, -0.3, 0.5)}, q);
        model.dofs().setPrescribedPositions(0, q);
        return q;
    }

    //- The state after increments on equations
    Vector moved(const Vector& q, const Vector& increments) const
    {
        Vector after;
        ties.advance(q, increments, q, after);
        return after;
    }

    //- A direction of increments, only those of the tie's freedoms at the tie
    Vector direction(int seed) const
    {
        Vector d = randomVector(model.dofs().nEquations(), seed);
        for (int node : tie().nodes())
        {
            for (int k = 0; k < 6 && node != tie().nodes().front(); ++k)
            {
                d[model.dofs().equation(7*node + k)] = 0;
            }
        }
        return d;
    }
};

//- Cantilever along x, normal z, free end tied to a point beyond it
struct TiedStrip
{
    ShellMesh mesh;
    ShellModel model;

    TiedStrip(int n, double length, double arm, ElementForm form, double h = 0.1)
    :
        mesh(strip(n, length)),
        model
        (
            mesh, {{"all", h, material(1.2e6, 0)}},
            Constraints(mesh).clamped("uMin")
                .rigidTie("uMax", Vec3(length + arm, 0.5, 0)).dofMap(),
            {}, form
        )
    {}

    Vec3 pointIn(const ShellState& state) const
    {
        return model.dofs().ties()[0].point(state.position);
    }
};

StaticStep solved(const ShellModel& model, const Loads& loads, int steps)
{
    StaticSolver solver(model);
    return solver.run(model.initialState(), 1, steps, loads);
}

} // namespace

TEST(RigidTie, motionsResultantsAndSpreadForces)
{
    const TiedPatch patch;
    const RigidTie& tie = patch.tie();
    const Vector q0 = patch.mesh.initialPositions();
    EXPECT_LT((tie.point(q0) - point).norm(), 1e-14);
    EXPECT_LT((tie.rotation(q0) - Mat3::Identity()).norm(), 1e-13);

    const RigidTie::Six motion{Vec3(1, 2, 3), Vec3(0.5, -1, 0.7)};
    const Mat3 turn =
        Eigen::AngleAxisd(motion.angular.norm(), motion.angular.normalized()).toRotationMatrix();
    Vector q = q0;
    tie.move(q0, motion, q);
    EXPECT_LT((tie.rotation(q) - turn).norm(), 1e-13);
    const Vec3 c = tie.centre(q0);
    EXPECT_LT((tie.point(q) - (c + motion.linear + turn*(point - c))).norm(), 1e-13);

    const RigidTie::Six six{Vec3(1, -2, 0.5), Vec3(0.2, 0.1, 3)};
    Vector force = Vector::Zero(q.size());
    tie.spread(q, six, force);
    const RigidTie::Six back = tie.resultant(q, force);
    EXPECT_LT((back.linear - six.linear).norm(), 1e-13);
    EXPECT_LT((back.angular - six.angular).norm(), 1e-13);

    // Rigid rates are found again, and forces do their work on them
    Vector rate = Vector::Zero(q.size());
    for (int node : tie.nodes())
    {
        const Vec3 r = q.segment<3>(7*node) - tie.centre(q);
        const Vec3 g = q.segment<3>(7*node + 3);
        rate.segment<3>(7*node) = six.linear + six.angular.cross(r);
        rate.segment<3>(7*node + 3) = six.angular.cross(g);
    }
    const RigidTie::Six found = tie.rigidPart(q, rate);
    EXPECT_LT((found.linear - six.linear).norm(), 1e-13);
    EXPECT_LT((found.angular - six.angular).norm(), 1e-13);
    EXPECT_NEAR
    (
        force.dot(rate), six.linear.squaredNorm() + six.angular.squaredNorm(), 1e-12
    );
}

// The reduced residual is the first derivative of the energy along finite motions of the
// tie, the reduced tangent the second, also where nothing is in equilibrium
TEST(TieElimination, isTheDerivativeOfTheEnergy)
{
    const TiedPatch patch;
    const ShellModel& model = patch.model;
    const Vec3 force(3, -2, 5);
    const Loads loads
    {
        std::make_shared<TieLoad>(model, "uMax", force, Vec3::Zero()),
        std::make_shared<EdgeLoad>(model, "uMax", Vec3(1, 2, -1))
    };
    const Vector dead = [&]
    {
        Vector f = Vector::Zero(model.dofs().nFull());
        loads[1]->addForce(model, f, 0, f);
        return f;
    }();
    const Vector q = patch.state();
    const Vector none;
    StaticProblem problem(model, loads, nullptr, 0, q, none);
    Vector residual;
    KindNorms scale;
    problem.residual(residual, scale);
    Vector onEquations = model.dofs().reduce(residual);
    patch.ties.project(q, onEquations);
    SystemMatrix K = model.makeMatrix();
    problem.addStiffness({q, q}, K);
    const SparseMatrix reduced =
        patch.ties.reduced(q, K.matrix(), residual, problem.tieForces());

    for (int seed = 1; seed < 4; ++seed)
    {
        const Vector d = patch.direction(seed);
        const auto potential = [&](double s)
        {
            const Vector x = patch.moved(q, s*d);
            return model.strainEnergy(x) - dead.dot(x) - force.dot(patch.tie().point(x));
        };
        EXPECT_NEAR
        (
            polynomialDerivative<double>(potential, 0.02), -onEquations.dot(d),
            1e-8*std::abs(onEquations.dot(d))
        );
        // Weights of the central difference of order 8 for the second derivative
        const double weights[5] = {-205.0/72, 8.0/5, -1.0/5, 8.0/315, -1.0/560};
        const double step = 0.01;
        double second = weights[0]*potential(0);
        for (int k = 1; k < 5; ++k)
        {
            second += weights[k]*(potential(k*step) + potential(-k*step));
        }
        second /= step*step;
        EXPECT_NEAR(d.dot(reduced*d), second, 1e-6*std::abs(second)) << seed;
    }
}

// With a moment, which has no energy, the tangent is that of the residual in equilibrium
TEST(TieElimination, tangentWithAMomentIsThatOfTheResidual)
{
    const TiedPatch patch;
    const ShellModel& model = patch.model;
    const Loads loads
    {
        std::make_shared<TieLoad>
        (
            model, "uMax", Vec3(0.02, -0.01, 0.03), Vec3(0.02, 0.03, -0.01), linearInTime(0, 1)
        )
    };
    StaticOptions options;
    options.newton.residualTolerance = 1e-12;
    options.newton.incrementTolerance = 1e-10;
    StaticSolver solver(model, options);
    const StaticStep end = solver.run(model.initialState(), 1, 3, loads);
    ASSERT_TRUE(end.converged) << end.report.describe();
    const Vector q = end.state.position;
    EXPECT_GT((patch.tie().rotation(q) - Mat3::Identity()).norm(), 0.2);
    EXPECT_GT(solver.linearReport().nLU, 0);

    const Vector none;
    const auto residualAt = [&](const Vector& x, Vector& full)
    {
        StaticProblem problem(model, loads, nullptr, 1, x, none);
        KindNorms scale;
        problem.residual(full, scale);
        Vector r = model.dofs().reduce(full);
        patch.ties.project(x, r);
        return r;
    };
    Vector full;
    residualAt(q, full);
    StaticProblem problem(model, loads, nullptr, 1, q, none);
    SystemMatrix K = model.makeMatrix();
    problem.addStiffness({q, q}, K);
    const SparseMatrix reduced = patch.ties.reduced(q, K.matrix(), full, problem.tieForces());
    Vector ignored;
    for (int seed = 5; seed < 8; ++seed)
    {
        const Vector d = patch.direction(seed);
        const Vector rate = polynomialDerivative<Vector>
        (
            [&](double s) { return residualAt(patch.moved(q, s*d), ignored); }, 0.01
        );
        EXPECT_LT((rate + reduced*d).norm(), 1e-7*rate.norm()) << seed;
    }
}

// source: beam theory, deflection P L^3/(3 EI) + P a L^2/(2 EI) at the end of the strip and
// rotation P L^2/(2 EI) + P a L/EI for a force P at the arm a beyond it
TEST(RigidTie, forceAtAnArmInSmallDeflection)
{
    const double L = 10;
    const double a = 3;
    const double EI = 100;
    const double P = 1e-3;
    const TiedStrip strip(8, L, a, ElementForm::assumedStrain);
    const Loads loads
    {
        std::make_shared<TieLoad>(strip.model, "uMax", Vec3(0, 0, P), Vec3::Zero())
    };
    const StaticStep end = solved(strip.model, loads, 1);
    ASSERT_TRUE(end.converged);
    const double slope = P*L*L/(2*EI) + P*a*L/EI;
    const double w = P*L*L*L/(3*EI) + P*a*L*L/(2*EI);
    EXPECT_NEAR(strip.pointIn(end.state)[2], w + a*slope, 2e-3*(w + a*slope));
    EXPECT_NEAR(strip.model.dofs().ties()[0].centre(end.state.position)[2], w, 2e-3*w);
}

// At large rotation: the root carries the force with its arm, to the accuracy of the
// iteration; the loads' full vector has the same resultant; the tie is rigid
TEST(RigidTie, supportsCarryTheForceWithItsArm)
{
    for (ElementForm form : {ElementForm::displacement, ElementForm::assumedStrain})
    {
        const TiedStrip strip(6, 10, 3, form);
        const ShellModel& model = strip.model;
        const Vec3 force(-1, 0.2, 2);
        const Vec3 moment(0.3, -4, 0.5);
        const Loads loads
        {
            std::make_shared<TieLoad>(model, "uMax", force, moment, linearInTime(0, 1))
        };
        const StaticStep end = solved(model, loads, 4);
        ASSERT_TRUE(end.converged) << end.report.describe();
        EXPECT_LE(end.report.iterations, 9) << end.report.describe();
        const Vector& q = end.state.position;
        const Vector external = totalForce(loads, model, q, 1);
        const ResultantForce root =
            resultant(strip.mesh.nodeSet("uMin"), q, reactions(model, end.state, external));
        const Vec3 whole = moment + strip.pointIn(end.state).cross(force);
        EXPECT_GT(std::abs(strip.pointIn(end.state)[2]), 3);
        EXPECT_LT((root.force + force).norm(), 1e-6*force.norm());
        EXPECT_LT((root.moment + whole).norm(), 1e-6*whole.norm());
        const ResultantForce spread = resultant(strip.mesh.nodeSet("uMax"), q, external);
        EXPECT_LT((spread.force - force).norm(), 1e-12);
        EXPECT_LT((spread.moment - whole).norm(), 1e-10);

        Vector rigid = q;
        const RigidTie& tie = model.dofs().ties()[0];
        const Vec3 turned = Eigen::AngleAxisd(tie.rotation(q)).angle()
           *Eigen::AngleAxisd(tie.rotation(q)).axis();
        const Vector q0 = strip.mesh.initialPositions();
        tie.move(q0, {tie.centre(q) - tie.centre(q0), turned}, rigid);
        EXPECT_LT((rigid - q).norm(), 1e-12);
    }
}

// source: Sze, Liu and Lo (2004), 3.2: the moment 2 pi EI/L closes the strip to a circle
TEST(RigidTie, endMomentRollsAStripUp)
{
    const double L = 12;
    const double pi = std::acos(-1.0);
    const TiedStrip strip(16, L, 0, ElementForm::assumedStrain);
    const Loads loads
    {
        std::make_shared<TieLoad>
        (
            strip.model, "uMax", Vec3::Zero(), Vec3(0, -2*pi*100/L, 0), linearInTime(0, 1)
        )
    };
    const StaticStep end = solved(strip.model, loads, 12);
    ASSERT_TRUE(end.converged) << end.report.describe();
    EXPECT_LT((strip.pointIn(end.state) - Vec3(0, 0.5, 0)).norm(), 0.01*L);
    const Mat3 turn = strip.model.dofs().ties()[0].rotation(end.state.position);
    EXPECT_LT((turn - Mat3::Identity()).norm(), 0.05);
}

// A tie across the end leaves the bending of a strip without transverse contraction alone
TEST(RigidTie, frequenciesOfATiedStrip)
{
    const TiedStrip tied(4, 10, 0, ElementForm::assumedStrain);
    const ShellModel loose
    (
        tied.mesh, {{"all", 0.1, material(1.2e6, 0)}},
        Constraints(tied.mesh).clamped("uMin").dofMap(), {}, ElementForm::assumedStrain
    );
    const Vector q = tied.mesh.initialPositions();
    const EigenModes with = lowestModes(tied.model, q, 2);
    const EigenModes without = lowestModes(loose, q, 2);
    ASSERT_TRUE(with.converged);
    for (int k = 0; k < 2; ++k)
    {
        EXPECT_NEAR(with.frequency[k], without.frequency[k], 1e-3*without.frequency[k]);
        EXPECT_LT
        (
            (with.mode.col(k).cwiseAbs() - without.mode.col(k).cwiseAbs()).norm(),
            0.02*without.mode.col(k).norm()
        );
    }
}

TEST(RigidTie, wrongTiesAreNamed)
{
    const ShellMesh mesh = strip(2, 1);
    ShellMesh named = mesh;
    named.addNodeSet("one", {3});
    EXPECT_NE
    (
        errorOf([&] { Constraints(named).rigidTie("one", Vec3::Zero()); })
            .find("rigid tie of node set one: its nodes are at one place"),
        std::string::npos
    );
    const auto both = [&](Constraints& c) { return errorOf([&] { c.dofMap(); }); };
    Constraints clamped(named);
    clamped.rigidTie("uMax", Vec3::Zero()).fixed("vMin", {Component::y});
    EXPECT_NE(both(clamped).find("rigid tie of node set uMax: node"), std::string::npos);
    Constraints shared(named);
    shared.rigidTie("uMax", Vec3::Zero()).tied("vMin", Component::z);
    EXPECT_NE(both(shared).find("in another constraint"), std::string::npos);
    Constraints twice(named);
    twice.rigidTie("uMax", Vec3::Zero()).rigidTie("vMax", Vec3::Zero());
    EXPECT_NE(both(twice).find("in another constraint"), std::string::npos);

    const ShellModel model
    (
        named, {{"all", 0.1, material(1, 0)}},
        Constraints(named).rigidTie("uMax", Vec3::Zero()).dofMap()
    );
    EXPECT_EQ
    (
        errorOf([&] { TieLoad(model, "uMin", Vec3::Zero(), Vec3::Zero()); }),
        "load on a rigid tie: no tie has the node set uMin; those of ties are: uMax"
    );
}
