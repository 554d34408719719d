// SPDX-License-Identifier: GPL-3.0-or-later

#include "StaticSolver.hpp"

#include <stdexcept>

namespace positionalShell
{

namespace
{

//- F(q, t) + fixed force - dU/dq = 0
class StaticProblem : public EquilibriumProblem
{
public:

    StaticProblem
    (
        const ShellModel& model,
        const Loads& loads,
        const Vector* fixedForce,
        double time,
        Vector q
    )
    :
        model_(model),
        loads_(loads),
        fixedForce_(fixedForce),
        time_(time),
        q_(std::move(q))
    {
        model_.dofs().setPrescribedPositions(time_, q_);
    }

    const ShellModel& model() const override { return model_; }
    const Vector& position() const override { return q_; }

    void residual(Vector& full, KindNorms& scale) override
    {
        full = totalForce(loads_, model_, q_, time_);
        if (fixedForce_) full += *fixedForce_;
        scale = normsByKind(full);
        const Vector internal = model_.internalForce(q_);
        scale = greater(scale, normsByKind(internal));
        full -= internal;
    }

    void addTangent(SystemMatrix& K) override
    {
        model_.addTangent(q_, K);
        for (const LoadPtr& load : loads_)
        {
            if (load->dependsOnPosition())
            {
                load->addTangent(model_, q_, time_, 1, K);
            }
        }
    }

    void move(const Vector& increment) override
    {
        model_.dofs().addExpanded(increment, q_);
    }

private:

    const ShellModel& model_;
    const Loads& loads_;
    const Vector* fixedForce_;
    double time_;
    Vector q_;
};

} // namespace

StaticSolver::StaticSolver(const ShellModel& model, NewtonOptions options)
:
    model_(model),
    newton_(options)
{}

StaticStep StaticSolver::step
(
    const ShellState& start,
    double t,
    const Loads& loads,
    const Vector* fixedForce
)
{
    StaticProblem problem(model_, loads, fixedForce, t, start.position);
    StaticStep result;
    result.report = newton_.solve(problem);
    result.converged = result.report.converged;
    result.state = start;
    if (result.converged)
    {
        result.state.time = t;
        result.state.position = problem.position();
    }
    return result;
}

StaticStep StaticSolver::run
(
    const ShellState& start,
    double endTime,
    int nSteps,
    const Loads& loads,
    const std::function<void(const StaticStep&)>& observer
)
{
    if (nSteps < 1)
    {
        throw std::invalid_argument
        (
            "static solver: " + std::to_string(nSteps)
          + " load steps; at least 1 is needed"
        );
    }
    StaticStep last;
    last.state = start;
    for (int k = 1; k <= nSteps; ++k)
    {
        const double t = start.time + (endTime - start.time)*k/nSteps;
        last = step(last.state, t, loads);
        if (!last.converged) return last;
        if (observer) observer(last);
    }
    return last;
}

} // namespace positionalShell
