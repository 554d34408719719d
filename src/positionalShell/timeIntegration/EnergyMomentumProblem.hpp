// SPDX-License-Identifier: GPL-3.0-or-later
//
// Balance of momentum over a step, (T5)-(T6). The unknown is the increment d of the
// step.

#ifndef positionalShell_EnergyMomentumProblem_hpp
#define positionalShell_EnergyMomentumProblem_hpp

#include "TimeIntegrator.hpp"

namespace positionalShell
{

class EnergyMomentumProblem : public EquilibriumProblem
{
public:

    EnergyMomentumProblem
    (
        const ShellModel& model,
        const Loads& loads,
        const GivenForce& given,
        const ShellState& start,
        double dt,
        double massDamping
    );

    const ShellModel& model() const override { return model_; }
    const Vector& position() const override { return end_.position; }
    const Vector& origin() const override { return start_.position; }
    void residual(Vector& full, KindNorms& scale) override;
    void addStiffness(const StressPrediction&, SystemMatrix& K) override;
    void addInertia(SystemMatrix& K) override;
    const Vector& tieArms() const override { return middle_; }
    std::vector<TieForce> tieForces() const override;
    Vector& unknowns() override { return increment_; }
    void update() override;

    const ShellState& endState() const { return end_; }

    //- External force at the end
    Vector forceAtEnd() const;

    //- External force in the middle, whose work counts
    const Vector& meanForce() const { return external_; }

    //- Force of the supports on prescribed unknowns over the step
    Vector meanReaction() const;

private:

    const ShellModel& model_;
    const Loads& loads_;
    const GivenForce given_;
    const ShellState& start_;
    const double dt_;
    const double damping_;

    Vector increment_;      // d, full
    Vector middle_;         // positions
    ShellState end_;
    Vector external_;
    Vector resistance_;     // internal force and inertia

    double middleTime() const { return start_.time + 0.5*dt_; }
};

} // namespace positionalShell

#endif
