/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "meshDump.H"
#include "feMesh.H"

#include <algorithm>
#include <cstdio>
#include <fstream>

namespace
{

using namespace Foam;

//- Some number that depends on the labels and their order
double someNumber(const std::vector<long>& labels)
{
    double x = 0.1;
    for (const long l : labels)
    {
        x = std::fmod(37.17*x + 0.618*l + 0.3, 1.0);
    }
    return x + 0.01;
}

std::string exact(const double x)
{
    char text[64];
    std::snprintf(text, sizeof(text), "%a", x);
    return text;
}

double number(std::istream& is)
{
    std::string text;
    is >> text;
    return std::strtod(text.c_str(), nullptr);
}

void addNodes(const feMesh& mesh, meshDump& dump)
{
    // Three numbers per node, of which two are reduced
    const label n = mesh.nNodes(), stride = mesh.dim() + 1;
    std::vector<double> sums(3*n, 0.0), least(n, Pstream::myProcNo());
    std::vector<double> greatest(least);
    for (label s = 0; s < mesh.nSimplices(); ++s)
    {
        std::vector<long> labels;
        for (label a = 0; a < stride; ++a)
        {
            labels.push_back(mesh.globalNode()[mesh.simplices()[stride*s + a]]);
        }
        std::sort(labels.begin(), labels.end());
        dump.simplices.insert(labels);
        for (label a = 0; a < stride; ++a)
        {
            double* sum = &sums[3*mesh.simplices()[stride*s + a]];
            sum[0] += someNumber(labels);
            sum[1] += 1e6*someNumber(labels);
            sum[2] += 1;
        }
    }
    mesh.exchange().sum(sums.data(), 3, 2);
    mesh.exchange().min(least.data(), 1, 1);
    mesh.exchange().max(greatest.data(), 1, 1);
    for (label i = 0; i < n; ++i)
    {
        dump.nodes[mesh.globalNode()[i]] =
        {
            {sums[3*i], sums[3*i + 1]}, least[i], greatest[i],
            mesh.exchange().owned(i)
        };
    }
}

void addEdges(const feMesh& mesh, meshDump& dump)
{
    const label perSimplex = mesh.dim()*(mesh.dim() + 1)/2;
    std::vector<double> sums(2*mesh.nEdges(), 0.0);
    forAll(mesh.simplexEdges(), i)
    {
        const label edgei = mesh.simplexEdges()[i];
        std::vector<long> labels;
        for (label a = 0; a <= mesh.dim(); ++a)
        {
            const label s = i/perSimplex;
            labels.push_back
            (
                mesh.globalNode()[mesh.simplices()[(mesh.dim() + 1)*s + a]]
            );
        }
        std::sort(labels.begin(), labels.end());
        sums[2*edgei] += 1;

        // From the first to the second node of this processor's edge
        sums[2*edgei + 1] += mesh.edgeSense(edgei)*someNumber(labels);
    }
    for (label edgei = 0; edgei < mesh.nEdges(); ++edgei)
    {
        sums[2*edgei + 1] *= mesh.edgeSense(edgei);
    }
    mesh.edgeExchange().sum(sums.data(), 2, 2);

    forAll(mesh.edges(), edgei)
    {
        const long a = mesh.globalNode()[mesh.edges()[edgei][0]];
        const long b = mesh.globalNode()[mesh.edges()[edgei][1]];
        dump.edges[{std::min(a, b), std::max(a, b)}] =
        {
            sums[2*edgei], sums[2*edgei + 1], mesh.edgeExchange().owned(edgei)
        };
    }
}

} // End namespace


Foam::meshDump Foam::dumpOf(const feMesh& mesh)
{
    meshDump dump;
    addNodes(mesh, dump);
    addEdges(mesh, dump);
    for (const fePatch& patch : mesh.patches())
    {
        std::set<long>& nodes = dump.patchNodes[patch.name];
        for (const labelList* list : {&patch.nodes, &patch.remoteNodes})
        {
            for (const label nodei : *list)
            {
                nodes.insert(mesh.globalNode()[nodei]);
            }
        }
    }
    return dump;
}


void Foam::meshDump::write(const fileName& name) const
{
    std::ofstream os(name);
    for (const auto& n : nodes)
    {
        os  << "node " << n.first << " " << exact(n.second.sum[0]) << " "
            << exact(n.second.sum[1]) << " " << n.second.least << " "
            << n.second.greatest << " " << n.second.owned << "\n";
    }
    for (const auto& e : edges)
    {
        os  << "edge " << e.first.first << " " << e.first.second << " "
            << exact(e.second.nSimplices) << " " << exact(e.second.directed)
            << " " << e.second.owned << "\n";
    }
    for (const auto& s : simplices)
    {
        os  << "simplex " << s.size();
        for (const long l : s)
        {
            os  << " " << l;
        }
        os  << "\n";
    }
    for (const auto& p : patchNodes)
    {
        for (const long l : p.second)
        {
            os  << "patch " << p.first << " " << l << "\n";
        }
    }
    os  << "end\n";
}


Foam::meshDump Foam::meshDump::read(const fileName& name)
{
    std::ifstream is(name);
    meshDump dump;
    std::string what;
    while (is >> what && what != "end")
    {
        if (what == "node")
        {
            long l;
            is >> l;
            nodeData& n = dump.nodes[l];
            n.sum[0] = number(is);
            n.sum[1] = number(is);
            is >> n.least >> n.greatest >> n.owned;
        }
        else if (what == "edge")
        {
            std::pair<long, long> key;
            is >> key.first >> key.second;
            edgeData& e = dump.edges[key];
            e.nSimplices = number(is);
            e.directed = number(is);
            is >> e.owned;
        }
        else if (what == "simplex")
        {
            size_t n;
            is >> n;
            std::vector<long> labels(n);
            for (long& l : labels)
            {
                is >> l;
            }
            dump.simplices.insert(labels);
        }
        else
        {
            std::string patch;
            long l;
            is >> patch >> l;
            dump.patchNodes[patch].insert(l);
        }
    }
    if (what != "end")
    {
        FatalErrorInFunction
            << name << " is not complete" << exit(FatalError);
    }
    return dump;
}
