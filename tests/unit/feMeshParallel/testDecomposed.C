/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// A decomposed mesh is the undecomposed one: nodes, simplices, edges, sums

#include "meshDump.H"
#include "testFolder.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- A block mesh, its decomposition, and a name for the test's report
struct decomposedScene
{
    const char* name;

    //- Cells, and what divides them
    const char* cells;
    const char* division;
    int nProcs;

    //- Types of the sides in x, y, z
    const char* sides[3];
};

void PrintTo(const decomposedScene& s, std::ostream* os) { *os << s.name; }

std::string side(const char* name, const char* other, const char* type,
    const char* face)
{
    std::string text(std::string(name) + " { type " + type + "; faces (("
        + face + ")); ");
    if (std::string(type) == "cyclic")
    {
        text += std::string("neighbourPatch ") + other + "; ";
    }
    return text + "}\n";
}

class Decomposed
:
    public testing::TestWithParam<decomposedScene>
{
protected:

    testFolder folder;
    const decomposedScene& scene = GetParam();

    void write() const
    {
        const auto& s = scene.sides;
        folder.writeDict
        (
            "system/blockMeshDict",
            std::string("scale 1; vertices ((0 0 0) (1.1 0 0) (1.1 1 0)"
            " (0 1 0) (0 0 1) (1.1 0 1) (1.1 1 1) (0 1 1));"
            " blocks (hex (0 1 2 3 4 5 6 7) (") + scene.cells
            + ") simpleGrading (3 1 0.5)); edges (); boundary (\n"
            + side("left", "right", s[0], "0 4 7 3")
            + side("right", "left", s[0], "1 2 6 5")
            + side("bottom", "top", s[1], "0 1 5 4")
            + side("top", "bottom", s[1], "3 7 6 2")
            + side("back", "front", s[2], "0 3 2 1")
            + side("front", "back", s[2], "4 5 6 7") + ");"
        );
        folder.writeDict("system/fvSchemes", "");
        folder.writeDict("system/fvSolution", "");
        folder.writeDict
        (
            "system/decomposeParDict",
            "numberOfSubdomains " + std::to_string(scene.nProcs)
            + "; method hierarchical; coeffs { n (" + scene.division
            + "); order xyz; }"
        );
    }

    int run(const std::string& command) const
    {
        const std::string log = folder.path() + "/log";
        const int status =
            std::system((command + " > " + log + " 2>&1").c_str());
        if (status)
        {
            std::ifstream is(log);
            ADD_FAILURE() << command << "\n"
                << std::string(std::istreambuf_iterator<char>(is), {});
        }
        return status;
    }

    //- Dumps of all processors, after one of the undecomposed mesh
    std::vector<meshDump> dumps() const
    {
        const std::string onCase = " -case " + folder.path();
        const std::string self =
            std::string(std::getenv("SHOCKSHELL_APPBIN"))
          + "/tests/feMeshParallel -dump" + onCase;
        write();
        std::vector<meshDump> result;
        if
        (
            run("blockMesh" + onCase) || run(self)
         || run("decomposePar" + onCase)
         || run
            (
                "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
                "mpirun --oversubscribe -np " + std::to_string(scene.nProcs)
              + " " + self + " -parallel"
            )
        )
        {
            return result;
        }
        result.push_back(meshDump::read(folder.path()/"dump.1.0"));
        for (int i = 0; i < scene.nProcs; ++i)
        {
            const std::string name =
                "dump." + std::to_string(scene.nProcs) + "."
              + std::to_string(i);
            result.push_back(meshDump::read(folder.path()/name));
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
        decomposedScene{"line", "9 1 1", "2 1 1", 2,
            {"patch", "empty", "empty"}},
        decomposedScene{"plane", "7 6 1", "2 2 1", 4,
            {"patch", "patch", "empty"}},
        decomposedScene{"space", "5 4 3", "2 2 1", 4,
            {"patch", "patch", "patch"}},
        decomposedScene{"periodicLine", "5 1 1", "2 1 1", 2,
            {"cyclic", "empty", "empty"}},
        decomposedScene{"periodicPlane", "6 4 1", "2 2 1", 4,
            {"cyclic", "cyclic", "empty"}},
        decomposedScene{"periodicTwo", "4 4 2", "2 1 1", 2,
            {"cyclic", "patch", "cyclic"}},
        decomposedScene{"periodicThree", "5 4 4", "4 1 1", 4,
            {"cyclic", "cyclic", "cyclic"}}
    ),
    [](const auto& info) { return std::string(info.param.name); }
);
