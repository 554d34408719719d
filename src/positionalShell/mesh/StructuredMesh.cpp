// SPDX-License-Identifier: GPL-3.0-or-later

#include "StructuredMesh.hpp"
#include "CubicTriangle.hpp"

#include <array>
#include <map>
#include <stdexcept>
#include <utility>

namespace positionalShell
{

namespace
{

//- Place of a node: thirds of a quadrilateral along v, sixths along u, since the
//  triangles at a pole have a node at half its width
using Place = std::pair<int, int>;

constexpr int perU = 6;
constexpr int perV = 3;

//- Numbers the places that triangles ask for, v by v, u running fastest
class Lattice
{
public:

    explicit Lattice(const StructuredLayout& layout)
    :
        layout_(layout),
        lastU_(perU*(static_cast<int>(layout.u.size()) - 1)),
        lastV_(perV*(static_cast<int>(layout.v.size()) - 1))
    {}

    int nU() const { return lastU_/perU; }
    int nV() const { return lastV_/perV; }
    int lastU() const { return lastU_; }
    int lastV() const { return lastV_; }

    //- The place that stands for all places at the same point; (j, i)
    Place unique(int i, int j) const
    {
        const bool pole = (j == 0 && layout_.poleVMin)
            || (j == lastV_ && layout_.poleVMax);
        if (pole || (layout_.closedU && i == lastU_)) i = 0;
        return {j, i};
    }

    void add(const std::array<Place, nodesPerElement>& places)
    {
        triangles_.push_back(places);
        for (const Place& place : places) numbers_[place] = 0;
    }

    void number()
    {
        int n = 0;
        for (auto& [place, node] : numbers_) node = n++;
    }

    int node(const Place& place) const { return numbers_.at(place); }

    const std::map<Place, int>& numbers() const { return numbers_; }

    double u(int i) const { return between(layout_.u, i, perU); }
    double v(int j) const { return between(layout_.v, j, perV); }

    std::vector<Triangle> triangles() const
    {
        std::vector<Triangle> result;
        for (const auto& places : triangles_)
        {
            Triangle t;
            for (int k = 0; k < nodesPerElement; ++k) t[k] = node(places[k]);
            result.push_back(t);
        }
        return result;
    }

private:

    const StructuredLayout& layout_;
    int lastU_;
    int lastV_;
    std::map<Place, int> numbers_;
    std::vector<std::array<Place, nodesPerElement>> triangles_;

    static double between(const std::vector<double>& lines, int i, int per)
    {
        const int cell = i/per;
        if (i % per == 0) return lines[cell];
        return lines[cell] + (lines[cell + 1] - lines[cell])*(i % per)/per;
    }
};

//- The two triangles of the quadrilateral with lower corner (i0, j0): the second
//  is the first turned by half a turn
void addPair(Lattice& lattice, int i0, int j0)
{
    std::array<Place, nodesPerElement> lower;
    std::array<Place, nodesPerElement> upper;
    const auto& places = CubicTriangle::nodePoints();
    for (int k = 0; k < nodesPerElement; ++k)
    {
        const int di = 2*static_cast<int>(3*places[k][0] + 0.5);
        const int dj = static_cast<int>(3*places[k][1] + 0.5);
        lower[k] = lattice.unique(i0 + di, j0 + dj);
        upper[k] = lattice.unique(i0 + perU - di, j0 + perV - dj);
    }
    lattice.add(lower);
    lattice.add(upper);
}

//- The triangle of the quadrilateral whose side v = v0 is the pole; the other
//  side is j = j0 + away
void addAtPole(Lattice& lattice, int i0, int pole, int away)
{
    // From the pole along one side, across, and back: anticlockwise in (u, v)
    const int first = away > 0 ? i0 + perU : i0;
    const int last = away > 0 ? i0 : i0 + perU;
    const int step = (last - first)/3;
    const int third = away/3;
    const auto at = [&](int i, int thirds)
    {
        return lattice.unique(i, pole + thirds*third);
    };
    lattice.add
    ({
        at(first, 0), at(first, 3), at(last, 3), at(first, 1), at(first, 2),
        at(first + step, 3), at(last - step, 3), at(last, 2), at(last, 1),
        at((first + last)/2, 2)
    });
}

NamedSets edgeSets(const Lattice& lattice)
{
    NamedSets sets;
    const int lastU = lattice.lastU();
    const int lastV = lattice.lastV();
    const auto node = [&](int i, int j)
    {
        return lattice.node(lattice.unique(i, j));
    };
    for (int j = 0; j <= lastV; ++j)
    {
        sets["uMin"].push_back(node(0, j));
        sets["uMax"].push_back(node(lastU, j));
    }
    for (int i = 0; i <= lastU; i += perU/3)
    {
        sets["vMin"].push_back(node(i, 0));
        sets["vMax"].push_back(node(i, lastV));
    }
    sets["uMinVMin"] = {node(0, 0)};
    sets["uMaxVMin"] = {node(lastU, 0)};
    sets["uMinVMax"] = {node(0, lastV)};
    sets["uMaxVMax"] = {node(lastU, lastV)};
    return sets;
}

void checkLines(const std::vector<double>& lines, const char* name)
{
    bool valid = lines.size() > 1 && lines.front() == 0 && lines.back() == 1;
    for (std::size_t i = 1; valid && i < lines.size(); ++i)
    {
        valid = lines[i] > lines[i - 1];
    }
    if (!valid)
    {
        throw std::invalid_argument
        (
            std::string("structured mesh: the lines of ") + name
          + " do not ascend from 0 to 1"
        );
    }
}

void check(const StructuredLayout& layout)
{
    checkLines(layout.u, "u");
    checkLines(layout.v, "v");
    if (layout.closedU && layout.u.size() < 4)
    {
        throw std::invalid_argument
        (
            "structured mesh: a surface that is closed along u needs 3 "
            "quadrilaterals round it at least"
        );
    }
    if (layout.poleVMin && layout.poleVMax && layout.v.size() < 3)
    {
        throw std::invalid_argument
        (
            "structured mesh: a surface from pole to pole needs 2 "
            "quadrilaterals along v at least"
        );
    }
}

std::vector<double> evenLines(int n, const char* name)
{
    if (n < 1)
    {
        throw std::invalid_argument
        (
            "structured mesh: " + std::to_string(n) + " quadrilaterals along "
          + name + "; there must be at least 1"
        );
    }
    std::vector<double> lines(n + 1);
    for (int i = 0; i <= n; ++i) lines[i] = double(i)/n;
    return lines;
}

} // namespace

StructuredLayout StructuredLayout::even(int nU, int nV)
{
    StructuredLayout layout;
    layout.u = evenLines(nU, "u");
    layout.v = evenLines(nV, "v");
    return layout;
}

ShellMesh structuredMesh
(
    const StructuredLayout& layout,
    const SurfaceMap& position,
    const SurfaceMap& normal
)
{
    check(layout);
    Lattice lattice(layout);
    for (int j = 0; j < lattice.nV(); ++j)
    {
        for (int i = 0; i < lattice.nU(); ++i)
        {
            const bool first = j == 0 && layout.poleVMin;
            const bool last = j == lattice.nV() - 1 && layout.poleVMax;
            if (first) addAtPole(lattice, perU*i, 0, perV);
            else if (last) addAtPole(lattice, perU*i, lattice.lastV(), -perV);
            else addPair(lattice, perU*i, perV*j);
        }
    }
    lattice.number();

    std::vector<Vec3> nodes;
    std::vector<Vec3> directors;
    for (const auto& [place, node] : lattice.numbers())
    {
        const double u = lattice.u(place.second);
        const double v = lattice.v(place.first);
        nodes.push_back(position(u, v));
        if (normal) directors.push_back(normal(u, v));
    }
    return ShellMesh
    (
        std::move(nodes), lattice.triangles(), edgeSets(lattice), {},
        std::move(directors)
    );
}

ShellMesh structuredMesh
(
    int nU,
    int nV,
    const SurfaceMap& position,
    const SurfaceMap& normal
)
{
    return structuredMesh(StructuredLayout::even(nU, nV), position, normal);
}

ShellMesh rectangleMesh
(
    int nU,
    int nV,
    const Vec3& origin,
    const Vec3& sideU,
    const Vec3& sideV
)
{
    return structuredMesh
    (
        nU, nV,
        [&](double u, double v) -> Vec3 { return origin + u*sideU + v*sideV; }
    );
}

} // namespace positionalShell
