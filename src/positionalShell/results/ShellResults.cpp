// SPDX-License-Identifier: GPL-3.0-or-later

#include "ShellResults.hpp"
#include "CubicTriangle.hpp"

#include <Eigen/LU>

#include <cmath>
#include <stdexcept>

namespace positionalShell
{

namespace
{

constexpr double heights[3] = {-1, 0, 1};

//- Half the squares and products of base vectors, as twice-shear strains, (S7)
Strain halfMetric(const Mat3& a)
{
    Strain e;
    for (int v = 0; v < 6; ++v)
    {
        const int i = voigt[v][0];
        const int j = voigt[v][1];
        e[v] = (i == j ? 0.5 : 1)*a.col(i).dot(a.col(j));
    }
    return e;
}

Mat3 tensor(const SymmTensor& v, double shear = 1)
{
    Mat3 T;
    for (int k = 0; k < 6; ++k)
    {
        const int i = voigt[k][0];
        const int j = voigt[k][1];
        T(i, j) = T(j, i) = (i == j ? 1 : shear)*v[k];
    }
    return T;
}

SymmTensor components(const Mat3& T)
{
    SymmTensor v;
    for (int k = 0; k < 6; ++k) v[k] = T(voigt[k][0], voigt[k][1]);
    return v;
}

void add(const PointResult& part, double factor, PointResult& sum)
{
    for (int h = 0; h < 3; ++h)
    {
        sum.height[h].strain += factor*part.height[h].strain;
        sum.height[h].secondPiola += factor*part.height[h].secondPiola;
        sum.height[h].cauchy += factor*part.height[h].cauchy;
    }
    sum.section.N += factor*part.section.N;
    sum.section.M += factor*part.section.M;
    sum.section.Q += factor*part.section.Q;
    sum.axis1 += part.axis1;
    sum.axis3 += part.axis3;
}

} // namespace

double HeightResult::vonMises() const
{
    const auto s = cauchy.array();
    const double normal =
        (s[0] - s[1])*(s[0] - s[1]) + (s[1] - s[2])*(s[1] - s[2])
      + (s[2] - s[0])*(s[2] - s[0]);
    const double shear = s[3]*s[3] + s[4]*s[4] + s[5]*s[5];
    return std::sqrt(0.5*normal + 3*shear);
}

ShellResults::ShellResults(const ShellModel& model, ResultOptions options)
:
    model_(model),
    options_(options),
    initial_(model.mesh().initialPositions()),
    points_(model, options.foldAngle),
    fit_(strainFit(triangleRule(model.integration().areaPoints)))
{
    if (!(options_.axis.norm() > 0))
    {
        throw std::invalid_argument("results: the axis is zero");
    }
    for (const TrianglePoint& p : triangleRule(model.integration().areaPoints))
    {
        area_.push_back(areaPoint(p.xi1, p.xi2, p.weight));
    }
    for (int j = 0; j < nodesPerElement; ++j)
    {
        const Eigen::Vector2d& xi = CubicTriangle::nodePoints()[j];
        nodes_[j] = areaPoint(xi[0], xi[1], 0);
    }
}

std::vector<PointResult> ShellResults::at(const Vector& q) const
{
    const std::vector<Strain> gaps = model_.strainGaps(q);
    std::vector<PointResult> results(points_.size());
    for (int e = 0; e < model_.mesh().nElements(); ++e)
    {
        const ElementResults own = elementResults
        (
            e, q, gaps.empty() ? nullptr : &gaps[area_.size()*e]
        );
        const Triangle& points = points_.ofElement(e);
        for (int j = 0; j < nodesPerElement; ++j)
        {
            const int point = points[j];
            add(own[j], 1.0/points_.nElements(point), results[point]);
        }
    }
    for (PointResult& result : results)
    {
        result.axis1.normalize();
        result.axis3.normalize();
    }
    return results;
}

std::array<PointResult, nodesPerElement> ShellResults::ofElement
(
    int element,
    const Vector& q
) const
{
    const std::vector<Strain> gaps = model_.strainGaps(q);
    return elementResults
    (
        element, q, gaps.empty() ? nullptr : &gaps[area_.size()*element]
    );
}

ShellResults::ElementResults ShellResults::elementResults
(
    int element,
    const Vector& q,
    const Strain* gaps
) const
{
    ElementResults results;
    for (int h = 0; h < 3; ++h)
    {
        const NodeStrains e = nodeStrains(element, q, gaps, heights[h]);
        for (int j = 0; j < nodesPerElement; ++j)
        {
            results[j].height[h] =
                heightResult(element, j, q, e.row(j).transpose(), heights[h]);
        }
    }

    std::vector<NodeStrains> strains;
    for (const LinePoint& z : gaussRule(model_.integration().thicknessPoints))
    {
        strains.push_back(nodeStrains(element, q, gaps, z.xi));
    }
    for (int j = 0; j < nodesPerElement; ++j)
    {
        addSection(element, j, q, strains, results[j]);
    }
    return results;
}

ShellResults::NodeStrains ShellResults::nodeStrains
(
    int element,
    const Vector& q,
    const Strain* gaps,
    double zeta
) const
{
    const Triangle& triangle = model_.mesh().triangle(element);
    const double c = 0.5*model_.thickness(element);
    Eigen::Matrix<double, Eigen::Dynamic, 6> e(area_.size(), 6);
    for (std::size_t p = 0; p < area_.size(); ++p)
    {
        const Strain motion =
            halfMetric(baseVectors(triangle, q, c, area_[p], zeta))
          - halfMetric(baseVectors(triangle, initial_, c, area_[p], zeta));
        e.row(p) = gaps ? Strain(motion + gaps[p]) : motion;
    }
    return fit_*e;
}

//- (R2)-(R4)
HeightResult ShellResults::heightResult
(
    int element,
    int place,
    const Vector& q,
    const Strain& e,
    double zeta
) const
{
    const Triangle& triangle = model_.mesh().triangle(element);
    const Section& section = model_.section(element);
    const double c = 0.5*section.thickness;
    const Mat3 G = baseVectors(triangle, initial_, c, nodes_[place], zeta);
    const Mat3 axes = materialAxes(G, section);
    const Strain local = strainTransform(G, axes)*e;
    const Mat3 S = axes*tensor(section.material->stress(local))*axes.transpose();
    const Mat3 A =
        baseVectors(triangle, q, c, nodes_[place], zeta)*G.inverse();

    HeightResult result;
    result.strain = components(axes*tensor(local, 0.5)*axes.transpose());
    result.secondPiola = components(S);
    result.cauchy = components(A*S*A.transpose()/A.determinant());
    return result;
}

//- (R5)-(R8)
void ShellResults::addSection
(
    int element,
    int place,
    const Vector& q,
    const std::vector<NodeStrains>& strains,
    PointResult& result
) const
{
    const Triangle& triangle = model_.mesh().triangle(element);
    const Section& section = model_.section(element);
    const double c = 0.5*section.thickness;
    const AreaPoint& node = nodes_[place];
    const double a = q[fullIndex(triangle[place], Component::a)];
    const auto& rule = gaussRule(model_.integration().thicknessPoints);

    SectionSums sums;
    for (std::size_t z = 0; z < rule.size(); ++z)
    {
        const double zeta = rule[z].xi;
        const Mat3 G = baseVectors(triangle, initial_, c, node, zeta);
        const ElasticMatrix T = strainTransform(G, materialAxes(G, section));
        const Strain e = strains[z].row(place).transpose();
        const Stress S = T.transpose()*section.material->stress(T*e);
        sums.add
        (
            S,
            rule[z].weight*G.determinant(),
            baseVectors(triangle, q, c, node, zeta),
            c*(zeta + a*zeta*zeta)
        );
    }

    const Mat3 G = baseVectors(triangle, initial_, c, node, 0);
    const Mat3 now = baseVectors(triangle, q, c, node, 0);
    const Mat3 axes = sectionAxes(G, section, options_.axis);
    const Mat3 present = presentAxes(G, now, axes);
    result.section =
        sums.forces(G, axes, present, now.col(2).norm()/c);
    result.axis1 = present.col(0);
    result.axis3 = present.col(2);
}

} // namespace positionalShell
