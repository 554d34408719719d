// SPDX-License-Identifier: GPL-3.0-or-later
//
// Norms of the three kinds of unknowns (positions, directors, thickness strain),
// which have different units and are judged apart.

#ifndef positionalShell_KindNorms_hpp
#define positionalShell_KindNorms_hpp

#include "DofMap.hpp"

namespace positionalShell
{

struct KindNorms
{
    double position = 0;    // [N] or [m]
    double director = 0;    // [N m] or [-]
    double thickness = 0;   // [N m] or [-]

    //- Norm that a component of a node belongs to
    double& ofComponent(int c)
    {
        return c < 3 ? position : c < 6 ? director : thickness;
    }

    double largest() const;
};

//- Norms of a full vector by kind
KindNorms normsByKind(const Vector& full);

//- Norms of an equation vector by the kind of the equations
KindNorms equationNorms(const DofMap& dofs, const Vector& reduced);

//- Greatest entries of an equation vector by kind
KindNorms greatestEntries(const DofMap& dofs, const Vector& reduced);

//- Greatest entries of a full vector by kind
KindNorms greatestEntries(const Vector& full);

//- The greater of each kind
KindNorms greater(const KindNorms& a, const KindNorms& b);

//- Each over each; zero over anything is zero
KindNorms ratio(const KindNorms& a, const KindNorms& b);

//- Whether each kind is within its limit
bool within(const KindNorms& a, const KindNorms& limits);

KindNorms operator*(double factor, const KindNorms& a);

} // namespace positionalShell

#endif
