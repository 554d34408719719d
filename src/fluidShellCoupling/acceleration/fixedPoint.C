/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "fixedPoint.H"

#include <Eigen/QR>

void Foam::fixedPoint::begin(const scalar omega)
{
    omega_ = omega;
    residuals_.clear();
    results_.clear();
}


Foam::fixedPoint::Vector Foam::fixedPoint::leastSquares() const
{
    const Vector& r = residuals_.back();
    const Vector& g = results_.back();
    const Eigen::Index n = residuals_.size() - 1;

    Eigen::MatrixXd V(r.size(), n), W(r.size(), n);
    for (Eigen::Index j = 0; j < n; ++j)
    {
        V.col(j) = residuals_[j] - r;
        W.col(j) = results_[j] - g;
        const scalar size = V.col(j).norm();
        if (size > 0)
        {
            V.col(j) /= size;
            W.col(j) /= size;
        }
    }

    // Passes whose direction is that of others to half of the digits are left
    // out: what they add is rounding
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
    qr.setThreshold(Foam::sqrt(SMALL));
    qr.compute(V);
    const Vector c = qr.solve(-r);
    return g + W*c;
}


Foam::fixedPoint::Vector Foam::fixedPoint::next
(
    const Vector& guess,
    const Vector& result
)
{
    residuals_.push_back(result - guess);
    results_.push_back(result);
    const Vector& r = residuals_.back();

    if (residuals_.size() > 1)
    {
        if (method_ == quasiNewton)
        {
            return leastSquares();
        }
        if (method_ == Aitken)
        {
            const Vector& before = residuals_[residuals_.size() - 2];
            const Vector change = r - before;
            const scalar square = change.squaredNorm();
            if (square > 0)
            {
                omega_ *= -before.dot(change)/square;
            }
        }
    }
    return guess + omega_*r;
}
