// SPDX-License-Identifier: GPL-3.0-or-later

#include "NewtonRun.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace positionalShell
{

namespace
{

//- The line search gives up below this fraction of an increment: cutting the step
//  gets further
constexpr double leastFraction = 1.0/256;

//- Increments of positions over the length of the mesh, of directors and of the
//  thickness strain that no step of any use has: the iteration diverges
constexpr double greatestIncrement = 100;

} // namespace

Newton::Run::Run(Newton& newton, EquilibriumProblem& problem, bool lineSearch)
:
    newton_(newton),
    problem_(problem),
    lineSearch_(lineSearch),
    dofs_(problem.model().dofs()),
    ties_(dofs_),
    scales_(problem.model())
{}

void Newton::Run::evaluate()
{
    KindNorms scale;
    problem_.residual(full_, scale);
    scale = scales_.completed(scale);
    dofs_.reduce(full_, residual_);
    ties_.project(problem_.tieArms(), residual_);
    report_.forceScale = scale;
    report_.roundOff = ratio(newton_.roundOff_, scale);
    relative_ = ratio(equationNorms(dofs_, residual_), scale);
}

//- What the residual of each kind must come down to
KindNorms Newton::Run::target() const
{
    const double t = options().residualTolerance;
    return newton_.factorsUsable_
        ? greater({t, t, t}, report_.roundOff)
        : KindNorms{t, t, t};
}

bool Newton::Run::atTarget() const
{
    return within(relative_, target());
}

bool Newton::Run::converged() const
{
    const std::size_t n = report_.history.size();
    if (n < 2) return equationNorms(dofs_, residual_).largest() == 0;
    if (report_.history[n - 2].fraction < 1) return false;
    const double increment = report_.history[n - 2].increment.largest();
    return increment <= scales_.roundOffIncrement()
        ||
        (
            increment <= options().incrementTolerance
         && atTarget()
        );
}

bool Newton::Run::worthKeeping() const
{
    if (!newton_.factorsUsable_) return false;
    const std::size_t n = report_.history.size();
    if (n < 2) return true;
    if (options().tangentUpdate == TangentUpdate::everyIteration) return false;
    if (report_.history[n - 2].fraction < 1) return false;

    // At its target already: what is left to fall is the increment
    const double above = ratio
    (
        report_.history[n - 1].residual, target()
    ).largest();
    if (above <= 1) return true;
    if (!(contraction_ < 1)) return false;
    return -std::log(above)/std::log(contraction_) <= options().keptIterations;
}

double Newton::Run::size(const Vector& increment) const
{
    KindNorms norms = equationNorms(dofs_, increment);
    norms.position /= scales_.length;
    return std::sqrt
    (
        norms.position*norms.position + norms.director*norms.director
      + norms.thickness*norms.thickness
    );
}

//- Neither the first guess nor what kept factors made of it satisfies any linear
//  equations: their stress is left out
void Newton::Run::makeTangent()
{
    // Factors of this very solution that did not serve: the part of the tangent
    // that is left out is to blame
    newton_.symmetricPartFailed_ = newton_.symmetricPartFailed_ || ownTangents_;

    const Vector& origin = problem_.origin();
    newton_.makeTangent
    (
        problem_,
        ownTangents_
      ? StressPrediction{before_, ties_.none() ? problem_.position() : linear_}
      : StressPrediction{origin, origin},
        full_
    );
    ownTangents_ = true;
}

Vector Newton::Run::solved()
{
    return newton_.turned_->solve(newton_.linear_, problem_.position(), residual_);
}

void Newton::Run::solveForIncrement(bool newTangent)
{
    if (newTangent) makeTangent();
    if (newTangent || next_.size() == 0)
    {
        increment_ = solved();
    }
    else
    {
        increment_.swap(next_);
    }
    next_.resize(0);
    base_ = problem_.unknowns();
    before_ = problem_.position();

    NewtonIteration& now = report_.history.back();
    now.newTangent = now.newTangent || newTangent;
    now.factorisation = newton_.linear_.report().last;
    now.increment = scales_.ofIncrement(dofs_, increment_);
    ++report_.iterations;
}

void Newton::Run::moveTo(double fraction)
{
    // Ties turn by a finite rotation, of which the linear step knows nothing
    linear_ = ties_.advance
    (
        before_, fraction*increment_, base_, problem_.unknowns()
    );
    problem_.update();
    evaluate();
}

//- Where the next increment would not be shorter, if along the increment it
//  changed as a parabola, (N2)
double Newton::Run::shorter(double fraction) const
{
    if (next_.size() == 0 || !next_.allFinite()) return fraction/4;
    const double curvature = size(next_ - (1 - fraction)*increment_);
    const double best = 0.5*size(increment_)*fraction*fraction/curvature;
    return std::max(fraction/10, std::min(best, fraction/2));
}

bool Newton::Run::takeIncrement()
{
    NewtonIteration& now = report_.history.back();
    const double length = size(increment_);
    fraction_ = std::min(1.0, 4*fraction_);
    for (;; fraction_ = shorter(fraction_))
    {
        if (fraction_ < leastFraction) return false;
        moveTo(fraction_);
        now.fraction = fraction_;
        next_.resize(0);
        if (!lineSearch_ && (!finite() || diverges())) return false;
        if (!finite()) continue;
        // At its target the residual tells nothing about the next increment
        if (atTarget() || now.increment.largest() <= scales_.roundOffIncrement())
        {
            return true;
        }
        const bool kept = options().tangentUpdate == TangentUpdate::whenSlow;
        if (!lineSearch_ && !kept) return true;

        next_ = solved();
        contraction_ = size(next_)/length;
        if (!lineSearch_ || contraction_ <= 1 - 0.25*fraction_) return true;
    }
}

bool Newton::Run::diverges() const
{
    return report_.history.back().increment.largest() > greatestIncrement;
}

NewtonReport Newton::Run::solve()
{
    evaluate();
    if (!finite()) return failed("the residual is not finite");
    for (;;)
    {
        report_.history.emplace_back();
        report_.history.back().residual = relative_;
        report_.converged = converged();
        if (report_.converged) return report_;
        if (report_.iterations >= options().maxIterations)
        {
            return failed
            (
                "no convergence in " + std::to_string(report_.iterations)
              + " iterations"
            );
        }

        const bool keep = worthKeeping();
        solveForIncrement(!keep);
        if (takeIncrement()) continue;

        // Kept factors may be to blame: once more with those of this guess
        if (keep)
        {
            moveTo(0);
            fraction_ = 1;
            solveForIncrement(true);
            if (takeIncrement()) continue;
        }
        return failed
        (
            finite()
          ? "the increments lead away from a solution"
          : "the residual is not finite"
        );
    }
}

NewtonReport Newton::Run::failed(const std::string& reason)
{
    report_.message = reason + "; " + worst();
    return report_;
}

std::string Newton::Run::worst() const
{
    Eigen::Index equation = 0;
    for (Eigen::Index e = 0; e < residual_.size(); ++e)
    {
        if (!std::isfinite(residual_[e]))
        {
            equation = e;
            break;
        }
        if (std::abs(residual_[e]) > std::abs(residual_[equation]))
        {
            equation = e;
        }
    }
    const Vector& q = problem_.position();
    const int unknown = dofs_.firstUnknown(int(equation));
    const int node = unknown/dofsPerNode;
    char text[200];
    std::snprintf
    (
        text, sizeof(text),
        "largest residual %.3g at node %d, component %s, position (%g %g %g)",
        residual_[equation], node,
        componentName(static_cast<Component>(unknown%dofsPerNode)),
        q[dofsPerNode*node], q[dofsPerNode*node + 1], q[dofsPerNode*node + 2]
    );
    return text;
}

} // namespace positionalShell
