// SPDX-License-Identifier: GPL-3.0-or-later

#include "Orthotropic.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <stdexcept>

namespace positionalShell
{

namespace
{

void checkPositive(const char* name, double modulus)
{
    if (!(modulus > 0))
    {
        throw std::invalid_argument
        (
            std::string("orthotropic: ") + name + " must be positive, not "
          + std::to_string(modulus)
        );
    }
}

//- Upper left part of the compliance
Eigen::Matrix3d compliance(const OrthotropicConstants& c)
{
    Eigen::Matrix3d S;
    S << 1/c.E1, -c.nu12/c.E1, -c.nu13/c.E1,
        -c.nu12/c.E1, 1/c.E2, -c.nu23/c.E2,
        -c.nu13/c.E1, -c.nu23/c.E2, 1/c.E3;
    return S;
}

} // namespace

Orthotropic::Orthotropic(const OrthotropicConstants& c, double density)
:
    Material(density),
    C_(ElasticMatrix::Zero())
{
    checkPositive("youngsModulus1", c.E1);
    checkPositive("youngsModulus2", c.E2);
    checkPositive("youngsModulus3", c.E3);
    checkPositive("shearModulus12", c.G12);
    checkPositive("shearModulus23", c.G23);
    checkPositive("shearModulus13", c.G13);

    // With unit diagonal, so that the pivots do not depend on units
    const Eigen::Vector3d scale(std::sqrt(c.E1), std::sqrt(c.E2), std::sqrt(c.E3));
    const Eigen::Matrix3d S =
        scale.asDiagonal()*compliance(c)*scale.asDiagonal();
    if (Eigen::LLT<Eigen::Matrix3d>(S).info() != Eigen::Success)
    {
        throw std::invalid_argument
        (
            "orthotropic: poissonRatio12, poissonRatio23 and poissonRatio13 make the "
            "strain energy negative for some strain; needed: nu12^2 < E1/E2, "
            "nu23^2 < E2/E3, nu13^2 < E1/E3 and a positive determinant of the compliance"
        );
    }
    C_.topLeftCorner<3, 3>() =
        scale.asDiagonal()*Eigen::Matrix3d(S.inverse())*scale.asDiagonal();
    C_.diagonal().tail<3>() << c.G12, c.G23, c.G13;
}

double Orthotropic::energyDensity(const Strain& E) const
{
    return 0.5*E.dot(C_*E);
}

Stress Orthotropic::stress(const Strain& E) const
{
    return C_*E;
}

ElasticMatrix Orthotropic::tangent(const Strain&) const
{
    return C_;
}

} // namespace positionalShell
