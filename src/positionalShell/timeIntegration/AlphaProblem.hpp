// SPDX-License-Identifier: GPL-3.0-or-later
//
// Weighted equilibrium over a step, (T2), with Newmark's expansions, (S30). The
// unknown is the increment d of the step, so that accelerations are not differences
// of large numbers.

#ifndef positionalShell_AlphaProblem_hpp
#define positionalShell_AlphaProblem_hpp

#include "AlphaFamily.hpp"

namespace positionalShell
{

class AlphaProblem : public EquilibriumProblem
{
public:

    AlphaProblem
    (
        const ShellModel& model,
        const Loads& loads,
        const GivenForce& given,
        const ShellState& start,
        double dt,
        const AlphaParameters& parameters,
        double massDamping
    );

    const ShellModel& model() const override { return model_; }
    const Vector& position() const override { return end_.position; }
    const Vector& origin() const override { return start_.position; }
    void residual(Vector& full, KindNorms& scale) override;
    void addStiffness(const StressPrediction&, SystemMatrix& K) override;
    void addInertia(SystemMatrix& K) override;
    std::vector<TieForce> tieForces() const override;
    Vector& unknowns() override { return increment_; }
    void update() override;

    const ShellState& endState() const { return end_; }
    const Vector& externalForce() const { return external_; }

private:

    const ShellModel& model_;
    const Loads& loads_;
    const Vector* given_;           // at the end
    const ShellState& start_;
    const double dt_;
    const AlphaParameters p_;
    const double damping_;

    Vector increment_;      // d, full
    ShellState end_;
    Vector external_;

    //- alphaF times the forces at the start, of the equations with inertia
    Vector startForce_;

    //- Resultants of the start on rigid ties, which are not of its positions, (C10)
    std::vector<TieForce> tieStart_;

    void moveStartOfTies();

    Vector totalAt(const ShellState& state, const Vector* given) const;
};

} // namespace positionalShell

#endif
