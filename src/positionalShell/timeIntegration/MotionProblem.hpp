// SPDX-License-Identifier: GPL-3.0-or-later
//
// Equilibrium at the end of a Newmark step, (S29)-(S30). The unknown is the
// increment d of the step, so that accelerations are not differences of large
// numbers.

#ifndef positionalShell_MotionProblem_hpp
#define positionalShell_MotionProblem_hpp

#include "Newmark.hpp"

namespace positionalShell
{

class MotionProblem : public EquilibriumProblem
{
public:

    MotionProblem
    (
        const ShellModel& model,
        const Loads& loads,
        const Vector* fixedForce,
        const ShellState& start,
        double dt,
        const NewmarkOptions& options
    );

    const ShellModel& model() const override { return model_; }
    const Vector& position() const override { return end_.position; }
    void residual(Vector& full, KindNorms& scale) override;
    void addTangent(SystemMatrix& K) override;
    void move(const Vector& increment) override;

    const ShellState& endState() const { return end_; }
    const Vector& externalForce() const { return external_; }

private:

    const ShellModel& model_;
    const Loads& loads_;
    const Vector* fixedForce_;
    const ShellState& start_;
    const double dt_;
    const double beta_;
    const double gamma_;
    const double damping_;

    Vector increment_;      // d, full
    ShellState end_;
    Vector external_;

    void predict();
    void update();
};

} // namespace positionalShell

#endif
