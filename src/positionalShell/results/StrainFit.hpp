// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the area points of an element to its nodes: the complete quadratic in the
// parametric coordinates that fits best, (R1). On flat triangles with straight sides
// it holds the strains of a cubic displacement exactly.

#ifndef positionalShell_StrainFit_hpp
#define positionalShell_StrainFit_hpp

#include "Quadrature.hpp"
#include "ShellTypes.hpp"

namespace positionalShell
{

using StrainFit = Eigen::Matrix<double, nodesPerElement, Eigen::Dynamic>;

//- Values at the nodes (rows) by those at the points of a rule (columns)
StrainFit strainFit(const std::vector<TrianglePoint>& rule);

} // namespace positionalShell

#endif
