// SPDX-License-Identifier: GPL-3.0-or-later
//
// Dead force [N] at the point of a rigid tie and moment [N m] fixed in space, times a
// factor of time, (C7).

#ifndef positionalShell_TieLoad_hpp
#define positionalShell_TieLoad_hpp

#include "Load.hpp"

#include <string>

namespace positionalShell
{

class TieLoad : public Load
{
public:

    //- nodeSet: of the tie. Throws std::invalid_argument, listing those that there
    //  are, when no tie has it.
    TieLoad
    (
        const ShellModel& model,
        const std::string& nodeSet,
        const Vec3& force,
        const Vec3& moment,
        TimeFunctionPtr factor = constant(1)
    );

    void addForce
    (
        const ShellModel& model, const Vector& q, double time, Vector& force
    ) const override;

    void addTieForces
    (
        const ShellModel& model, const Vector& q, double time,
        std::vector<TieForce>& forces
    ) const override;

private:

    int tie_;
    Vec3 force_;
    Vec3 moment_;
    TimeFunctionPtr factor_;

    TieForce at(const ShellModel& model, const Vector& q, double time) const;
};

} // namespace positionalShell

#endif
