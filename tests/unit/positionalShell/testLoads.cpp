// SPDX-License-Identifier: GPL-3.0-or-later

#include "BlastWave.hpp"
#include "KingeryBulmash.hpp"
#include "BodyForce.hpp"
#include "EdgeLoad.hpp"
#include "ElasticFoundation.hpp"
#include "FollowerPressure.hpp"
#include "NodalLoad.hpp"
#include "ShellTestModels.hpp"
#include "SurfaceTraction.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

using namespace shellTest;

namespace
{

Vec3 resultant(const Vector& force)
{
    Vec3 sum = Vec3::Zero();
    for (Eigen::Index i = 0; i < force.size(); i += dofsPerNode) sum += force.segment<3>(i);
    return sum;
}

//- About the origin, with what the directors carry
Vec3 moment(const Vector& q, const Vector& force)
{
    Vec3 sum = Vec3::Zero();
    for (Eigen::Index i = 0; i < force.size(); i += dofsPerNode)
    {
        sum += Vec3(q.segment<3>(i)).cross(Vec3(force.segment<3>(i)));
        sum += Vec3(q.segment<3>(i + 3)).cross(Vec3(force.segment<3>(i + 3)));
    }
    return sum;
}

Vector forceOf(const Load& load, const ShellModel& model, const Vector& q, double t = 0)
{
    Vector f = Vector::Zero(q.size());
    load.addForce(model, q, t, f);
    return f;
}

struct Patch
{
    ShellMesh mesh = curvedPatch();
    ShellModel model
    {
        mesh, {{"all", 0.1, material(3, 0.3, 2)}}, Constraints(mesh).dofMap()
    };
};

} // namespace

TEST(Loads, nodalLoadIsWhatItSays)
{
    const Patch patch;
    const NodalLoad load
    (
        patch.model, "uMax", {1, 2, 3}, linearInTime(0, 2), {0.1, 0.2, 0.3}
    );
    const Vector f = forceOf(load, patch.model, patch.mesh.initialPositions(), 1.5);
    EXPECT_LT((resultant(f) - 4*3*Vec3(1, 2, 3)).norm(), 1e-13);
    const int node = patch.mesh.nodeSet("uMax")[2];
    EXPECT_LT((f.segment<3>(7*node + 3) - 3*Vec3(0.1, 0.2, 0.3)).norm(), 1e-15);
    EXPECT_EQ(f.segment<7>(7*patch.mesh.nodeSet("uMin")[0]).norm(), 0);
    EXPECT_FALSE(load.dependsOnPosition());
}

TEST(Loads, edgeLoadHasTheResultantOfTheEdge)
{
    // A quarter of a circle of radius 2: length pi up to the cubic interpolation
    const ShellMesh mesh = structuredMesh
    (
        4, 1,
        [](double u, double v) -> Vec3
        {
            const double angle = 0.5*std::acos(-1.0)*u;
            return {(2 + v)*std::cos(angle), -(2 + v)*std::sin(angle), 0};
        }
    );
    const ShellModel model(mesh, {{"all", 0.1, material(3, 0.3)}}, Constraints(mesh).dofMap());
    const EdgeLoad load(model, "vMin", {0, 0, 5}, constant(1), {1, 0, 0});
    const Vector f = forceOf(load, model, mesh.initialPositions());
    EXPECT_NEAR(resultant(f)[2], 5*std::acos(-1.0), 1e-4);
    // First moment of a quarter circle: radius^2; director force x on directors z
    EXPECT_NEAR(moment(mesh.initialPositions(), f)[1], -5*4 + std::acos(-1.0), 1e-3);
    EXPECT_NE
    (
        errorOf([&] { EdgeLoad(model, "uMinVMin", {0, 0, 1}); }).find("no whole edge"),
        std::string::npos
    );
}

TEST(Loads, tractionAndDeadPressureHaveTheirResultants)
{
    const Patch patch;
    const Vector q = patch.mesh.initialPositions();
    const double area = patch.model.area(q);
    const SurfaceTraction traction(patch.model, "all", {1, -2, 0.5});
    EXPECT_LT
    (
        (resultant(forceOf(traction, patch.model, q)) - area*Vec3(1, -2, 0.5)).norm(), 1e-13
    );

    // A plate: pressure on the upper face pushes down
    const ShellMesh plate = rectangleMesh(2, 1, Vec3::Zero(), {2, 0, 0}, {0, 1, 0});
    const ShellModel model(plate, {{"all", 0.1, material(3, 0.3)}}, Constraints(plate).dofMap());
    const auto pressure = SurfaceTraction::deadPressure(model, "all", 3);
    const Vector f = forceOf(*pressure, model, plate.initialPositions());
    EXPECT_LT((resultant(f) - Vec3(0, 0, -6)).norm(), 1e-13);
    EXPECT_LT((moment(plate.initialPositions(), f) - Vec3(-3, 6, 0)).norm(), 1e-13);
}

TEST(Loads, bodyForceIsMassTimesAcceleration)
{
    const Patch patch;
    const Vector q = patch.mesh.initialPositions();
    const Vec3 g(0.1, 0.2, -9.81);
    const Vector f = forceOf(BodyForce(patch.model, g), patch.model, q);
    const double m = patch.model.totalMass();
    EXPECT_LT((resultant(f) - m*g).norm(), 1e-13*m*g.norm());
    EXPECT_LT
    (
        (moment(q, f) - m*patch.model.centreOfMass(q).cross(g)).norm(), 1e-13*m*g.norm()
    );
}

// At the initial state a follower is the dead pressure
TEST(Loads, followerPressureStartsAsDeadPressure)
{
    const Patch patch;
    const Vector q = patch.mesh.initialPositions();
    const Vector dead =
        forceOf(*SurfaceTraction::deadPressure(patch.model, "all", 3), patch.model, q);
    const Vector follower = forceOf(FollowerPressure(patch.model, "all", 3), patch.model, q);
    EXPECT_LT((dead - follower).norm(), 1e-13*dead.norm());
}

// Uniform pressure on a closed surface has no resultant; on an open one the resultant
// depends on the rim only. Turning the body turns the force.
TEST(Loads, followerPressureFollows)
{
    const Patch patch;
    const FollowerPressure load(patch.model, "all", 3);
    const Eigen::Matrix3d R =
        Eigen::AngleAxisd(1.2, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    const Vector q = randomState(patch.mesh, 0.05, 3);
    Vector turned = q;
    for (Eigen::Index i = 0; i < q.size(); i += dofsPerNode)
    {
        turned.segment<3>(i) = R*q.segment<3>(i);
        turned.segment<3>(i + 3) = R*q.segment<3>(i + 3);
    }
    const Vec3 before = resultant(forceOf(load, patch.model, q));
    const Vec3 after = resultant(forceOf(load, patch.model, turned));
    EXPECT_LT((after - R*before).norm(), 1e-12*before.norm());

    Vector dented = q;
    std::vector<bool> rim(patch.mesh.nNodes(), false);
    for (const char* edge : {"uMin", "uMax", "vMin", "vMax"})
    {
        for (int node : patch.mesh.nodeSet(edge)) rim[node] = true;
    }
    for (int i = 0; i < patch.mesh.nNodes(); ++i)
    {
        if (!rim[i]) dented.segment<3>(7*i) += 0.1*randomVector(3, i);
    }
    EXPECT_GT((dented - q).norm(), 0.1);
    EXPECT_LT
    (
        (resultant(forceOf(load, patch.model, dented)) - before).norm(), 1e-12*before.norm()
    );
}

TEST(Loads, followerTangentIsMinusTheDerivativeOfTheForce)
{
    const Patch patch;
    for (double face : {0.0, 1.0, -1.0})
    {
        const FollowerPressure load(patch.model, "all", 3, linearInTime(1, 1), face);
        ASSERT_TRUE(load.dependsOnPosition());
        const Vector q = randomState(patch.mesh, 0.1, 5);
        const Vector d = randomVector(q.size(), 6);
        const Vector dF = polynomialDerivative<Vector>
        (
            [&](double s) -> Vector { return forceOf(load, patch.model, q + s*d, 0.5); }
        );
        SystemMatrix K = patch.model.makeMatrix();
        load.addTangent(patch.model, q, 0.5, 2, K);
        EXPECT_FALSE(K.symmetric());
        EXPECT_LT((K.matrix()*d + 2*dF).norm(), 1e-11*dF.norm()) << "face " << face;
    }
}

// On a face the pressure does the work of the face's motion
TEST(Loads, pressureOnAFaceUsesItsLeverArm)
{
    const ShellMesh plate = rectangleMesh(1, 1, Vec3::Zero(), {1, 0, 0}, {0, 1, 0});
    const ShellModel model(plate, {{"all", 0.2, material(3, 0.3)}}, Constraints(plate).dofMap());
    const Vector q = plate.initialPositions();
    const Vector f = forceOf(FollowerPressure(model, "all", 3, constant(1), 1), model, q);
    // Thickness change: all directors grow together, the upper face moves by h/2
    Vector swell = Vector::Zero(q.size());
    for (int i = 0; i < plate.nNodes(); ++i) swell[7*i + 5] = 1;
    EXPECT_NEAR(f.dot(swell), -3*0.1, 1e-14);
}

// Peak, arrival and decay by position; the impulse of the positive phase is the formula's
TEST(BlastWave, isFriedlandersHistoryBehindItsFront)
{
    BlastWave blast;
    blast.centre = {0, 0, -1};
    blast.referenceDistance = 2;
    blast.peak = 5e4;
    blast.peakExponent = 1.5;
    blast.arrival = 3e-3;
    blast.speed = 400;
    blast.duration = 2e-3;
    blast.decay = 1.3;
    blast.check();

    const Vec3 near(0, 0, 1);
    EXPECT_EQ(blast.value(near, 2.999e-3), 0);
    EXPECT_NEAR(blast.value(near, 3e-3), 5e4, 1e-6);
    EXPECT_NEAR(blast.value(near, 5e-3), 0, 1e-6);
    EXPECT_LT(blast.value(near, 6e-3), 0) << "the phase of suction";

    // Twice as far: later by 2/400 and lower by 2^1.5
    const Vec3 far(0, 4, -1);
    EXPECT_EQ(blast.value(far, 7.99e-3), 0);
    EXPECT_NEAR(blast.value(far, 8e-3), 5e4/std::pow(2, 1.5), 1e-6);

    double impulse = 0;
    const int n = 2000;
    for (int k = 0; k < n; ++k)
    {
        impulse += blast.value(near, 3e-3 + 2e-3*(k + 0.5)/n)*2e-3/n;
    }
    const double b = 1.3;
    const double exact = 5e4*2e-3*(b - 1 + std::exp(-b))/(b*b);
    EXPECT_NEAR(impulse, exact, 1e-6*exact);

    blast.speed = 0;
    EXPECT_NE(errorOf([&] { blast.check(); }).find("speed"), std::string::npos);
}

// Far from the charge a blast is a follower pressure; near it, only the part of the shell
// that the front has passed is loaded
TEST(BlastWave, loadsWhatTheFrontHasPassed)
{
    const Patch patch;
    const Vector q = randomState(patch.mesh, 0.05, 3);
    auto blast = std::make_shared<BlastWave>();
    blast->peak = 7;
    blast->duration = 1e3;
    blast->speed = 1e9;
    const FollowerPressure byPosition(patch.model, "all", blast, constant(2), 1);
    const double p = 14*(1 - 1e-3)*std::exp(-1e-3);
    const FollowerPressure uniform(patch.model, "all", p, constant(1), 1);
    const Vector expected = forceOf(uniform, patch.model, q, 1);
    EXPECT_LT
    (
        (forceOf(byPosition, patch.model, q, 1) - expected).norm(), 1e-8*expected.norm()
    );

    // The front has come half the way along a plate of area 2
    const ShellMesh mesh = rectangleMesh(8, 1, Vec3::Zero(), {2, 0, 0}, {0, 1, 0});
    const ShellModel plate(mesh, {{"all", 0.1, material(3, 0.3)}}, Constraints(mesh).dofMap());
    auto front = std::make_shared<BlastWave>();
    front->centre = {-1000, 0.5, 0};
    front->referenceDistance = 1000;
    front->peak = 3;
    front->duration = 1e6;
    front->speed = 1;
    const FollowerPressure load(plate, "all", front);
    const Vec3 total = resultant(forceOf(load, plate, mesh.initialPositions(), 1));
    EXPECT_NEAR(total[2], -3, 0.02);
}

// source: table of the fits evaluated by another program; the hemispherical values agree with
// those printed for 10 kg in public data to all their digits
TEST(KingeryBulmash, tableValues)
{
    using Q = BlastTable::Quantity;
    struct Row { BlastTable::Burst burst; double Z, Pso, Iso, Ta, Td, Pr, Ir; };
    const auto air = BlastTable::Burst::freeAir;
    const auto surface = BlastTable::Burst::surface;
    const Row rows[] =
    {
        {air, 0.5, 3884.8, 141.29, 0.15408, 0.31965, 30360, 1454.1},
        {air, 1, 934.86, 174.54, 0.53184, 1.7949, 5005.6, 559.03},
        {air, 2, 194.67, 92.122, 1.944, 1.8459, 645.83, 235.75},
        {air, 3, 81.589, 64.331, 3.9874, 2.6845, 215.5, 147.08},
        {surface, 0.5, 4874.6, 166.11, 0.14328, 0.28128, 39493, 2370.8},
        {surface, 1, 1356.7, 236.43, 0.46751, 1.737, 8144.9, 884.77},
        {surface, 3, 115.67, 92.747, 3.5442, 2.8305, 330.71, 224.29},
    };
    for (const Row& row : rows)
    {
        const BlastTable table(row.burst);
        const auto expectClose = [&](Q q, double value)
        {
            EXPECT_NEAR(table.value(q, row.Z)/value, 1, 1e-4);
        };
        expectClose(Q::incidentPeak, 1e3*row.Pso);
        expectClose(Q::incidentImpulse, row.Iso);
        expectClose(Q::arrival, 1e-3*row.Ta);
        expectClose(Q::duration, 1e-3*row.Td);
        expectClose(Q::reflectedPeak, 1e3*row.Pr);
        expectClose(Q::reflectedImpulse, row.Ir);
    }

    // source: blastFoam's validation data, 10 kg on the ground at 5 m: 202.4 kPa
    const double Z = 5/std::cbrt(10.0);
    EXPECT_NEAR(BlastTable(surface).value(Q::incidentPeak, Z), 202.4e3, 50);
}

TEST(KingeryBulmash, decayGivesTheImpulse)
{
    for (const double b : {-3.0, -0.2, 0.0, 0.004, 0.5, 1.3, 9.0, 200.0})
    {
        // Midpoint sums of (1 - s) exp(-b s)
        double part = 0;
        const int n = 200000;
        for (int i = 0; i < n; ++i)
        {
            const double s = (i + 0.5)/n;
            part += (1 - s)*std::exp(-b*s)/n;
        }
        EXPECT_NEAR(friedlanderDecay(part), b, 1e-6*(1 + b*b)) << b;
    }
    EXPECT_NE(errorOf([] { friedlanderDecay(-1.2); }).find("-1.2"), std::string::npos);
}

// Face on: reflected; edge on and turned away: incident; cos^2 between, both with their impulse
TEST(KingeryBulmash, angleOfIncidence)
{
    KingeryBulmash charge;
    charge.mass = 8;
    charge.position = {0, 0, 6};        // Z = 3
    charge.check();
    const auto look = [&](double angle, double& peak, double& impulse)
    {
        const PressureHistory p =
            charge.at(Vec3::Zero(), {std::sin(angle), 0, std::cos(angle)});
        const double arrival = 2*3.9874e-3;
        EXPECT_EQ(p(arrival*(1 - 1e-4)), 0);
        peak = p(arrival*(1 + 1e-4));
        impulse = 0;
        const int n = 20000;
        const double dt = 2*2.7e-3/n;
        for (int i = 0; i < n; ++i) impulse += p(arrival + (i + 0.5)*dt)*dt;
    };
    double peak, impulse;
    look(0, peak, impulse);
    EXPECT_NEAR(peak/215.5e3, 1, 2e-3);
    EXPECT_NEAR(impulse/(2*147.08), 1, 1e-3);
    look(M_PI/2, peak, impulse);
    EXPECT_NEAR(peak/81.589e3, 1, 2e-3);
    EXPECT_NEAR(impulse/(2*64.331), 1, 1e-3);
    look(M_PI, peak, impulse);
    EXPECT_NEAR(peak/81.589e3, 1, 2e-3);
    look(M_PI/3, peak, impulse);
    EXPECT_NEAR(impulse/(2*(147.08*0.25 + 64.331*(1 + 0.5 - 0.5))), 1, 1e-3);

    // The lower face of a shell that sees the charge from below
    charge.side = -1;
    look(M_PI, peak, impulse);
    EXPECT_NEAR(peak/-215.5e3, 1, 2e-3);

    charge.mass = 1e-6;
    const std::string far = errorOf([&] { charge.at(Vec3::Zero(), {0, 0, 1}); });
    EXPECT_NE(far.find("600"), std::string::npos) << far;
    EXPECT_NE(far.find("40"), std::string::npos) << far;
}

// Sachs: at a tenth of the pressure the same Z is 10^(1/3) times as far, with a tenth of the
// overpressure
TEST(KingeryBulmash, thinAir)
{
    KingeryBulmash charge;
    charge.mass = 1;
    charge.pressure = 10132.5;
    const double r = 3*std::cbrt(10.0);
    charge.position = {0, 0, r};
    EXPECT_NEAR(charge.scaledDistance(Vec3::Zero()), 3, 1e-12);
    const PressureHistory p = charge.at(Vec3::Zero(), {1, 0, 0});
    const double arrival = 3.9874e-3*std::cbrt(10.0);
    EXPECT_EQ(p(arrival*(1 - 1e-4)), 0);
    EXPECT_NEAR(p(arrival*(1 + 1e-4))/8158.9, 1, 2e-3);
}

TEST(Loads, elasticFoundationPullsBackWhatHasMoved)
{
    const Patch patch;
    const Vector q0 = patch.mesh.initialPositions();
    const double k = 3;
    const ElasticFoundation all(patch.model, "all", k);
    const ElasticFoundation along(patch.model, "all", k, {0, 0, 2});

    // A translation: area times stiffness, whatever the shape
    Vector q = q0;
    const Vec3 shift(0.1, -0.2, 0.3);
    for (Eigen::Index i = 0; i < q.size(); i += dofsPerNode) q.segment<3>(i) += shift;
    const double area = patch.model.area(q0);
    EXPECT_EQ(forceOf(all, patch.model, q0).norm(), 0);
    EXPECT_LT((resultant(forceOf(all, patch.model, q)) + k*area*shift).norm(), 1e-13);
    EXPECT_LT
    (
        (resultant(forceOf(along, patch.model, q)) + k*area*Vec3(0, 0, shift[2])).norm(), 1e-13
    );
    EXPECT_NE
    (
        errorOf([&] { ElasticFoundation(patch.model, "all", 0); }).find("positive"),
        std::string::npos
    );
}

TEST(Loads, elasticFoundationHasItsTangent)
{
    const Patch patch;
    const Vector q = randomState(patch.mesh, 0.1, 3);
    const Vector dq = randomVector(q.size(), 4);
    for (const Vec3& d : {Vec3(0, 0, 0), Vec3(1, 2, -1)})
    {
        const ElasticFoundation load(patch.model, "all", 3, d, constant(1.5));
        SystemMatrix K = patch.model.makeMatrix();
        K.setZero();
        load.addTangent(patch.model, q, 0, 0.7, K);
        EXPECT_TRUE(K.symmetric());

        // Linear in q: any difference is the derivative
        const Vector f = 0.7
            *(forceOf(load, patch.model, q) - forceOf(load, patch.model, Vector(q + dq)));
        const Vector reduced = K.matrix()*patch.model.dofs().reduce(dq);
        EXPECT_LT((reduced - patch.model.dofs().reduce(f)).norm(), 1e-12*reduced.norm());
    }
}
