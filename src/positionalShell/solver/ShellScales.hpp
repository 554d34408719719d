// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lengths of a shell that residuals and increments are measured by.

#ifndef positionalShell_ShellScales_hpp
#define positionalShell_ShellScales_hpp

#include "KindNorms.hpp"
#include "ShellModel.hpp"

#include <algorithm>
#include <limits>

namespace positionalShell
{

struct ShellScales
{
    double length;              // diagonal of the mesh
    double greatestThickness;
    double leastThickness;

    explicit ShellScales(const ShellModel& model)
    :
        length(model.mesh().lengthScale()),
        greatestThickness(model.sections().front().thickness),
        leastThickness(greatestThickness)
    {
        for (const Section& section : model.sections())
        {
            greatestThickness =
                std::max(greatestThickness, section.thickness);
            leastThickness = std::min(leastThickness, section.thickness);
        }
    }

    //- Directors and thickness strain do work through the thickness: their scale
    //  is at least that of the positions times the thickness, (S23)
    KindNorms completed(KindNorms force) const
    {
        const double moment = greatestThickness*force.position;
        force.director = std::max(force.director, moment);
        force.thickness = std::max(force.thickness, moment);
        return force;
    }

    //- Greatest entries of an increment over the scales, (S24)
    KindNorms ofIncrement(const DofMap& dofs, const Vector& reduced) const
    {
        KindNorms greatest = greatestEntries(dofs, reduced);
        greatest.position /= length;
        return greatest;
    }

    //- Membrane strains of the order of machine precision bend a shell by about
    //  this much, over the length, (S25)
    double roundOffIncrement() const
    {
        return 4*std::numeric_limits<double>::epsilon()*length/leastThickness;
    }
};

} // namespace positionalShell

#endif
