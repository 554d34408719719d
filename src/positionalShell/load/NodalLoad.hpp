// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same dead force [N], and director force [N m] (conjugate of g), on every
// node of a set, times a factor of time.

#ifndef positionalShell_NodalLoad_hpp
#define positionalShell_NodalLoad_hpp

#include "Load.hpp"

#include <string>

namespace positionalShell
{

class NodalLoad : public Load
{
public:

    NodalLoad
    (
        const ShellModel& model,
        const std::string& nodeSet,
        const Vec3& force,
        TimeFunctionPtr factor = constant(1),
        const Vec3& directorForce = Vec3::Zero()
    );

    void addForce
    (
        const ShellModel&, const Vector& q, double time, Vector& force
    ) const override;

private:

    std::vector<int> nodes_;
    Vec3 force_;
    TimeFunctionPtr factor_;
    Vec3 directorForce_;
};

} // namespace positionalShell

#endif
