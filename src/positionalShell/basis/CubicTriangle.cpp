// SPDX-License-Identifier: GPL-3.0-or-later

#include "CubicTriangle.hpp"

namespace positionalShell
{

namespace CubicTriangle
{

namespace
{

//- Derivatives of an area-coordinate polynomial: value, d/dLa and d2/dLadLb
struct AreaJet
{
    double value = 0;
    std::array<double, 3> first{};
    std::array<std::array<double, 3>, 3> second{};
};

AreaJet corner(const std::array<double, 3>& L, int a)
{
    const double l = L[a];
    AreaJet jet;
    jet.value = 0.5*l*(3*l - 1)*(3*l - 2);
    jet.first[a] = 0.5*(27*l*l - 18*l + 2);
    jet.second[a][a] = 27*l - 9;
    return jet;
}

//- Node on the edge a-b, nearer to a
AreaJet edge(const std::array<double, 3>& L, int a, int b)
{
    AreaJet jet;
    jet.value = 4.5*L[a]*L[b]*(3*L[a] - 1);
    jet.first[a] = 4.5*L[b]*(6*L[a] - 1);
    jet.first[b] = 4.5*L[a]*(3*L[a] - 1);
    jet.second[a][a] = 27*L[b];
    jet.second[a][b] = jet.second[b][a] = 4.5*(6*L[a] - 1);
    return jet;
}

AreaJet centre(const std::array<double, 3>& L)
{
    AreaJet jet;
    jet.value = 27*L[0]*L[1]*L[2];
    for (int a = 0; a < 3; ++a)
    {
        const int b = (a + 1)%3;
        const int c = (a + 2)%3;
        jet.first[a] = 27*L[b]*L[c];
        jet.second[a][b] = jet.second[b][a] = 27*L[c];
    }
    return jet;
}

std::array<AreaJet, nodesPerElement> jets(double xi1, double xi2)
{
    const std::array<double, 3> L{1 - xi1 - xi2, xi1, xi2};
    return
    {
        corner(L, 0), corner(L, 1), corner(L, 2),
        edge(L, 0, 1), edge(L, 1, 0),
        edge(L, 1, 2), edge(L, 2, 1),
        edge(L, 2, 0), edge(L, 0, 2),
        centre(L)
    };
}

} // namespace

Values values(double xi1, double xi2)
{
    Values N;
    const auto all = jets(xi1, xi2);
    for (int j = 0; j < nodesPerElement; ++j)
    {
        N[j] = all[j].value;
    }
    return N;
}

// dL0 = -dxi1 - dxi2, dL1 = dxi1, dL2 = dxi2
Gradients gradients(double xi1, double xi2)
{
    Gradients dN;
    const auto all = jets(xi1, xi2);
    for (int j = 0; j < nodesPerElement; ++j)
    {
        const auto& d = all[j].first;
        dN(j, 0) = d[1] - d[0];
        dN(j, 1) = d[2] - d[0];
    }
    return dN;
}

SecondDerivatives secondDerivatives(double xi1, double xi2)
{
    SecondDerivatives ddN;
    const auto all = jets(xi1, xi2);
    for (int j = 0; j < nodesPerElement; ++j)
    {
        const auto& d = all[j].second;
        ddN(j, 0) = d[1][1] - 2*d[0][1] + d[0][0];
        ddN(j, 1) = d[2][2] - 2*d[0][2] + d[0][0];
        ddN(j, 2) = d[1][2] - d[0][1] - d[0][2] + d[0][0];
    }
    return ddN;
}

const std::array<Eigen::Vector2d, nodesPerElement>& nodePoints()
{
    static const double t = 1.0/3;
    static const std::array<Eigen::Vector2d, nodesPerElement> points
    {{
        {0, 0}, {1, 0}, {0, 1},
        {t, 0}, {2*t, 0},
        {2*t, t}, {t, 2*t},
        {0, 2*t}, {0, t},
        {t, t}
    }};
    return points;
}

Eigen::Vector4d edgeValues(double s)
{
    const double r = 1 - s;
    return
    {
        0.5*r*(3*r - 1)*(3*r - 2),
        4.5*r*s*(3*r - 1),
        4.5*r*s*(3*s - 1),
        0.5*s*(3*s - 1)*(3*s - 2)
    };
}

Eigen::Vector4d edgeDerivatives(double s)
{
    return
    {
        -5.5 + s*(18 - 13.5*s),
        9 + s*(-45 + 40.5*s),
        -4.5 + s*(36 - 40.5*s),
        1 + s*(-9 + 13.5*s)
    };
}

const std::array<std::array<int, 4>, 3>& edgeNodes()
{
    static const std::array<std::array<int, 4>, 3> places
    {{
        {0, 3, 4, 1}, {1, 5, 6, 2}, {2, 7, 8, 0}
    }};
    return places;
}

} // namespace CubicTriangle

} // namespace positionalShell
