// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pressure as a function of the initial place on the shell and of time.

#ifndef positionalShell_PressureField_hpp
#define positionalShell_PressureField_hpp

#include "ShellTypes.hpp"

#include <functional>
#include <memory>

namespace positionalShell
{

//- Pressure [Pa] at one place as a function of time [s]
using PressureHistory = std::function<double(double)>;

class PressureField
{
public:

    virtual ~PressureField() = default;

    //- At the initial position X of the mid-surface, whose unit normal is given
    virtual PressureHistory at(const Vec3& X, const Vec3& normal) const = 0;
};

using PressureFieldPtr = std::shared_ptr<const PressureField>;

} // namespace positionalShell

#endif
