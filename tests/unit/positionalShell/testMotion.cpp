// SPDX-License-Identifier: GPL-3.0-or-later

#include "ShellTestModels.hpp"
#include "SurfaceLocator.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

using namespace shellTest;

namespace
{

constexpr double thickness = 0.08;

struct Curved
{
    ShellMesh mesh = structuredMesh
    (
        5, 4,
        [](double u, double v) -> Vec3
        {
            return {2*u, 1.5*v + 0.2*u, 0.3*std::sin(3*u)*std::cos(2*v)};
        }
    );
    ShellModel model
    {
        mesh, {{"all", thickness, material(3, 0.3)}}, Constraints(mesh).dofMap()
    };
};

SurfacePoint randomPoint(const ShellMesh& mesh, std::mt19937& generator)
{
    std::uniform_real_distribution<double> uniform(0, 1);
    SurfacePoint p;
    p.element = int(uniform(generator)*mesh.nElements());
    p.xi1 = uniform(generator);
    p.xi2 = uniform(generator);
    if (p.xi1 + p.xi2 > 1)
    {
        p.xi1 = 1 - p.xi1;
        p.xi2 = 1 - p.xi2;
    }
    p.xi3 = 2*uniform(generator) - 1;
    return p;
}

} // namespace

TEST(MotionMap, isLinearInTheUnknownsAndLeavesOutTheThicknessStrain)
{
    const Curved shell;
    const MotionMap map(shell.model);
    const SurfacePoint p{7, 0.2, 0.5, 0.7};
    const Vector q1 = randomState(shell.mesh, 0.1, 1);
    const Vector q2 = randomState(shell.mesh, 0.1, 2);
    EXPECT_LT
    (
        (map.position(p, q1) + 2*map.position(p, q2) - map.position(p, q1 + 2*q2)).norm(), 1e-13
    );
    Vector q3 = q1;
    for (int i = 0; i < shell.mesh.nNodes(); ++i) q3[7*i + 6] += 5;
    EXPECT_EQ((map.position(p, q1) - map.position(p, q3)).norm(), 0);
    EXPECT_EQ((map.velocity(p, q1) - map.position(p, q1)).norm(), 0);

    // At a node: position plus half the thickness along the director
    const int node = shell.mesh.triangle(7)[1];
    const Vec3 expected =
        q1.segment<3>(7*node) + 0.5*thickness*0.7*q1.segment<3>(7*node + 3);
    EXPECT_LT((map.position({7, 1, 0, 0.7}, q1) - expected).norm(), 1e-14);
}

// Force, moment and work of random point forces equal those of their generalised force
TEST(MotionMap, theTransposeKeepsForceMomentAndWork)
{
    const Curved shell;
    const MotionMap map(shell.model);
    const Vector q = randomState(shell.mesh, 0.1, 3);
    const Vector v = randomVector(q.size(), 4);
    std::mt19937 generator(5);
    Vector generalised = Vector::Zero(q.size());
    Vec3 force = Vec3::Zero();
    Vec3 moment = Vec3::Zero();
    double power = 0;
    double size = 0;
    for (int k = 0; k < 200; ++k)
    {
        const SurfacePoint p = randomPoint(shell.mesh, generator);
        const Vec3 f = randomVector(3, 100 + k);
        map.addForce(p, f, generalised);
        force += f;
        moment += map.position(p, q).cross(f);
        power += map.velocity(p, v).dot(f);
        size += f.norm();
    }
    Vec3 sum = Vec3::Zero();
    Vec3 sumOfMoments = Vec3::Zero();
    for (Eigen::Index i = 0; i < q.size(); i += dofsPerNode)
    {
        const Vec3 f = generalised.segment<3>(i);
        const Vec3 c = generalised.segment<3>(i + 3);
        sum += f;
        sumOfMoments += Vec3(q.segment<3>(i)).cross(f) + Vec3(q.segment<3>(i + 3)).cross(c);
    }
    EXPECT_LT((sum - force).norm(), 1e-12*size);
    EXPECT_LT((sumOfMoments - moment).norm(), 1e-12*size);
    EXPECT_NEAR(generalised.dot(v), power, 1e-12*size);
}

TEST(MotionMap, normalIsThatOfTheSurface)
{
    const Curved shell;
    const MotionMap map(shell.model);
    const Vector q = shell.mesh.initialPositions();
    const SurfacePoint p{11, 0.3, 0.3, 0};
    const double s = 1e-4;
    const Vec3 d1 = map.position({11, 0.3 + s, 0.3, 0}, q) - map.position({11, 0.3 - s, 0.3, 0}, q);
    const Vec3 d2 = map.position({11, 0.3, 0.3 + s, 0}, q) - map.position({11, 0.3, 0.3 - s, 0}, q);
    EXPECT_LT((map.normal(p, q) - d1.cross(d2).normalized()).norm(), 1e-7);
    EXPECT_GT(map.normal(p, q)[2], 0);
}

TEST(SurfaceLocator, recoversRandomPointsOfTheBody)
{
    const Curved shell;
    const MotionMap map(shell.model);
    const SurfaceLocator locator(shell.model);
    const Vector q = shell.mesh.initialPositions();
    std::mt19937 generator(7);
    for (int k = 0; k < 500; ++k)
    {
        const SurfacePoint p = randomPoint(shell.mesh, generator);
        const Vec3 X = map.position(p, q);
        const Projection found = locator.locate(X);
        EXPECT_LT(found.offset.norm(), 1e-12) << k;
        EXPECT_LT((map.position(found.point, q) - X).norm(), 1e-12) << k;
        EXPECT_NEAR(found.point.xi3, p.xi3, 1e-3) << k;
        EXPECT_LE(found.distance, 0.5*thickness*1.001) << k;
        // Well inside the element the coordinates are those that made the point
        const bool inside = p.xi1 > 0.05 && p.xi2 > 0.05 && p.xi1 + p.xi2 < 0.95;
        if (!inside) continue;
        EXPECT_EQ(found.point.element, p.element) << k;
        EXPECT_NEAR(found.point.xi1, p.xi1, 1e-10) << k;
        EXPECT_NEAR(found.point.xi2, p.xi2, 1e-10) << k;
        EXPECT_NEAR(found.point.xi3, p.xi3, 1e-10) << k;
    }
}

// The tree against plain search over all elements, points far off included
TEST(SurfaceLocator, theTreeFindsTheNearestElementWithAnyHint)
{
    const Curved shell;
    const SurfaceLocator locator(shell.model);
    for (int k = 0; k < 60; ++k)
    {
        const Vec3 X = Vec3(1, 0.75, 0) + 1.5*randomVector(3, k);
        double least = 1e300;
        for (int e = 0; e < shell.mesh.nElements(); ++e)
        {
            least = std::min(least, locator.project(X, e).distance);
        }
        const Projection found = locator.locate(X);
        EXPECT_NEAR(found.distance, least, 1e-12);
        const Projection hinted = locator.locate(X, k%shell.mesh.nElements());
        EXPECT_EQ(hinted.point.element, found.point.element);
        EXPECT_EQ(hinted.point.xi1, found.point.xi1);
    }
}

// Beyond the rim the nearest point is on the rim; the rest is the offset
TEST(SurfaceLocator, pointsBeyondTheRimAreClamped)
{
    const ShellMesh mesh = rectangleMesh(2, 1, Vec3::Zero(), {2, 0, 0}, {0, 1, 0});
    const ShellModel model
    (
        mesh, {{"all", thickness, material(3, 0.3)}}, Constraints(mesh).dofMap()
    );
    const SurfaceLocator locator(model);
    const MotionMap map(model);
    const Projection found = locator.locate({2.4, 0.3, 0.02});
    const Vec3 carried = map.position(found.point, mesh.initialPositions());
    EXPECT_LT((carried - Vec3(2, 0.3, 0.02)).norm(), 1e-12);
    EXPECT_LT((found.offset - Vec3(0.4, 0, 0)).norm(), 1e-12);
    EXPECT_NEAR(found.point.xi3, 0.5, 1e-12);
    EXPECT_NEAR(found.distance, std::hypot(0.4, 0.02), 1e-12);

    // The tip face of a panel meshed with its thickness lies on the rim exactly
    const Projection tip = locator.locate({2, 0.5, -0.5*thickness});
    EXPECT_LT(tip.offset.norm(), 1e-13);
    EXPECT_NEAR(tip.point.xi3, -1, 1e-12);
    EXPECT_NEAR(tip.distance, 0.5*thickness, 1e-13);
}
