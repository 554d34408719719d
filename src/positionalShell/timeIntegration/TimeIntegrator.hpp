// SPDX-License-Identifier: GPL-3.0-or-later
//
// Family of integrators of M q'' + C q' + dU/dq = F, C = c M, (S29).
//
// A step is a function of its start: it changes nothing but the result, so a
// coupling scheme repeats it with other loads from the same start. Kept factors
// are all that an integrator remembers.

#ifndef positionalShell_TimeIntegrator_hpp
#define positionalShell_TimeIntegrator_hpp

#include "Load.hpp"
#include "Newton.hpp"

namespace positionalShell
{

//- Generalised force beside the loads, full vectors at the start and at the end of
//  a step; null: none
struct GivenForce
{
    const Vector* start = nullptr;
    const Vector* end = nullptr;

    GivenForce() = default;

    //- The same at both ends
    GivenForce(const Vector* constant) : start(constant), end(constant) {}

    GivenForce(const Vector* s, const Vector* e) : start(s), end(e) {}
};

struct DynamicStep
{
    bool converged = false;
    ShellState state;           // end of the step; last iterate if not converged
    Vector externalForce;       // full vector at the end of the step

    //- Forces of loads and of supports that act over the step; empty: the mean of
    //  those at both ends does, (S34)
    Vector meanForce;
    Vector meanReaction;

    NewtonReport report;
};

struct MotionOptions
{
    double massDamping = 0;         // c [1/s]
    NewtonOptions newton;

    MotionOptions() { newton.tangentUpdate = TangentUpdate::whenSlow; }
};

class TimeIntegrator
{
public:

    virtual ~TimeIntegrator() = default;

    //- Consistent start: a in equilibrium for the given positions and
    //  directors, accelerations from (S31). state holds time, position, velocity.
    //  Throws std::runtime_error when a cannot be brought into equilibrium.
    void initialise
    (
        ShellState& state,
        const Loads& loads,
        const Vector* givenForce = nullptr
    ) const;

    //- From start to start.time + dt
    DynamicStep step
    (
        const ShellState& start,
        double dt,
        const Loads& loads,
        const GivenForce& given = {}
    );

    //- Local error of positions over the length of the mesh, and of directors, that
    //  the change of the accelerations over a step tells, (T13)
    double errorEstimate(const ShellState& start, const ShellState& end) const;

    const ShellModel& model() const { return model_; }
    double massDamping() const { return massDamping_; }
    const LinearSolverReport& linearReport() const
    {
        return newton_.linearReport();
    }

protected:

    //- The model must live as long as the integrator. Throws
    //  std::invalid_argument unless massDamping >= 0.
    TimeIntegrator
    (
        const std::string& name, const ShellModel& model,
        const MotionOptions& options
    );

    Newton& newton() { return newton_; }

    //- std::invalid_argument with the integrator's name unless the condition holds
    void require(bool condition, const std::string& message) const;

    virtual DynamicStep doStep
    (
        const ShellState& start,
        double dt,
        const Loads& loads,
        const GivenForce& given
    ) = 0;

    //- Local error = this times dt^2 times the change of the acceleration, (T13)
    virtual double errorConstant() const = 0;

private:

    std::string name_;
    const ShellModel& model_;
    double massDamping_;
    Newton newton_;
    double keptTimeStep_ = 0;

    void equilibrateThickness(ShellState&, const Loads&, const Vector*) const;
    void setAccelerations(ShellState&, const Loads&, const Vector*) const;
};

//- Thickness strain has no rates; driven unknowns take those of their motion
void setFixedRates(const DofMap& dofs, ShellState& state);

//- First guess of the increment of a step: constant acceleration; driven unknowns
//  exact, thickness strain unchanged, (S33)
Vector predictedIncrement
(
    const DofMap& dofs, const ShellState& start, double dt
);

} // namespace positionalShell

#endif
