// SPDX-License-Identifier: GPL-3.0-or-later
//
// Strains, stresses and section forces of a state at the nodes, from the strains that
// the elements really use, assumed ones included, (R1)-(R8).
//
// Recovery: in each element the covariant strain at a height is a quadratic fitted to
// its area points. At a node the base vectors, axes and the law are those of the node,
// so that stress and strain satisfy the law there; the results of the elements of one
// part of the shell (ResultPoints.hpp) are averaged. Nothing is smoothed across folds
// or between sections.
//
// Tensors: Cartesian components xx yy zz xy yz xz of the strain itself (no factor 2).

#ifndef positionalShell_ShellResults_hpp
#define positionalShell_ShellResults_hpp

#include "ResultPoints.hpp"
#include "SectionForces.hpp"
#include "StrainFit.hpp"

#include <array>

namespace positionalShell
{

using SymmTensor = Eigen::Matrix<double, 6, 1>;

//- At one height of the shell
struct HeightResult
{
    SymmTensor strain = SymmTensor::Zero();         // Green-Lagrange [-]
    SymmTensor secondPiola = SymmTensor::Zero();    // [Pa]
    SymmTensor cauchy = SymmTensor::Zero();         // [Pa]

    //- Of the Cauchy stress [Pa]
    double vonMises() const;
};

//- Heights of the results: xi3 = -1, 0, 1
enum class Height : int { lower = 0, middle, upper };

struct PointResult
{
    std::array<HeightResult, 3> height;
    SectionForces section;

    //- Present axes of the section forces, unit vectors
    Vec3 axis1 = Vec3::Zero();
    Vec3 axis3 = Vec3::Zero();

    const HeightResult& at(Height h) const { return height[int(h)]; }
};

struct ResultOptions
{
    //- Direction 1 of section forces where the section has none
    Vec3 axis = Vec3::UnitX();

    //- Angle between normals that makes a fold [rad]: 20 degrees
    double foldAngle = 0.35;
};

class ShellResults
{
public:

    //- The model must live as long as this object. Throws std::invalid_argument for
    //  an axis of zero length and a fold angle out of range.
    explicit ShellResults(const ShellModel& model, ResultOptions options = {});

    const ResultPoints& points() const { return points_; }

    //- Results at all points
    std::vector<PointResult> at(const Vector& q) const;

    //- Those of one element at its ten nodes, before averaging
    std::array<PointResult, nodesPerElement> ofElement
    (
        int element, const Vector& q
    ) const;

private:

    using NodeStrains = Eigen::Matrix<double, nodesPerElement, 6>;
    using ElementResults = std::array<PointResult, nodesPerElement>;

    const ShellModel& model_;
    ResultOptions options_;
    Vector initial_;
    ResultPoints points_;
    std::vector<AreaPoint> area_;
    std::array<AreaPoint, nodesPerElement> nodes_;
    StrainFit fit_;

    //- gaps: of the element by area point, or null
    ElementResults elementResults
    (
        int element, const Vector& q, const Strain* gaps
    ) const;

    //- Covariant strains at the nodes at a height, (R1)
    NodeStrains nodeStrains
    (
        int element, const Vector& q, const Strain* gaps, double zeta
    ) const;

    HeightResult heightResult
    (
        int element, int place, const Vector& q, const Strain& e, double zeta
    ) const;

    //- strains: by thickness point
    void addSection
    (
        int element, int place, const Vector& q,
        const std::vector<NodeStrains>& strains, PointResult& result
    ) const;
};

} // namespace positionalShell

#endif
