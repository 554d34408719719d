// SPDX-License-Identifier: GPL-3.0-or-later

#include "ElementData.hpp"

namespace positionalShell
{

namespace
{

//- The six numbers of the mid-surface (AssumedStrain.hpp) as covariant strains, (A2)
Strain covariant(const ReferenceGap& gap, int lane)
{
    const auto v = [&](int k) { return gap.v[k].lane[lane]; };
    Strain e;
    e << v(0), v(2), v(5), v(0) + v(2) - v(1), v(4), v(3);
    return e;
}

} // namespace

std::vector<Strain> ElementData::strainGaps(const Vector& q) const
{
    if (!kernel_.gap) return {};

    const std::size_t nArea = rule_.area.size();
    std::vector<Strain> result(nArea*mesh_.nElements());
    std::vector<ReferenceGap> gaps(nArea);
    ElementVector own;
    for (const ElementBatch& batch : batches_)
    {
        gather(batch, q, own);
        kernel_.gap(rule_, batch, own, gaps.data());
        for (int l = 0; l < batch.nElements; ++l)
        {
            for (std::size_t p = 0; p < nArea; ++p)
            {
                result[nArea*batch.elements[l] + p] = covariant(gaps[p], l);
            }
        }
    }
    return result;
}

} // namespace positionalShell
