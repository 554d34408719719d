// SPDX-License-Identifier: GPL-3.0-or-later
//
// W = E:C:E/2 with three planes of symmetry, in full 3D: the compliance by the
// engineering constants, (S8a). Axis 1 is the section's direction, axis 3 the director.

#ifndef positionalShell_Orthotropic_hpp
#define positionalShell_Orthotropic_hpp

#include "Material.hpp"

namespace positionalShell
{

//- nu_ij: contraction along j over extension along i under tension along i
struct OrthotropicConstants
{
    double E1, E2, E3;          // [Pa]
    double nu12, nu23, nu13;    // [-]
    double G12, G23, G13;       // [Pa]
};

class Orthotropic : public Material
{
public:

    //- Throws std::invalid_argument unless all moduli are positive and the
    //  compliance is positive definite
    Orthotropic(const OrthotropicConstants& constants, double density);

    std::string name() const override { return "orthotropic"; }
    double energyDensity(const Strain& E) const override;
    Stress stress(const Strain& E) const override;
    ElasticMatrix tangent(const Strain& E) const override;
    bool linear() const override { return true; }
    bool directional() const override { return true; }

private:

    ElasticMatrix C_;
};

} // namespace positionalShell

#endif
