// SPDX-License-Identifier: GPL-3.0-or-later
//
// Integration rules: symmetric positive rules on the triangle and
// Gauss-Legendre on the line. Which are used where, and why: theory page,
// section on quadrature.

#ifndef positionalShell_Quadrature_hpp
#define positionalShell_Quadrature_hpp

#include <vector>

namespace positionalShell
{

struct TrianglePoint
{
    double xi1;
    double xi2;
    double weight;      // sum of weights = 1/2, the area of the triangle
};

struct LinePoint
{
    double xi;          // in [-1, 1]
    double weight;      // sum of weights = 2
};

//- Rule with the given number of points: 6, 7, 12, 16 or 25 points are exact to
//  degree 4, 5, 6, 8 and 10. Throws std::invalid_argument for another number.
const std::vector<TrianglePoint>& triangleRule(int nPoints);

//- Smallest rule of the list that is exact to the given degree
const std::vector<TrianglePoint>& triangleRuleOfDegree(int degree);

//- Gauss-Legendre with n = 1 ... 10 points, exact to degree 2n-1
const std::vector<LinePoint>& gaussRule(int nPoints);

} // namespace positionalShell

#endif
