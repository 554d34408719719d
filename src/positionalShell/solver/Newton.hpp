// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton-Raphson for equilibrium, (S22)-(S24). Converged when
//   - the residual of each kind of unknown (position, director, thickness
//     strain) is within residualTolerance of its force scale, and
//   - the last increment of positions over the length scale of the mesh, of g and
//     of a, is within incrementTolerance;
// or when the last increment is round-off, (S25): the residual then cannot fall
// any further, whatever its tolerance.
// Never throws for lack of convergence: the report says so, and why.

#ifndef positionalShell_Newton_hpp
#define positionalShell_Newton_hpp

#include "LinearSolver.hpp"
#include "ShellModel.hpp"

#include <memory>
#include <string>
#include <vector>

namespace positionalShell
{

enum class TangentUpdate
{
    everyIteration,     // full Newton
    whenSlow            // keep the factors, also from step to step, while
                        // keptIterations more iterations with them are enough
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
};

//- Norms of the three kinds of unknowns
struct KindNorms
{
    double position = 0;    // [N] or [m]
    double director = 0;    // [N m] or [-]
    double thickness = 0;   // [N m] or [-]
};

//- One evaluation of the residual and what was done about it
struct NewtonIteration
{
    KindNorms residual;         // norms over their scales, before the solve
    KindNorms increment;        // greatest entries over their scales
    bool newTangent = false;
    Factorisation factorisation = Factorisation::none;  // none: no solve
};

struct NewtonReport
{
    bool converged = false;
    int iterations = 0;             // linear solves
    KindNorms forceScale;           // what residuals were divided by
    std::vector<NewtonIteration> history;
    std::string message;            // empty when converged; else what and where

    //- One line per iteration, for logs
    std::string describe() const;
};

//- Norms of a full vector by kind
KindNorms normsByKind(const Vector& full);

//- The greater of each kind
KindNorms greater(const KindNorms& a, const KindNorms& b);

//- What Newton solves: r(u) = 0 for the equations of a model
class EquilibriumProblem
{
public:

    virtual ~EquilibriumProblem() = default;

    virtual const ShellModel& model() const = 0;

    //- Full position vector of the current guess
    virtual const Vector& position() const = 0;

    //- Full residual (driving force minus resistance) of the current guess; scale:
    //  by kind, the largest norm of its contributions
    virtual void residual(Vector& full, KindNorms& scale) = 0;

    //- K += minus d(residual)/dq
    virtual void addTangent(SystemMatrix& K) = 0;

    //- Move the guess by an increment of the equations
    virtual void move(const Vector& increment) = 0;
};

class Newton
{
public:

    explicit Newton(NewtonOptions options = {}) : options_(options) {}

    //- Starts from the problem's guess and leaves it at the last iterate
    NewtonReport solve(EquilibriumProblem& problem);

    //- Forget kept factors: after the step length or the model changed
    void reset() { factorsUsable_ = false; }

    const NewtonOptions& options() const { return options_; }
    const LinearSolverReport& linearReport() const { return linear_.report(); }

private:

    NewtonOptions options_;
    LinearSolver linear_;
    std::unique_ptr<SystemMatrix> matrix_;
    bool factorsUsable_ = false;

    void makeTangent(EquilibriumProblem& problem);
    bool worthKeeping(const NewtonReport& report) const;
    bool converged(const NewtonReport& report, double roundOff) const;
};

} // namespace positionalShell

#endif
