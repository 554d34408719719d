// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fits of Kingery and Bulmash (1984) to the blast of TNT, by scaled distance
// Z = r/W^(1/3) [m/kg^(1/3)], at sea level: peak overpressures [Pa], impulses
// [Pa s/kg^(1/3)], arrival and duration of the positive phase [s/kg^(1/3)]. Reflected:
// on a wall at right angles.

#ifndef positionalShell_BlastTable_hpp
#define positionalShell_BlastTable_hpp

#include <vector>

namespace positionalShell
{

class BlastTable
{
public:

    enum class Burst
    {
        freeAir,    // spherical, away from all walls
        surface     // hemispherical, on the ground
    };

    enum class Quantity
    {
        incidentPeak, incidentImpulse, reflectedPeak, reflectedImpulse, arrival, duration
    };

    explicit BlastTable(Burst burst) : burst_(burst) {}

    //- Throws std::invalid_argument with the valid range when Z is outside it
    double value(Quantity quantity, double Z) const;

    //- Range of Z in which all quantities are given
    double least() const;
    double greatest() const;

private:

    Burst burst_;
};

} // namespace positionalShell

#endif
