/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// The viscous terms of one simplex, (G60)-(G65), against integrals of the weak
// form at points at random places, gradients by finite differences

#include "simplexViscosity.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

using namespace Foam;
using gasDynamics::PerfectGas;
using gasDynamics::Transport;

namespace
{

const PerfectGas air = PerfectGas::fromGamma(1.4, 287);

double some(std::mt19937& random, const double from, const double to)
{
    return std::uniform_real_distribution<double>(from, to)(random);
}


//- A simplex with velocities and temperatures, the radius being component 0
template<int dim>
struct scene
{
    using Vec = simplexVec<dim>;

    Vec x[dim + 1];
    Vec U[dim + 1];
    double T[dim + 1];
    int curvature;

    scene(std::mt19937& random, const int k)
    :
        curvature(k)
    {
        do
        {
            for (int a = 0; a <= dim; ++a)
            {
                for (int i = 0; i < dim; ++i)
                {
                    x[a][i] = some(random, 0.1, 1);
                    U[a][i] = some(random, -50, 50);
                }
                T[a] = some(random, 250, 400);
            }
        }
        while (simplex::volume<dim>(simplex::edges<dim>(x)) < 0.02);
    }

    simplexTerms<dim> terms() const
    {
        return simplexTerms<dim>(x, curvature, 0);
    }

    //- Barycentric coordinates of a point, by the solution of a linear system
    Eigen::Matrix<double, dim + 1, 1> weights(const Vec& y) const
    {
        Eigen::Matrix<double, dim + 1, dim + 1> A;
        Eigen::Matrix<double, dim + 1, 1> b;
        for (int a = 0; a <= dim; ++a)
        {
            A.col(a) << 1, x[a];
        }
        b << 1, y;
        return A.fullPivLu().solve(b);
    }

    Vec velocity(const Vec& y) const
    {
        const auto N = weights(y);
        Vec u = Vec::Zero();
        for (int a = 0; a <= dim; ++a)
        {
            u += N[a]*U[a];
        }
        return u;
    }

    double temperature(const Vec& y) const
    {
        const auto N = weights(y);
        double t = 0;
        for (int a = 0; a <= dim; ++a)
        {
            t += N[a]*T[a];
        }
        return t;
    }

    //- Integral over the simplex, measure r^curvature, by the midpoints of
    //  its recursive halving along the longest edge
    double integral(const std::function<double(const Vec&)>& f) const
    {
        const std::vector<Vec> corners(x, x + dim + 1);
        return integral(corners, f, dim == 3 ? 12 : 14);
    }

    double integral
    (
        const std::vector<Vec>& corners,
        const std::function<double(const Vec&)>& f,
        const int depth
    ) const
    {
        if (depth == 0)
        {
            Vec centre = Vec::Zero();
            for (const Vec& c : corners)
            {
                centre += c/(dim + 1);
            }
            return
                simplex::volume<dim>(simplex::edges<dim>(corners.data()))
               *std::pow(centre[0], curvature)*f(centre);
        }
        int from = 0, to = 1;
        for (int a = 0; a <= dim; ++a)
        {
            for (int b = a + 1; b <= dim; ++b)
            {
                if
                (
                    (corners[a] - corners[b]).norm()
                  > (corners[from] - corners[to]).norm()
                )
                {
                    from = a;
                    to = b;
                }
            }
        }
        const Vec middle(0.5*(corners[from] + corners[to]));
        std::vector<Vec> one(corners), other(corners);
        one[to] = middle;
        other[from] = middle;
        return integral(one, f, depth - 1) + integral(other, f, depth - 1);
    }
};


//- Gradient of a linear function by differences
template<int dim, class Function>
simplexVec<dim> gradient(const Function& f, const simplexVec<dim>& y)
{
    simplexVec<dim> g;
    for (int i = 0; i < dim; ++i)
    {
        simplexVec<dim> up(y), down(y);
        up[i] += 0.01;
        down[i] -= 0.01;
        g[i] = (f(up) - f(down))/0.02;
    }
    return g;
}


//- The weak form (G60) of a node by its integral; hoop terms with the mean
//  strain (G63) in curved scenes
template<int dim>
struct weakForm
{
    using Vec = simplexVec<dim>;
    using Tensor = Eigen::Matrix<double, dim, dim>;

    const scene<dim>& s;
    double mu, kappa;
    Tensor stress;
    Vec gradT;
    double hoopStress = 0, volume;

    weakForm(const scene<dim>& scene, const Transport& transport)
    :
        s(scene)
    {
        const Vec y(s.x[0]);
        Tensor L;
        for (int i = 0; i < dim; ++i)
        {
            L.row(i) = gradient<dim>
            (
                [&](const Vec& z) { return s.velocity(z)[i]; }, y
            ).transpose();
        }
        gradT = gradient<dim>
        (
            [&](const Vec& z) { return s.temperature(z); }, y
        );
        volume = s.integral([](const Vec&) { return 1.0; });
        const double T =
            s.integral([&](const Vec& z) { return s.temperature(z); })/volume;
        mu = transport.mu(T);
        kappa = mu*transport.kappaOverMu();

        double divergence = L.trace(), hoop = 0;
        if (s.curvature)
        {
            hoop = s.integral
            (
                [&](const Vec& z) { return s.velocity(z)[0]/z[0]; }
            )/volume;
            divergence += s.curvature*hoop;
        }
        stress =
            mu*(L + L.transpose())
          - 2.0/3*mu*divergence*Tensor::Identity();
        hoopStress = 2*mu*hoop - 2.0/3*mu*divergence;
    }

    Vec gradN(const int a) const
    {
        return gradient<dim>
        (
            [&](const Vec& z) { return s.weights(z)[a]; }, s.x[0]
        );
    }

    Vec force(const int a) const
    {
        Vec f = -volume*(stress*gradN(a));
        if (s.curvature)
        {
            f[0] -= hoopStress*s.curvature*s.integral
            (
                [&](const Vec& z) { return s.weights(z)[a]/z[0]; }
            );
        }
        return f;
    }

    double heating(const int a) const
    {
        const Vec g(gradN(a));
        return -s.integral
        (
            [&](const Vec& z)
            {
                return (stress*s.velocity(z) + kappa*gradT).dot(g);
            }
        );
    }
};


template<int dim>
void compare(const int curvature, const Transport& transport)
{
    std::mt19937 random(7 + dim + 10*curvature);
    for (int trial = 0; trial < 3; ++trial)
    {
        const scene<dim> s(random, curvature);
        const simplexTerms<dim> t(s.terms());
        const simplexViscosity<dim> v(t, 0, transport, s.U, s.T);
        const weakForm<dim> exact(s, transport);

        // The midpoint rule's error with 2^12 parts or more in curved scenes
        const double tolerance = curvature ? 2e-4 : 1e-9;
        double forces = 0, powers = 0;
        for (int a = 0; a <= dim; ++a)
        {
            forces = std::max(forces, exact.force(a).norm());
            powers = std::max(powers, std::abs(exact.heating(a)));
        }
        for (int a = 0; a <= dim; ++a)
        {
            EXPECT_LE
            (
                (v.force(t, 0, a) - exact.force(a)).norm(), tolerance*forces
            );
            EXPECT_NEAR
            (
                v.heating(t, a), exact.heating(a), tolerance*powers
            );
        }
    }
}

} // End namespace


TEST(SimplexViscosity, isTheWeakForm)
{
    const Transport constant = Transport::constant(air, 1.8e-3, 0.7);
    const Transport sutherland = Transport::sutherland(air, 1.4e-6, 110, 0);
    for (const Transport& transport : {constant, sutherland})
    {
        compare<1>(0, transport);
        compare<2>(0, transport);
        compare<3>(0, transport);
        compare<1>(1, transport);
        compare<1>(2, transport);
        compare<2>(1, transport);
    }
}


namespace
{

//- Velocity and temperature as functions of place, on a simplex at random
template<int dim, class Motion>
void expectNoForce(const int curvature, const Motion& motion)
{
    std::mt19937 random(3);
    scene<dim> s(random, curvature);
    for (int a = 0; a <= dim; ++a)
    {
        s.U[a] = motion(s.x[a]);
        s.T[a] = 300;
    }
    const simplexTerms<dim> t(s.terms());
    const simplexViscosity<dim> v
    (
        t, 0, Transport::constant(air, 1, 0.7), s.U, s.T
    );
    for (int a = 0; a <= dim; ++a)
    {
        EXPECT_LE(v.force(t, 0, a).norm(), 1e-13);
        EXPECT_LE(std::abs(v.heating(t, a)), 1e-12*300*air.Cp()/0.7);
    }
}

} // End namespace


// A rigid body's motion, and the expansion of all of space, have no stress
TEST(SimplexViscosity, noStressWithoutDistortion)
{
    expectNoForce<2>
    (
        0, [](const simplexVec<2>& x)
        {
            return simplexVec<2>(3 - 2*x[1], 1 + 2*x[0]);
        }
    );
    expectNoForce<3>
    (
        0, [](const simplexVec<3>& x)
        {
            return simplexVec<3>
            (
                Eigen::Vector3d(1, 2, 3).cross(Eigen::Vector3d(x))
              + 5*Eigen::Vector3d(x)
            );
        }
    );
    expectNoForce<1>(2, [](const simplexVec<1>& r) { return r; });
    expectNoForce<2>(1, [](const simplexVec<2>& x) { return x; });
}


namespace
{

template<int dim>
void checkDissipation(const int curvature)
{
    std::mt19937 random(5 + dim);
    const Transport transport = Transport::constant(air, 1, 0.7);
    for (int trial = 0; trial < 20; ++trial)
    {
        const scene<dim> s(random, curvature);
        const simplexTerms<dim> t(s.terms());
        const simplexViscosity<dim> v(t, 0, transport, s.U, s.T);
        double work = 0, energy = 0, scale = 0;
        simplexVec<dim> sum = simplexVec<dim>::Zero();
        for (int a = 0; a <= dim; ++a)
        {
            const simplexVec<dim> f(v.force(t, 0, a));
            work += f.dot(s.U[a]);
            energy += v.heating(t, a);
            scale += std::abs(v.heating(t, a));
            sum += f;
        }
        EXPECT_LT(work, 0);
        EXPECT_LE(std::abs(energy), 1e-12*scale);
        if (!curvature)
        {
            EXPECT_LE(sum.norm(), 1e-10);
        }
    }
}

//- Twice the rates r_v of (G65) are bounds of the decay rates: the eigenvalues
//  of the simplex' matrix over its lumped mass, at density 1
template<int dim>
void checkStableStep(const int curvature)
{
    std::mt19937 random(15 + dim + curvature);
    const Transport transport = Transport::constant(air, 1, 100);
    const double factor = dim > 1 || curvature ? 2 : 4.0/3;
    for (int trial = 0; trial < 20; ++trial)
    {
        scene<dim> s(random, curvature);
        const simplexTerms<dim> t(s.terms());
        constexpr int n = dim*(dim + 1);
        Eigen::Matrix<double, n, n> A;
        double bound = 0;
        for (int column = 0; column < n; ++column)
        {
            for (int a = 0; a <= dim; ++a)
            {
                s.U[a].setZero();
                s.T[a] = 300;
            }
            s.U[column/dim][column % dim] = 1;
            const simplexViscosity<dim> v(t, 0, transport, s.U, s.T);
            for (int a = 0; a <= dim; ++a)
            {
                A.template block<dim, 1>(dim*a, column) =
                    -v.force(t, 0, a)/t.nodal[a];
                bound = std::max
                (
                    bound,
                    2*factor*simplexViscosity<dim>::halfRow(t, a)/t.nodal[a]
                );
            }
        }
        const double greatest =
            Eigen::EigenSolver<Eigen::MatrixXd>(A).eigenvalues().real()
           .maxCoeff();
        EXPECT_LE(greatest, bound*(1 + 1e-12));

        // Sharp on a line, and never far off
        EXPECT_GE(greatest, bound*(dim == 1 && !curvature ? 1 - 1e-12 : 0.1));
    }
}

} // End namespace


TEST(SimplexViscosity, takesWorkAndKeepsEnergyAndMomentum)
{
    checkDissipation<1>(0);
    checkDissipation<2>(0);
    checkDissipation<3>(0);
    checkDissipation<1>(1);
    checkDissipation<1>(2);
    checkDissipation<2>(1);
}


TEST(SimplexViscosity, stableStepIsABound)
{
    checkStableStep<1>(0);
    checkStableStep<2>(0);
    checkStableStep<3>(0);
    checkStableStep<1>(1);
    checkStableStep<1>(2);
    checkStableStep<2>(1);
}
