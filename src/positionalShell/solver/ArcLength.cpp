// SPDX-License-Identifier: GPL-3.0-or-later

#include "ArcLength.hpp"
#include "StaticProblem.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace positionalShell
{

namespace
{

void require(bool condition, const std::string& message)
{
    if (!condition) throw std::invalid_argument("arc length: " + message);
}

//- (N5): thickness strain does not count
Vector lengthWeights(const ShellModel& model)
{
    const int nNodes = model.mesh().nNodes();
    const double length = model.mesh().lengthScale();
    Vector weights = Vector::Zero(dofsPerNode*nNodes);
    for (int i = 0; i < nNodes; ++i)
    {
        weights.segment<3>(dofsPerNode*i).setConstant
        (
            1/(nNodes*length*length)
        );
        weights.segment<3>(dofsPerNode*i + 3).setConstant(1.0/nNodes);
    }
    return weights;
}

//- Distance over which loads are looked at for their rate: they are mostly linear
//  in the parameter, and their round-off is to stay small
double rateDistance(double parameter, double increment)
{
    return 1e-3*std::max(std::abs(parameter), std::abs(increment));
}

} // namespace

ArcLength::Path::Path(const Vector& memory)
{
    if (memory.size() < 3) return;
    first = memory[0];
    wanted = memory[1];
    parameter = memory[2];
    increment = memory.tail(memory.size() - 3);
}

Vector ArcLength::Path::memory() const
{
    Vector m(3 + increment.size());
    m << first, wanted, parameter, increment;
    return m;
}

ArcLength::ArcLength(const ShellModel& model, ArcLengthOptions options)
:
    model_(model),
    options_(options),
    scales_(model),
    matrix_(model.makeMatrix()),
    weights_(lengthWeights(model))
{
    for (const auto& p : model.dofs().prescribed())
    {
        require
        (
            !p.displacement,
            "component "
          + std::string
            (
                componentName(static_cast<Component>(p.index%dofsPerNode))
            )
          + " of node " + std::to_string(p.index/dofsPerNode)
          + " has a prescribed motion; the path follows loads only"
        );
    }
    require
    (
        model.dofs().ties().empty(),
        "the model has a rigid tie, which is for load steps and dynamics"
    );
    require(options.maxCuts >= 0, "maxCuts is negative");
    require(options.desiredIterations > 0, "desiredIterations is not positive");
    require(options.maxGrowth >= 1, "maxGrowth is less than 1");
}

double ArcLength::product(const Vector& a, const Vector& b) const
{
    return a.dot(weights_.cwiseProduct(b));
}

void ArcLength::makeTangent
(
    StaticProblem& problem,
    const StressPrediction& stress
)
{
    matrix_.setZero();
    problem.addStiffness(stress, matrix_);
    linear_.factorise(matrix_);
}

void ArcLength::predict
(
    StaticProblem& problem,
    double firstIncrement,
    const Path& path,
    double& length
)
{
    const DofMap& dofs = model_.dofs();
    makeTangent(problem, {problem.origin(), problem.origin()});
    const double distance = rateDistance(problem.time(), firstIncrement);
    const Vector rate = dofs.expand
    (
        linear_.solve(dofs.reduce(problem.loadRate(distance)))
    );
    const double perParameter = std::sqrt(product(rate, rate));
    if (perParameter == 0)
    {
        throw std::runtime_error
        (
            "arc length: the loads do not change with the load parameter"
        );
    }
    double parameter = firstIncrement;
    if (path.first > 0)
    {
        const bool onwards = product(rate, path.increment) > 0;
        parameter = (onwards ? 1 : -1)*length/perParameter;
    }
    else if (length == 0)
    {
        length = std::abs(parameter)*perParameter;
    }
    else
    {
        parameter = std::copysign(length/perParameter, firstIncrement);
    }
    problem.unknowns() += parameter*rate;
    problem.setTime(problem.time() + parameter);
}

//- Residual of the present guess into the report; whether it is finite
bool ArcLength::measure
(
    StaticProblem& problem,
    NewtonReport& report,
    Vector& residual
) const
{
    Vector full;
    KindNorms scale;
    problem.residual(full, scale);
    report.forceScale = scales_.completed(scale);
    residual = model_.dofs().reduce(full);
    report.history.emplace_back();
    report.history.back().residual = ratio
    (
        equationNorms(model_.dofs(), residual), report.forceScale
    );
    return residual.allFinite();
}

NewtonReport ArcLength::correct(StaticProblem& problem, double length)
{
    const DofMap& dofs = model_.dofs();
    const NewtonOptions& newton = options_.newton;
    const double tolerance = newton.residualTolerance;
    NewtonReport report;
    Vector residual;
    Vector before = problem.origin();
    double lastIncrement = 1;
    while (measure(problem, report, residual))
    {
        NewtonIteration& now = report.history.back();
        const bool atTarget =
            within(now.residual, {tolerance, tolerance, tolerance});
        report.converged =
            lastIncrement <= scales_.roundOffIncrement()
         || (atTarget && lastIncrement <= newton.incrementTolerance);
        if (report.converged) return report;
        if (report.iterations >= newton.maxIterations)
        {
            report.message = "no convergence on the arc in "
              + std::to_string(report.iterations) + " iterations";
            return report;
        }

        makeTangent(problem, {before, problem.position()});
        before = problem.position();
        const Vector covered = problem.position() - problem.origin();
        const Vector atLoad = dofs.expand(linear_.solve(residual));
        const double distance = rateDistance(problem.time(), 1e-3);
        const Vector rate = dofs.expand
        (
            linear_.solve(dofs.reduce(problem.loadRate(distance)))
        );
        const double excess =
            0.5*(product(covered, covered) - length*length);
        const double parameter =
            -(excess + product(covered, atLoad))/product(covered, rate);
        const Vector increment = atLoad + parameter*rate;

        problem.unknowns() += increment;
        problem.setTime(problem.time() + parameter);
        now.newTangent = true;
        now.fraction = 1;
        now.factorisation = linear_.report().last;
        now.increment = scales_.ofIncrement(dofs, dofs.pick(increment));
        lastIncrement = now.increment.largest();
        ++report.iterations;
        if (!(lastIncrement < 10)) break;
    }
    report.message = "the iteration on the arc diverges";
    return report;
}

ArcLengthStep ArcLength::step
(
    const ShellState& start,
    double firstIncrement,
    const Loads& loads,
    Vector& memory,
    const Vector* fixedForce
)
{
    const Vector none;
    Path path(memory);
    ArcLengthStep result;
    result.state = start;
    double length = path.wanted;
    for (; result.cuts <= options_.maxCuts; ++result.cuts, length /= 2)
    {
        StaticProblem problem
        (
            model_, loads, fixedForce, start.time, start.position, none
        );
        try
        {
            predict(problem, firstIncrement, path, length);
            result.report = correct(problem, length);
        }
        catch (const SingularMatrix& singular)
        {
            result.report = NewtonReport();
            result.report.message = singular.what();
        }
        if (!result.report.converged) continue;

        result.converged = true;
        result.length = length;
        result.state.time = problem.time();
        result.state.position = problem.position();

        if (path.first == 0) path.first = length;
        const double growth = std::sqrt
        (
            double(options_.desiredIterations)
           /std::max(1, result.report.iterations)
        );
        path.wanted = std::min
        (
            length*std::max(0.5, std::min(2.0, growth)),
            options_.maxGrowth*path.first
        );
        path.parameter = problem.time() - start.time;
        path.increment = problem.position() - start.position;
        memory = path.memory();
        break;
    }
    return result;
}

} // namespace positionalShell
