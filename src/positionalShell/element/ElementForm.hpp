// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the strains of an element follow from its unknowns.
//
//     displacement    the strains of the interpolated motion, (S5): the element of
//                     the paper
//     assumedStrain   membrane and transverse shear strains of the mid-surface and
//                     the stretch of the thickness are interpolated anew, (A3)-(A8):
//                     thin curved shells do not lock
//
// ShellModel's default is that of the paper, the applications' is assumedStrain.

#ifndef positionalShell_ElementForm_hpp
#define positionalShell_ElementForm_hpp

#include <string>
#include <vector>

namespace positionalShell
{

enum class ElementForm { displacement, assumedStrain };

//- Names in the order of the enumeration
const std::vector<std::string>& elementFormNames();

const std::string& elementFormName(ElementForm form);

//- Throws std::invalid_argument for another name, listing the valid ones
ElementForm elementForm(const std::string& name);

} // namespace positionalShell

#endif
