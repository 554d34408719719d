/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "inverseDistanceOperator.H"
#include "treeOperator.H"
#include "boundBox.H"
#include "error.H"

namespace
{

using namespace Foam;

//- Everything divided by the size of the set-up, so that no power of a
//  distance over- or underflows; the strengths make up for it
struct scaledSetUp
{
    attractingPoints moving;
    attractingPoints fixed;
    List<slidingPoints> sliding;
    pointField targets;

    scaledSetUp
    (
        const attractingPoints& moving,
        const attractingPoints& fixed,
        const UList<slidingPoints>& sliding,
        const pointField& targets,
        const inverseDistanceSettings& settings
    )
    :
        moving(moving),
        fixed(fixed),
        sliding(sliding),
        targets(targets)
    {
        boundBox box(moving.positions, false);
        box.add(fixed.positions);
        for (const slidingPoints& s : sliding)
        {
            box.add(s.positions);
        }
        const point origin(box.midpoint());
        const scalar size = box.mag() > 0 ? box.mag() : 1;

        const auto scale = [&](pointField& p)
        {
            p -= origin;
            p /= size;
        };
        const scalar factor = Foam::pow
        (
            settings.referenceLength/size,
            settings.e2 - settings.e1
        );
        scale(this->moving.positions);
        scale(this->fixed.positions);
        scale(this->targets);
        this->fixed.strengths *= factor;
        for (slidingPoints& s : this->sliding)
        {
            scale(s.positions);
            s.strengths *= factor;
        }
    }
};

} // End namespace


Foam::autoPtr<Foam::inverseDistanceOperator> Foam::inverseDistanceOperator::New
(
    const label dim,
    const attractingPoints& moving,
    const attractingPoints& fixed,
    const pointField& targets,
    const inverseDistanceSettings& settings,
    const UList<slidingPoints>& sliding
)
{
    const scaledSetUp s(moving, fixed, sliding, targets, settings);

    const auto make = [&](auto dimensions)
    {
        return autoPtr<inverseDistanceOperator>
        (
            new treeOperator<decltype(dimensions)::value>
            (
                s.moving, s.fixed, s.sliding, s.targets, settings
            )
        );
    };
    switch (dim)
    {
        case 1: return make(std::integral_constant<int, 1>());
        case 2: return make(std::integral_constant<int, 2>());
        case 3: return make(std::integral_constant<int, 3>());
    }

    FatalErrorInFunction
        << "No inverse distance in " << dim << " dimensions"
        << abort(FatalError);
    return nullptr;
}
