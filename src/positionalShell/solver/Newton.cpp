// SPDX-License-Identifier: GPL-3.0-or-later

#include "Newton.hpp"
#include "NewtonRun.hpp"
#include "TangentFactors.hpp"

#include <cmath>
#include <cstdio>
#include <limits>

namespace positionalShell
{

namespace
{

//- Residuals that unknowns rounded to machine precision leave, (N1)
KindNorms residualRoundOff
(
    const DofMap& dofs,
    const SparseMatrix& K,
    const Vector& q
)
{
    KindNorms unknown = greatestEntries(q);
    Vector squares = Vector::Zero(K.rows());
    for (int j = 0; j < K.cols(); ++j)
    {
        const double size =
            unknown.ofComponent(dofs.firstUnknown(j)%dofsPerNode);
        for (SparseMatrix::InnerIterator it(K, j); it; ++it)
        {
            const double part = it.value()*size;
            squares[it.row()] += part*part;
        }
    }
    const Vector roots = squares.cwiseSqrt();
    return std::numeric_limits<double>::epsilon()*equationNorms(dofs, roots);
}

NewtonReport joined(const NewtonReport& first, NewtonReport second)
{
    second.iterations += first.iterations;
    second.history.insert
    (
        second.history.begin(), first.history.begin(), first.history.end()
    );
    return second;
}

} // namespace

std::string NewtonReport::describe() const
{
    std::string text;
    char line[200];
    for (std::size_t i = 0; i < history.size(); ++i)
    {
        const NewtonIteration& it = history[i];
        std::snprintf
        (
            line, sizeof(line),
            "%2d  residual %.2e %.2e %.2e", int(i), it.residual.position,
            it.residual.director, it.residual.thickness
        );
        text += line;
        if (it.factorisation != Factorisation::none)
        {
            std::snprintf
            (
                line, sizeof(line),
                "  increment %.2e %.2e %.2e  %s%s", it.increment.position,
                it.increment.director, it.increment.thickness,
                factorisationName(it.factorisation),
                it.newTangent ? ", new tangent" : ""
            );
            text += line;
            if (it.fraction < 1)
            {
                std::snprintf
                (
                    line, sizeof(line), ", %.3g of the increment", it.fraction
                );
                text += line;
            }
        }
        text += '\n';
    }
    return text + message;
}

void Newton::makeTangent
(
    EquilibriumProblem& problem,
    const StressPrediction& stress,
    const Vector& residual
)
{
    if (!matrix_)
    {
        matrix_.reset(new SystemMatrix(problem.model().makeMatrix()));
        turned_.reset(new TurnedFactors(problem.model().dofs()));
    }
    factorsUsable_ = false;
    matrix_->setZero();
    problem.addStiffness(stress, *matrix_);
    roundOff_ = residualRoundOff
    (
        problem.model().dofs(), matrix_->matrix(), problem.position()
    );
    problem.addInertia(*matrix_);
    const bool part =
        options_.tangentUpdate == TangentUpdate::whenSlow && !symmetricPartFailed_;
    factoriseTangent
    (
        problem, *matrix_, residual,
        part ? UnsymmetricTangent::symmetricPart : UnsymmetricTangent::whole,
        linear_
    );
    turned_->madeAt(problem.position());
    factorsUsable_ = true;
}

NewtonReport Newton::solve(EquilibriumProblem& problem)
{
    if (options_.tangentUpdate == TangentUpdate::everyIteration) reset();
    const Vector guess = problem.unknowns();
    const bool search = options_.lineSearch == LineSearch::always;
    NewtonReport report = Run(*this, problem, search).solve();
    if (!report.converged && options_.lineSearch == LineSearch::whenNeeded)
    {
        reset();
        problem.unknowns() = guess;
        problem.update();
        report = joined(report, Run(*this, problem, true).solve());
    }
    if (!report.converged) reset();
    return report;
}

} // namespace positionalShell
