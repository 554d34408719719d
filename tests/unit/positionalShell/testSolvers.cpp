// SPDX-License-Identifier: GPL-3.0-or-later

#include "EdgeLoad.hpp"
#include "FollowerPressure.hpp"
#include "NodalLoad.hpp"
#include "ReferenceTable.hpp"
#include "ShellTestModels.hpp"
#include "StaticSolver.hpp"
#include "TurnedFactors.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

using namespace shellTest;

namespace
{

SparseMatrix sparse(const Eigen::MatrixXd& dense)
{
    return dense.sparseView();
}

//- Strip of the published large-deflection cantilevers
struct Cantilever
{
    ShellMesh mesh;
    ShellModel model;
    int tip;

    Cantilever(int n, double length, IntegrationOptions rule = {})
    :
        mesh(strip(n, length)),
        model
        (
            mesh, {{"all", 0.1, material(1.2e6, 0)}},
            Constraints(mesh).clamped("uMin").dofMap(), rule
        ),
        tip(mesh.nodeSet("uMaxVMin")[0])
    {}

    Vec3 tipDisplacement(const ShellState& state) const
    {
        return state.position.segment<3>(7*tip) - mesh.nodes()[tip];
    }
};

} // namespace

TEST(LinearSolver, usesCholeskyWhereTheMatrixIsPositiveDefinite)
{
    Eigen::MatrixXd A(3, 3);
    A << 4, 1, 0, 1, 3, -1, 0, -1, 2;
    LinearSolver solver;
    solver.factoriseSymmetric(sparse(A));
    EXPECT_EQ(solver.report().last, Factorisation::cholesky);
    const Vector b = randomVector(3, 1);
    EXPECT_LT((A*solver.solve(b) - b).norm(), 1e-14);

    // Same pattern again: no second analysis
    solver.factoriseSymmetric(sparse(2*A));
    EXPECT_LT((2*A*solver.solve(b) - b).norm(), 1e-14);
    EXPECT_EQ(solver.report().nAnalyses, 1);
    EXPECT_EQ(solver.report().nCholesky, 2);
    EXPECT_EQ(solver.report().nSolves, 2);
}

TEST(TurnedFactors, areThoseOfABodyThatTurnedAsAWhole)
{
    const ShellMesh mesh = strip(3, 2);
    const ShellModel model
    (
        mesh, {{"all", 0.05, material(1.2e6, 0.3)}},
        Constraints(mesh).hinged("uMin").dofMap()
    );
    const auto factorise = [&](const Vector& q, LinearSolver& solver)
    {
        SystemMatrix K = model.makeMatrix();
        model.addTangent(q, K);
        model.addMass(1e4, K);
        solver.factorise(K);
    };

    // Turned by 0.9 about an axis in its surface
    const Vector before = mesh.initialPositions();
    const Eigen::Matrix3d R =
        Eigen::AngleAxisd(0.9, Vec3(0.6, 0.8, 0)).toRotationMatrix();
    Vector after = before;
    for (int i = 0; i < mesh.nNodes(); ++i)
    {
        after.segment<3>(7*i) = R*before.segment<3>(7*i) + Vec3(1, 2, 3);
        after.segment<3>(7*i + 3) = R*before.segment<3>(7*i + 3);
    }

    LinearSolver kept, exact;
    factorise(before, kept);
    factorise(after, exact);
    TurnedFactors turned(model.dofs());
    turned.madeAt(before);
    const Vector r = randomVector(model.dofs().nEquations(), 3);
    const Vector x = exact.solve(r);
    EXPECT_LT((turned.solve(kept, after, r) - x).norm(), 1e-9*x.norm());
    EXPECT_GT((kept.solve(r) - x).norm(), 0.1*x.norm());
    EXPECT_EQ(turned.solve(kept, before, r), kept.solve(r));
}

TEST(TurnedFactors, leaveFactorsOfShellsThatCanFlyAlone)
{
    const ShellMesh mesh = strip(3, 2);
    for (bool along : {false, true})
    {
        Constraints constraints(mesh);
        if (along) constraints.symmetryPlane("uMin", Axis::x);
        const ShellModel model
        (
            mesh, {{"all", 0.05, material(1.2e6, 0.3)}}, constraints.dofMap()
        );
        SystemMatrix K = model.makeMatrix();
        const Vector q = mesh.initialPositions();
        model.addTangent(q, K);
        model.addMass(1e4, K);
        LinearSolver solver;
        solver.factorise(K);
        TurnedFactors turned(model.dofs());
        turned.madeAt(q);
        Vector after = q;
        for (int i = 0; i < mesh.nNodes(); ++i) after[7*i + 4] += 0.3;
        const Vector r = randomVector(model.dofs().nEquations(), 3);
        EXPECT_EQ(turned.solve(solver, after, r), solver.solve(r)) << along;
    }
}

TEST(LinearSolver, fallsBackToLUWhereTheMatrixIsIndefinite)
{
    for (int n : {3, 300})
    {
        // Positive diagonal, so that only the factorisation can tell
        Eigen::MatrixXd A = 2*Eigen::MatrixXd::Identity(n, n);
        A(0, n - 1) = A(n - 1, 0) = 5;
        LinearSolver solver;
        solver.factoriseSymmetric(sparse(A));
        EXPECT_EQ(solver.report().last, Factorisation::lu) << n;
        EXPECT_EQ(solver.report().nIndefinite, 1) << n;
        const Vector b = randomVector(n, 2);
        EXPECT_LT((A*solver.solve(b) - b).norm(), 1e-12) << n;
    }
}

TEST(LinearSolver, aSingularMatrixIsAnError)
{
    Eigen::MatrixXd A(2, 2);
    A << 1, 1, 1, 1;
    LinearSolver solver;
    EXPECT_THROW(solver.factoriseSymmetric(sparse(A)), SingularMatrix);
    EXPECT_FALSE(solver.factorised());
    EXPECT_THROW(solver.solve(Vector(Vector::Ones(2))), std::logic_error);
}

TEST(LinearSolver, aFollowerMakesItUseLU)
{
    const ShellMesh mesh = strip(2, 1);
    const ShellModel model
    (
        mesh, {{"all", 0.1, material(10, 0.3)}}, Constraints(mesh).clamped("uMin").dofMap()
    );
    const Vector q = mesh.initialPositions();
    SystemMatrix K = model.makeMatrix();
    model.addTangent(q, K);
    LinearSolver solver;
    solver.factorise(K);
    EXPECT_EQ(solver.report().last, Factorisation::cholesky);
    FollowerPressure(model, "all", 0.1).addTangent(model, q, 0, 1, K);
    solver.factorise(K);
    EXPECT_EQ(solver.report().last, Factorisation::lu);
    const Vector b = randomVector(K.nEquations(), 3);
    EXPECT_LT((K.matrix()*solver.solve(b) - b).norm(), 1e-8);
}

TEST(LinearSolver, theSymmetricPartOfAFollowerTakesCholesky)
{
    const ShellMesh mesh = strip(2, 1);
    const ShellModel model
    (
        mesh, {{"all", 0.1, material(10, 0.3)}}, Constraints(mesh).clamped("uMin").dofMap()
    );
    const Vector q = mesh.initialPositions();
    SystemMatrix K = model.makeMatrix();
    model.addTangent(q, K);
    FollowerPressure(model, "all", 1e-3).addTangent(model, q, 0, 1, K);
    LinearSolver solver;
    solver.factoriseSymmetricPart(K);
    EXPECT_EQ(solver.report().last, Factorisation::cholesky);
    const SparseMatrix whole = K.matrix();
    const SparseMatrix part = 0.5*(whole + SparseMatrix(whole.transpose()));
    EXPECT_GT((whole - part).norm(), 1e-6*whole.norm());
    const Vector b = randomVector(K.nEquations(), 3);
    EXPECT_LT((part*solver.solve(b) - b).norm(), 1e-8);
}

//- Tip of a beam under pressure that follows it, and how it was found
struct FollowedBeam
{
    Vec3 tip;
    LinearSolverReport linear;

    FollowedBeam(TangentUpdate update, double pressure, int nSteps)
    {
        const Cantilever beam(4, 10);
        const Loads loads
        {
            std::make_shared<FollowerPressure>(beam.model, "all", pressure, linearInTime(0, 1))
        };
        NewtonOptions options;
        options.tangentUpdate = update;
        options.maxIterations = 60;
        StaticSolver solver(beam.model, options);
        const StaticStep end = solver.run(beam.model.initialState(), 1, nSteps, loads);
        EXPECT_TRUE(end.converged) << end.report.describe();
        tip = beam.tipDisplacement(end.state);
        linear = solver.linearReport();
    }
};

TEST(Newton, keptFactorsOfAFollowerAreFirstThoseOfTheSymmetricPart)
{
    const FollowedBeam exact(TangentUpdate::everyIteration, 5e-4, 2);
    const FollowedBeam kept(TangentUpdate::whenSlow, 5e-4, 2);
    EXPECT_LT((exact.tip - kept.tip).norm(), 1e-6);
    EXPECT_GT(kept.tip.norm(), 5e-3);
    EXPECT_EQ(exact.linear.nCholesky, 0);
    EXPECT_GT(kept.linear.nCholesky, 0);
    EXPECT_LT(kept.linear.nLU, exact.linear.nLU);
}

TEST(Newton, theWholeTangentOfAFollowerIsTakenWhereItsPartDoesNotServe)
{
    const FollowedBeam exact(TangentUpdate::everyIteration, 0.8, 2);
    const FollowedBeam kept(TangentUpdate::whenSlow, 0.8, 2);
    EXPECT_LT((exact.tip - kept.tip).norm(), 1e-5);
    EXPECT_GT(kept.tip.norm(), 5);
    EXPECT_GT(kept.linear.nLU, 0);
}

// With an exact tangent the last increments square from one iteration to the next.
// A thick beam: in a thin one stretching hides the order until the last iteration.
TEST(Newton, convergesQuadratically)
{
    const ShellMesh mesh = strip(4, 10);
    const ShellModel model
    (
        mesh, {{"all", 2, material(150, 0.3)}}, Constraints(mesh).clamped("uMin").dofMap()
    );
    const Loads loads
    {
        std::make_shared<EdgeLoad>(model, "uMax", Vec3(0, 0, 0.5)),
        std::make_shared<FollowerPressure>(model, "all", 0.02)
    };
    StaticSolver solver(model);
    const StaticStep end = solver.step(model.initialState(), 1, loads);
    ASSERT_TRUE(end.converged) << end.report.describe();
    std::vector<double> increments;
    for (const NewtonIteration& iteration : end.report.history)
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
    EXPECT_GT(best, 1.8) << end.report.describe();
    EXPECT_LE(end.report.iterations, 7);
}

TEST(Newton, keptFactorsGiveTheSameAnswer)
{
    const Cantilever beam(4, 10);
    const Loads loads
    {
        std::make_shared<EdgeLoad>(beam.model, "uMax", Vec3(0, 0, 1), linearInTime(0, 1))
    };
    NewtonOptions kept;
    kept.tangentUpdate = TangentUpdate::whenSlow;
    kept.maxIterations = 60;
    StaticSolver full(beam.model);
    StaticSolver lazy(beam.model, kept);
    const StaticStep a = full.run(beam.model.initialState(), 1, 10, loads);
    const StaticStep b = lazy.run(beam.model.initialState(), 1, 10, loads);
    ASSERT_TRUE(a.converged);
    ASSERT_TRUE(b.converged) << b.report.describe();
    EXPECT_LT((beam.tipDisplacement(a.state) - beam.tipDisplacement(b.state)).norm(), 1e-6);
    EXPECT_LT(lazy.linearReport().nCholesky, full.linearReport().nCholesky);
}

TEST(Newton, failureSaysWhyAndKeepsTheLastState)
{
    const Cantilever beam(2, 10);
    const Loads loads{std::make_shared<EdgeLoad>(beam.model, "uMax", Vec3(0, 0, 4))};
    NewtonOptions few;
    few.maxIterations = 2;
    StaticSolver solver(beam.model, few);
    const ShellState start = beam.model.initialState();
    const StaticStep end = solver.step(start, 1, loads);
    EXPECT_FALSE(end.converged);
    EXPECT_EQ((end.state.position - start.position).norm(), 0);
    EXPECT_EQ(end.state.time, 0);
    EXPECT_NE(end.report.message.find("no convergence in 2 iterations"), std::string::npos);
    EXPECT_NE(end.report.message.find("at node"), std::string::npos);
    EXPECT_NE(end.report.describe().find("CHOLMOD LL^T"), std::string::npos);
}

TEST(StaticSolver, anUnloadedShellStaysWhereItIs)
{
    const Cantilever beam(2, 10);
    StaticSolver solver(beam.model);
    const StaticStep end = solver.step(beam.model.initialState(), 1, {});
    EXPECT_TRUE(end.converged) << end.report.describe();
    EXPECT_LT((end.state.position - beam.mesh.initialPositions()).norm(), 1e-12);
}

// Sze, Liu and Lo 2004, section 3.1; exact: inextensible elastica. The tolerance is
// that of the published comparison, 0.5 %; the model stretches and shears, which the
// elastica does not (1e-4 here)
TEST(StaticSolver, cantileverUnderEndShear)
{
    const Cantilever beam(8, 10);
    const Loads loads
    {
        std::make_shared<EdgeLoad>(beam.model, "uMax", Vec3(0, 0, 4), linearInTime(0, 1))
    };
    const auto table = referenceTable("sze31_cantilever_end_shear.csv");
    ASSERT_EQ(table.size(), 20u);
    StaticSolver solver(beam.model);
    ShellState state = beam.model.initialState();
    for (const ReferenceRow& row : table)
    {
        const StaticStep end = solver.step(state, row.number("P_over_Pmax"), loads);
        ASSERT_TRUE(end.converged) << end.report.describe();
        state = end.state;
        const Vec3 u = beam.tipDisplacement(state);
        const double exactU = row.number("minus_U_exact");
        const double exactW = row.number("W_exact");
        EXPECT_NEAR(-u[0], exactU, 0.005*exactU) << "P/Pmax " << row.number("P_over_Pmax");
        EXPECT_NEAR(u[2], exactW, 0.005*exactW) << "P/Pmax " << row.number("P_over_Pmax");
    }
}

// A given generalised force is a load like any other
TEST(StaticSolver, aFixedForceActsAsALoad)
{
    const Cantilever beam(2, 10);
    const Loads loads{std::make_shared<EdgeLoad>(beam.model, "uMax", Vec3(0, 0, 0.01))};
    const ShellState start = beam.model.initialState();
    const Vector force = totalForce(loads, beam.model, start.position, 1);
    const StaticStep a = StaticSolver(beam.model).step(start, 1, loads);
    const StaticStep b = StaticSolver(beam.model).step(start, 1, {}, &force);
    ASSERT_TRUE(a.converged && b.converged);
    EXPECT_GT(beam.tipDisplacement(a.state)[2], 0.01);
    EXPECT_LT((a.state.position - b.state.position).norm(), 1e-9);
}

// Three points through the thickness are enough at finite strain as well
TEST(StaticSolver, morePointsThroughTheThicknessChangeNothing)
{
    Vec3 tips[2];
    for (int k : {0, 1})
    {
        const Cantilever beam(4, 10, {7, k == 0 ? 3 : 5});
        const Loads loads
        {
            std::make_shared<EdgeLoad>(beam.model, "uMax", Vec3(0, 0, 4), linearInTime(0, 1))
        };
        StaticSolver solver(beam.model);
        const StaticStep end = solver.run(beam.model.initialState(), 1, 10, loads);
        ASSERT_TRUE(end.converged) << end.report.describe();
        tips[k] = beam.tipDisplacement(end.state);
    }
    EXPECT_LT((tips[0] - tips[1]).norm(), 1e-5*tips[1].norm());
}

// Prescribed end: pulling a strip with nu = 0 to a given stretch needs the second
// Piola-Kirchhoff force E h b (stretch^2 - 1)/2 times the stretch
TEST(StaticSolver, prescribedStretch)
{
    const ShellMesh mesh = strip(2, 2, 0.5);
    const double stretch = 1.25;
    const DofMap dofs = Constraints(mesh)
        .fixed("uMin", {Component::x})
        .fixed("uMinVMin", {Component::y})
        .fixed("all", {Component::z})
        .prescribed("uMax", Component::x, linearInTime(0, 2*(stretch - 1)))
        .dofMap();
    const ShellModel model(mesh, {{"all", 0.1, material(100, 0)}}, dofs);
    StaticSolver solver(model);
    const StaticStep end = solver.run(model.initialState(), 1, 2, {});
    ASSERT_TRUE(end.converged) << end.report.describe();
    const Vector f = model.internalForce(end.state.position);
    double pull = 0;
    for (int node : mesh.nodeSet("uMax")) pull += f[7*node];
    const double exact = 100*0.1*0.5*0.5*(stretch*stretch - 1)*stretch;
    EXPECT_NEAR(pull, exact, 1e-9*exact);
}

// A beam in plane strain bends with E/(1-nu^2), exactly across the strip
TEST(StaticSolver, planeStrainStripBendsWithThePlateModulus)
{
    const double nu = 0.3;
    const double h = 0.01;
    const ShellMesh mesh = rectangleMesh(8, 1, Vec3::Zero(), {0, 1, 0}, {0, 0, 0.1});
    const ShellModel model
    (
        mesh, {{"all", h, material(1e6, nu)}},
        Constraints(mesh).clamped("uMin").planeStrainStrip(Axis::z).dofMap()
    );
    const double P = 1e-6;
    const Loads loads{std::make_shared<EdgeLoad>(model, "uMax", Vec3(10*P, 0, 0))};
    StaticSolver solver(model);
    const StaticStep end = solver.step(model.initialState(), 1, loads);
    ASSERT_TRUE(end.converged) << end.report.describe();
    const double EI = 1e6/(1 - nu*nu)*0.1*h*h*h/12;
    const double beam = P/(3*EI);
    const int tip = mesh.nodeSet("uMax")[0];
    // Shear adds about (h/L)^2 = 1e-4
    EXPECT_NEAR(end.state.position[7*tip], beam, 0.002*beam);
}

TEST(StaticSolver, aShellWithoutSupportsIsSingular)
{
    const ShellMesh mesh = strip(1, 1);
    const ShellModel model(mesh, {{"all", 0.1, material(1, 0.3)}}, Constraints(mesh).dofMap());
    const Loads loads{std::make_shared<NodalLoad>(model, "uMax", Vec3(0, 0, 1))};
    StaticSolver solver(model);
    bool converged = false;
    try
    {
        converged = solver.step(model.initialState(), 1, loads).converged;
    }
    catch (const SingularMatrix& error)
    {
        EXPECT_NE(std::string(error.what()).find("motion without resistance"), std::string::npos);
    }
    EXPECT_FALSE(converged);
}
