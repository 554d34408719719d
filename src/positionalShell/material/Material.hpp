// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hyperelastic material in terms of the Green-Lagrange strain, (S8).
//
// Strain vectors hold E11 E22 E33 2E12 2E23 2E13, stress vectors S11 S22 S33 S12
// S23 S13 (second Piola-Kirchhoff) in the local Cartesian frame of a point: axis
// 3 along the director, axis 1 along the section's direction (Section.hpp).
//
// Factory: Material::create(name, parameters). Another material is added by
// deriving from Material and one entry in Material.cpp.
//     SaintVenantKirchhoff   youngsModulus [Pa], poissonRatio [-]; density [kg/m3]
//     orthotropic            youngsModulus1, 2, 3 [Pa], poissonRatio12, 23, 13 [-],
//                            shearModulus12, 23, 13 [Pa]; density [kg/m3]
//
// The element asks for energy, stress and tangent at a strain, point by point, and
// for nothing else: a law with another relation of stress to strain needs no change
// of the element. One with a memory (plasticity) also needs a place for the state of
// each integration point, which the callers of generalResponse() have by batch, point
// and lane.

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

    //- Whether the law depends on where axis 1 points: sections then need a
    //  direction
    virtual bool directional() const { return false; }

private:

    double density_;
};

using MaterialPtr = std::shared_ptr<const Material>;

} // namespace positionalShell

#endif
