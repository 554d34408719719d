// SPDX-License-Identifier: GPL-3.0-or-later

#include "ShellMesh.hpp"
#include "CubicTriangle.hpp"
#include "ShellMeshChecks.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>

namespace positionalShell
{

namespace
{

std::vector<int> sortedUnique(std::vector<int> members)
{
    std::sort(members.begin(), members.end());
    members.erase
    (
        std::unique(members.begin(), members.end()), members.end()
    );
    return members;
}

std::vector<int> range(int n)
{
    std::vector<int> all(n);
    std::iota(all.begin(), all.end(), 0);
    return all;
}

void checkMembers
(
    const std::string& kind,
    const std::string& name,
    const std::vector<int>& members,
    int n
)
{
    for (int i : members)
    {
        if (i < 0 || i >= n)
        {
            throw std::invalid_argument
            (
                "shell mesh: " + kind + " set " + name + " holds "
              + std::to_string(i) + ", but there are " + std::to_string(n)
              + " " + kind + "s, counted from 0"
            );
        }
    }
}

const std::vector<int>& find
(
    const NamedSets& sets,
    const std::string& kind,
    const std::string& name
)
{
    const auto found = sets.find(name);
    if (found != sets.end()) return found->second;

    std::string valid;
    for (const auto& [other, members] : sets) valid += " " + other;
    throw std::invalid_argument
    (
        "shell mesh: no " + kind + " set " + name + "; there are:" + valid
    );
}

} // namespace

ShellMesh::ShellMesh
(
    std::vector<Vec3> nodes,
    std::vector<Triangle> triangles,
    NamedSets nodeSets,
    NamedSets elementSets,
    std::vector<Vec3> directors,
    const MeshNames& names
)
:
    nodes_(std::move(nodes)),
    triangles_(std::move(triangles))
{
    if (triangles_.empty())
    {
        throw std::invalid_argument("shell mesh: no triangles");
    }
    meshChecks::indices(nodes_, triangles_, names);
    meshChecks::shapes(nodes_, triangles_, names);
    meshChecks::neighbours(triangles_, names);

    for (auto& [name, members] : nodeSets) addNodeSet(name, members);
    for (auto& [name, members] : elementSets) addElementSet(name, members);
    addNodeSet("all", range(nNodes()));
    addElementSet("all", range(nElements()));

    Vec3 low = nodes_.front();
    Vec3 high = low;
    for (const Vec3& x : nodes_)
    {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    lengthScale_ = (high - low).norm();

    setDirectors(std::move(directors), names);
}

const std::vector<int>& ShellMesh::nodeSet(const std::string& name) const
{
    return find(nodeSets_, "node", name);
}

const std::vector<int>& ShellMesh::elementSet(const std::string& name) const
{
    return find(elementSets_, "element", name);
}

bool ShellMesh::hasNodeSet(const std::string& name) const
{
    return nodeSets_.count(name) > 0;
}

bool ShellMesh::hasElementSet(const std::string& name) const
{
    return elementSets_.count(name) > 0;
}

void ShellMesh::addNodeSet(const std::string& name, std::vector<int> nodes)
{
    checkMembers("node", name, nodes, nNodes());
    nodeSets_[name] = sortedUnique(std::move(nodes));
}

void ShellMesh::addElementSet
(
    const std::string& name,
    std::vector<int> elements
)
{
    checkMembers("element", name, elements, nElements());
    elementSets_[name] = sortedUnique(std::move(elements));
}

std::vector<CubicEdge> ShellMesh::edgesOf(const std::string& nodeSet) const
{
    const std::vector<int>& members = this->nodeSet(nodeSet);
    std::vector<bool> inside(nodes_.size(), false);
    for (int node : members) inside[node] = true;

    std::vector<CubicEdge> edges;
    std::set<std::pair<int, int>> seen;
    for (const Triangle& triangle : triangles_)
    {
        for (const auto& places : CubicTriangle::edgeNodes())
        {
            CubicEdge edge;
            bool whole = true;
            for (int i = 0; i < 4; ++i)
            {
                edge[i] = triangle[places[i]];
                whole = whole && inside[edge[i]];
            }
            const auto ends = std::minmax(edge[0], edge[3]);
            if (whole && seen.insert(ends).second) edges.push_back(edge);
        }
    }
    return edges;
}

Vector ShellMesh::initialPositions() const
{
    Vector q = Vector::Zero(dofsPerNode*nNodes());
    for (int i = 0; i < nNodes(); ++i)
    {
        q.segment<3>(fullIndex(i, Component::x)) = nodes_[i];
        q.segment<3>(fullIndex(i, Component::gx)) = directors_[i];
    }
    return q;
}

int ShellMesh::nearestNode(const Vec3& point) const
{
    int nearest = -1;
    double least = std::numeric_limits<double>::max();
    for (int i = 0; i < nNodes(); ++i)
    {
        const double d = (nodes_[i] - point).squaredNorm();
        if (d < least)
        {
            least = d;
            nearest = i;
        }
    }
    return nearest;
}

void ShellMesh::setDirectors
(
    std::vector<Vec3> given,
    const MeshNames& names
)
{
    const bool computed = given.empty();
    if (!computed && given.size() != nodes_.size())
    {
        throw std::invalid_argument
        (
            "shell mesh: " + std::to_string(given.size()) + " directors for "
          + std::to_string(nodes_.size()) + " nodes"
        );
    }

    directors_ = computed
        ? std::vector<Vec3>(nodes_.size(), Vec3::Zero())
        : std::move(given);
    if (!computed)
    {
        for (Vec3& d : directors_) d.normalize();
        meshChecks::directors(nodes_, triangles_, directors_, names);
        return;
    }

    for (const Triangle& triangle : triangles_)
    {
        for (int j = 0; j < nodesPerElement; ++j)
        {
            directors_[triangle[j]] +=
                meshChecks::nodalNormal(nodes_, triangle, j).normalized();
        }
    }
    for (Vec3& d : directors_) d.normalize();
    meshChecks::directors(nodes_, triangles_, directors_, names);
}

} // namespace positionalShell
