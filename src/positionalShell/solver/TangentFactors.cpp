// SPDX-License-Identifier: GPL-3.0-or-later

#include "TangentFactors.hpp"
#include "TieElimination.hpp"

namespace positionalShell
{

void factoriseTangent
(
    EquilibriumProblem& problem,
    const SystemMatrix& matrix,
    const Vector& residual,
    UnsymmetricTangent unsymmetric,
    LinearSolver& linear
)
{
    const TieElimination ties(problem.model().dofs());
    if (ties.none())
    {
        unsymmetric == UnsymmetricTangent::symmetricPart
          ? linear.factoriseSymmetricPart(matrix)
          : linear.factorise(matrix);
        return;
    }
    const std::vector<TieForce> points = problem.tieForces();
    const SparseMatrix K = ties.reduced
    (
        problem.tieArms(), matrix.matrix(), residual, points
    );
    matrix.symmetric() && TieElimination::symmetric(points)
      ? linear.factoriseSymmetric(K)
      : linear.factoriseGeneral(K);
}

} // namespace positionalShell
