// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static equilibrium along a path of given length, through limit points of the load,
// (N5)-(N9). The load parameter is an unknown; loads are functions of it as they are
// of time elsewhere. Cylindrical arc length in positions and directors.
//
// The length of a step follows from the number of iterations of the last; a step that
// does not converge is cut and repeated from its start.

#ifndef positionalShell_ArcLength_hpp
#define positionalShell_ArcLength_hpp

#include "Load.hpp"
#include "Newton.hpp"
#include "ShellScales.hpp"
#include "TieElimination.hpp"

namespace positionalShell
{

class StaticProblem;

struct ArcLengthOptions
{
    NewtonOptions newton;

    //- The shortest step is the one wanted over 2^maxCuts
    int maxCuts = 10;

    //- Iterations that a step should take: fewer lengthen the next, more shorten it
    int desiredIterations = 5;

    //- Longest step over the first
    double maxGrowth = 10;
};

struct ArcLengthStep
{
    bool converged = false;
    ShellState state;           // time: the load parameter; start if not converged
    NewtonReport report;        // of the last try
    double length = 0;          // of the step, (N5)
    int cuts = 0;
};

class ArcLength
{
public:

    //- The model must live as long as the solver. Throws std::invalid_argument for
    //  a model with driven unknowns and for options out of range.
    explicit ArcLength(const ShellModel& model, ArcLengthOptions options = {});

    //- One step. firstIncrement: of the load parameter, in the first step of a path
    //  (its length sets the scale of all others). memory: empty at the start of a
    //  path, else as the last step left it.
    ArcLengthStep step
    (
        const ShellState& start,
        double firstIncrement,
        const Loads& loads,
        Vector& memory,
        const Vector* fixedForce = nullptr
    );

    const LinearSolverReport& linearReport() const { return linear_.report(); }

private:

    //- What one step knows of the path (memory)
    struct Path
    {
        double first = 0;       // length of the first step; 0: none yet
        double wanted = 0;      // length of the next
        double parameter = 0;   // last increment of the load parameter
        Vector increment;       // and of the unknowns, full

        explicit Path(const Vector& memory);
        Vector memory() const;
    };

    const ShellModel& model_;
    ArcLengthOptions options_;
    ShellScales scales_;
    LinearSolver linear_;
    SystemMatrix matrix_;
    TieElimination ties_;

    //- Weights of the unknowns in the length, (N5)
    Vector weights_;

    //- Positions that the last increment started from, and what they became by the
    //  linear step
    Vector before_;
    Vector led_;

    double product(const Vector& a, const Vector& b) const;

    //- Factors at the present guess; its residual: full
    void makeTangent
    (
        StaticProblem& problem, const StressPrediction& stress, const Vector& residual
    );

    //- Increments on equations as changes of the positions, linear, (C4)
    Vector changes(const StaticProblem& problem, const Vector& increments) const;

    //- Increments on equations with the rate of the loads, from present factors
    Vector rate(StaticProblem& problem, double distance);

    void move(StaticProblem& problem, const Vector& increments, double parameter);

    //- Start along the tangent of the path, (N6); sets the length of a first step
    void predict
    (
        StaticProblem& problem, double firstIncrement, const Path& path,
        double& length
    );

    //- Iterate to equilibrium on the arc, (N7)-(N8)
    NewtonReport correct(StaticProblem& problem, double length);

    //- Residual of the present guess, full and on equations, and its place in the
    //  report; whether it is finite
    bool measure
    (
        StaticProblem& problem, NewtonReport& report, Vector& full, Vector& residual
    ) const;
};

} // namespace positionalShell

#endif
