// SPDX-License-Identifier: GPL-3.0-or-later

#include "SaintVenantKirchhoff.hpp"

#include <stdexcept>

namespace positionalShell
{

SaintVenantKirchhoff::SaintVenantKirchhoff
(
    double youngsModulus,
    double poissonRatio,
    double density
)
:
    Material(density),
    youngsModulus_(youngsModulus),
    poissonRatio_(poissonRatio),
    C_(ElasticMatrix::Zero())
{
    if (!(youngsModulus > 0))
    {
        throw std::invalid_argument
        (
            "SaintVenantKirchhoff: youngsModulus must be positive, not "
          + std::to_string(youngsModulus)
        );
    }
    if (!(poissonRatio > -1 && poissonRatio < 0.5))
    {
        throw std::invalid_argument
        (
            "SaintVenantKirchhoff: poissonRatio must lie between -1 and 0.5, "
            "not " + std::to_string(poissonRatio)
        );
    }

    const double mu = youngsModulus/(2*(1 + poissonRatio));
    const double lambda = 2*mu*poissonRatio/(1 - 2*poissonRatio);
    C_.topLeftCorner<3, 3>().setConstant(lambda);
    C_.diagonal().head<3>().array() += 2*mu;
    C_.diagonal().tail<3>().setConstant(mu);
}

double SaintVenantKirchhoff::energyDensity(const Strain& E) const
{
    return 0.5*E.dot(C_*E);
}

Stress SaintVenantKirchhoff::stress(const Strain& E) const
{
    return C_*E;
}

ElasticMatrix SaintVenantKirchhoff::tangent(const Strain&) const
{
    return C_;
}

} // namespace positionalShell
