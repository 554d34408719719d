// SPDX-License-Identifier: GPL-3.0-or-later
//
// W = E:C:E/2 with the isotropic C of Hooke's law in full 3D, (S8);
// paper eq. (16)-(17).

#ifndef positionalShell_SaintVenantKirchhoff_hpp
#define positionalShell_SaintVenantKirchhoff_hpp

#include "Material.hpp"

namespace positionalShell
{

class SaintVenantKirchhoff : public Material
{
public:

    //- Young's modulus [Pa] > 0, -1 < Poisson's ratio < 1/2, density [kg/m3] > 0.
    //  Throws std::invalid_argument otherwise
    SaintVenantKirchhoff
    (
        double youngsModulus,
        double poissonRatio,
        double density
    );

    std::string name() const override { return "SaintVenantKirchhoff"; }
    double energyDensity(const Strain& E) const override;
    Stress stress(const Strain& E) const override;
    ElasticMatrix tangent(const Strain& E) const override;
    bool linear() const override { return true; }

    double youngsModulus() const { return youngsModulus_; }
    double poissonRatio() const { return poissonRatio_; }

private:

    double youngsModulus_;
    double poissonRatio_;
    ElasticMatrix C_;
};

} // namespace positionalShell

#endif
