// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tangent of one element as the formulas stand, to compare with: at every
// integration point of the body all matrices are full, the sums B^T C B of a strain
// matrix B (6 x 70) and D^T S D of the gradients D (9 x 70) run over all 70 x 70
// entries. Displacement form, Saint-Venant-Kirchhoff.
//
// Plain arrays, compiled for the same instruction sets as the library's kernels.

#ifndef straightforwardTangent_hpp
#define straightforwardTangent_hpp

constexpr int nNodes = 10;
constexpr int nUnknowns = 7*nNodes;

//- What the element is: unknowns of the initial state, node by node (position,
//  director, thickness strain), half the thickness, Lame's constants
struct PlainElement
{
    const double* initial;
    double halfThickness;
    double lambda;
    double mu;
};

//- Point of the body: basis and its two derivatives, thickness coordinate, weight
//  on the reference element
struct PlainPoint
{
    double N[nNodes];
    double dN[2][nNodes];
    double zeta;
    double weight;
};

//- K = second derivative of the energy by the unknowns; all 70 x 70 entries
void straightforwardTangent
(
    const PlainElement& element,
    const PlainPoint* points,
    int nPoints,
    const double* unknowns,
    double K[nUnknowns][nUnknowns]
);

#endif
