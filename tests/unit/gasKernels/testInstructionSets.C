/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// All instruction sets that this processor has give the same but for rounding

#include "kernelScene.H"

#include <gtest/gtest.h>

using namespace kernelTest;

template<class Dim>
class InstructionSets
:
    public testing::Test
{};

using dims = testing::Types
<
    std::integral_constant<int, 1>,
    std::integral_constant<int, 2>,
    std::integral_constant<int, 3>
>;
TYPED_TEST_SUITE(InstructionSets, dims);


namespace
{

//- Of the nodes; what stands in the rows after them does not matter
void expectSame
(
    const int nNodes,
    const std::vector<double>& a,
    const std::vector<double>& b,
    const std::string& what
)
{
    double size = 0, difference = 0;
    for (int i = 0; i < rowSize*nNodes; ++i)
    {
        size = std::max(size, std::abs(a[i]));
        difference = std::max(difference, std::abs(a[i] - b[i]));
    }
    EXPECT_GT(size, 0) << what;
    EXPECT_LE(difference, 1e-11*size) << what;
}

} // End namespace


TYPED_TEST(InstructionSets, agree)
{
    constexpr int dim = TypeParam::value;
    const auto sets = gasKernel::gasKernels<dim>::available();
    ASSERT_GE(sets.size(), 1u);
    EXPECT_STREQ
    (
        sets.back().name, gasKernel::gasKernels<dim>::best().name
    );

    const scene<dim> s(150, 1.5, 0.5, 3);
    const stepResult reference = step(s, sets.front(), 0.8);
    for (const auto& set : sets)
    {
        const stepResult r = step(s, set, 0.8);
        const std::string name(set.name);
        EXPECT_EQ(r.unphysicalLow, reference.unphysicalLow);
        EXPECT_NEAR(r.deltaT/reference.deltaT, 1, 1e-13);
        expectSame(s.nNodes, reference.rate, r.rate, name + " rate");
        expectSame
        (
            s.nNodes, reference.difference, r.difference, name + " difference"
        );
        expectSame(s.nNodes, reference.low, r.low, name + " low");
        expectSame(s.nNodes, reference.sum, r.sum, name + " sum");
    }
}
