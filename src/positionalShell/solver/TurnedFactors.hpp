// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solution with the factors of a tangent that was made in another position of the shell, (N3):
// each node's forces are turned back by the rotation of its director since then, the increments
// that the factors give for them forwards again. Membranes are orders of magnitude stiffer than
// bending, and without this kept factors take the membrane to lie where it lay: a rotation of a few
// hundredths of a radian then costs several iterations.
//
// A preconditioner only: what an iteration converges to does not depend on it. Positions or
// directors of a node of which a component is held or shared are not turned. Nothing is with rigid
// ties, or where a shell can fly along an axis: increments of its own factors keep the sum of the
// forces, and so its momentum, to round-off instead of the tolerance of the iteration.

#ifndef positionalShell_TurnedFactors_hpp
#define positionalShell_TurnedFactors_hpp

#include "LinearSolver.hpp"

namespace positionalShell
{

class TurnedFactors
{
public:

    explicit TurnedFactors(const DofMap& dofs);

    //- The factors of the solver belong to this position, full vector
    void madeAt(const Vector& position) { origin_ = position; }

    //- Increment at another position
    Vector solve(LinearSolver& factors, const Vector& position, const Vector& residual) const;

private:

    //- First equations of positions and directors that are turned, and their node
    struct Triple
    {
        int node;
        int equations[3];
    };

    std::vector<Triple> triples_;
    Vector origin_;
};

} // namespace positionalShell

#endif
