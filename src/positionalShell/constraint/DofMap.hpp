// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which equation each of the 7 unknowns per node belongs to, (S20). An unknown is
// free, shared (several unknowns move by the same increment) or prescribed (its
// displacement from the initial state is a function of time). Made by Constraints.

#ifndef positionalShell_DofMap_hpp
#define positionalShell_DofMap_hpp

#include "RigidTie.hpp"
#include "TimeFunction.hpp"

#include <vector>

namespace positionalShell
{

class DofMap
{
public:

    struct Prescribed
    {
        int index;                      // in the full vector
        double initial;
        TimeFunctionPtr displacement;   // null: stays at the initial value
    };

    //- equation[i]: number of the equation of unknown i, or -1
    DofMap
    (
        std::vector<int> equation,
        int nEquations,
        std::vector<Prescribed> prescribed,
        std::vector<RigidTie> ties = {}
    );

    //- Size of full vectors, 7 x number of nodes
    int nFull() const { return static_cast<int>(equation_.size()); }

    int nEquations() const { return nEquations_; }

    //- Equation of an unknown, -1 when prescribed
    int equation(int fullIndex) const { return equation_[fullIndex]; }
    const std::vector<int>& equations() const { return equation_; }

    //- Some unknown of the equation (the first): names it in messages
    int firstUnknown(int equation) const { return first_[equation]; }

    const std::vector<Prescribed>& prescribed() const { return prescribed_; }

    //- Rigid ties. Their nodes have equations of their own here, free ones;
    //  TieElimination reduces them to six
    const std::vector<RigidTie>& ties() const { return ties_; }

    //- Full force vector to equations (sums over shared unknowns)
    Vector reduce(const Vector& full) const;
    void reduce(const Vector& full, Vector& reduced) const;

    //- Equation vector to a full vector, zero where prescribed
    Vector expand(const Vector& reduced) const;

    //- Values of the equations in a full vector in which shared unknowns are equal
    Vector pick(const Vector& full) const;

    //- full += expand(reduced)
    void addExpanded(const Vector& reduced, Vector& full) const;

    //- Write the prescribed values at time t into full vectors
    void setPrescribedPositions(double t, Vector& q) const;
    void setPrescribedRates(double t, Vector& velocity, Vector& accel) const;

private:

    std::vector<int> equation_;
    int nEquations_;
    std::vector<int> first_;
    std::vector<Prescribed> prescribed_;
    std::vector<RigidTie> ties_;
};

} // namespace positionalShell

#endif
