// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rigid ties on paths by arc length.

#include "ArcLength.hpp"
#include "NodalLoad.hpp"
#include "ShellTestModels.hpp"
#include "TieLoad.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace shellTest;

namespace
{

const double pi = std::acos(-1.0);

//- Flat arch, both ends hinged; its crown loose, or tied to a point
struct Arch
{
    ShellMesh mesh;
    ShellModel model;

    explicit Arch(bool tied) : mesh(arc()), model(mesh, sections(), supports(mesh, tied)) {}

    static ShellMesh arc()
    {
        ShellMesh mesh = structuredMesh
        (
            6, 1,
            [](double u, double v) -> Vec3
            {
                const double angle = 0.5*(u - 0.5);
                return {10*std::sin(angle), v, 10*std::cos(angle)};
            }
        );
        std::vector<int> crown, sides, inside;
        for (int i = 0; i < mesh.nNodes(); ++i)
        {
            if (std::abs(mesh.nodes()[i][0]) > 1e-9) continue;
            crown.push_back(i);
            const double y = mesh.nodes()[i][1];
            (std::abs(y - 0.5) > 0.4 ? sides : inside).push_back(i);
        }
        mesh.addNodeSet("crown", crown);
        mesh.addNodeSet("crownSides", sides);
        mesh.addNodeSet("crownInside", inside);
        return mesh;
    }

    static std::vector<Section> sections() { return {{"all", 0.2, material(1e6, 0)}}; }

    static DofMap supports(const ShellMesh& mesh, bool tied)
    {
        Constraints c(mesh);
        c.hinged("uMin").hinged("uMax");
        if (tied) c.rigidTie("crown", Vec3(0, 0.5, 10.5));
        return c.dofMap();
    }

    //- Load parameter and height of the crown
    std::vector<std::pair<double, double>> path(const Loads& loads, int steps) const
    {
        ArcLength arc(model);
        Vector memory;
        ShellState state = model.initialState();
        std::vector<std::pair<double, double>> points;
        for (int k = 0; k < steps; ++k)
        {
            const ArcLengthStep step = arc.step(state, 0.2, loads, memory);
            if (!step.converged) throw std::runtime_error(step.report.describe());
            state = step.state;
            points.emplace_back
            (
                state.time, state.position[7*mesh.nodeSet("crown")[0] + 2]
            );
        }
        return points;
    }
};

} // namespace

// Without transverse contraction a tie across the crown holds next to nothing: the path
// through both limit points is that of the loose arch under the same line load
TEST(TiePaths, aTiedCrownSnapsThroughAsALooseOne)
{
    const double P = -300;
    const Arch loose(false);
    const TimeFunctionPtr growing = linearInTime(0, 1);
    const auto line = loose.path
    (
        {
            std::make_shared<NodalLoad>
            (
                loose.model, "crownSides", Vec3(0, 0, P/8), growing
            ),
            std::make_shared<NodalLoad>
            (
                loose.model, "crownInside", Vec3(0, 0, 3*P/8), growing
            )
        },
        11
    );
    const Arch tied(true);
    const auto point = tied.path
    (
        {
            std::make_shared<TieLoad>
            (
                tied.model, "crown", Vec3(0, 0, P), Vec3::Zero(), growing
            )
        },
        11
    );
    int falling = 0;
    int rising = 0;
    for (std::size_t k = 0; k < line.size(); ++k)
    {
        EXPECT_NEAR(point[k].first, line[k].first, 2e-3) << k;
        EXPECT_NEAR(point[k].second, line[k].second, 5e-4) << k;
        if (k == 0) continue;
        (line[k].first < line[k - 1].first ? falling : rising) += 1;
    }
    EXPECT_GT(falling, 2);
    EXPECT_GT(rising, 5);
    EXPECT_LT(line.back().second, 9.4);
}

// source: exact; the moment M bends a strip without stretch to the radius EI/M. With a
// moment the matrix is unsymmetric, and rotations are finite
TEST(TiePaths, anEndMomentRollsAStripUp)
{
    const double L = 12;
    const double EI = 100;
    const ShellMesh mesh = strip(8, L);
    const ShellModel model
    (
        mesh, {{"all", 0.1, material(1.2e6, 0)}},
        Constraints(mesh).clamped("uMin").rigidTie("uMax", Vec3(L, 0.5, 0)).dofMap(), {},
        ElementForm::assumedStrain
    );
    const Loads loads
    {
        std::make_shared<TieLoad>
        (
            model, "uMax", Vec3::Zero(), Vec3(0, -2*pi*EI/L, 0), linearInTime(0, 1)
        )
    };
    ArcLength arc(model);
    Vector memory;
    ShellState state = model.initialState();
    int steps = 0;
    for (; state.time < 1 && steps < 60; ++steps)
    {
        const ArcLengthStep step = arc.step(state, 0.05, loads, memory);
        ASSERT_TRUE(step.converged) << step.report.describe();
        EXPECT_LE(step.report.iterations, 8) << step.report.describe();
        state = step.state;
        const double radius = L/(2*pi*state.time);
        const Vec3 exact
        (
            radius*std::sin(L/radius), 0.5, radius*(1 - std::cos(L/radius))
        );
        const Vec3 point = model.dofs().ties()[0].point(state.position);
        EXPECT_LT((point - exact).norm(), 0.01*L) << state.time;
    }
    EXPECT_GE(state.time, 1);
}
