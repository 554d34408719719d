// SPDX-License-Identifier: GPL-3.0-or-later
//
// One solution by Newton-Raphson in progress: the guess, its residual, and the
// increment that is to be taken from it.

#ifndef positionalShell_NewtonRun_hpp
#define positionalShell_NewtonRun_hpp

#include "Newton.hpp"
#include "ShellScales.hpp"
#include "TieElimination.hpp"

namespace positionalShell
{

class Newton::Run
{
public:

    Run(Newton& newton, EquilibriumProblem& problem, bool lineSearch);

    NewtonReport solve();

private:

    Newton& newton_;
    EquilibriumProblem& problem_;
    const bool lineSearch_;
    const DofMap& dofs_;
    const TieElimination ties_;
    const ShellScales scales_;

    NewtonReport report_;
    Vector full_;
    Vector residual_;

    //- Its norms over their scales
    KindNorms relative_;

    //- Positions that the last increment started from
    Vector before_;

    //- What they became by the linear step; only with rigid ties
    Vector linear_;

    //- Whether the present factors were made in this solution
    bool ownTangents_ = false;

    //- Unknowns that the present increment starts from
    Vector base_;
    Vector increment_;

    //- With the factors of increment_, from the guess that it led to; empty when
    //  not computed
    Vector next_;

    //- Of the last increment
    double fraction_ = 1;

    //- Length of the next increment over that of the last, with the same factors
    double contraction_ = 1;

    const NewtonOptions& options() const { return newton_.options_; }

    //- Residual of the guess, and its place in the report
    void evaluate();
    bool finite() const { return residual_.allFinite(); }
    bool converged() const;
    KindNorms target() const;
    bool atTarget() const;

    //- Whether kept factors serve for another increment
    bool worthKeeping() const;

    //- Increment from the present guess, with new factors if need be
    void solveForIncrement(bool newTangent);
    void makeTangent();

    //- Increment from the present guess with the present factors
    Vector solved();

    //- Take the increment, or the fraction of it that brings the solution nearer;
    //  false when there is none
    bool takeIncrement();
    void moveTo(double fraction);

    //- Length of an increment, all kinds over their scales
    double size(const Vector& increment) const;

    //- The fraction to try after one that was too long
    double shorter(double fraction) const;

    //- Increments that leave all bounds
    bool diverges() const;

    NewtonReport failed(const std::string& reason);
    std::string worst() const;
};

} // namespace positionalShell

#endif
