// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lowest frequencies of small vibrations about a state: K phi = omega^2 M phi by
// shift-invert subspace iteration, (S35). M is singular (a has no inertia): every
// iterate lies in the range of (K - s M)^-1 M, which holds no massless mode.

#ifndef positionalShell_EigenFrequencies_hpp
#define positionalShell_EigenFrequencies_hpp

#include "ShellModel.hpp"

namespace positionalShell
{

struct EigenOptions
{
    double tolerance = 1e-9;        // relative change of omega^2
    int maxIterations = 200;
    double shift = 0;               // s [1/s^2]; negative for free bodies
};

struct EigenModes
{
    bool converged = false;
    int iterations = 0;
    Vector frequency;               // [Hz], ascending
    Vector eigenvalue;              // omega^2 [1/s^2]
    Eigen::MatrixXd mode;           // columns: full vectors, phi^T M phi = 1
};

//- Throws std::invalid_argument when n is not within 1 ... number of equations
//  with inertia, SingularMatrix when K - s M is singular.
EigenModes lowestModes
(
    const ShellModel& model,
    const Vector& q,
    int n,
    EigenOptions options = {}
);

} // namespace positionalShell

#endif
