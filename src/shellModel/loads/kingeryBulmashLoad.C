/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "kingeryBulmashLoad.H"
#include "dictionaryCheck.H"
#include "MinMax.H"
#include "shellVector.H"

#include "FollowerPressure.hpp"
#include "KingeryBulmash.hpp"

namespace
{

//- Scaled distances of the nodes of the loaded elements
Foam::scalarMinMax distances
(
    const positionalShell::ShellModel& model,
    const std::string& elementSet,
    const positionalShell::KingeryBulmash& charge
)
{
    Foam::scalarMinMax range;
    for (const int e : model.mesh().elementSet(elementSet))
    {
        for (const int node : model.mesh().triangle(e))
        {
            range.add(charge.scaledDistance(model.mesh().nodes()[node]));
        }
    }
    return range;
}

} // End namespace


positionalShell::LoadPtr Foam::kingeryBulmashLoad
(
    const positionalShell::ShellModel& model,
    const dictionary& dict,
    const positionalShell::TimeFunctionPtr& factor
)
{
    using positionalShell::BlastTable;

    auto charge = std::make_shared<positionalShell::KingeryBulmash>();
    charge->mass = dict.get<scalar>("mass");
    charge->position = toShell(dict.get<vector>("position"));
    charge->burst =
        selectEntry(dict, "burst", {"freeAir", "surface"}) == 0
      ? BlastTable::Burst::freeAir : BlastTable::Burst::surface;
    charge->side = 2*selectEntry(dict, "face", {"lower", "upper"}) - 1;
    charge->pressure =
        dict.lookupOrDefault<scalar>("pressure", charge->pressure);
    charge->temperature =
        dict.lookupOrDefault<scalar>("temperature", charge->temperature);
    charge->check();

    const std::string elements
    (
        dict.lookupOrDefault<word>("elementSet", "all")
    );
    const auto load = std::make_shared<positionalShell::FollowerPressure>
    (
        model, elements, charge, factor, charge->side
    );
    const scalarMinMax Z(distances(model, elements, *charge));
    const BlastTable table(charge->burst);
    Info<< "Load " << dict.dictName() << ": " << charge->mass
        << " kg of TNT, Kingery-Bulmash" << nl
        << "    scaled distance " << Z.min() << " to " << Z.max()
        << " m/kg^(1/3); the fits hold from " << table.least() << " to "
        << table.greatest() << nl
        << "    positive phase only, no clearing from edges" << endl;
    return load;
}
