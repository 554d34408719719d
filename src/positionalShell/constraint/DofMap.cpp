// SPDX-License-Identifier: GPL-3.0-or-later

#include "DofMap.hpp"

namespace positionalShell
{

DofMap::DofMap
(
    std::vector<int> equation,
    int nEquations,
    std::vector<Prescribed> prescribed,
    std::vector<RigidTie> ties
)
:
    equation_(std::move(equation)),
    nEquations_(nEquations),
    first_(nEquations, -1),
    prescribed_(std::move(prescribed)),
    ties_(std::move(ties))
{
    for (int i = nFull() - 1; i >= 0; --i)
    {
        if (equation_[i] >= 0) first_[equation_[i]] = i;
    }
}

void DofMap::reduce(const Vector& full, Vector& reduced) const
{
    reduced.setZero(nEquations_);
    for (int i = 0; i < nFull(); ++i)
    {
        if (equation_[i] >= 0) reduced[equation_[i]] += full[i];
    }
}

Vector DofMap::reduce(const Vector& full) const
{
    Vector reduced;
    reduce(full, reduced);
    return reduced;
}

Vector DofMap::expand(const Vector& reduced) const
{
    Vector full = Vector::Zero(nFull());
    addExpanded(reduced, full);
    return full;
}

Vector DofMap::pick(const Vector& full) const
{
    Vector reduced(nEquations_);
    for (int e = 0; e < nEquations_; ++e) reduced[e] = full[first_[e]];
    return reduced;
}

void DofMap::addExpanded(const Vector& reduced, Vector& full) const
{
    for (int i = 0; i < nFull(); ++i)
    {
        if (equation_[i] >= 0) full[i] += reduced[equation_[i]];
    }
}

void DofMap::setPrescribedPositions(double t, Vector& q) const
{
    for (const Prescribed& p : prescribed_)
    {
        q[p.index] = p.initial + (p.displacement ? p.displacement->value(t) : 0);
    }
}

void DofMap::setPrescribedRates
(
    double t,
    Vector& velocity,
    Vector& acceleration
) const
{
    for (const Prescribed& p : prescribed_)
    {
        velocity[p.index] =
            p.displacement ? p.displacement->firstDerivative(t) : 0;
        acceleration[p.index] =
            p.displacement ? p.displacement->secondDerivative(t) : 0;
    }
}

} // namespace positionalShell
