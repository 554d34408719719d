// SPDX-License-Identifier: GPL-3.0-or-later
//
// Running balance: kinetic + strain - (initial) = work of loads and of driven
// nodes - work lost in damping. The work of a step is the trapezoidal rule (S34),
// or that of the forces that the integrator says act over the step.

#ifndef positionalShell_EnergyBalance_hpp
#define positionalShell_EnergyBalance_hpp

#include "TimeIntegrator.hpp"

namespace positionalShell
{

class EnergyBalance
{
public:

    //- Start of the account. The model must live as long as the balance.
    //  externalForce: full vector at that instant.
    EnergyBalance
    (
        const ShellModel& model,
        const ShellState& start,
        const Vector& externalForce,
        double massDamping = 0
    );

    void add(const DynamicStep& step);

    double kinetic() const { return kinetic_; }
    double strain() const { return strain_; }
    double total() const { return kinetic_ + strain_; }
    double externalWork() const { return externalWork_; }
    double supportWork() const { return supportWork_; }
    double dissipated() const { return dissipated_; }

    //- Force of the supports, full vector: at the end of the last step, or over it
    //  where the integrator names those (energy-momentum), (R9)
    const Vector& reaction() const { return reaction_; }

    //- Impulse of loads and supports [N s]
    const Vec3& impulse() const { return impulse_; }

    //- total - initial total - externalWork - supportWork + dissipated [J]
    double mismatch() const;

private:

    const ShellModel& model_;
    double massDamping_;
    ShellState last_;
    Vector lastForce_;
    Vector lastReaction_;
    Vector reaction_;
    double kinetic_;
    double strain_;
    double initialTotal_ = 0;
    double externalWork_ = 0;
    double supportWork_ = 0;
    double dissipated_ = 0;
    Vec3 impulse_ = Vec3::Zero();
};

} // namespace positionalShell

#endif
