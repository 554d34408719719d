// SPDX-License-Identifier: GPL-3.0-or-later
//
// Direct solution of K x = b for matrices of one fixed pattern: symbolic analysis
// once, CHOLMOD (L L^T) for symmetric positive definite matrices, UMFPACK (L U)
// where the matrix is unsymmetric or turns out indefinite. The report says which.

#ifndef positionalShell_LinearSolver_hpp
#define positionalShell_LinearSolver_hpp

#include "SystemMatrix.hpp"

#include <memory>
#include <stdexcept>
#include <string>

namespace positionalShell
{

enum class Factorisation { none, cholesky, lu };

//- "none", "CHOLMOD LL^T", "UMFPACK LU"
const char* factorisationName(Factorisation f);

struct LinearSolverReport
{
    Factorisation last = Factorisation::none;
    int nEquations = 0;
    int nAnalyses = 0;
    int nCholesky = 0;              // successful factorisations of each kind
    int nLU = 0;
    int nIndefinite = 0;            // Cholesky tried and not positive definite
    int nSolves = 0;
};

//- The matrix is singular: a mechanism, or an unsupported shell in statics
class SingularMatrix : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

class LinearSolver
{
public:

    LinearSolver();
    ~LinearSolver();
    LinearSolver(LinearSolver&&) noexcept;
    LinearSolver& operator=(LinearSolver&&) noexcept;

    //- Factorise. Throws SingularMatrix.
    void factorise(const SystemMatrix& K);

    //- Factorise the symmetric part (K + K^T)/2 instead, or the whole matrix when
    //  that is not positive definite: an approximation of unsymmetric matrices
    //  that is cheaper to make and to solve with. Throws SingularMatrix.
    void factoriseSymmetricPart(const SystemMatrix& K);

    //- Same as factorise for any symmetric matrix given whole
    void factoriseSymmetric(const SparseMatrix& K);

    //- Same for any matrix
    void factoriseGeneral(const SparseMatrix& K) { makeLU(K); }

    bool factorised() const { return report_.last != Factorisation::none; }

    //- Solve with the last factors
    Vector solve(const Vector& b);
    Eigen::MatrixXd solve(const Eigen::MatrixXd& B);

    const LinearSolverReport& report() const { return report_; }

private:

    struct Factors;
    std::unique_ptr<Factors> factors_;
    LinearSolverReport report_;

    bool tryCholesky(const SparseMatrix& lower);
    void makeLU(const SparseMatrix& K);
};

} // namespace positionalShell

#endif
