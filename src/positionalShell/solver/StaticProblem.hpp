// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static equilibrium at a load parameter, (S22), also of a part of a load step, (N4).

#ifndef positionalShell_StaticProblem_hpp
#define positionalShell_StaticProblem_hpp

#include "EquilibriumProblem.hpp"
#include "Load.hpp"

namespace positionalShell
{

class StaticProblem : public EquilibriumProblem
{
public:

    //- start: positions of a solution nearby; lack: right-hand side of (N4), empty
    //  for zero. All must live as long as the problem.
    StaticProblem
    (
        const ShellModel& model,
        const Loads& loads,
        const Vector* fixedForce,
        double time,
        const Vector& start,
        const Vector& lack
    );

    const ShellModel& model() const override { return model_; }
    const Vector& position() const override { return q_; }
    const Vector& origin() const override { return start_; }
    void residual(Vector& full, KindNorms& scale) override;
    void addStiffness(const StressPrediction&, SystemMatrix& K) override;
    std::vector<TieForce> tieForces() const override;
    Vector& unknowns() override { return q_; }

    double time() const { return time_; }
    void setTime(double t) { time_ = t; }

    //- Derivative of the residual by the load parameter, from loads within
    //  distance of it: exact for loads that are linear in it
    Vector loadRate(double distance) const;

private:

    const ShellModel& model_;
    const Loads& loads_;
    const Vector* fixedForce_;
    double time_;
    const Vector& start_;
    const Vector& lack_;
    Vector q_;
};

} // namespace positionalShell

#endif
