// SPDX-License-Identifier: GPL-3.0-or-later

#include "ElementBatch.hpp"
#include "Material.hpp"
#include "SystemMatrix.hpp"

namespace positionalShell
{

namespace
{

bool processorHasAvx2()
{
    #if defined(__x86_64__) && defined(__GNUC__)
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    #else
    return false;
    #endif
}

ElasticMatrix ofLane(const StrainTransform& transform, int lane)
{
    ElasticMatrix T;
    for (int u = 0; u < 6; ++u)
    {
        for (int v = 0; v < 6; ++v) T(u, v) = transform.T[u][v].lane[lane];
    }
    return T;
}

Strain ofLane(const LaneValues* e, int lane)
{
    Strain strain;
    for (int u = 0; u < 6; ++u) strain[u] = e[u].lane[lane];
    return strain;
}

} // namespace

const BatchKernel& batchKernel(ElementForm form)
{
    static const bool fast = processorHasAvx2();
    const BatchKernel* avx2 = fast ? avx2Kernel(form) : nullptr;
    return avx2 ? *avx2 : baselineKernel(form);
}

void generalResponse
(
    const ElementBatch& batch,
    std::size_t point,
    const LaneValues* e,
    LaneValues* S,
    LaneValues* C
)
{
    for (int l = 0; l < lanes; ++l)
    {
        const ElasticMatrix T = ofLane(batch.transforms[point], l);
        const double w = batch.points[point].weight.lane[l];
        const Strain E = T*ofLane(e, l);
        const Stress s = w*(T.transpose()*batch.material->stress(E));
        for (int u = 0; u < 6; ++u) S[u].lane[l] = s[u];
        if (!C) continue;

        const ElasticMatrix c =
            w*(T.transpose()*batch.material->tangent(E)*T);
        int k = 0;
        for (int u = 0; u < 6; ++u)
        {
            for (int v = 0; v <= u; ++v) C[k++].lane[l] = c(u, v);
        }
    }
}

void generalEnergy
(
    const ElementBatch& batch,
    std::size_t point,
    const LaneValues* e,
    LaneValues& energy
)
{
    for (int l = 0; l < lanes; ++l)
    {
        const Strain E = ofLane(batch.transforms[point], l)*ofLane(e, l);
        energy.lane[l] = batch.points[point].weight.lane[l]
            *batch.material->energyDensity(E);
    }
}

void scatterBlock
(
    const ElementBatch& batch,
    int i,
    int j,
    const LaneValues* block,
    SystemMatrix& K
)
{
    constexpr int n = SparsityMap::entriesPerPair;
    double own[n];
    for (int l = 0; l < batch.nElements; ++l)
    {
        for (int k = 0; k < n; ++k) own[k] = block[k].lane[l];
        K.addSymmetricBlock(batch.elements[l], i, j, own);
    }
}

} // namespace positionalShell
