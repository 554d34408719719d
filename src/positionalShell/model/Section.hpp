// SPDX-License-Identifier: GPL-3.0-or-later
//
// Thickness and material of a set of elements. Every element belongs to exactly
// one section; ShellModel checks it.

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
};

} // namespace positionalShell

#endif
