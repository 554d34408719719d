// SPDX-License-Identifier: GPL-3.0-or-later
//
// Thickness and material of a set of elements. Every element belongs to exactly
// one section; ShellModel checks it.
//
// Axis 1 of the material is the projection of `axis` onto the shell, turned by `angle`
// about the director. Without an axis it is that of the element's first parametric
// line, which serves laws that do not depend on it.

#ifndef positionalShell_Section_hpp
#define positionalShell_Section_hpp

#include "Material.hpp"

namespace positionalShell
{

struct Section
{
    std::string elementSet = "all";
    double thickness = 0;               // h0 [m]
    MaterialPtr material;
    Vec3 axis = Vec3::Zero();
    double angle = 0;                   // [rad]
};

} // namespace positionalShell

#endif
