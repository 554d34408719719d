// SPDX-License-Identifier: GPL-3.0-or-later

#include "Constraints.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace positionalShell
{

namespace
{

constexpr std::array<Component, dofsPerNode> allComponents
{
    Component::x, Component::y, Component::z,
    Component::gx, Component::gy, Component::gz,
    Component::a
};

Component positionAlong(Axis axis)
{
    return static_cast<Component>(static_cast<int>(axis));
}

Component directorAlong(Axis axis)
{
    return static_cast<Component>(3 + static_cast<int>(axis));
}

} // namespace

Constraints::Constraints(const ShellMesh& mesh)
:
    mesh_(mesh),
    motion_(dofsPerNode*mesh.nNodes()),
    parent_(dofsPerNode*mesh.nNodes())
{
    std::iota(parent_.begin(), parent_.end(), 0);
}

Constraints& Constraints::clamped(const std::string& nodeSet)
{
    return fixed
    (
        nodeSet,
        {
            Component::x, Component::y, Component::z,
            Component::gx, Component::gy, Component::gz
        }
    );
}

Constraints& Constraints::hinged(const std::string& nodeSet)
{
    return fixed(nodeSet, {Component::x, Component::y, Component::z});
}

Constraints& Constraints::symmetryPlane
(
    const std::string& nodeSet,
    Axis normal
)
{
    return fixed(nodeSet, {positionAlong(normal), directorAlong(normal)});
}

Constraints& Constraints::fixed
(
    const std::string& nodeSet,
    const std::vector<Component>& components
)
{
    for (int node : mesh_.nodeSet(nodeSet))
    {
        for (Component c : components) set(node, c, nullptr);
    }
    return *this;
}

Constraints& Constraints::prescribed
(
    const std::string& nodeSet,
    Component component,
    TimeFunctionPtr displacement
)
{
    if (!displacement)
    {
        throw std::invalid_argument
        (
            "constraint on node set " + nodeSet + ": no function of time for "
          + componentName(component)
        );
    }
    for (int node : mesh_.nodeSet(nodeSet)) set(node, component, displacement);
    return *this;
}

Constraints& Constraints::tied(const std::string& nodeSet, Component component)
{
    const std::vector<int>& nodes = mesh_.nodeSet(nodeSet);
    for (int node : nodes)
    {
        share(fullIndex(nodes.front(), component), fullIndex(node, component));
    }
    return *this;
}

Constraints& Constraints::planeStrainStrip(Axis direction)
{
    // Two nodes are at the same place of the plane within this distance: far
    // above the round-off of coordinates, far below a node spacing
    const double tolerance = 1e-8*mesh_.lengthScale();
    const int out = static_cast<int>(direction);
    const int u = (out + 1)%3;
    const int v = (out + 2)%3;
    const std::vector<Vec3>& X = mesh_.nodes();

    // Sorted along a skew line, so that only nodes at one place have equal keys
    // in usual meshes, also when the strip lies along an axis
    const auto key = [&](int node) { return X[node][u] + 0.61803*X[node][v]; };
    const auto samePlace = [&](int a, int b)
    {
        return std::abs(X[a][u] - X[b][u]) <= tolerance
            && std::abs(X[a][v] - X[b][v]) <= tolerance;
    };
    std::vector<int> order(mesh_.nNodes());
    std::iota(order.begin(), order.end(), 0);
    std::sort
    (
        order.begin(), order.end(),
        [&](int a, int b) { return key(a) < key(b); }
    );

    std::vector<bool> partner(order.size(), false);
    for (std::size_t i = 0; i < order.size(); ++i)
    {
        const int node = order[i];
        set(node, positionAlong(direction), nullptr);
        set(node, directorAlong(direction), nullptr);
        for
        (
            std::size_t k = i + 1;
            k < order.size() && key(order[k]) - key(node) <= 2*tolerance;
            ++k
        )
        {
            if (!samePlace(node, order[k])) continue;
            partner[node] = partner[order[k]] = true;
            for (Component c : allComponents)
            {
                if (c == positionAlong(direction)) continue;
                if (c == directorAlong(direction)) continue;
                share(fullIndex(node, c), fullIndex(order[k], c));
            }
        }
    }
    for (int node = 0; node < mesh_.nNodes(); ++node)
    {
        if (!partner[node])
        {
            throw std::invalid_argument
            (
                "plane strain strip: node " + std::to_string(node)
              + " has no other node on its line along the strip's direction"
            );
        }
    }
    return *this;
}

Constraints& Constraints::rigidTie
(
    const std::string& nodeSet,
    const Vec3& point
)
{
    ties_.emplace_back(mesh_, nodeSet, point);
    return *this;
}

Constraints& Constraints::rigidMotion
(
    const std::string& nodeSet,
    const RigidMotion& motion
)
{
    for (int node : mesh_.nodeSet(nodeSet))
    {
        const Vec3 arm = mesh_.nodes()[node] - motion.point;
        for (int c = 0; c < 3; ++c)
        {
            set
            (
                node, static_cast<Component>(c), motion.ofPosition(arm, c)
            );
            set
            (
                node, static_cast<Component>(3 + c),
                motion.ofDirector(mesh_.directors()[node], c)
            );
        }
    }
    return *this;
}

//- The unknowns of a tie are its own
void Constraints::checkTies() const
{
    std::vector<int> members(motion_.size(), 0);
    for (std::size_t i = 0; i < motion_.size(); ++i) ++members[root(int(i))];
    std::vector<bool> taken(motion_.size(), false);
    for (const RigidTie& tie : ties_)
    {
        for (int node : tie.nodes())
        {
            for (int i = dofsPerNode*node; i < dofsPerNode*node + 6; ++i)
            {
                if (motion_[i].isSet || members[root(i)] > 1 || taken[i])
                {
                    throw std::invalid_argument
                    (
                        "rigid tie of node set " + tie.nodeSet() + ": node "
                      + std::to_string(node) + " is in another constraint as "
                        "well; leave it in one of them only"
                    );
                }
                taken[i] = true;
            }
        }
    }
}

DofMap Constraints::dofMap() const
{
    checkTies();
    const int nFull = static_cast<int>(motion_.size());
    const Vector initial = mesh_.initialPositions();

    // A group of shared unknowns moves as its prescribed member does
    std::vector<Motion> groupMotion(nFull);
    for (int i = 0; i < nFull; ++i)
    {
        if (!motion_[i].isSet) continue;
        Motion& group = groupMotion[root(i)];
        if (group.isSet && group.displacement != motion_[i].displacement)
        {
            conflict(i);
        }
        group = motion_[i];
    }

    std::vector<int> equation(nFull, -1);
    std::vector<int> equationOfRoot(nFull, -1);
    std::vector<DofMap::Prescribed> prescribed;
    int nEquations = 0;
    for (int i = 0; i < nFull; ++i)
    {
        const int r = root(i);
        if (groupMotion[r].isSet)
        {
            prescribed.push_back({i, initial[i], groupMotion[r].displacement});
            continue;
        }
        if (equationOfRoot[r] < 0) equationOfRoot[r] = nEquations++;
        equation[i] = equationOfRoot[r];
    }
    return DofMap
    (
        std::move(equation), nEquations, std::move(prescribed), ties_
    );
}

int Constraints::root(int unknown) const
{
    while (parent_[unknown] != unknown)
    {
        parent_[unknown] = parent_[parent_[unknown]];
        unknown = parent_[unknown];
    }
    return unknown;
}

void Constraints::share(int unknown1, int unknown2)
{
    const auto [low, high] = std::minmax({root(unknown1), root(unknown2)});
    parent_[high] = low;
}

void Constraints::set
(
    int node,
    Component c,
    const TimeFunctionPtr& displacement
)
{
    const int unknown = fullIndex(node, c);
    Motion& motion = motion_[unknown];
    if (motion.isSet && motion.displacement != displacement) conflict(unknown);
    motion.isSet = true;
    motion.displacement = displacement;
}

void Constraints::conflict(int unknown) const
{
    const int node = unknown/dofsPerNode;
    const Component c = static_cast<Component>(unknown%dofsPerNode);
    throw std::invalid_argument
    (
        "constraints: component " + std::string(componentName(c)) + " of node "
      + std::to_string(node) + " is asked to move in two ways; leave the node "
        "in one of the conditions only (a moving clamp: prescribe the position "
        "components and fix gx gy gz)"
    );
}

} // namespace positionalShell
