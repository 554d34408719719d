// SPDX-License-Identifier: GPL-3.0-or-later

#include "ArcLength.hpp"
#include "StaticProblem.hpp"
#include "TangentFactors.hpp"

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
    ties_(model.dofs()),
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
    const StressPrediction& stress,
    const Vector& residual
)
{
    matrix_.setZero();
    problem.addStiffness(stress, matrix_);
    factoriseTangent
    (
        problem, matrix_, residual, UnsymmetricTangent::whole, linear_
    );
}

Vector ArcLength::changes
(
    const StaticProblem& problem,
    const Vector& increments
) const
{
    Vector linear = increments;
    ties_.expand(problem.position(), linear);
    return model_.dofs().expand(linear);
}

Vector ArcLength::rate(StaticProblem& problem, double distance)
{
    Vector load = model_.dofs().reduce(problem.loadRate(distance));
    ties_.project(problem.position(), load);
    return linear_.solve(load);
}

void ArcLength::move
(
    StaticProblem& problem,
    const Vector& increments,
    double parameter
)
{
    before_ = problem.position();
    led_ = ties_.advance(before_, increments, before_, problem.unknowns());
    if (ties_.none()) led_ = problem.position();
    problem.setTime(problem.time() + parameter);
}

void ArcLength::predict
(
    StaticProblem& problem,
    double firstIncrement,
    const Path& path,
    double& length
)
{
    Vector residual;
    KindNorms scale;
    problem.residual(residual, scale);
    makeTangent(problem, {problem.origin(), problem.origin()}, residual);
    const Vector perUnit =
        rate(problem, rateDistance(problem.time(), firstIncrement));
    const Vector change = changes(problem, perUnit);
    const double perParameter = std::sqrt(product(change, change));
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
        const bool onwards = product(change, path.increment) > 0;
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
    move(problem, parameter*perUnit, parameter);
}

bool ArcLength::measure
(
    StaticProblem& problem,
    NewtonReport& report,
    Vector& full,
    Vector& residual
) const
{
    KindNorms scale;
    problem.residual(full, scale);
    report.forceScale = scales_.completed(scale);
    residual = model_.dofs().reduce(full);
    ties_.project(problem.position(), residual);
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
    Vector full;
    Vector residual;
    double lastIncrement = 1;
    while (measure(problem, report, full, residual))
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

        makeTangent(problem, {before_, led_}, full);
        const Vector covered = problem.position() - problem.origin();
        const Vector atLoad = linear_.solve(residual);
        const Vector perUnit = rate(problem, rateDistance(problem.time(), 1e-3));
        const double excess =
            0.5*(product(covered, covered) - length*length);
        const double parameter =
            -(excess + product(covered, changes(problem, atLoad)))
           /product(covered, changes(problem, perUnit));
        const Vector increment = atLoad + parameter*perUnit;
        move(problem, increment, parameter);
        now.newTangent = true;
        now.fraction = 1;
        now.factorisation = linear_.report().last;
        now.increment = scales_.ofIncrement(dofs, increment);
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
