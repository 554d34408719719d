// SPDX-License-Identifier: GPL-3.0-or-later

#include "EigenFrequencies.hpp"
#include "LinearSolver.hpp"
#include "TieElimination.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace positionalShell
{

namespace
{

//- Start vectors: random, the same in every run
Eigen::MatrixXd startBlock(int n, int size)
{
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Eigen::MatrixXd X(n, size);
    for (int j = 0; j < size; ++j)
    {
        for (int i = 0; i < n; ++i) X(i, j) = uniform(generator);
    }
    return X;
}

int equationsWithInertia(const ShellModel& model)
{
    int n = 0;
    for (int e = 0; e < model.dofs().nEquations(); ++e)
    {
        if (!model.massless(e)) ++n;
    }
    return n;
}

//- Full vectors of unit modal mass, greatest entry positive
Eigen::MatrixXd expand(const DofMap& dofs, const Eigen::MatrixXd& reduced)
{
    Eigen::MatrixXd full(dofs.nFull(), reduced.cols());
    for (int j = 0; j < reduced.cols(); ++j)
    {
        Vector mode = dofs.expand(reduced.col(j));
        Eigen::Index greatest = 0;
        mode.cwiseAbs().maxCoeff(&greatest);
        if (mode[greatest] < 0) mode = -mode;
        full.col(j) = mode;
    }
    return full;
}

} // namespace

EigenModes lowestModes
(
    const ShellModel& model,
    const Vector& q,
    int n,
    EigenOptions options
)
{
    const int available = equationsWithInertia(model);
    if (n < 1 || n > available)
    {
        throw std::invalid_argument
        (
            "eigenfrequencies: " + std::to_string(n)
          + " modes asked for, between 1 and " + std::to_string(available)
          + " can be given"
        );
    }

    const TieElimination ties(model.dofs());
    SparseMatrix K = model.tangent(q);
    SparseMatrix M = model.massMatrix();
    if (!ties.none())
    {
        // Forces in the state turn with the tie; loads at its point are not known
        K = ties.reduced(q, K, -model.internalForce(q), {});
        M = ties.reduced(q, M, Vector::Zero(q.size()), {}) - ties.units();
    }
    LinearSolver shifted;
    shifted.factoriseSymmetric(K - options.shift*M);

    // Twice the modes: the last of them converge as fast as the first
    const int size = std::min({2*n, n + 8, available});
    Eigen::MatrixXd X = startBlock(model.dofs().nEquations(), size);
    EigenModes modes;
    Vector previous = Vector::Zero(n);
    for (int k = 1; k <= options.maxIterations; ++k)
    {
        X = shifted.solve(Eigen::MatrixXd(M*X));
        // Columns of one size keep the projected mass well conditioned
        for (int j = 0; j < size; ++j) X.col(j).normalize();
        const Eigen::MatrixXd projectedK = X.transpose()*(K*X);
        const Eigen::MatrixXd projectedM = X.transpose()*(M*X);
        const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>
            ritz(projectedK, projectedM);
        if (ritz.info() != Eigen::Success) break;

        X *= ritz.eigenvectors();
        modes.eigenvalue = ritz.eigenvalues().head(n);
        modes.iterations = k;
        const double scale = modes.eigenvalue.cwiseAbs().maxCoeff();
        const double change =
            (modes.eigenvalue - previous).cwiseAbs().maxCoeff();
        previous = modes.eigenvalue;
        if (change <= options.tolerance*scale)
        {
            modes.converged = true;
            break;
        }
    }
    // A free body has zero, by round-off perhaps just negative, eigenvalues
    modes.frequency =
        modes.eigenvalue.cwiseMax(0).cwiseSqrt()/(2*std::acos(-1.0));
    for (int j = 0; j < n; ++j)
    {
        Vector mode = X.col(j);
        ties.expand(q, mode);
        X.col(j) = mode;
    }
    modes.mode = expand(model.dofs(), X.leftCols(n));
    return modes;
}

} // namespace positionalShell
