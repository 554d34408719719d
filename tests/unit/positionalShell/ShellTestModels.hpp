// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small shells and random states that the tests share.

#ifndef ShellTestModels_hpp
#define ShellTestModels_hpp

#include "Constraints.hpp"
#include "SaintVenantKirchhoff.hpp"
#include "ShellModel.hpp"
#include "StructuredMesh.hpp"

#include <functional>
#include <memory>
#include <random>

namespace shellTest
{

using namespace positionalShell;

inline MaterialPtr material(double E, double nu, double rho = 1)
{
    return std::make_shared<SaintVenantKirchhoff>(E, nu, rho);
}

//- Doubly curved patch of 2 x 1 quadrilaterals, oblique in space
inline ShellMesh curvedPatch()
{
    return structuredMesh
    (
        2, 1,
        [](double u, double v) -> Vec3
        {
            return {u + 0.2*v, 0.6*v + 0.1*u*v, 0.3*u*u - 0.2*v*v + 0.1*u};
        }
    );
}

//- Strip along x, width along y, normal z
inline ShellMesh strip(int n, double length, double width = 1)
{
    return rectangleMesh(n, 1, Vec3::Zero(), {length, 0, 0}, {0, width, 0});
}

inline Vector randomVector(Eigen::Index n, int seed)
{
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal(0, 1);
    Vector v(n);
    for (double& x : v) x = normal(generator);
    return v;
}

//- State of finite strain and rotation, far from special
inline Vector randomState(const ShellMesh& mesh, double size, int seed)
{
    const Vector q = mesh.initialPositions();
    return q + size*randomVector(q.size(), seed);
}

//- Derivative at s = 0 of a function that is a polynomial of degree at most 12 in
//  s: the central difference of order 12 is exact for it, so that the step can be
//  large and what remains is round-off (about 1e-15 times a few over the step)
template<class Value>
Value polynomialDerivative
(
    const std::function<Value(double)>& f,
    double step = 0.05
)
{
    // (n!)^2/(k (n-k)! (n+k)!) with alternating sign, n = 6
    constexpr double weights[6] =
    {
        6.0/7, -15.0/56, 5.0/63, -1.0/56, 1.0/385, -1.0/5544
    };
    Value sum = weights[0]*(f(step) - f(-step));
    for (int k = 2; k <= 6; ++k)
    {
        sum += weights[k - 1]*(f(k*step) - f(-k*step));
    }
    return sum/step;
}

//- Material with cubic energy, to go through the path of general materials:
//  W = E:C:E/2 + c (tr E)^3/6, not meant for use
class CubicMaterial : public Material
{
public:

    CubicMaterial(double E, double nu, double cubic)
    :
        Material(1),
        linear_(E, nu, 1),
        cubic_(cubic)
    {}

    std::string name() const override { return "CubicMaterial"; }

    double energyDensity(const Strain& E) const override
    {
        const double trace = E.head<3>().sum();
        return linear_.energyDensity(E) + cubic_*trace*trace*trace/6;
    }

    Stress stress(const Strain& E) const override
    {
        const double trace = E.head<3>().sum();
        Stress S = linear_.stress(E);
        S.head<3>().array() += 0.5*cubic_*trace*trace;
        return S;
    }

    ElasticMatrix tangent(const Strain& E) const override
    {
        ElasticMatrix C = linear_.tangent(E);
        C.topLeftCorner<3, 3>().array() += cubic_*E.head<3>().sum();
        return C;
    }

private:

    SaintVenantKirchhoff linear_;
    double cubic_;
};

//- The message of the std::invalid_argument that a call throws, or "no error"
inline std::string errorOf(const std::function<void()>& call)
{
    try
    {
        call();
    }
    catch (const std::invalid_argument& error)
    {
        return error.what();
    }
    return "no error";
}

} // namespace shellTest

#endif
