// SPDX-License-Identifier: GPL-3.0-or-later

#include "LinearSolver.hpp"
#include "SingleThread.hpp"

#include <Eigen/CholmodSupport>
#include <Eigen/UmfPackSupport>

namespace positionalShell
{

namespace
{

//- Simplicial or supernodal, whichever CHOLMOD expects to be faster, but always
//  L L^T: an indefinite matrix must be noticed
class Cholesky
:
    public Eigen::CholmodDecomposition<SparseMatrix, Eigen::Lower>
{
public:

    Cholesky()
    {
        cholmod().supernodal = CHOLMOD_AUTO;
        cholmod().final_ll = 1;
        cholmod().final_asis = 0;
        // Not positive definite is an expected outcome, not worth its message
        cholmod().print = 0;
    }
};

} // namespace

struct LinearSolver::Factors
{
    Cholesky cholesky;
    Eigen::UmfPackLU<SparseMatrix> lu;
    bool choleskyAnalysed = false;
    bool luAnalysed = false;

    //- The last matrix was symmetric but indefinite: try L U at once, but come
    //  back to Cholesky as soon as a later matrix allows it
    SparseMatrix luMatrix;
};

const char* factorisationName(Factorisation f)
{
    switch (f)
    {
        case Factorisation::cholesky: return "CHOLMOD LL^T";
        case Factorisation::lu: return "UMFPACK LU";
        default: return "none";
    }
}

LinearSolver::LinearSolver() : factors_(new Factors) {}
LinearSolver::~LinearSolver() = default;
LinearSolver::LinearSolver(LinearSolver&&) noexcept = default;
LinearSolver& LinearSolver::operator=(LinearSolver&&) noexcept = default;

void LinearSolver::factorise(const SystemMatrix& K)
{
    if (K.symmetric() && tryCholesky(K.lower())) return;
    makeLU(K.matrix());
}

void LinearSolver::factoriseSymmetricPart(const SystemMatrix& K)
{
    if (!tryCholesky(K.lower())) makeLU(K.matrix());
}

void LinearSolver::factoriseSymmetric(const SparseMatrix& K)
{
    if (!tryCholesky(K)) makeLU(K);
}

bool LinearSolver::tryCholesky(const SparseMatrix& lower)
{
    const SingleThread alone;
    report_.nEquations = int(lower.rows());
    report_.last = Factorisation::none;
    if (!factors_->choleskyAnalysed)
    {
        factors_->cholesky.analyzePattern(lower);
        factors_->choleskyAnalysed = true;
        ++report_.nAnalyses;
    }
    factors_->cholesky.factorize(lower);
    if (factors_->cholesky.info() != Eigen::Success)
    {
        ++report_.nIndefinite;
        return false;
    }
    ++report_.nCholesky;
    report_.last = Factorisation::cholesky;
    return true;
}

void LinearSolver::makeLU(const SparseMatrix& K)
{
    const SingleThread alone;
    report_.nEquations = int(K.rows());
    report_.last = Factorisation::none;

    // UMFPACK refers to the matrix until the solve
    factors_->luMatrix = K;
    if (!factors_->luAnalysed)
    {
        factors_->lu.analyzePattern(factors_->luMatrix);
        factors_->luAnalysed = true;
        ++report_.nAnalyses;
    }
    factors_->lu.factorize(factors_->luMatrix);
    if (factors_->lu.info() != Eigen::Success)
    {
        throw SingularMatrix
        (
            "the matrix of the shell is singular: the supports leave it a "
            "motion without resistance"
        );
    }
    ++report_.nLU;
    report_.last = Factorisation::lu;
}

Vector LinearSolver::solve(const Vector& b)
{
    return solve(Eigen::MatrixXd(b));
}

Eigen::MatrixXd LinearSolver::solve(const Eigen::MatrixXd& B)
{
    if (!factorised())
    {
        throw std::logic_error("LinearSolver: solve before factorise");
    }
    const SingleThread alone;
    ++report_.nSolves;
    if (report_.last == Factorisation::cholesky)
    {
        return factors_->cholesky.solve(B);
    }
    return factors_->lu.solve(B);
}

} // namespace positionalShell
