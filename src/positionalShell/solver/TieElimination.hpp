// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rigid ties in the equations, (C4)-(C6): the six freedoms of a tie take the places of
// position (translation of the centre) and director (rotation vector) of its first
// node; the equations of its other positions and directors become those of the unit
// matrix. Residuals and matrices keep their size.

#ifndef positionalShell_TieElimination_hpp
#define positionalShell_TieElimination_hpp

#include "ShellModel.hpp"

namespace positionalShell
{

class TieElimination
{
public:

    //- The map must live as long as this object
    explicit TieElimination(const DofMap& dofs) : dofs_(dofs) {}

    bool none() const { return dofs_.ties().empty(); }

    //- residual = T^T residual. arms: full vector of positions that T is taken at
    void project(const Vector& arms, Vector& residual) const;

    //- T^T K T less the derivative of T^T by the freedoms, (C6). force: full
    //  residual; points: what of it is spread for forces at the ties
    SparseMatrix reduced
    (
        const Vector& arms,
        const SparseMatrix& K,
        const Vector& force,
        const std::vector<TieForce>& points
    ) const;

    //- What reduced matrices have on the diagonal where equations are eliminated
    SparseMatrix units() const;

    //- Whether what acts on the ties leaves the matrix symmetric
    static bool symmetric(const std::vector<TieForce>& points);

    //- increments = T increments
    void expand(const Vector& arms, Vector& increments) const;

    //- Unknowns after increments on equations, those of tied nodes by finite motions.
    //  before: positions that the increments belong to; base: unknowns there. Returns
    //  the positions that the linear step leads to; empty without ties, where the
    //  unknowns are changed by nothing else.
    Vector advance
    (
        const Vector& before,
        const Vector& increments,
        const Vector& base,
        Vector& unknowns
    ) const;

private:

    const DofMap& dofs_;

    //- The six equations of a tie
    int equation(const RigidTie& tie, int freedom) const;

    RigidTie::Six motion(const RigidTie& tie, const Vector& increments) const;

    SparseMatrix transform(const Vector& arms) const;

    //- Unknowns of the tied nodes after finite motions
    void move
    (
        const Vector& before,
        const Vector& increments,
        const Vector& base,
        Vector& unknowns
    ) const;
};

} // namespace positionalShell

#endif
