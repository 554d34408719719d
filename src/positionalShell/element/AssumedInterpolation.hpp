// SPDX-License-Identifier: GPL-3.0-or-later
//
// Interpolation of the assumed strains of the mid-surface from values along the
// edges and moments over the area, (A3)-(A6). Numbers of the parent triangle: the
// same for all elements of a rule.

#ifndef positionalShell_AssumedInterpolation_hpp
#define positionalShell_AssumedInterpolation_hpp

#include "ElementBatch.hpp"

namespace positionalShell
{

//- For the area points of a rule, which must integrate cubics exactly
AssumedInterpolation assumedInterpolation
(
    const std::vector<TrianglePoint>& areaRule
);

} // namespace positionalShell

#endif
