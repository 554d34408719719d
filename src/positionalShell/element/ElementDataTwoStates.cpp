// SPDX-License-Identifier: GPL-3.0-or-later

#include "ElementData.hpp"
#include "SystemMatrix.hpp"

namespace positionalShell
{

void ElementData::addExtrapolatedTangent
(
    const StressPrediction& stress,
    const Vector& q,
    SystemMatrix& K
) const
{
    ElementVector own[3];
    for (const ElementBatch& batch : batches_)
    {
        gather(batch, stress.before, own[0]);
        gather(batch, stress.after, own[1]);
        gather(batch, q, own[2]);
        kernel_.addExtrapolatedTangent
        (
            rule_, batch, own[0], own[1], own[2], K
        );
    }
}

void ElementData::addConservingForce
(
    const Vector& start,
    const Vector& end,
    Vector& f
) const
{
    ElementVector own[2];
    ElementVector force;
    for (const ElementBatch& batch : batches_)
    {
        gather(batch, start, own[0]);
        gather(batch, end, own[1]);
        kernel_.conservingForce(rule_, batch, own[0], own[1], force);
        scatter(batch, force, f);
    }
}

void ElementData::addConservingTangent
(
    const StressPrediction& endStress,
    const Vector& start,
    const Vector& end,
    SystemMatrix& K
) const
{
    ElementVector own[4];
    for (const ElementBatch& batch : batches_)
    {
        gather(batch, start, own[0]);
        gather(batch, endStress.before, own[1]);
        gather(batch, endStress.after, own[2]);
        gather(batch, end, own[3]);
        kernel_.addConservingTangent
        (
            rule_, batch, own[0], own[1], own[2], own[3], K
        );
    }
}

} // namespace positionalShell
