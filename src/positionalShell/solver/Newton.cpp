// SPDX-License-Identifier: GPL-3.0-or-later

#include "Newton.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace positionalShell
{

namespace
{

double& ofComponent(KindNorms& norms, int c)
{
    return c < 3 ? norms.position : c < 6 ? norms.director : norms.thickness;
}

double largest(const KindNorms& norms)
{
    return std::max({norms.position, norms.director, norms.thickness});
}

KindNorms ratio(const KindNorms& a, const KindNorms& b)
{
    const auto over = [](double x, double scale)
    {
        return x == 0 ? 0 : x/scale;
    };
    return
    {
        over(a.position, b.position),
        over(a.director, b.director),
        over(a.thickness, b.thickness)
    };
}

KindNorms squareRoots(const KindNorms& n)
{
    return
    {
        std::sqrt(n.position), std::sqrt(n.director), std::sqrt(n.thickness)
    };
}

//- Norms of an equation vector by the kind of the equations
KindNorms equationNorms(const DofMap& dofs, const Vector& reduced)
{
    KindNorms squares;
    for (int e = 0; e < dofs.nEquations(); ++e)
    {
        ofComponent(squares, dofs.firstUnknown(e)%dofsPerNode) +=
            reduced[e]*reduced[e];
    }
    return squareRoots(squares);
}

//- Greatest entries by kind over length, 1 and 1, (S24)
KindNorms incrementNorms
(
    const DofMap& dofs,
    const Vector& increment,
    double length
)
{
    KindNorms greatest;
    for (int e = 0; e < dofs.nEquations(); ++e)
    {
        double& g = ofComponent(greatest, dofs.firstUnknown(e)%dofsPerNode);
        g = std::max(g, std::abs(increment[e]));
    }
    greatest.position /= length;
    return greatest;
}

//- Directors and thickness strain do work through the thickness: their scale is
//  at least that of the positions times the thickness, (S23)
KindNorms completed(KindNorms scale, double thickness)
{
    scale.director = std::max(scale.director, thickness*scale.position);
    scale.thickness = std::max(scale.thickness, thickness*scale.position);
    return scale;
}

double greatestThickness(const ShellModel& model)
{
    double h = 0;
    for (const Section& section : model.sections())
    {
        h = std::max(h, section.thickness);
    }
    return h;
}

double leastThickness(const ShellModel& model)
{
    double h = greatestThickness(model);
    for (const Section& section : model.sections())
    {
        h = std::min(h, section.thickness);
    }
    return h;
}

//- Membrane strains of the order of machine precision bend a shell of this length
//  over thickness by about this much, over the length, (S25)
double roundOffIncrement(double slenderness)
{
    return 4*std::numeric_limits<double>::epsilon()*slenderness;
}

std::string worst(const ShellModel& model, const Vector& reduced, const Vector& q)
{
    Eigen::Index equation = 0;
    for (Eigen::Index e = 0; e < reduced.size(); ++e)
    {
        if (!std::isfinite(reduced[e]))
        {
            equation = e;
            break;
        }
        if (std::abs(reduced[e]) > std::abs(reduced[equation])) equation = e;
    }
    const int unknown = model.dofs().firstUnknown(int(equation));
    const int node = unknown/dofsPerNode;
    char text[200];
    std::snprintf
    (
        text, sizeof(text),
        "largest residual %.3g at node %d, component %s, position (%g %g %g)",
        reduced[equation], node,
        componentName(static_cast<Component>(unknown%dofsPerNode)),
        q[dofsPerNode*node], q[dofsPerNode*node + 1], q[dofsPerNode*node + 2]
    );
    return text;
}

} // namespace

KindNorms normsByKind(const Vector& full)
{
    KindNorms squares;
    for (Eigen::Index i = 0; i < full.size(); i += dofsPerNode)
    {
        squares.position += full.segment<3>(i).squaredNorm();
        squares.director += full.segment<3>(i + 3).squaredNorm();
        squares.thickness += full[i + 6]*full[i + 6];
    }
    return squareRoots(squares);
}

KindNorms greater(const KindNorms& a, const KindNorms& b)
{
    return
    {
        std::max(a.position, b.position),
        std::max(a.director, b.director),
        std::max(a.thickness, b.thickness)
    };
}

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
        }
        text += '\n';
    }
    return text + message;
}

void Newton::makeTangent(EquilibriumProblem& problem)
{
    if (!matrix_) matrix_.reset(new SystemMatrix(problem.model().makeMatrix()));
    matrix_->setZero();
    problem.addTangent(*matrix_);
    linear_.factorise(*matrix_);
    factorsUsable_ = options_.tangentUpdate == TangentUpdate::whenSlow;
}

bool Newton::worthKeeping(const NewtonReport& report) const
{
    if (!factorsUsable_) return false;
    const std::size_t n = report.history.size();
    if (n < 2) return true;

    const double now = largest(report.history[n - 1].residual);
    const double before = largest(report.history[n - 2].residual);
    const double contraction = now/before;
    if (!(contraction < 1)) return false;
    const double needed =
        std::log(options_.residualTolerance/now)/std::log(contraction);
    return needed <= options_.keptIterations;
}

bool Newton::converged(const NewtonReport& report, double roundOff) const
{
    const std::size_t n = report.history.size();
    if (n < 2) return false;
    const double residual = largest(report.history[n - 1].residual);
    const double increment = largest(report.history[n - 2].increment);
    return increment <= roundOff
        ||
        (
            residual <= options_.residualTolerance
         && increment <= options_.incrementTolerance
        );
}

NewtonReport Newton::solve(EquilibriumProblem& problem)
{
    const ShellModel& model = problem.model();
    const DofMap& dofs = model.dofs();
    const double length = model.mesh().lengthScale();
    const double thickness = greatestThickness(model);
    const double roundOff = roundOffIncrement(length/leastThickness(model));

    NewtonReport report;
    Vector full;
    Vector residual;
    for (int iteration = 0; ; ++iteration)
    {
        KindNorms scale;
        problem.residual(full, scale);
        scale = completed(scale, thickness);
        dofs.reduce(full, residual);
        const KindNorms norms = equationNorms(dofs, residual);

        NewtonIteration record;
        record.residual = ratio(norms, scale);
        report.history.push_back(record);
        report.forceScale = scale;

        if (!residual.allFinite())
        {
            report.message = "the residual is not finite; "
              + worst(model, residual, problem.position());
            factorsUsable_ = false;
            return report;
        }

        const bool exact = iteration == 0 && largest(norms) == 0;
        if (exact || converged(report, roundOff))
        {
            report.converged = true;
            return report;
        }
        if (iteration == options_.maxIterations)
        {
            report.message = "no convergence in "
              + std::to_string(iteration) + " iterations; "
              + worst(model, residual, problem.position());
            factorsUsable_ = false;
            return report;
        }

        NewtonIteration& now = report.history.back();
        now.newTangent = !worthKeeping(report);
        if (now.newTangent) makeTangent(problem);
        const Vector increment = linear_.solve(residual);
        now.factorisation = linear_.report().last;
        now.increment = incrementNorms(dofs, increment, length);
        problem.move(increment);
        ++report.iterations;
    }
}

} // namespace positionalShell
