// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shells that are joined at an angle, and several shells in one model.

#include "LinearProblems.hpp"
#include "Orthotropic.hpp"

#include <gtest/gtest.h>

using namespace shellTest;

namespace
{

//- Frame of a post and an arm at a right angle, both of length 1, width 0.2, n
//  quadrilaterals each: vertical displacement of the arm's end under a force there, over
//  that of beams with axial and shear strain
double frame(int n, double h, ElementForm form)
{
    const double E = 1e6;
    const ShellMesh mesh = structuredMesh
    (
        2*n, 1,
        [](double u, double v) -> Vec3
        {
            return u <= 0.5 ? Vec3(0, 0.2*v, 2*u) : Vec3(2*u - 1, 0.2*v, 1);
        }
    );
    const DofMap dofs = Constraints(mesh).clamped("uMin").dofMap();
    const ShellModel model(mesh, {{"all", h, material(E, 0)}}, dofs, {}, form);
    Vector mean = Vector::Zero(dofs.nFull());
    const double weights[4] = {1.0/8, 3.0/8, 3.0/8, 1.0/8};
    for (int k = 0; k < 4; ++k) mean[7*mesh.nodeSet("uMax")[k] + 2] = weights[k];

    // The arm bends, the post bends under the moment of the force and is stretched
    const double A = 0.2*h;
    const double EI = E*A*h*h/12;
    const double beams = 1/(3*EI) + 1/EI + 1/(E*A) + 1/(0.5*E*A);
    return mean.dot(linearSolution(model, mean))/beams;
}

//- Two strips side by side that do not touch, the second with another section
ShellMesh twoStrips()
{
    const ShellMesh one = strip(3, 3);
    std::vector<Vec3> nodes = one.nodes();
    std::vector<Triangle> triangles = one.triangles();
    const int n = one.nNodes();
    const int m = one.nElements();
    for (int i = 0; i < n; ++i) nodes.push_back(one.nodes()[i] + Vec3(0, 5, 1));
    std::vector<int> first;
    std::vector<int> second;
    for (int e = 0; e < m; ++e)
    {
        Triangle t = one.triangle(e);
        for (int& node : t) node += n;
        triangles.push_back(t);
        first.push_back(e);
        second.push_back(m + e);
    }
    std::vector<int> roots = one.nodeSet("uMin");
    for (int node : one.nodeSet("uMin")) roots.push_back(node + n);
    return ShellMesh
    (
        nodes, triangles, {{"roots", roots}}, {{"first", first}, {"second", second}}
    );
}

} // namespace

// The elements of both sides share the director of the fold, which is normal to neither:
// a layer one element wide has fibres of the wrong direction. The error falls with the
// element size, at every thickness.
TEST(ShellGroups, aFoldHasAnErrorOfTheElementSize)
{
    for (double h : {0.01, 0.001})
    {
        const double coarse = frame(4, h, ElementForm::assumedStrain) - 1;
        const double fine = frame(8, h, ElementForm::assumedStrain) - 1;
        EXPECT_LT(std::abs(coarse), 0.03) << h;
        EXPECT_LT(std::abs(fine), 0.02) << h;
        EXPECT_LT(std::abs(fine), 0.65*std::abs(coarse)) << h;
    }
}

// Each shell moves as it would alone, with its thickness, material and direction
TEST(ShellGroups, shellsThatDoNotTouchAreIndependent)
{
    const MaterialPtr steel = material(200, 0.3);
    const OrthotropicConstants lamina{40, 10, 8, 0.25, 0.3, 0.2, 5, 3, 4};
    const Section thick{"first", 0.2, steel};
    Section laminate{"second", 0.1, std::make_shared<Orthotropic>(lamina, 1), {1, 1, 0}};

    const ShellMesh both = twoStrips();
    const DofMap dofs = Constraints(both).clamped("roots").dofMap();
    const ShellModel model(both, {thick, laminate}, dofs, {}, ElementForm::assumedStrain);
    const Vector u = linearSolution(model, uniformLoad(model, {0, 0, 1e-3}));

    const ShellMesh one = strip(3, 3);
    const DofMap own = Constraints(one).clamped("uMin").dofMap();
    const int n = 7*one.nNodes();
    Section alone[2] = {thick, laminate};
    for (int k = 0; k < 2; ++k)
    {
        alone[k].elementSet = "all";
        const ShellModel single(one, {alone[k]}, own, {}, ElementForm::assumedStrain);
        const Vector v = linearSolution(single, uniformLoad(single, {0, 0, 1e-3}));
        EXPECT_GT(v.norm(), 0);
        EXPECT_LT((u.segment(k*n, n) - v).norm(), 1e-10*v.norm()) << k;
    }
}
