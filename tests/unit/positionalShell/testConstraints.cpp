// SPDX-License-Identifier: GPL-3.0-or-later

#include "ShellTestModels.hpp"

#include <gtest/gtest.h>

using namespace shellTest;

namespace
{

std::vector<std::string> freeComponents(const DofMap& dofs, int node)
{
    std::vector<std::string> names;
    for (int c = 0; c < dofsPerNode; ++c)
    {
        if (dofs.equation(dofsPerNode*node + c) >= 0)
        {
            names.push_back(componentName(static_cast<Component>(c)));
        }
    }
    return names;
}

using Names = std::vector<std::string>;

} // namespace

TEST(Constraints, supportsFixWhatTheySay)
{
    const ShellMesh mesh = rectangleMesh(1, 1, Vec3::Zero(), {1, 0, 0}, {0, 1, 0});
    const int root = mesh.nodeSet("uMin")[1];
    const int other = mesh.nodeSet("uMax")[1];

    const DofMap clamped = Constraints(mesh).clamped("uMin").dofMap();
    EXPECT_EQ(freeComponents(clamped, root), Names{"a"});
    EXPECT_EQ(freeComponents(clamped, other).size(), 7u);
    EXPECT_EQ(clamped.nEquations(), 7*16 - 6*4);

    const DofMap hinged = Constraints(mesh).hinged("uMin").dofMap();
    EXPECT_EQ(freeComponents(hinged, root), (Names{"gx", "gy", "gz", "a"}));

    const DofMap symmetric = Constraints(mesh).symmetryPlane("uMin", Axis::x).dofMap();
    EXPECT_EQ(freeComponents(symmetric, root), (Names{"y", "z", "gy", "gz", "a"}));

    const DofMap both = Constraints(mesh)
        .symmetryPlane("uMin", Axis::x).symmetryPlane("vMin", Axis::y).dofMap();
    EXPECT_EQ(freeComponents(both, mesh.nodeSet("uMinVMin")[0]), (Names{"z", "gz", "a"}));
}

TEST(Constraints, tiedUnknownsShareAnEquation)
{
    const ShellMesh mesh = rectangleMesh(1, 1, Vec3::Zero(), {1, 0, 0}, {0, 1, 0});
    const DofMap dofs = Constraints(mesh).tied("uMax", Component::z).dofMap();
    const auto& nodes = mesh.nodeSet("uMax");
    const int shared = dofs.equation(fullIndex(nodes[0], Component::z));
    for (int node : nodes) EXPECT_EQ(dofs.equation(fullIndex(node, Component::z)), shared);
    EXPECT_EQ(dofs.nEquations(), 7*16 - 3);
    EXPECT_EQ(dofs.firstUnknown(shared), fullIndex(nodes[0], Component::z));

    // reduce is the transpose of expand
    const Vector full = randomVector(dofs.nFull(), 1);
    const Vector reduced = randomVector(dofs.nEquations(), 2);
    EXPECT_NEAR(dofs.reduce(full).dot(reduced), full.dot(dofs.expand(reduced)), 1e-13);
}

TEST(Constraints, aTiedGroupFollowsItsPrescribedMember)
{
    const ShellMesh mesh = rectangleMesh(1, 1, Vec3::Zero(), {1, 0, 0}, {0, 1, 0});
    const DofMap dofs = Constraints(mesh)
        .tied("uMax", Component::z)
        .prescribed("uMaxVMax", Component::z, linearInTime(0, 2))
        .dofMap();
    Vector q = mesh.initialPositions();
    dofs.setPrescribedPositions(3, q);
    Vector v = Vector::Constant(q.size(), 9);
    Vector a = v;
    dofs.setPrescribedRates(3, v, a);
    for (int node : mesh.nodeSet("uMax"))
    {
        const int i = fullIndex(node, Component::z);
        EXPECT_EQ(dofs.equation(i), -1);
        EXPECT_EQ(q[i], 6);
        EXPECT_EQ(v[i], 2);
        EXPECT_EQ(a[i], 0);
    }
}

TEST(Constraints, planeStrainStripSharesAcrossTheWidth)
{
    // Inclined in the plane and two quadrilaterals wide
    const ShellMesh mesh = rectangleMesh(3, 2, Vec3::Zero(), {1, 0.5, 0}, {0, 0, 0.2});
    const DofMap dofs = Constraints(mesh).planeStrainStrip(Axis::z).dofMap();
    // 10 stations, each x y gx gy a
    EXPECT_EQ(dofs.nEquations(), 10*5);
    for (int node = 0; node < mesh.nNodes(); ++node)
    {
        EXPECT_EQ(freeComponents(dofs, node), (Names{"x", "y", "gx", "gy", "a"}));
    }
    for (int i = 0; i < mesh.nNodes(); ++i)
    {
        for (int j = 0; j < mesh.nNodes(); ++j)
        {
            const Vec3 d = mesh.nodes()[i] - mesh.nodes()[j];
            const bool same = dofs.equation(7*i + 1) == dofs.equation(7*j + 1);
            EXPECT_EQ(same, d.head<2>().norm() < 1e-9) << i << ' ' << j;
        }
    }

    const ShellMesh skew = rectangleMesh(2, 1, Vec3::Zero(), {1, 0, 0}, {0.03, 0, 0.2});
    const std::string error =
        errorOf([&] { Constraints(skew).planeStrainStrip(Axis::z); });
    EXPECT_NE(error.find("has no other node on its line"), std::string::npos) << error;
}

TEST(Constraints, conflictsNameNodeAndComponent)
{
    const ShellMesh mesh = rectangleMesh(1, 1, Vec3::Zero(), {1, 0, 0}, {0, 1, 0});
    const auto moving = linearInTime(0, 1);
    const auto error = errorOf
    (
        [&] { Constraints(mesh).clamped("uMin").prescribed("uMinVMin", Component::y, moving); }
    );
    EXPECT_NE(error.find("component y of node 0"), std::string::npos) << error;

    const auto tiedError = errorOf
    (
        [&]
        {
            Constraints(mesh)
                .tied("uMax", Component::x)
                .fixed("uMaxVMin", {Component::x})
                .prescribed("uMaxVMax", Component::x, moving)
                .dofMap();
        }
    );
    EXPECT_NE(tiedError.find("component x of node"), std::string::npos) << tiedError;

    // The same motion twice is no conflict
    EXPECT_EQ
    (
        errorOf
        (
            [&]
            {
                Constraints(mesh)
                    .prescribed("uMin", Component::x, moving)
                    .prescribed("uMinVMin", Component::x, moving)
                    .dofMap();
            }
        ),
        "no error"
    );
    EXPECT_NE
    (
        errorOf([&] { Constraints(mesh).prescribed("uMin", Component::x, nullptr); })
       .find("no function of time for x"),
        std::string::npos
    );
    EXPECT_NE
    (
        errorOf([&] { Constraints(mesh).clamped("root"); }).find("no node set root"),
        std::string::npos
    );
}

TEST(TimeFunction, derivativesAreThoseOfTheValue)
{
    const std::vector<TimeFunctionPtr> functions
    {
        constant(3), linearInTime(1, -2), sine(2, 0.7, 0.3), smoothStep(0.1, 2, 5)
    };
    for (const auto& f : functions)
    {
        for (double t : {-0.4, 0.3, 1.1, 1.9, 2.6})
        {
            const double h = 1e-4;
            // Central differences: error h^2/6 times the third derivative, which is
            // below 300 for all of these
            EXPECT_NEAR
            (
                f->firstDerivative(t), (f->value(t + h) - f->value(t - h))/(2*h), 50*h*h
            );
            EXPECT_NEAR
            (
                f->secondDerivative(t),
                (f->firstDerivative(t + h) - f->firstDerivative(t - h))/(2*h), 500*h*h
            );
        }
    }
    EXPECT_EQ(smoothStep(1, 2, 5)->value(0.5), 0);
    EXPECT_EQ(smoothStep(1, 2, 5)->value(3), 5);
}

TEST(TimeFunction, tableIsLinearBetweenAndConstantOutside)
{
    const auto f = table({0, 1, 3}, {2, 4, 0});
    EXPECT_EQ(f->value(-1), 2);
    EXPECT_EQ(f->value(0.25), 2.5);
    EXPECT_EQ(f->value(2), 2);
    EXPECT_EQ(f->value(9), 0);
    EXPECT_EQ(f->firstDerivative(0.25), 2);
    EXPECT_EQ(f->firstDerivative(2), -2);
    EXPECT_EQ(f->firstDerivative(5), 0);
    EXPECT_NE(errorOf([] { table({0, 0}, {1, 2}); }).find("not later"), std::string::npos);
    EXPECT_NE(errorOf([] { table({0, 1}, {1}); }).find("2 times and 1 values"), std::string::npos);
}

TEST(TimeFunction, aValueAloneCannotDriveMotion)
{
    const auto f = timeFunction([](double t) { return t*t; });
    EXPECT_EQ(f->value(3), 9);
    EXPECT_NE
    (
        errorOf([&] { f->firstDerivative(1); }).find("needs the first and the second derivative"),
        std::string::npos
    );
}
