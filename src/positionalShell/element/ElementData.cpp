// SPDX-License-Identifier: GPL-3.0-or-later

#include "ElementData.hpp"
#include "AssumedInterpolation.hpp"
#include "BodyGeometry.hpp"
#include "SystemMatrix.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace positionalShell
{

namespace
{

std::string name(const ShellMesh& mesh, int element)
{
    const Vec3& x = mesh.nodes()[mesh.triangle(element).back()];
    return "element " + std::to_string(element) + " at ("
      + std::to_string(x[0]) + " " + std::to_string(x[1]) + " "
      + std::to_string(x[2]) + ")";
}

} // namespace

ElementData::ElementData
(
    const ShellMesh& mesh,
    const std::vector<Section>& sections,
    const std::vector<int>& sectionOfElement,
    int areaPoints,
    int thicknessPoints,
    ElementForm form
)
:
    mesh_(mesh),
    kernel_(batchKernel(form))
{
    for (const TrianglePoint& p : triangleRule(areaPoints))
    {
        rule_.area.push_back(areaPoint(p.xi1, p.xi2, p.weight));
    }
    rule_.thickness = gaussRule(thicknessPoints);
    if (form == ElementForm::assumedStrain)
    {
        rule_.assumed = assumedInterpolation(triangleRule(areaPoints));
    }

    const Vector q0 = mesh.initialPositions();
    for (std::size_t s = 0; s < sections.size(); ++s)
    {
        std::vector<int> elements;
        for (int e = 0; e < mesh.nElements(); ++e)
        {
            if (sectionOfElement[e] == int(s)) elements.push_back(e);
        }
        for (std::size_t first = 0; first < elements.size(); first += lanes)
        {
            const auto begin = elements.begin() + first;
            const auto end =
                elements.begin() + std::min(first + lanes, elements.size());
            addBatch(q0, sections[s], std::vector<int>(begin, end));
        }
    }
}

void ElementData::addBatch
(
    const Vector& q0,
    const Section& section,
    const std::vector<int>& elements
)
{
    ElementBatch batch;
    batch.material = section.material.get();
    batch.halfThickness = 0.5*section.thickness;
    batch.nElements = int(elements.size());
    for (int l = 0; l < lanes; ++l)
    {
        batch.elements[l] = elements[std::min(l, batch.nElements - 1)];
    }
    const std::size_t nPoints = rule_.area.size()*rule_.thickness.size();
    batch.points.resize(nPoints);
    if (!section.material->linear()) batch.transforms.resize(nPoints);
    for (int l = 0; l < lanes; ++l) setReference(q0, section, batch, l);
    if (kernel_.gap)
    {
        // By the kernel itself: the initial state is then free of strain to the bit
        ElementVector own;
        gather(batch, q0, own);
        std::vector<ReferenceGap> gaps(rule_.area.size());
        kernel_.gap(rule_, batch, own, gaps.data());
        batch.gaps = std::move(gaps);
    }
    batches_.push_back(std::move(batch));
}

void ElementData::setReference
(
    const Vector& q0,
    const Section& section,
    ElementBatch& batch,
    int lane
)
{
    const int element = batch.elements[lane];
    const Triangle& triangle = mesh_.triangle(element);
    const double c = batch.halfThickness;
    std::size_t k = 0;
    for (const AreaPoint& p : rule_.area)
    {
        for (double face : {-1.0, 1.0})
        {
            if (!(baseVectors(triangle, q0, c, p, face).determinant() > 0))
            {
                throw std::invalid_argument
                (
                    "shell model: the body of " + name(mesh_, element)
                  + " folds over on its concave face: the thickness "
                  + std::to_string(2*c) + " is too large for the curvature"
                );
            }
        }
        for (const LinePoint& z : rule_.thickness)
        {
            const Mat3 G = baseVectors(triangle, q0, c, p, z.xi);
            const double weight = p.weight*z.weight*G.determinant();
            ReferencePoint& point = batch.points[k];
            point.weight.lane[lane] = weight;
            for (int u = 0; u < 6; ++u)
            {
                point.metric[u].lane[lane] =
                    G.col(voigt[u][0]).dot(G.col(voigt[u][1]));
            }

            const Mat3 axes = materialAxes(G, section);
            if (axes.isZero())
            {
                throw std::invalid_argument
                (
                    "shell model: the axis of the material is normal to "
                  + name(mesh_, element)
                );
            }
            const ElasticMatrix T = strainTransform(G, axes);
            const ElasticMatrix C = weight
                *(T.transpose()*batch.material->tangent(Strain::Zero())*T);
            int entry = 0;
            for (int u = 0; u < 6; ++u)
            {
                for (int v = 0; v <= u; ++v)
                {
                    point.C[entry++].lane[lane] = C(u, v);
                }
                if (batch.transforms.empty()) continue;
                for (int v = 0; v < 6; ++v)
                {
                    batch.transforms[k].T[u][v].lane[lane] = T(u, v);
                }
            }
            ++k;
        }
    }
}

void ElementData::gather
(
    const ElementBatch& batch,
    const Vector& q,
    ElementVector& own
) const
{
    for (int l = 0; l < lanes; ++l)
    {
        const Triangle& triangle = mesh_.triangle(batch.elements[l]);
        for (int j = 0; j < nodesPerElement; ++j)
        {
            const double* node = q.data() + dofsPerNode*triangle[j];
            for (int c = 0; c < dofsPerNode; ++c)
            {
                own.x[dofsPerNode*j + c].lane[l] = node[c];
            }
        }
    }
}

double ElementData::energy(const Vector& q) const
{
    double sum = 0;
    ElementVector own;
    LaneValues energy;
    for (const ElementBatch& batch : batches_)
    {
        gather(batch, q, own);
        kernel_.energy(rule_, batch, own, energy);
        for (int l = 0; l < batch.nElements; ++l) sum += energy.lane[l];
    }
    return sum;
}

void ElementData::scatter
(
    const ElementBatch& batch,
    const ElementVector& force,
    Vector& f
) const
{
    for (int l = 0; l < batch.nElements; ++l)
    {
        const Triangle& triangle = mesh_.triangle(batch.elements[l]);
        for (int j = 0; j < nodesPerElement; ++j)
        {
            double* node = f.data() + dofsPerNode*triangle[j];
            for (int c = 0; c < dofsPerNode; ++c)
            {
                node[c] += force.x[dofsPerNode*j + c].lane[l];
            }
        }
    }
}

void ElementData::addForce(const Vector& q, Vector& f) const
{
    ElementVector own;
    ElementVector force;
    for (const ElementBatch& batch : batches_)
    {
        gather(batch, q, own);
        kernel_.force(rule_, batch, own, force);
        scatter(batch, force, f);
    }
}

void ElementData::addTangent(const Vector& q, SystemMatrix& K) const
{
    ElementVector own;
    for (const ElementBatch& batch : batches_)
    {
        gather(batch, q, own);
        kernel_.addTangent(rule_, batch, own, K);
    }
}

double ElementData::leastVolumeRatio(const Vector& q) const
{
    double least = std::numeric_limits<double>::max();
    for (const ElementBatch& batch : batches_)
    {
        for (int l = 0; l < batch.nElements; ++l)
        {
            const Triangle& triangle = mesh_.triangle(batch.elements[l]);
            std::size_t k = 0;
            for (const AreaPoint& p : rule_.area)
            {
                for (const LinePoint& z : rule_.thickness)
                {
                    const double reference =
                        batch.points[k++].weight.lane[l]/(p.weight*z.weight);
                    const Mat3 base = baseVectors
                    (
                        triangle, q, batch.halfThickness, p, z.xi
                    );
                    least = std::min(least, base.determinant()/reference);
                }
            }
        }
    }
    return least;
}

} // namespace positionalShell
