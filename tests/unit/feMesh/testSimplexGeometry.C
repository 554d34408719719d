/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Shape gradients, volumes and their averages over a step, eqs. (G7)-(G9)

#include "simplexGeometry.H"

#include <gtest/gtest.h>

#include <random>

using namespace Foam;

namespace
{

template<int dim>
struct movingSimplex
{
    simplexVec<dim> x0[dim + 1];
    simplexVec<dim> x1[dim + 1];

    explicit movingSimplex(std::mt19937& random)
    {
        std::uniform_real_distribution<double> some(-1, 1);
        for (int a = 0; a <= dim; ++a)
        {
            for (int i = 0; i < dim; ++i)
            {
                x0[a][i] = some(random);
                x1[a][i] = some(random);
            }
        }
    }

    Eigen::Matrix<double, dim, dim> edgesAt(double t) const
    {
        simplexVec<dim> x[dim + 1];
        for (int a = 0; a <= dim; ++a)
        {
            x[a] = (1 - t)*x0[a] + t*x1[a];
        }
        return simplex::edges<dim>(x);
    }

    simplexAreas<dim> areasAt(double t) const
    {
        const Eigen::Matrix<double, dim, dim> rest =
            Eigen::Matrix<double, dim, dim>::Zero();
        return simplex::areas(edgesAt(t), rest);
    }

    simplexAreas<dim> stepAreas() const
    {
        const Eigen::Matrix<double, dim, dim> delta = edgesAt(1) - edgesAt(0);
        return simplex::areas(edgesAt(0.5), delta);
    }
};


//- sum_a grad(N_a) x_a = I and sum_a grad(N_a) = 0: what makes them the
//  gradients of linear functions
template<int dim>
void areasAreShapeGradients()
{
    std::mt19937 random(1);
    for (int sample = 0; sample < 100; ++sample)
    {
        const movingSimplex<dim> s(random);
        const auto B = s.areasAt(0);
        const double V = simplex::volume<dim>(s.edgesAt(0));
        Eigen::Matrix<double, dim, dim> sum;
        sum.setZero();
        for (int a = 0; a <= dim; ++a)
        {
            sum += s.x0[a]*B.col(a).transpose();
        }
        sum.diagonal().array() -= V;
        EXPECT_LT(sum.norm(), 1e-14);
        EXPECT_LT(B.rowwise().sum().norm(), 1e-14);
    }
}


//- (G8): the averaged areas times the nodes' displacements are the change of
//  volume, exactly
template<int dim>
void volumeChangeIsExact()
{
    std::mt19937 random(2);
    for (int sample = 0; sample < 1000; ++sample)
    {
        const movingSimplex<dim> s(random);
        const auto B = s.stepAreas();
        double swept = 0;
        for (int a = 0; a <= dim; ++a)
        {
            swept += B.col(a).dot(s.x1[a] - s.x0[a]);
        }
        const double change =
            simplex::volume<dim>(s.edgesAt(1))
          - simplex::volume<dim>(s.edgesAt(0));
        EXPECT_NEAR(swept, change, 1e-14);
    }
}


//- The average itself by Gauss' rule, exact for the quadratics in time that
//  the areas of tetrahedra are
template<int dim>
void averageIsThatOfGaussRule()
{
    std::mt19937 random(3);
    const double g = 0.5/std::sqrt(3.0);
    for (int sample = 0; sample < 100; ++sample)
    {
        const movingSimplex<dim> s(random);
        const simplexAreas<dim> gauss =
            0.5*(s.areasAt(0.5 - g) + s.areasAt(0.5 + g));
        EXPECT_LT((s.stepAreas() - gauss).norm(), 1e-14);
    }
}


//- Outward: away from the opposite node; the unit simplex by hand
template<int dim>
void outwardAreasPointOutward()
{
    std::mt19937 random(4);
    for (int sample = 0; sample < 100; ++sample)
    {
        const movingSimplex<dim> s(random);
        const double V = simplex::volume<dim>(s.edgesAt(0));
        const auto B = s.areasAt(0);
        for (int a = 0; a <= dim; ++a)
        {
            // base times height
            const simplexVec<dim> S = simplex::outwardArea<dim>(B, a);
            const simplexVec<dim> toFacet = s.x0[(a + 1) % (dim + 1)] - s.x0[a];
            EXPECT_NEAR(S.dot(toFacet), dim*V, 1e-13);
        }
    }
}

} // End namespace


TEST(SimplexGeometry, areasAreShapeGradients)
{
    areasAreShapeGradients<1>();
    areasAreShapeGradients<2>();
    areasAreShapeGradients<3>();
}


TEST(SimplexGeometry, volumeChangeIsExact)
{
    volumeChangeIsExact<1>();
    volumeChangeIsExact<2>();
    volumeChangeIsExact<3>();
}


TEST(SimplexGeometry, averageIsThatOfGaussRule)
{
    averageIsThatOfGaussRule<1>();
    averageIsThatOfGaussRule<2>();
    averageIsThatOfGaussRule<3>();
}


TEST(SimplexGeometry, outwardAreasPointOutward)
{
    outwardAreasPointOutward<1>();
    outwardAreasPointOutward<2>();
    outwardAreasPointOutward<3>();
}


TEST(SimplexGeometry, unitSimplices)
{
    EXPECT_NEAR(simplex::volume<2>(Eigen::Matrix2d::Identity()), 1./2, 1e-15);
    EXPECT_NEAR(simplex::volume<3>(Eigen::Matrix3d::Identity()), 1./6, 1e-15);

    const Eigen::Matrix3d rest = Eigen::Matrix3d::Zero();
    const auto B = simplex::areas(Eigen::Matrix3d::Identity(), rest);
    const Eigen::Vector3d slanted = simplex::outwardArea<3>(B, 0);
    EXPECT_LT((slanted - Eigen::Vector3d(0.5, 0.5, 0.5)).norm(), 1e-15);
    const Eigen::Vector3d bottom = simplex::outwardArea<3>(B, 3);
    EXPECT_LT((bottom - Eigen::Vector3d(0, 0, -0.5)).norm(), 1e-15);
}
