// SPDX-License-Identifier: GPL-3.0-or-later
//
// Types and constants that every part of the shell library shares.
//
// Full vectors hold dofsPerNode = 7 values per node, node by node, in the order
// of Component: position x y z [m], director gx gy gz [-], thickness-strain
// rate a [-]. A full force vector holds the work-conjugate quantities: force [N]
// and, on g and a, force times length [N m]. Equations of
// doc/theory/positionalShell.md are cited as (S1), (S2), ...

#ifndef positionalShell_ShellTypes_hpp
#define positionalShell_ShellTypes_hpp

#include "ShellSizes.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace positionalShell
{

using Vec3 = Eigen::Vector3d;
using Vector = Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

//- Place of an unknown within its node
enum class Component : int { x = 0, y, z, gx, gy, gz, a };

//- Cartesian axis; also the plane that the axis is normal to
enum class Axis : int { x = 0, y, z };

//- Index of an unknown in a full vector
inline int fullIndex(int node, Component c)
{
    return dofsPerNode*node + static_cast<int>(c);
}

//- Name as used in messages and case files: x y z gx gy gz a
const char* componentName(Component c);

} // namespace positionalShell

#endif
