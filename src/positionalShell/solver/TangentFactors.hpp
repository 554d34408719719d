// SPDX-License-Identifier: GPL-3.0-or-later
//
// Factors of the matrix of a problem on its equations, rigid ties eliminated, (C5).

#ifndef positionalShell_TangentFactors_hpp
#define positionalShell_TangentFactors_hpp

#include "EquilibriumProblem.hpp"
#include "LinearSolver.hpp"

namespace positionalShell
{

enum class UnsymmetricTangent
{
    whole,              // factors of the matrix as it is
    symmetricPart       // of its symmetric part, where there are no ties
};

//- residual: full, of the present guess. Throws SingularMatrix
void factoriseTangent
(
    EquilibriumProblem& problem,
    const SystemMatrix& matrix,
    const Vector& residual,
    UnsymmetricTangent unsymmetric,
    LinearSolver& linear
);

} // namespace positionalShell

#endif
