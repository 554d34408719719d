// SPDX-License-Identifier: GPL-3.0-or-later

#include "ResultPoints.hpp"
#include "ShellMeshChecks.hpp"

#include <cmath>
#include <stdexcept>

namespace positionalShell
{

ResultPoints::ResultPoints(const ShellModel& model, double foldAngle)
{
    if (!(foldAngle > 0 && foldAngle < std::acos(-1.0)))
    {
        throw std::invalid_argument
        (
            "results: the fold angle is " + std::to_string(foldAngle)
          + " rad; it must be between 0 and pi"
        );
    }

    const ShellMesh& mesh = model.mesh();
    std::vector<std::vector<Corner>> corners(mesh.nNodes());
    for (int e = 0; e < mesh.nElements(); ++e)
    {
        const Triangle& triangle = mesh.triangle(e);
        for (int j = 0; j < nodesPerElement; ++j)
        {
            const Vec3 normal =
                meshChecks::nodalNormal(mesh.nodes(), triangle, j);
            corners[triangle[j]].push_back({e, j, normal.normalized()});
        }
    }

    points_.resize(mesh.nElements());
    for (int i = 0; i < mesh.nNodes(); ++i) node_.push_back(i);
    nElements_.assign(node_.size(), 0);
    for (int i = 0; i < mesh.nNodes(); ++i)
    {
        addNode(model, std::cos(foldAngle), i, corners[i]);
    }
}

void ResultPoints::addNode
(
    const ShellModel& model,
    double leastCosine,
    int node,
    const std::vector<Corner>& corners
)
{
    std::vector<bool> taken(corners.size(), false);
    for (std::size_t first = 0; first < corners.size(); ++first)
    {
        if (taken[first]) continue;
        int point = node;
        if (first > 0)
        {
            point = size();
            node_.push_back(node);
            nElements_.push_back(0);
        }

        // All that is reached from the first
        std::vector<std::size_t> part{first};
        taken[first] = true;
        for (std::size_t k = 0; k < part.size(); ++k)
        {
            const Corner& here = corners[part[k]];
            points_[here.element][here.place] = point;
            ++nElements_[point];
            for (std::size_t l = 0; l < corners.size(); ++l)
            {
                const Corner& other = corners[l];
                const bool together =
                    &model.section(other.element) == &model.section(here.element)
                 && other.normal.dot(here.normal) > leastCosine;
                if (taken[l] || !together) continue;
                taken[l] = true;
                part.push_back(l);
            }
        }
    }
}

} // namespace positionalShell
