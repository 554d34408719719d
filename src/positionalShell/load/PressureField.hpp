// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pressure as a function of the initial position and of time.

#ifndef positionalShell_PressureField_hpp
#define positionalShell_PressureField_hpp

#include "ShellTypes.hpp"

#include <memory>

namespace positionalShell
{

class PressureField
{
public:

    virtual ~PressureField() = default;

    //- At the initial position X of the mid-surface [Pa]
    virtual double value(const Vec3& X, double time) const = 0;
};

using PressureFieldPtr = std::shared_ptr<const PressureField>;

} // namespace positionalShell

#endif
