// SPDX-License-Identifier: GPL-3.0-or-later

#include "TieLoad.hpp"

#include <stdexcept>

namespace positionalShell
{

namespace
{

int tieOf(const ShellModel& model, const std::string& nodeSet)
{
    const std::vector<RigidTie>& ties = model.dofs().ties();
    std::string valid;
    for (std::size_t t = 0; t < ties.size(); ++t)
    {
        if (ties[t].nodeSet() == nodeSet) return int(t);
        valid += " " + ties[t].nodeSet();
    }
    throw std::invalid_argument
    (
        "load on a rigid tie: no tie has the node set " + nodeSet
      + "; those of ties are:" + (valid.empty() ? " none" : valid)
    );
}

} // namespace

TieLoad::TieLoad
(
    const ShellModel& model,
    const std::string& nodeSet,
    const Vec3& force,
    const Vec3& moment,
    TimeFunctionPtr factor
)
:
    tie_(tieOf(model, nodeSet)),
    force_(force),
    moment_(moment),
    factor_(std::move(factor))
{}

TieForce TieLoad::at
(
    const ShellModel& model,
    const Vector& q,
    double time
) const
{
    const RigidTie& tie = model.dofs().ties()[tie_];
    const double factor = factor_->value(time);
    return
    {
        tie_, factor*force_, tie.point(q) - tie.centre(q), factor*moment_
    };
}

void TieLoad::addForce
(
    const ShellModel& model,
    const Vector& q,
    double time,
    Vector& force
) const
{
    const TieForce own = at(model, q, time);
    model.dofs().ties()[tie_].spread
    (
        q, {own.force, own.momentAboutCentre()}, force
    );
}

void TieLoad::addTieForces
(
    const ShellModel& model,
    const Vector& q,
    double time,
    std::vector<TieForce>& forces
) const
{
    forces.push_back(at(model, q, time));
}

} // namespace positionalShell
