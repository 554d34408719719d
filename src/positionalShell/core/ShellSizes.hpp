// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sizes of the 7-parameter cubic triangle.

#ifndef positionalShell_ShellSizes_hpp
#define positionalShell_ShellSizes_hpp

namespace positionalShell
{

constexpr int nodesPerElement = 10;
constexpr int dofsPerNode = 7;
constexpr int dofsPerElement = nodesPerElement*dofsPerNode;

} // namespace positionalShell

#endif
