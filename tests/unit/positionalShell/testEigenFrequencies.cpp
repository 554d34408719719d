// SPDX-License-Identifier: GPL-3.0-or-later

#include "EigenFrequencies.hpp"
#include "ShellTestModels.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace shellTest;

namespace
{

const double pi = std::acos(-1.0);

//- Euler-Bernoulli: f = lambda^2/(2 pi L^2) sqrt(E h^2/(12 rho)), clamped and free
double beamFrequency(double lambda, double L, double h, double E, double rho)
{
    return lambda*lambda/(2*pi*L*L)*std::sqrt(E*h*h/(12*rho));
}

constexpr double lambda1 = 1.8751040687;
constexpr double lambda2 = 4.6940911330;

} // namespace

// Slender (L/h = 100): shear and rotary inertia lower the second frequency by 4e-4
TEST(EigenFrequencies, clampedStripAgainstBeamTheory)
{
    for (double nu : {0.0, 0.3})
    {
        const double L = 10;
        const double h = 0.1;
        const ShellMesh mesh = strip(6, L);
        const ShellModel model
        (
            mesh, {{"all", h, material(1.2e6, nu, 0.01)}},
            Constraints(mesh).clamped("uMin").planeStrainStrip(Axis::y).dofMap()
        );
        const EigenModes modes = lowestModes(model, mesh.initialPositions(), 2);
        ASSERT_TRUE(modes.converged);
        const double E = 1.2e6/(1 - nu*nu);
        EXPECT_NEAR(modes.frequency[0]/beamFrequency(lambda1, L, h, E, 0.01), 1, 0.005);
        EXPECT_NEAR(modes.frequency[1]/beamFrequency(lambda2, L, h, E, 0.01), 1, 0.005);
    }
}

// K phi = omega^2 M phi, orthonormal in M, checked with the matrices themselves
TEST(EigenFrequencies, modesSolveTheirEquation)
{
    const ShellMesh mesh = rectangleMesh(3, 2, Vec3::Zero(), {1, 0, 0}, {0, 0.7, 0});
    const ShellModel model
    (
        mesh, {{"all", 0.02, material(100, 0.3, 2)}}, Constraints(mesh).clamped("uMin").dofMap()
    );
    EigenOptions options;
    options.tolerance = 1e-13;
    const EigenModes modes = lowestModes(model, mesh.initialPositions(), 5, options);
    ASSERT_TRUE(modes.converged);
    const SparseMatrix K = model.tangent(mesh.initialPositions());
    for (int k = 0; k < 5; ++k)
    {
        Vector phi(model.dofs().nEquations());
        for (int e = 0; e < phi.size(); ++e) phi[e] = modes.mode(model.dofs().firstUnknown(e), k);
        const Vector Mphi = model.massMatrix()*phi;
        EXPECT_LT((K*phi - modes.eigenvalue[k]*Mphi).norm(), 1e-5*modes.eigenvalue[k]*Mphi.norm());
        EXPECT_NEAR(phi.dot(Mphi), 1, 1e-10);
        EXPECT_NEAR(modes.frequency[k], std::sqrt(modes.eigenvalue[k])/(2*pi), 1e-12);
        EXPECT_GE(modes.eigenvalue[k], k > 0 ? modes.eigenvalue[k - 1] : 0);
    }
}

// A free plate: six zero frequencies with a negative shift, then the first bending one.
// source: converged Ritz value of the free square plate, nu = 0.3: lambda = 13.468
TEST(EigenFrequencies, freePlateWithAShift)
{
    const double h = 0.01;
    const double E = 100;
    const double rho = 2;
    const ShellMesh mesh = rectangleMesh(6, 6, Vec3::Zero(), {1, 0, 0}, {0, 1, 0});
    const ShellModel model
    (
        mesh, {{"all", h, material(E, 0.3, rho)}}, Constraints(mesh).dofMap()
    );
    const double D = E*h*h*h/(12*(1 - 0.09));
    const double omega = 13.468*std::sqrt(D/(rho*h));
    EigenOptions options;
    options.shift = -0.1*omega*omega;
    const EigenModes modes = lowestModes(model, mesh.initialPositions(), 7, options);
    ASSERT_TRUE(modes.converged);
    for (int k = 0; k < 6; ++k) EXPECT_LT(modes.frequency[k], 1e-3*omega/(2*pi));
    EXPECT_NEAR(modes.frequency[6], omega/(2*pi), 0.005*omega/(2*pi));
}

// A shift close below the first eigenvalue makes the iteration faster, one as far below
// zero does not; both find the same frequency
TEST(EigenFrequencies, theShiftIsSubtracted)
{
    const ShellMesh mesh = rectangleMesh(2, 2, Vec3::Zero(), {1, 0, 0}, {0, 1, 0});
    const ShellModel model
    (
        mesh, {{"all", 0.05, material(100, 0.3)}}, Constraints(mesh).clamped("uMin").dofMap()
    );
    const Vector q = mesh.initialPositions();
    EigenOptions options;
    options.tolerance = 1e-12;
    const double first = lowestModes(model, q, 1, options).eigenvalue[0];
    options.shift = 0.95*first;
    const EigenModes near = lowestModes(model, q, 1, options);
    options.shift = -0.95*first;
    const EigenModes away = lowestModes(model, q, 1, options);
    ASSERT_TRUE(near.converged && away.converged);
    EXPECT_LT(near.iterations, away.iterations);
    EXPECT_NEAR(near.eigenvalue[0], first, 1e-8*first);
    EXPECT_NEAR(away.eigenvalue[0], first, 1e-8*first);
}

TEST(EigenFrequencies, errors)
{
    const ShellMesh mesh = strip(1, 1);
    const ShellModel model
    (
        mesh, {{"all", 0.1, material(1, 0)}}, Constraints(mesh).clamped("uMin").dofMap()
    );
    // 12 nodes not clamped, six unknowns with inertia each
    EXPECT_NE
    (
        errorOf([&] { lowestModes(model, mesh.initialPositions(), 73); })
       .find("between 1 and 72"),
        std::string::npos
    );
    EXPECT_NE
    (
        errorOf([&] { lowestModes(model, mesh.initialPositions(), 0); }).find("0 modes"),
        std::string::npos
    );
}
