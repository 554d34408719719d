// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton-Raphson for equilibrium, (S22)-(S25), (N1)-(N3). Converged when
//   - the residual of each kind of unknown (position, director, thickness
//     strain) is within residualTolerance of its force scale, or within what
//     round-off of the unknowns makes of it, (N1), and
//   - the last increment of positions over the length scale of the mesh, of g and
//     of a, is within incrementTolerance;
// or when the last increment is round-off, (S25): the residual then cannot fall
// any further, whatever its tolerance.
//
// Line search: an increment is accepted when the next one, with the same factors,
// is shorter, (N2); otherwise a part of it is taken. By default only after full
// increments from the same guess have failed: thin shells pass through large
// membrane forces on the way to a solution that full increments find sooner.
//
// Never throws for lack of convergence: the report says so, and why.

#ifndef positionalShell_Newton_hpp
#define positionalShell_Newton_hpp

#include "EquilibriumProblem.hpp"
#include "LinearSolver.hpp"
#include "TurnedFactors.hpp"

#include <memory>
#include <string>
#include <vector>

namespace positionalShell
{

enum class TangentUpdate
{
    everyIteration,     // full Newton
    whenSlow            // keep the factors, also from step to step, while
                        // keptIterations more iterations with them are enough,
                        // turned with the nodes, (N3);
                        // of unsymmetric tangents those of the symmetric part
                        // while they serve
};

enum class LineSearch
{
    off,
    whenNeeded,         // after full increments have failed
    always
};

struct NewtonOptions
{
    double residualTolerance = 1e-8;
    double incrementTolerance = 1e-6;
    int maxIterations = 30;
    TangentUpdate tangentUpdate = TangentUpdate::everyIteration;

    //- A new tangent is made when the observed rate of convergence with the kept
    //  one predicts more further iterations than this: about what a new tangent
    //  costs, in iterations
    int keptIterations = 10;

    LineSearch lineSearch = LineSearch::whenNeeded;
};

//- One evaluation of the residual and what was done about it
struct NewtonIteration
{
    KindNorms residual;         // norms over their scales, before the solve
    KindNorms increment;        // greatest entries over their scales
    double fraction = 0;        // of the increment, as the line search took it
    bool newTangent = false;
    Factorisation factorisation = Factorisation::none;  // none: no solve
};

struct NewtonReport
{
    bool converged = false;
    int iterations = 0;             // increments
    KindNorms forceScale;           // what residuals were divided by
    KindNorms roundOff;             // of residuals, over the scale, (N1)
    std::vector<NewtonIteration> history;
    std::string message;            // empty when converged; else what and where

    //- One line per iteration, for logs
    std::string describe() const;
};

class Newton
{
public:

    explicit Newton(NewtonOptions options = {}) : options_(options) {}

    //- Starts from the problem's guess and leaves it at the last iterate
    NewtonReport solve(EquilibriumProblem& problem);

    //- Forget kept factors: after the step length or the model changed
    void reset() { factorsUsable_ = symmetricPartFailed_ = false; }

    const NewtonOptions& options() const { return options_; }
    const LinearSolverReport& linearReport() const { return linear_.report(); }

private:

    //- One solution in progress (NewtonRun.cpp)
    class Run;

    NewtonOptions options_;
    LinearSolver linear_;
    std::unique_ptr<SystemMatrix> matrix_;
    std::unique_ptr<TurnedFactors> turned_;
    bool factorsUsable_ = false;

    //- Factors of the symmetric part alone did not serve in the present steps
    bool symmetricPartFailed_ = false;

    //- Residual that round-off of the unknowns makes with the present tangent
    KindNorms roundOff_;

    //- residual: full, of the present guess
    void makeTangent
    (
        EquilibriumProblem&, const StressPrediction&, const Vector& residual
    );
};

} // namespace positionalShell

#endif
