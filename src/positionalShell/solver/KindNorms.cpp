// SPDX-License-Identifier: GPL-3.0-or-later

#include "KindNorms.hpp"

#include <algorithm>
#include <cmath>

namespace positionalShell
{

namespace
{

KindNorms squareRoots(const KindNorms& n)
{
    return
    {
        std::sqrt(n.position), std::sqrt(n.director), std::sqrt(n.thickness)
    };
}

} // namespace

double KindNorms::largest() const
{
    return std::max({position, director, thickness});
}

KindNorms normsByKind(const Vector& full)
{
    KindNorms squares;
    for (Eigen::Index i = 0; i < full.size(); i += dofsPerNode)
    {
        squares.position += full.segment<3>(i).squaredNorm();
        squares.director += full.segment<3>(i + 3).squaredNorm();
        squares.thickness += full[i + 6]*full[i + 6];
    }
    return squareRoots(squares);
}

KindNorms equationNorms(const DofMap& dofs, const Vector& reduced)
{
    KindNorms squares;
    for (int e = 0; e < dofs.nEquations(); ++e)
    {
        squares.ofComponent(dofs.firstUnknown(e)%dofsPerNode) +=
            reduced[e]*reduced[e];
    }
    return squareRoots(squares);
}

KindNorms greatestEntries(const DofMap& dofs, const Vector& reduced)
{
    KindNorms greatest;
    for (int e = 0; e < dofs.nEquations(); ++e)
    {
        double& g = greatest.ofComponent(dofs.firstUnknown(e)%dofsPerNode);
        g = std::max(g, std::abs(reduced[e]));
    }
    return greatest;
}

KindNorms greatestEntries(const Vector& full)
{
    KindNorms greatest;
    for (Eigen::Index i = 0; i < full.size(); ++i)
    {
        double& g = greatest.ofComponent(int(i%dofsPerNode));
        g = std::max(g, std::abs(full[i]));
    }
    return greatest;
}

KindNorms greater(const KindNorms& a, const KindNorms& b)
{
    return
    {
        std::max(a.position, b.position),
        std::max(a.director, b.director),
        std::max(a.thickness, b.thickness)
    };
}

KindNorms ratio(const KindNorms& a, const KindNorms& b)
{
    const auto over = [](double x, double scale)
    {
        return x == 0 ? 0 : x/scale;
    };
    return
    {
        over(a.position, b.position),
        over(a.director, b.director),
        over(a.thickness, b.thickness)
    };
}

bool within(const KindNorms& a, const KindNorms& limits)
{
    return a.position <= limits.position
        && a.director <= limits.director
        && a.thickness <= limits.thickness;
}

KindNorms operator*(double factor, const KindNorms& a)
{
    return {factor*a.position, factor*a.director, factor*a.thickness};
}

} // namespace positionalShell
