// SPDX-License-Identifier: GPL-3.0-or-later
//
// Equilibrium of the thickness strain a for given positions and directors, (S32):
// the equations of a are those of statics, all others are held.

#ifndef positionalShell_ThicknessProblem_hpp
#define positionalShell_ThicknessProblem_hpp

#include "Load.hpp"
#include "Newton.hpp"

namespace positionalShell
{

class ThicknessProblem : public EquilibriumProblem
{
public:

    ThicknessProblem
    (
        const ShellModel& model,
        const Loads& loads,
        const Vector* fixedForce,
        const ShellState& state
    )
    :
        model_(model),
        loads_(loads),
        fixedForce_(fixedForce),
        time_(state.time),
        start_(state.position),
        q_(state.position)
    {}

    const ShellModel& model() const override { return model_; }
    const Vector& position() const override { return q_; }
    const Vector& origin() const override { return start_; }

    void residual(Vector& full, KindNorms& scale) override
    {
        full = totalForce(loads_, model_, q_, time_);
        if (fixedForce_) full += *fixedForce_;
        const Vector internal = model_.internalForce(q_);
        scale = greater(normsByKind(full), normsByKind(internal));
        full -= internal;
        for (Eigen::Index i = 0; i < full.size(); ++i)
        {
            if (i%dofsPerNode != static_cast<int>(Component::a)) full[i] = 0;
        }
    }

    // Loads do no work on a
    void addStiffness(const StressPrediction& stress, SystemMatrix& K) override
    {
        model_.addTangent(stress, q_, K);
        K.decouple
        (
            [this](int equation) { return !model_.massless(equation); }
        );
    }

    Vector& unknowns() override { return q_; }

private:

    const ShellModel& model_;
    const Loads& loads_;
    const Vector* fixedForce_;
    double time_;
    const Vector& start_;
    Vector q_;
};

} // namespace positionalShell

#endif
