// SPDX-License-Identifier: GPL-3.0-or-later

#include "TieElimination.hpp"

#include <Eigen/Geometry>

namespace positionalShell
{

namespace
{

using Mat3 = Eigen::Matrix3d;
using Entry = Eigen::Triplet<double>;

//- cross(v) w = v x w
Mat3 cross(const Vec3& v)
{
    Mat3 m;
    m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
    return m;
}

//- Symmetric part of the derivative of r x f by a rotation of r, (C6)
Mat3 turned(const Vec3& r, const Vec3& f)
{
    return 0.5*(r*f.transpose() + f*r.transpose())
        - r.dot(f)*Mat3::Identity();
}

} // namespace

int TieElimination::equation(const RigidTie& tie, int freedom) const
{
    return dofs_.equation(dofsPerNode*tie.nodes().front() + freedom);
}

RigidTie::Six TieElimination::motion
(
    const RigidTie& tie,
    const Vector& increments
) const
{
    RigidTie::Six six;
    for (int c = 0; c < 3; ++c)
    {
        six.linear[c] = increments[equation(tie, c)];
        six.angular[c] = increments[equation(tie, 3 + c)];
    }
    return six;
}

//- T: what the six freedoms do to positions and directors, (C4); unit elsewhere
SparseMatrix TieElimination::transform(const Vector& arms) const
{
    const int n = dofs_.nEquations();
    std::vector<bool> tied(n, false);
    std::vector<Entry> entries;
    for (const RigidTie& tie : dofs_.ties())
    {
        const Vec3 c = tie.centre(arms);
        for (int node : tie.nodes())
        {
            const int first = dofsPerNode*node;
            const Mat3 r = cross(arms.segment<3>(first) - c);
            const Mat3 g = cross(arms.segment<3>(first + 3));
            for (int k = 0; k < 3; ++k)
            {
                const int x = dofs_.equation(first + k);
                const int d = dofs_.equation(first + 3 + k);
                tied[x] = tied[d] = true;
                entries.emplace_back(x, equation(tie, k), 1);
                for (int l = 0; l < 3; ++l)
                {
                    entries.emplace_back(x, equation(tie, 3 + l), -r(k, l));
                    entries.emplace_back(d, equation(tie, 3 + l), -g(k, l));
                }
            }
        }
    }
    for (int e = 0; e < n; ++e)
    {
        if (!tied[e]) entries.emplace_back(e, e, 1);
    }
    SparseMatrix T(n, n);
    T.setFromTriplets(entries.begin(), entries.end());
    return T;
}

void TieElimination::project(const Vector& arms, Vector& residual) const
{
    if (none()) return;
    residual = transform(arms).transpose()*residual;
}

bool TieElimination::symmetric(const std::vector<TieForce>& points)
{
    for (const TieForce& point : points)
    {
        if (!point.moment.isZero(0)) return false;
    }
    return true;
}

SparseMatrix TieElimination::reduced
(
    const Vector& arms,
    const SparseMatrix& K,
    const Vector& force,
    const std::vector<TieForce>& points
) const
{
    // Forces at the ties have arms of their own, and moments none
    Vector onNodes = force;
    std::vector<Mat3> turning(dofs_.ties().size(), Mat3::Zero());
    for (const TieForce& p : points)
    {
        dofs_.ties()[p.tie].spread
        (
            arms, {-p.force, -p.momentAboutCentre()}, onNodes
        );
        turning[p.tie] += turned(p.arm, p.force) + 0.5*cross(p.moment);
    }

    std::vector<Entry> entries;
    for (std::size_t t = 0; t < dofs_.ties().size(); ++t)
    {
        const RigidTie& tie = dofs_.ties()[t];
        const Vec3 c = tie.centre(arms);
        for (int node : tie.nodes())
        {
            const int first = dofsPerNode*node;
            const Vec3 r = arms.segment<3>(first) - c;
            turning[t] += turned(r, onNodes.segment<3>(first))
                + turned(arms.segment<3>(first + 3), onNodes.segment<3>(first + 3));
        }
        for (int k = 0; k < 3; ++k)
        {
            for (int l = 0; l < 3; ++l)
            {
                entries.emplace_back
                (
                    equation(tie, 3 + k), equation(tie, 3 + l), -turning[t](k, l)
                );
            }
        }
    }
    SparseMatrix own(K.rows(), K.cols());
    own.setFromTriplets(entries.begin(), entries.end());
    const SparseMatrix T = transform(arms);
    const SparseMatrix KT = K*T;
    const SparseMatrix TKT = SparseMatrix(T.transpose())*KT;
    return TKT + own + units();
}

SparseMatrix TieElimination::units() const
{
    std::vector<Entry> entries;
    for (const RigidTie& tie : dofs_.ties())
    {
        for (int node : tie.nodes())
        {
            // The freedoms have taken the places of the first node
            if (node == tie.nodes().front()) continue;
            for (int k = 0; k < 6; ++k)
            {
                const int e = dofs_.equation(dofsPerNode*node + k);
                entries.emplace_back(e, e, 1);
            }
        }
    }
    SparseMatrix result(dofs_.nEquations(), dofs_.nEquations());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

void TieElimination::expand(const Vector& arms, Vector& increments) const
{
    if (none()) return;
    increments = transform(arms)*increments;
}

void TieElimination::move
(
    const Vector& before,
    const Vector& increments,
    const Vector& base,
    Vector& unknowns
) const
{
    Vector after = before;
    for (const RigidTie& tie : dofs_.ties())
    {
        tie.move(before, motion(tie, increments), after);
        for (int node : tie.nodes())
        {
            const int first = dofsPerNode*node;
            unknowns.segment<6>(first) = base.segment<6>(first)
                + (after - before).segment<6>(first);
        }
    }
}

Vector TieElimination::advance
(
    const Vector& before,
    const Vector& increments,
    const Vector& base,
    Vector& unknowns
) const
{
    unknowns = base;
    dofs_.addExpanded(increments, unknowns);
    if (none()) return {};
    Vector tangent = increments;
    expand(before, tangent);
    Vector linear = before;
    dofs_.addExpanded(tangent, linear);
    move(before, increments, base, unknowns);
    return linear;
}

} // namespace positionalShell
