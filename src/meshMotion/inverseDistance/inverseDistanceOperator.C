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
    pointField targets;

    scaledSetUp
    (
        const attractingPoints& moving,
        const attractingPoints& fixed,
        const pointField& targets,
        const inverseDistanceSettings& settings
    )
    :
        moving(moving),
        fixed(fixed),
        targets(targets)
    {
        boundBox box(moving.positions, false);
        box.add(fixed.positions);
        const point origin(box.midpoint());
        const scalar size = box.mag() > 0 ? box.mag() : 1;

        for
        (
            pointField* p :
            {&this->moving.positions, &this->fixed.positions, &this->targets}
        )
        {
            *p -= origin;
            *p /= size;
        }

        this->fixed.strengths *= Foam::pow
        (
            settings.referenceLength/size,
            settings.e2 - settings.e1
        );
    }
};

} // End namespace


Foam::autoPtr<Foam::inverseDistanceOperator> Foam::inverseDistanceOperator::New
(
    const label dim,
    const attractingPoints& moving,
    const attractingPoints& fixed,
    const pointField& targets,
    const inverseDistanceSettings& settings
)
{
    const scaledSetUp s(moving, fixed, targets, settings);

    switch (dim)
    {
        case 1:
            return autoPtr<inverseDistanceOperator>
            (
                new treeOperator<1>(s.moving, s.fixed, s.targets, settings)
            );

        case 2:
            return autoPtr<inverseDistanceOperator>
            (
                new treeOperator<2>(s.moving, s.fixed, s.targets, settings)
            );

        case 3:
            return autoPtr<inverseDistanceOperator>
            (
                new treeOperator<3>(s.moving, s.fixed, s.targets, settings)
            );
    }

    FatalErrorInFunction
        << "No inverse distance in " << dim << " dimensions"
        << abort(FatalError);
    return nullptr;
}
