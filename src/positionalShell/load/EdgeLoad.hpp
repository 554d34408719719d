// SPDX-License-Identifier: GPL-3.0-or-later
//
// Dead line load [N/m of initial length] and director line load [N m/m] on the
// mesh edges whose four nodes belong to a set, times a factor of time. Throws
// std::invalid_argument when the set contains no whole edge.

#ifndef positionalShell_EdgeLoad_hpp
#define positionalShell_EdgeLoad_hpp

#include "Load.hpp"

#include <string>

namespace positionalShell
{

class EdgeLoad : public Load
{
public:

    EdgeLoad
    (
        const ShellModel& model,
        const std::string& nodeSet,
        const Vec3& forcePerLength,
        TimeFunctionPtr factor = constant(1),
        const Vec3& directorForcePerLength = Vec3::Zero()
    );

    void addForce
    (
        const ShellModel&, const Vector& q, double time, Vector& force
    ) const override;

private:

    Vector unitForce_;
    TimeFunctionPtr factor_;
};

} // namespace positionalShell

#endif
