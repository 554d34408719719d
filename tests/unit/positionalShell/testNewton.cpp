// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton's line search, round-off, predicted stresses; steps in parts.

#include "EdgeLoad.hpp"
#include "FollowerPressure.hpp"
#include "StaticSolver.hpp"
#include "StepParts.hpp"
#include "StripModel.hpp"
#include "SurfaceTraction.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace shellTest;

namespace
{

//- Cantilever of length 10, nu = 0.3, under an end force of P E I/L^2 per width
struct EndForce
{
    ShellMesh mesh = strip(8, 10);
    ShellModel model;
    Loads loads;
    int tip;

    EndForce(double h, double P, ElementForm form = ElementForm::displacement)
    :
        model
        (
            mesh, {{"all", h, material(1.2e6, 0.3)}}, Constraints(mesh).clamped("uMin").dofMap(),
            {}, form
        ),
        tip(mesh.nodeSet("uMaxVMin")[0])
    {
        const double force = P*1.2e6*h*h*h/12/100;
        loads.push_back(std::make_shared<EdgeLoad>(model, "uMax", Vec3(0, 0, force)));
    }

    double w(const ShellState& state) const { return state.position[7*tip + 2]; }
};

//- atan(x - 1) = 0 in the z component of one node: full increments from far off
//  diverge
class ArcTangent : public EquilibriumProblem
{
public:

    ArcTangent(const ShellModel& model, double start)
    :
        model_(model), q_(model.mesh().initialPositions()), start_(q_)
    {
        q_[unknown_] = start;
    }

    static int unknown(const ShellMesh& mesh) { return 7*mesh.nodeSet("uMaxVMin")[0] + 2; }
    double x() const { return q_[unknown_]; }

    const ShellModel& model() const override { return model_; }
    const Vector& position() const override { return q_; }
    const Vector& origin() const override { return start_; }
    Vector& unknowns() override { return q_; }

    void residual(Vector& full, KindNorms& scale) override
    {
        full = Vector::Zero(q_.size());
        full[unknown_] = -std::atan(q_[unknown_] - 1);
        scale = {1, 1, 1};
    }

    void addStiffness(const StressPrediction&, SystemMatrix& K) override
    {
        for (int e = 0; e < K.nEquations(); ++e) K.setDiagonal(e, 1);
        const double d = q_[unknown_] - 1;
        K.setDiagonal(model_.dofs().equation(unknown_), 1/(1 + d*d));
    }

private:

    const ShellModel& model_;
    Vector q_;
    Vector start_;
    int unknown_ = unknown(model_.mesh());
};

} // namespace

// atan(x - 1) = 0 from x = 3: full increments diverge, parts of them do not
TEST(LineSearch, findsASolutionThatFullIncrementsMiss)
{
    const EndForce beam(1, 0);
    NewtonOptions options;
    options.maxIterations = 50;
    for (LineSearch choice : {LineSearch::off, LineSearch::whenNeeded, LineSearch::always})
    {
        options.lineSearch = choice;
        ArcTangent problem(beam.model, 3);
        const NewtonReport report = Newton(options).solve(problem);
        EXPECT_EQ(report.converged, choice != LineSearch::off) << report.describe();
        if (!report.converged) continue;
        EXPECT_NEAR(problem.x(), 1, 1e-6);
        const std::string text = report.describe();
        EXPECT_NE(text.find("of the increment"), std::string::npos) << text;
    }
}

// Thin shells: the number of iterations of a large load step does not grow with the
// slenderness, which membrane stresses of the iterates would make it do
TEST(PredictedStress, iterationsDoNotGrowWithTheSlenderness)
{
    for (ElementForm form : {ElementForm::displacement, ElementForm::assumedStrain})
    {
        for (double h : {0.1, 0.01, 0.001})
        {
            const EndForce beam(h, 4, form);
            StaticSolver solver(beam.model, {NewtonOptions(), 0});
            const StaticStep end = solver.step(beam.model.initialState(), 1, beam.loads);
            ASSERT_TRUE(end.converged) << h << '\n' << end.report.describe();
            EXPECT_LE(end.report.iterations, 9) << elementFormName(form) << ' ' << h;
            EXPECT_GT(beam.w(end.state), 6.4);
        }
    }
}

// A residual that round-off of the positions makes is the end of the iteration: no new
// tangents, although the tolerance cannot be met
TEST(RoundOff, aResidualAtRoundOffIsConvergence)
{
    // Far from the origin, where positions have lost four digits
    const ShellMesh mesh = rectangleMesh(4, 1, {1e4, 0, 0}, {10, 0, 0}, {0, 1, 0});
    const ShellModel model
    (
        mesh, {{"all", 0.01, material(1.2e6, 0, 0.01)}},
        Constraints(mesh).clamped("uMin").planeStrainStrip(Axis::y).dofMap()
    );
    const Loads loads{SurfaceTraction::deadPressure(model, "all", -1e-7)};
    Newmark newmark(model);
    ShellState state = model.initialState();
    newmark.initialise(state, loads);
    int iterations = 0;
    for (int k = 0; k < 100; ++k)
    {
        const DynamicStep step = newmark.step(state, 0.01, loads);
        ASSERT_TRUE(step.converged) << step.report.describe();
        EXPECT_GT(step.report.roundOff.position, 1e-8);
        iterations += step.report.iterations;
        state = step.state;
    }
    EXPECT_EQ(newmark.linearReport().nCholesky, 1);
    EXPECT_LE(iterations, 300);
}

TEST(StepParts, failuresAreHalvedAndSuccessesGrow)
{
    // Parts longer than 0.3 fail before 0.5
    std::vector<double> ends;
    const auto attempt = [&](double from, double to)
    {
        const bool good = from >= 0.5 || to - from <= 0.3;
        if (good) ends.push_back(to);
        return PartOutcome{good};
    };
    const PartsReport report = takeInParts(4, 1, attempt);
    EXPECT_EQ(report.reached, 1);
    EXPECT_EQ(report.rejected, 2);
    EXPECT_EQ(ends, (std::vector<double>{0.25, 0.5, 1}));
    EXPECT_LT(takeInParts(1, 1, attempt).reached, 1) << "two cuts are needed";
    EXPECT_EQ(takeInParts(0, 0.25, attempt).accepted, 3);
}

TEST(StepParts, askedForLengthsAreTaken)
{
    std::vector<double> lengths;
    const auto attempt = [&](double from, double to)
    {
        lengths.push_back(to - from);
        return PartOutcome{lengths.size() != 1, lengths.size() == 1 ? 0.2 : 1.5};
    };
    const PartsReport report = takeInParts(4, 1, attempt);
    EXPECT_EQ(report.reached, 1);
    ASSERT_GE(lengths.size(), 3u);
    EXPECT_DOUBLE_EQ(lengths[1], 0.2);
    EXPECT_NEAR(lengths[2], 0.3, 1e-12);
}

// A thousand times the load that bends the strip to 65 degrees, at once, on a load
// factor that does not depend on time
TEST(StaticSolver, anExtremeSuddenLoadIsAppliedInParts)
{
    const EndForce beam(0.01, 4000);
    StaticSolver whole(beam.model, {NewtonOptions(), 0});
    EXPECT_FALSE(whole.step(beam.model.initialState(), 1, beam.loads).converged);

    StaticSolver solver(beam.model);
    const StaticStep end = solver.step(beam.model.initialState(), 1, beam.loads);
    ASSERT_TRUE(end.converged) << end.report.describe();
    EXPECT_GT(end.parts, 1);
    EXPECT_EQ(end.state.time, 1);

    // The end is in equilibrium with the whole load
    Vector residual = totalForce(beam.loads, beam.model, end.state.position, 1)
        - beam.model.internalForce(end.state.position);
    const double load = totalForce(beam.loads, beam.model, end.state.position, 1).norm();
    EXPECT_LT(beam.model.dofs().reduce(residual).norm(), 1e-5*load);
    EXPECT_GT(beam.w(end.state), 9);
}
