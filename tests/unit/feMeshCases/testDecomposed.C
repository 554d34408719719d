/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// A decomposed mesh is the undecomposed one: nodes, simplices, edges, sums

#include "blockCase.H"
#include "meshDump.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- A mesh, its decomposition, and a name for the test's report
struct decomposedScene
{
    const char* name;
    std::string blockMeshDict;

    //- Parts in x, y and z, or scotch
    const char* division;
    int nProcs;
};

void PrintTo(const decomposedScene& s, std::ostream* os) { *os << s.name; }

decomposedScene scene
(
    const char* name,
    const blockDict& dict,
    const char* division,
    const int nProcs
)
{
    return {name, dict.text(), division, nProcs};
}

class Decomposed
:
    public testing::TestWithParam<decomposedScene>
{
protected:

    const decomposedScene& scene = GetParam();
    blockCase blocks{scene.blockMeshDict};

    meshDump dump(const int nProcs, const int i) const
    {
        return meshDump::read
        (
            blocks.folder.path()/"dump." + std::to_string(nProcs) + "."
          + std::to_string(i)
        );
    }

    //- Dumps of all processors, after one of the undecomposed mesh
    std::vector<meshDump> dumps() const
    {
        blocks.folder.writeDict
        (
            "system/decomposeParDict",
            "numberOfSubdomains " + std::to_string(scene.nProcs) + "; method "
          + (
                std::string(scene.division) == "scotch" ? "scotch;"
              : "hierarchical; coeffs { order xyz; n ("
              + std::string(scene.division) + "); }"
            )
        );
        const std::string self =
            std::string(std::getenv("SHOCKSHELL_APPBIN"))
          + "/tests/feMeshCases -dump" + blocks.onCase();
        std::vector<meshDump> result;
        if
        (
            blocks.run(self) && blocks.run("decomposePar" + blocks.onCase())
         && blocks.run
            (
                "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
                "mpirun --oversubscribe -np " + std::to_string(scene.nProcs)
              + " " + self + " -parallel"
            )
        )
        {
            result.push_back(dump(1, 0));
            for (int i = 0; i < scene.nProcs; ++i)
            {
                result.push_back(dump(scene.nProcs, i));
            }
        }
        return result;
    }
};


void expectSameNodes(const std::vector<meshDump>& dumps)
{
    const meshDump& serial = dumps[0];
    std::map<long, meshDump::nodeData> seen;
    std::map<long, int> owners;
    std::map<long, std::pair<double, double>> holders;
    for (size_t p = 1; p < dumps.size(); ++p)
    {
        for (const auto& n : dumps[p].nodes)
        {
            ASSERT_TRUE(serial.nodes.count(n.first)) << n.first;
            const auto& exact = serial.nodes.at(n.first).sum;
            EXPECT_NEAR(n.second.sum[0], exact[0], 1e-14*exact[0]);
            EXPECT_NEAR(n.second.sum[1], exact[1], 1e-14*exact[1]);
            owners[n.first] += n.second.owned;
            holders.insert({n.first, {p - 1, p - 1}});
            holders[n.first].second = p - 1;

            // Bitwise the same on all processors
            const auto first = seen.insert(n).first;
            EXPECT_EQ(first->second.sum, n.second.sum);
        }
    }
    EXPECT_EQ(seen.size(), serial.nodes.size());
    for (const auto& n : owners)
    {
        EXPECT_EQ(n.second, 1) << "owners of node " << n.first;
        EXPECT_EQ(seen[n.first].least, holders[n.first].first);
        EXPECT_EQ(seen[n.first].greatest, holders[n.first].second);
    }
}


void expectSameEdges(const std::vector<meshDump>& dumps)
{
    const meshDump& serial = dumps[0];
    std::map<std::pair<long, long>, meshDump::edgeData> seen;
    std::map<std::pair<long, long>, int> owners;
    for (size_t p = 1; p < dumps.size(); ++p)
    {
        for (const auto& e : dumps[p].edges)
        {
            ASSERT_TRUE(serial.edges.count(e.first));
            const auto& exact = serial.edges.at(e.first);
            EXPECT_EQ(e.second.nSimplices, exact.nSimplices);
            EXPECT_NEAR
            (
                e.second.directed, exact.directed,
                1e-14*std::abs(exact.directed)
            );
            const auto first = seen.insert(e).first;
            EXPECT_EQ(first->second.directed, e.second.directed);
            owners[e.first] += e.second.owned;
        }
    }
    EXPECT_EQ(seen.size(), serial.edges.size());
    for (const auto& e : owners)
    {
        EXPECT_EQ(e.second, 1);
    }
}

} // End namespace


TEST_P(Decomposed, isTheUndecomposedMesh)
{
    const std::vector<meshDump> all = dumps();
    ASSERT_EQ(int(all.size()), scene.nProcs + 1);
    expectSameNodes(all);
    expectSameEdges(all);

    std::multiset<std::vector<long>> simplices;
    for (size_t p = 1; p < all.size(); ++p)
    {
        simplices.insert(all[p].simplices.begin(), all[p].simplices.end());
        for (const auto& patch : all[p].patchNodes)
        {
            // Of the patch's nodes, all those that this processor holds
            std::set<long> here;
            for (const long l : all[0].patchNodes.at(patch.first))
            {
                if (all[p].nodes.count(l))
                {
                    here.insert(l);
                }
            }
            EXPECT_EQ(patch.second, here) << patch.first << " " << p;
        }
    }
    EXPECT_EQ(simplices, all[0].simplices);
}


INSTANTIATE_TEST_SUITE_P
(
    Scenes, Decomposed, testing::Values
    (
        scene("line", boxDict("9 1 1", {"patch", "empty", "empty"}),
            "2 1 1", 2),
        scene("plane", boxDict("7 6 1", {"patch", "patch", "empty"}),
            "2 2 1", 4),
        scene("space", boxDict("5 4 3", {"patch", "patch", "patch"}),
            "2 2 1", 4),
        scene("periodicLine", boxDict("5 1 1", {"cyclic", "empty", "empty"}),
            "2 1 1", 2),
        scene("periodicPlane", boxDict("6 4 1", {"cyclic", "cyclic", "empty"}),
            "2 2 1", 4),
        scene("periodicTwo", boxDict("4 4 2", {"cyclic", "patch", "cyclic"}),
            "2 1 1", 2),
        scene("periodicThree", boxDict("5 4 4", {"cyclic", "cyclic", "cyclic"}),
            "4 1 1", 4),
        scene("scotch", boxDict("6 5 4", {"patch", "patch", "patch"}),
            "scotch", 4),
        scene("periodicScotch", boxDict("6 5 4", {"cyclic", "patch", "cyclic"}),
            "scotch", 3),
        scene("wedge", wedgeDict("8 4 1", 0.1), "2 2 1", 4),
        scene("periodicWedge", wedgeDict("8 4 1", 0.1, 0, "cyclic"),
            "2 2 1", 4),
        scene("cylinder", wedgeDict("1 8 1", 0.1, 2, "empty"), "2 1 1", 2),
        scene("sphere", pyramidDict("9 1 1", 0.1, 0.15), "2 1 1", 2)
    ),
    [](const auto& info) { return std::string(info.param.name); }
);
