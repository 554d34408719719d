// SPDX-License-Identifier: GPL-3.0-or-later

#include "straightforwardTangent.hpp"

#include <cmath>

#if defined(__x86_64__) && defined(__GNUC__)
    #define BEST_INSTRUCTIONS \
        __attribute__((target_clones("arch=haswell", "default")))
#else
    #define BEST_INSTRUCTIONS
#endif

namespace
{

//- Base vectors and their derivatives by the unknowns
struct Base
{
    double a[3][3];                     // [direction][component]
    double D[3][3][nUnknowns];
};

//- Fields N_j g_j, N_j a_j and their derivatives along xi1, xi2
struct Fields
{
    double m[2][3];
    double g[3][3];                     // value, d/dxi1, d/dxi2
    double a[3];
};

Fields fields(const PlainPoint& p, const double* q)
{
    Fields f = {};
    for (int j = 0; j < nNodes; ++j)
    {
        const double phi[3] = {p.N[j], p.dN[0][j], p.dN[1][j]};
        for (int d = 0; d < 3; ++d)
        {
            for (int c = 0; c < 3; ++c) f.g[d][c] += phi[d]*q[7*j + 3 + c];
            f.a[d] += phi[d]*q[7*j + 6];
        }
        for (int d = 0; d < 2; ++d)
        {
            for (int c = 0; c < 3; ++c) f.m[d][c] += phi[1 + d]*q[7*j + c];
        }
    }
    return f;
}

void baseVectors(const PlainPoint& p, double h, const Fields& f, double a[3][3])
{
    const double z = p.zeta;
    for (int c = 0; c < 3; ++c)
    {
        for (int d = 0; d < 2; ++d)
        {
            a[d][c] = f.m[d][c]
              + h*((z + f.a[0]*z*z)*f.g[1 + d][c] + f.a[1 + d]*z*z*f.g[0][c]);
        }
        a[2][c] = h*(1 + 2*f.a[0]*z)*f.g[0][c];
    }
}

void gradients(const PlainPoint& p, double h, const Fields& f, Base& base)
{
    const double z = p.zeta;
    baseVectors(p, h, f, base.a);
    for (auto& direction : base.D)
    {
        for (auto& row : direction)
        {
            for (double& entry : row) entry = 0;
        }
    }
    for (int j = 0; j < nNodes; ++j)
    {
        for (int c = 0; c < 3; ++c)
        {
            for (int d = 0; d < 2; ++d)
            {
                base.D[d][c][7*j + c] = p.dN[d][j];
                base.D[d][c][7*j + 3 + c] = h
                   *((z + f.a[0]*z*z)*p.dN[d][j] + f.a[1 + d]*z*z*p.N[j]);
                base.D[d][c][7*j + 6] = h*z*z
                   *(p.N[j]*f.g[1 + d][c] + p.dN[d][j]*f.g[0][c]);
            }
            base.D[2][c][7*j + 3 + c] = h*(1 + 2*f.a[0]*z)*p.N[j];
            base.D[2][c][7*j + 6] = 2*h*z*p.N[j]*f.g[0][c];
        }
    }
}

double dot(const double* x, const double* y)
{
    return x[0]*y[0] + x[1]*y[1] + x[2]*y[2];
}

//- Inverse of the symmetric metric; the root of its determinant
double inverse(const double G[3][3], double H[3][3])
{
    for (int i = 0; i < 3; ++i)
    {
        const int i1 = (i + 1) % 3;
        const int i2 = (i + 2) % 3;
        for (int j = 0; j < 3; ++j)
        {
            const int j1 = (j + 1) % 3;
            const int j2 = (j + 2) % 3;
            H[i][j] = G[i1][j1]*G[i2][j2] - G[i1][j2]*G[i2][j1];
        }
    }
    const double det = dot(G[0], H[0]);
    for (int i = 0; i < 3; ++i)
    {
        for (int j = 0; j < 3; ++j) H[i][j] /= det;
    }
    return std::sqrt(det);
}

constexpr int first[6] = {0, 1, 2, 0, 1, 0};
constexpr int second[6] = {0, 1, 2, 1, 2, 2};

//- Elastic matrix on covariant strains, shear doubled
void elasticity(const PlainElement& e, const double H[3][3], double C[6][6])
{
    for (int u = 0; u < 6; ++u)
    {
        const int i = first[u];
        const int j = second[u];
        for (int v = 0; v < 6; ++v)
        {
            const int k = first[v];
            const int l = second[v];
            C[u][v] = e.lambda*H[i][j]*H[k][l]
              + e.mu*(H[i][k]*H[j][l] + H[i][l]*H[j][k]);
        }
    }
}

//- Second derivatives of the base vectors, times the stress: pairs (a_i, g_j)
void addSecondDerivatives
(
    const PlainPoint& p,
    double h,
    const Base& base,
    const double S[3][3],
    double weight,
    double K[nUnknowns][nUnknowns]
)
{
    const double z = p.zeta;
    double t[3][3] = {};
    for (int i = 0; i < 3; ++i)
    {
        for (int j = 0; j < 3; ++j)
        {
            for (int c = 0; c < 3; ++c) t[i][c] += weight*S[i][j]*base.a[j][c];
        }
    }
    for (int i = 0; i < nNodes; ++i)
    {
        for (int j = 0; j < nNodes; ++j)
        {
            for (int c = 0; c < 3; ++c)
            {
                double sum = 2*h*z*p.N[i]*p.N[j]*t[2][c];
                for (int d = 0; d < 2; ++d)
                {
                    sum += h*z*z*t[d][c]
                       *(p.N[i]*p.dN[d][j] + p.dN[d][i]*p.N[j]);
                }
                K[7*i + 6][7*j + 3 + c] += sum;
                K[7*j + 3 + c][7*i + 6] += sum;
            }
        }
    }
}

//- K += weight (B^T C B + D^T S D)
BEST_INSTRUCTIONS void addProducts
(
    const double B[6][nUnknowns],
    const double C[6][6],
    const double D[3][3][nUnknowns],
    const double S[3][3],
    double weight,
    double K[nUnknowns][nUnknowns]
)
{
    double CB[6][nUnknowns];
    double SD[3][3][nUnknowns];
    for (int u = 0; u < 6; ++u)
    {
        for (int s = 0; s < nUnknowns; ++s)
        {
            double sum = 0;
            for (int v = 0; v < 6; ++v) sum += C[u][v]*B[v][s];
            CB[u][s] = weight*sum;
        }
    }
    for (int i = 0; i < 3; ++i)
    {
        for (int c = 0; c < 3; ++c)
        {
            for (int s = 0; s < nUnknowns; ++s)
            {
                double sum = 0;
                for (int j = 0; j < 3; ++j) sum += S[i][j]*D[j][c][s];
                SD[i][c][s] = weight*sum;
            }
        }
    }
    for (int r = 0; r < nUnknowns; ++r)
    {
        for (int u = 0; u < 6; ++u)
        {
            const double b = B[u][r];
            for (int s = 0; s < nUnknowns; ++s) K[r][s] += b*CB[u][s];
        }
        for (int i = 0; i < 3; ++i)
        {
            for (int c = 0; c < 3; ++c)
            {
                const double d = D[i][c][r];
                for (int s = 0; s < nUnknowns; ++s) K[r][s] += d*SD[i][c][s];
            }
        }
    }
}

} // namespace

void straightforwardTangent
(
    const PlainElement& element,
    const PlainPoint* points,
    int nPoints,
    const double* unknowns,
    double K[nUnknowns][nUnknowns]
)
{
    for (int r = 0; r < nUnknowns; ++r)
    {
        for (int s = 0; s < nUnknowns; ++s) K[r][s] = 0;
    }
    const double h = element.halfThickness;
    for (const PlainPoint* p = points; p != points + nPoints; ++p)
    {
        double A[3][3];
        double G[3][3];
        double H[3][3];
        double C[6][6];
        baseVectors(*p, h, fields(*p, element.initial), A);
        for (int i = 0; i < 3; ++i)
        {
            for (int j = 0; j < 3; ++j) G[i][j] = dot(A[i], A[j]);
        }
        const double weight = p->weight*inverse(G, H);
        elasticity(element, H, C);

        Base base;
        gradients(*p, h, fields(*p, unknowns), base);

        double strain[6];
        double B[6][nUnknowns];
        for (int u = 0; u < 6; ++u)
        {
            const int i = first[u];
            const int j = second[u];
            const double half = i == j ? 0.5 : 1;
            strain[u] = half*(dot(base.a[i], base.a[j]) - G[i][j]);
            for (int s = 0; s < nUnknowns; ++s)
            {
                double sum = 0;
                for (int c = 0; c < 3; ++c)
                {
                    sum += base.a[i][c]*base.D[j][c][s]
                      + base.a[j][c]*base.D[i][c][s];
                }
                B[u][s] = half*sum;
            }
        }

        double S[3][3];
        for (int u = 0; u < 6; ++u)
        {
            double sum = 0;
            for (int v = 0; v < 6; ++v) sum += C[u][v]*strain[v];
            S[first[u]][second[u]] = S[second[u]][first[u]] = sum;
        }
        addProducts(B, C, base.D, S, weight, K);
        addSecondDerivatives(*p, h, base, S, weight, K);
    }
}
