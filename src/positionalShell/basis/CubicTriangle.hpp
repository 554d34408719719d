// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lagrange basis of the cubic triangle on {xi1, xi2 >= 0, xi1 + xi2 <= 1}, (S3).
//
// Written in the area coordinates L0 = 1 - xi1 - xi2, L1 = xi1, L2 = xi2:
// corners N = L(3L-1)(3L-2)/2, edge nodes N = 9/2 La Lb (3La-1) for the node
// nearer to corner a, centre N = 27 L0 L1 L2. Node order: see ShellMesh.hpp.

#ifndef positionalShell_CubicTriangle_hpp
#define positionalShell_CubicTriangle_hpp

#include "ShellTypes.hpp"

#include <array>

namespace positionalShell
{

namespace CubicTriangle
{
    using Values = Eigen::Matrix<double, nodesPerElement, 1>;

    //- Derivatives: column 0 d/dxi1, column 1 d/dxi2
    using Gradients = Eigen::Matrix<double, nodesPerElement, 2>;

    //- Columns d2/dxi1dxi1, d2/dxi2dxi2, d2/dxi1dxi2
    using SecondDerivatives = Eigen::Matrix<double, nodesPerElement, 3>;

    Values values(double xi1, double xi2);
    Gradients gradients(double xi1, double xi2);
    SecondDerivatives secondDerivatives(double xi1, double xi2);

    //- Parametric coordinates (xi1, xi2) of the nodes
    const std::array<Eigen::Vector2d, nodesPerElement>& nodePoints();

    //- Values and d/ds of the four cubic functions of an edge, s in [0, 1],
    //  nodes at 0, 1/3, 2/3, 1
    Eigen::Vector4d edgeValues(double s);
    Eigen::Vector4d edgeDerivatives(double s);

    //- Places within the triangle of the nodes of edge 0->1, 1->2, 2->0
    const std::array<std::array<int, 4>, 3>& edgeNodes();
}

} // namespace positionalShell

#endif
