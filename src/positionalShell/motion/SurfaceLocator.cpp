// SPDX-License-Identifier: GPL-3.0-or-later

#include "SurfaceLocator.hpp"
#include "ElementProjection.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace positionalShell
{

namespace
{

//- Bernstein coefficients of a cubic triangle from its nodal values: the surface
//  lies in their convex hull, which the nodes do not bound
const Eigen::Matrix<double, nodesPerElement, nodesPerElement>& toBernstein()
{
    using Matrix = Eigen::Matrix<double, nodesPerElement, nodesPerElement>;
    static const Matrix transform = []
    {
        Matrix values;
        const auto& points = CubicTriangle::nodePoints();
        for (int i = 0; i < nodesPerElement; ++i)
        {
            const double u = points[i][0];
            const double v = points[i][1];
            const double w = 1 - u - v;
            values.row(i) <<
                u*u*u, v*v*v, w*w*w,
                3*u*u*v, 3*u*u*w, 3*v*v*u, 3*v*v*w, 3*w*w*u, 3*w*w*v,
                6*u*v*w;
        }
        return Matrix(values.inverse());
    }();
    return transform;
}

} // namespace

SurfaceLocator::SurfaceLocator(const ShellModel& model) : model_(model)
{
    const ShellMesh& mesh = model.mesh();
    std::vector<int> elements(mesh.nElements());
    for (int e = 0; e < mesh.nElements(); ++e)
    {
        elements[e] = e;
        Eigen::Matrix<double, nodesPerElement, 3> X;
        for (int j = 0; j < nodesPerElement; ++j)
        {
            X.row(j) = mesh.nodes()[mesh.triangle(e)[j]].transpose();
        }
        const Eigen::Matrix<double, nodesPerElement, 3> hull = toBernstein()*X;
        Sphere sphere;
        sphere.centre = hull.colwise().mean().transpose();
        sphere.radius =
            (hull.rowwise() - sphere.centre.transpose()).rowwise().norm()
           .maxCoeff();
        spheres_.push_back(sphere);
    }
    tree_.reserve(2*elements.size());
    build(elements, 0, mesh.nElements());
}

int SurfaceLocator::build(std::vector<int>& elements, int begin, int end)
{
    Vec3 low = spheres_[elements[begin]].centre;
    Vec3 high = low;
    for (int k = begin; k < end; ++k)
    {
        low = low.cwiseMin(spheres_[elements[k]].centre);
        high = high.cwiseMax(spheres_[elements[k]].centre);
    }
    TreeNode node;
    node.sphere.centre = 0.5*(low + high);
    node.sphere.radius = 0;
    for (int k = begin; k < end; ++k)
    {
        const Sphere& own = spheres_[elements[k]];
        node.sphere.radius = std::max
        (
            node.sphere.radius,
            (own.centre - node.sphere.centre).norm() + own.radius
        );
    }

    const int index = int(tree_.size());
    tree_.push_back(node);
    if (end - begin == 1)
    {
        tree_[index].element = elements[begin];
        return index;
    }

    int axis = 0;
    (high - low).maxCoeff(&axis);
    const int middle = (begin + end)/2;
    std::nth_element
    (
        elements.begin() + begin,
        elements.begin() + middle,
        elements.begin() + end,
        [&](int a, int b)
        {
            return spheres_[a].centre[axis] < spheres_[b].centre[axis];
        }
    );
    const int left = build(elements, begin, middle);
    const int right = build(elements, middle, end);
    tree_[index].left = left;
    tree_[index].right = right;
    return index;
}

Projection SurfaceLocator::project(const Vec3& X, int element) const
{
    return ElementProjection(model_, element).project(X);
}

Projection SurfaceLocator::locate(const Vec3& X, int hint) const
{
    // Distances within this are the same: the lower element number wins, so that
    // the order of the search does not matter
    const double same = 1e-12*model_.mesh().lengthScale();

    Projection best;
    best.distance = std::numeric_limits<double>::max();
    const auto take = [&](int element)
    {
        const Projection found = project(X, element);
        const double gain = best.distance - found.distance;
        const bool first = best.point.element < 0;
        const bool nearer = gain > same;
        const bool lower =
            std::abs(gain) <= same && element < best.point.element;
        if (first || nearer || lower) best = found;
    };
    if (hint >= 0 && hint < model_.mesh().nElements()) take(hint);

    const auto bound = [&](int node)
    {
        const Sphere& s = tree_[node].sphere;
        return (X - s.centre).norm() - s.radius;
    };
    std::vector<int> stack{0};
    while (!stack.empty())
    {
        const int index = stack.back();
        stack.pop_back();
        if (bound(index) > best.distance + same) continue;
        const TreeNode& node = tree_[index];
        if (node.element >= 0)
        {
            if (node.element != hint) take(node.element);
            continue;
        }
        const bool leftFirst = bound(node.left) < bound(node.right);
        stack.push_back(leftFirst ? node.right : node.left);
        stack.push_back(leftFirst ? node.left : node.right);
    }
    return best;
}

} // namespace positionalShell
