// SPDX-License-Identifier: GPL-3.0-or-later
//
// The strip of the dynamic tests and its march in time.

#ifndef StripModel_hpp
#define StripModel_hpp

#include "Newmark.hpp"
#include "ShellTestModels.hpp"

#include <stdexcept>

namespace shellTest
{

//- Cantilever strip in plane strain, L/h = 100, nu = 0
struct Strip
{
    ShellMesh mesh;
    ShellModel model;
    int tip;

    explicit Strip(int n)
    :
        mesh(strip(n, 10)),
        model
        (
            mesh, {{"all", 0.1, material(1.2e6, 0, 0.01)}},
            Constraints(mesh).clamped("uMin").planeStrainStrip(Axis::y).dofMap()
        ),
        tip(mesh.nodeSet("uMax")[0])
    {}

    double w(const ShellState& state) const { return state.position[7*tip + 2]; }
};

//- First period of small vibrations, beam theory
constexpr double period = 0.565105;

//- State at the end time, n equal steps; loads from the start
inline ShellState march
(
    const Strip& strip, const Loads& loads, double endTime, int n, NewmarkOptions options = {}
)
{
    Newmark newmark(strip.model, options);
    ShellState state = strip.model.initialState();
    newmark.initialise(state, loads);
    for (int k = 0; k < n; ++k)
    {
        const DynamicStep step = newmark.step(state, endTime/n, loads);
        if (!step.converged) throw std::runtime_error(step.report.describe());
        state = step.state;
    }
    return state;
}

} // namespace shellTest

#endif
