// SPDX-License-Identifier: GPL-3.0-or-later

#include "TurnedFactors.hpp"

#include <Eigen/Geometry>

namespace positionalShell
{

namespace
{

//- The smallest rotation from direction a to b; none where it is not defined
Eigen::Matrix3d rotation(const Vec3& a, const Vec3& b)
{
    const double scale = 1/(a.norm()*b.norm());
    const double cosine = scale*a.dot(b);
    if (!(cosine > -0.99)) return Eigen::Matrix3d::Identity();
    const Vec3 axis = scale*a.cross(b);
    Eigen::Matrix3d cross;
    cross << 0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0;
    return Eigen::Matrix3d::Identity() + cross + cross*cross/(1 + cosine);
}

//- Whether the supports take forces along all axes
bool held(const DofMap& dofs)
{
    bool along[3] = {false, false, false};
    for (const auto& p : dofs.prescribed())
    {
        const int c = p.index%dofsPerNode;
        if (c < 3) along[c] = true;
    }
    return along[0] && along[1] && along[2];
}

Vec3 director(const Vector& position, int node)
{
    return position.segment<3>(dofsPerNode*node + 3);
}

} // namespace

TurnedFactors::TurnedFactors(const DofMap& dofs)
{
    if (!dofs.ties().empty() || !held(dofs)) return;

    std::vector<int> unknowns(dofs.nEquations(), 0);
    for (int equation : dofs.equations())
    {
        if (equation >= 0) ++unknowns[equation];
    }
    for (int node = 0; node < dofs.nFull()/dofsPerNode; ++node)
    {
        for (int first : {0, 3})
        {
            Triple triple{node, {}};
            bool own = true;
            for (int c = 0; c < 3; ++c)
            {
                const int equation = dofs.equation(dofsPerNode*node + first + c);
                triple.equations[c] = equation;
                own = own && equation >= 0 && unknowns[equation] == 1;
            }
            if (own) triples_.push_back(triple);
        }
    }
}

Vector TurnedFactors::solve
(
    LinearSolver& factors,
    const Vector& position,
    const Vector& residual
) const
{
    std::vector<Eigen::Matrix3d> turns;
    turns.reserve(triples_.size());
    Vector turned = residual;
    for (const Triple& t : triples_)
    {
        turns.push_back(rotation(director(origin_, t.node), director(position, t.node)));
        const int* e = t.equations;
        const Vec3 back =
            turns.back().transpose()*Vec3(residual[e[0]], residual[e[1]], residual[e[2]]);
        for (int c = 0; c < 3; ++c) turned[e[c]] = back[c];
    }
    Vector increment = factors.solve(turned);
    for (std::size_t i = 0; i < triples_.size(); ++i)
    {
        const int* e = triples_[i].equations;
        const Vec3 forth = turns[i]*Vec3(increment[e[0]], increment[e[1]], increment[e[2]]);
        for (int c = 0; c < 3; ++c) increment[e[c]] = forth[c];
    }
    return increment;
}

} // namespace positionalShell
