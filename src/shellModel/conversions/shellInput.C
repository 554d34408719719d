/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellInput.H"
#include "vector.H"
#include "wordList.H"
#include "ListOps.H"

static Foam::label axisOf(const Foam::vector& v)
{
    using namespace Foam;

    label axis = -1;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        if (v[d] != 0)
        {
            if (axis >= 0) return -1;
            axis = d;
        }
    }
    return axis;
}


positionalShell::Axis Foam::readAxis
(
    const dictionary& dict,
    const word& keyword
)
{
    const vector v(dict.get<vector>(keyword));
    const label axis = axisOf(v);

    if (axis < 0)
    {
        FatalIOErrorInFunction(dict)
            << keyword << " " << v << " is not along a coordinate axis" << nl
            << "    Valid directions are (1 0 0), (0 1 0) and (0 0 1)" << nl
            << exit(FatalIOError);
    }
    return static_cast<positionalShell::Axis>(axis);
}


positionalShell::Component Foam::readComponent
(
    const dictionary& dict,
    const word& name
)
{
    wordList valid(label(positionalShell::dofsPerNode));
    forAll(valid, i)
    {
        const auto component = static_cast<positionalShell::Component>(i);
        valid[i] = positionalShell::componentName(component);

        if (valid[i] == name)
        {
            return component;
        }
    }

    FatalIOErrorInFunction(dict)
        << "Unknown component " << name << nl
        << "    Valid components are " << flatOutput(valid) << nl
        << exit(FatalIOError);

    return positionalShell::Component::x;
}
