// SPDX-License-Identifier: GPL-3.0-or-later

#include "EnergyGuard.hpp"

#include <cmath>

namespace positionalShell
{

namespace
{

//- A motion of so many lengths of the mesh in a step is one of rounding
constexpr double invisible = 1e-10;

} // namespace

double EnergyGuard::strainEnergy(const Vector& position)
{
    if (position.size() != kept_.size() || position != kept_)
    {
        keptEnergy_ = model_.strainEnergy(position);
        kept_ = position;
    }
    return keptEnergy_;
}

double EnergyGuard::excess(const ShellState& start, const DynamicStep& step)
{
    if (step.meanForce.size() > 0) return 0;

    const double strain0 = strainEnergy(start.position);
    const double kinetic0 = model_.kineticEnergy(start.velocity);
    const double strain1 = strainEnergy(step.state.position);
    const double kinetic1 = model_.kineticEnergy(step.state.velocity);

    const double dt = step.state.time - start.time;
    const double speed = invisible*model_.mesh().lengthScale()/dt;
    const double before = strain0 + kinetic0 + model_.totalMass()*speed*speed;

    // (T16) cannot hold otherwise
    if (strain1 + kinetic1 < 2*before) return 0;

    const Vector moved = step.state.position - start.position;
    const double work = 0.5*moved.dot
    (
        model_.internalForce(start.position)
      + model_.internalForce(step.state.position)
    );
    const double gain = strain1 - strain0 - work;
    const double putIn = kinetic1 - kinetic0 + work;
    return gain > before + std::abs(putIn) || std::isnan(gain) ? gain : 0;
}

} // namespace positionalShell
