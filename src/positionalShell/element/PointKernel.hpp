// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shell at one point of the mid-surface and through its thickness: strains,
// force and tangent with respect to the 18 fields of the point, (S6)-(S13).
//
// Fields, in this order (F below):
//     m1 m2     derivatives of the mid-surface position by xi1, xi2 (3 + 3)
//     g g1 g2   director and its derivatives                        (3 + 3 + 3)
//     a a1 a2   thickness-strain rate and its derivatives           (1 + 1 + 1)
//
// Every number is a Pack: one value for each of four elements. Symmetric tensors
// are six numbers 11 22 33 12 23 13. Included by the batch kernels only.

#include "Pack.hpp"

namespace positionalShell
{

namespace SHELL_KERNEL_NAMESPACE
{

namespace F
{
    constexpr int m1 = 0, m2 = 3, g = 6, g1 = 9, g2 = 12, a = 15, a1 = 16, a2 = 17;
    constexpr int size = 18;

    //- First field of the derivative by xi1 (0) or xi2 (1)
    constexpr int m(int derivative) { return m1 + 3*derivative; }
    constexpr int dg(int derivative) { return g1 + 3*derivative; }
    constexpr int da(int derivative) { return a1 + derivative; }
}

//- Place of component (i, j) among the six numbers
constexpr int symmetricIndex[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};

//- Place of (u, v) in the 21 numbers of a symmetric 6 x 6 matrix
constexpr int packedIndex(int u, int v)
{
    return u >= v ? u*(u + 1)/2 + v : v*(v + 1)/2 + u;
}

//- Base vectors of the deformed body at one thickness coordinate, and how they
//  depend on the fields, (S6)
struct BaseVectors
{
    Pack a[3][3];       // a[i] = dx/dxi_i
    Pack p;             // da_alpha/dg_alpha
    Pack r[2];          // da_alpha/dg
    double square;      // h/2 zeta^2: da_alpha/d(a_alpha) is square*g
    Pack s;             // da_3/dg
    double linear;      // h zeta: da_3/da is linear*g
};

SHELL_INLINE BaseVectors baseVectors
(
    const Pack* f,
    double halfThickness,
    double zeta
)
{
    BaseVectors b;
    b.square = halfThickness*zeta*zeta;
    b.linear = 2*halfThickness*zeta;
    b.p = Pack(halfThickness*zeta) + b.square*f[F::a];
    b.s = Pack(halfThickness) + b.linear*f[F::a];
    for (int d = 0; d < 2; ++d)
    {
        b.r[d] = b.square*f[F::da(d)];
        for (int c = 0; c < 3; ++c)
        {
            b.a[d][c] =
                f[F::m(d) + c] + b.p*f[F::dg(d) + c] + b.r[d]*f[F::g + c];
        }
    }
    for (int c = 0; c < 3; ++c) b.a[2][c] = b.s*f[F::g + c];
    return b;
}

SHELL_INLINE Pack dot(const Pack* u, const Pack* v)
{
    return u[0]*v[0] + u[1]*v[1] + u[2]*v[2];
}

//- Covariant Green-Lagrange strain e11 e22 e33 2e12 2e23 2e13, (S7)
SHELL_INLINE void covariantStrain
(
    const BaseVectors& b,
    const LaneValues* metric,
    Pack* e
)
{
    for (int i = 0; i < 3; ++i)
    {
        e[i] = 0.5*(dot(b.a[i], b.a[i]) - metric[i]);
    }
    e[3] = dot(b.a[0], b.a[1]) - metric[3];
    e[4] = dot(b.a[1], b.a[2]) - metric[4];
    e[5] = dot(b.a[0], b.a[2]) - metric[5];
}

//- t^i = S^ij a_j: weight times the first Piola-Kirchhoff traction on the
//  coordinate surfaces, (S10)
SHELL_INLINE void tractions
(
    const BaseVectors& b,
    const Pack* S,
    Pack t[3][3]
)
{
    for (int i = 0; i < 3; ++i)
    {
        for (int c = 0; c < 3; ++c)
        {
            t[i][c] = S[symmetricIndex[i][0]]*b.a[0][c]
                + S[symmetricIndex[i][1]]*b.a[1][c]
                + S[symmetricIndex[i][2]]*b.a[2][c];
        }
    }
}

//- force += dW/dfields, (S11)
SHELL_INLINE void addFieldForce
(
    const BaseVectors& b,
    const Pack* f,
    const Pack t[3][3],
    Pack* force
)
{
    const Pack* g = f + F::g;
    for (int d = 0; d < 2; ++d)
    {
        for (int c = 0; c < 3; ++c)
        {
            force[F::m(d) + c] += t[d][c];
            force[F::dg(d) + c] += b.p*t[d][c];
            force[F::g + c] += b.r[d]*t[d][c];
        }
        force[F::a] += b.square*dot(f + F::dg(d), t[d]);
        force[F::da(d)] += b.square*dot(g, t[d]);
    }
    for (int c = 0; c < 3; ++c) force[F::g + c] += b.s*t[2][c];
    force[F::a] += b.linear*dot(g, t[2]);
}

//- Q[v][l] = dS_v/da_l: weighted stress by the base vectors
SHELL_INLINE void stressDerivatives
(
    const BaseVectors& b,
    const LaneValues* C,
    Pack Q[6][3][3]
)
{
    for (int v = 0; v < 6; ++v)
    {
        for (int l = 0; l < 3; ++l)
        {
            for (int y = 0; y < 3; ++y)
            {
                Q[v][l][y] =
                    C[packedIndex(v, symmetricIndex[l][0])]*b.a[0][y]
                  + C[packedIndex(v, symmetricIndex[l][1])]*b.a[1][y]
                  + C[packedIndex(v, symmetricIndex[l][2])]*b.a[2][y];
            }
        }
    }
}

//- H[i][l] = dt^i/da_l, (S12)
SHELL_INLINE void tractionDerivatives
(
    const BaseVectors& b,
    const Pack* S,
    const Pack Q[6][3][3],
    Pack H[3][3][3][3]
)
{
    for (int i = 0; i < 3; ++i)
    {
        for (int l = i; l < 3; ++l)
        {
            for (int x = 0; x < 3; ++x)
            {
                for (int y = 0; y < 3; ++y)
                {
                    H[i][l][x][y] =
                        b.a[0][x]*Q[symmetricIndex[i][0]][l][y]
                      + b.a[1][x]*Q[symmetricIndex[i][1]][l][y]
                      + b.a[2][x]*Q[symmetricIndex[i][2]][l][y];
                }
                H[i][l][x][x] += S[symmetricIndex[i][l]];
            }
            if (l == i) continue;
            for (int x = 0; x < 3; ++x)
            {
                for (int y = 0; y < 3; ++y) H[l][i][y][x] = H[i][l][x][y];
            }
        }
    }
}

SHELL_INLINE void multiply(const Pack A[3][3], const Pack* v, Pack* Av)
{
    for (int x = 0; x < 3; ++x) Av[x] = dot(A[x], v);
}

//- Columns of position and director fields: tangent += upper block triangle
SHELL_INLINE void addVectorColumns
(
    const BaseVectors& b,
    const Pack H[3][3][3][3],
    Pack (*K)[F::size]
)
{
    const Pack pp = b.p*b.p;
    for (int d = 0; d < 2; ++d)
    {
        for (int e = 0; e < 2; ++e)
        {
            for (int x = 0; x < 3; ++x)
            {
                for (int y = 0; y < 3; ++y)
                {
                    const Pack& h = H[d][e][x][y];
                    K[F::m(d) + x][F::dg(e) + y] += b.p*h;
                    if (e < d) continue;
                    K[F::m(d) + x][F::m(e) + y] += h;
                    K[F::dg(d) + x][F::dg(e) + y] += pp*h;
                }
            }
        }
    }
    for (int x = 0; x < 3; ++x)
    {
        for (int y = 0; y < 3; ++y)
        {
            // dt/dg of the three tractions
            Pack X[3];
            for (int i = 0; i < 3; ++i)
            {
                X[i] = b.r[0]*H[i][0][x][y] + b.r[1]*H[i][1][x][y]
                    + b.s*H[i][2][x][y];
            }
            K[F::m1 + x][F::g + y] += X[0];
            K[F::m2 + x][F::g + y] += X[1];
            K[F::g + y][F::g1 + x] += b.p*X[0];
            K[F::g + y][F::g2 + x] += b.p*X[1];
            K[F::g + x][F::g + y] += b.r[0]*X[0] + b.r[1]*X[1] + b.s*X[2];
        }
    }
}

//- Columns of a and of its derivatives, given the derivatives u of the three
//  base vectors by that field. Adds the rows of position and director; the
//  caller adds what comes from second derivatives of the base vectors.
SHELL_INLINE void addScalarColumn
(
    const BaseVectors& b,
    const Pack dt[3][3],
    int column,
    Pack (*K)[F::size]
)
{
    for (int x = 0; x < 3; ++x)
    {
        K[F::m1 + x][column] += dt[0][x];
        K[F::m2 + x][column] += dt[1][x];
        K[F::g1 + x][column] += b.p*dt[0][x];
        K[F::g2 + x][column] += b.p*dt[1][x];
        K[F::g + x][column] +=
            b.r[0]*dt[0][x] + b.r[1]*dt[1][x] + b.s*dt[2][x];
    }
}

//- tangent += d2W/dfields2, upper block triangle, (S13)
SHELL_INLINE void addFieldTangent
(
    const BaseVectors& b,
    const Pack* f,
    const Pack* S,
    const Pack Q[6][3][3],
    const Pack t[3][3],
    Pack (*K)[F::size]
)
{
    Pack H[3][3][3][3];
    tractionDerivatives(b, S, Q, H);
    addVectorColumns(b, H, K);

    // Derivatives of the base vectors: by a (w, z), by a1 or a2 (u)
    Pack w[2][3];
    Pack z[3];
    Pack u[3];
    for (int c = 0; c < 3; ++c)
    {
        w[0][c] = b.square*f[F::g1 + c];
        w[1][c] = b.square*f[F::g2 + c];
        z[c] = b.linear*f[F::g + c];
        u[c] = b.square*f[F::g + c];
    }

    Pack dtda[3][3];
    for (int i = 0; i < 3; ++i)
    {
        for (int x = 0; x < 3; ++x)
        {
            dtda[i][x] = dot(H[i][0][x], w[0]) + dot(H[i][1][x], w[1])
                + dot(H[i][2][x], z);
        }
    }
    addScalarColumn(b, dtda, F::a, K);
    K[F::a][F::a] += dot(w[0], dtda[0]) + dot(w[1], dtda[1]) + dot(z, dtda[2]);
    for (int x = 0; x < 3; ++x)
    {
        K[F::g1 + x][F::a] += b.square*t[0][x];
        K[F::g2 + x][F::a] += b.square*t[1][x];
        K[F::g + x][F::a] += b.linear*t[2][x];
    }

    for (int d = 0; d < 2; ++d)
    {
        Pack dt[3][3];
        for (int i = 0; i < 3; ++i) multiply(H[i][d], u, dt[i]);
        addScalarColumn(b, dt, F::da(d), K);
        K[F::a][F::da(d)] +=
            dot(w[0], dt[0]) + dot(w[1], dt[1]) + dot(z, dt[2]);
        for (int e = 0; e <= d; ++e) K[F::da(e)][F::da(d)] += dot(u, dt[e]);
        for (int x = 0; x < 3; ++x) K[F::g + x][F::da(d)] += b.square*t[d][x];
    }
}

} // namespace SHELL_KERNEL_NAMESPACE

} // namespace positionalShell
