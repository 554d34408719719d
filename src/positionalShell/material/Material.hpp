// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hyperelastic material in terms of the Green-Lagrange strain, (S8).
//
// Strain vectors hold E11 E22 E33 2E12 2E23 2E13, stress vectors S11 S22 S33 S12
// S23 S13 (second Piola-Kirchhoff) in the local Cartesian frame of a point: axis
// 3 along the director, axis 1 along the projected first parametric line.
//
// Factory: Material::create(name, parameters). Another material is added by
// deriving from Material and one line in Material.cpp.
//     SaintVenantKirchhoff   youngsModulus [Pa], poissonRatio [-]; density [kg/m3]

#ifndef positionalShell_Material_hpp
#define positionalShell_Material_hpp

#include "ShellTypes.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace positionalShell
{

using Strain = Eigen::Matrix<double, 6, 1>;
using Stress = Eigen::Matrix<double, 6, 1>;
using ElasticMatrix = Eigen::Matrix<double, 6, 6>;

class Material
{
public:

    using Parameters = std::map<std::string, double>;

    //- Throws std::invalid_argument for an unknown name (listing the valid
    //  ones), a missing, unknown or out-of-range parameter
    static std::shared_ptr<const Material> create
    (
        const std::string& name,
        const Parameters& parameters
    );

    static std::vector<std::string> names();

    //- Density [kg/m3] must be positive
    explicit Material(double density);
    virtual ~Material() = default;

    double density() const { return density_; }

    virtual std::string name() const = 0;

    //- Strain energy per reference volume [J/m3]
    virtual double energyDensity(const Strain& E) const = 0;

    //- dW/dE
    virtual Stress stress(const Strain& E) const = 0;

    //- d2W/dE2
    virtual ElasticMatrix tangent(const Strain& E) const = 0;

    //- Whether the tangent is the same for all strains: the elements then
    //  compute it once
    virtual bool linear() const { return false; }

private:

    double density_;
};

using MaterialPtr = std::shared_ptr<const Material>;

} // namespace positionalShell

#endif
