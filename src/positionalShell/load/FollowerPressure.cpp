// SPDX-License-Identifier: GPL-3.0-or-later

#include "FollowerPressure.hpp"
#include "CubicTriangle.hpp"
#include "Quadrature.hpp"

#include <Eigen/Geometry>

#include <array>

namespace positionalShell
{

namespace
{

using Mat3 = Eigen::Matrix3d;

//- Basis at the points of a rule that integrates (S26) exactly: degree 3 + 2 + 2
struct BasisPoint
{
    double weight;
    CubicTriangle::Values N;
    CubicTriangle::Gradients dN;
};

const std::vector<BasisPoint>& basisPoints()
{
    static const std::vector<BasisPoint> all = []
    {
        std::vector<BasisPoint> made;
        for (const TrianglePoint& p : triangleRuleOfDegree(7))
        {
            made.push_back
            ({
                p.weight,
                CubicTriangle::values(p.xi1, p.xi2),
                CubicTriangle::gradients(p.xi1, p.xi2)
            });
        }
        return made;
    }();
    return all;
}

//- The loaded surface of an element: y_j = x_j + arm*g_j
struct Surface
{
    Eigen::Matrix<double, 3, nodesPerElement> y;

    Surface(const Triangle& triangle, const Vector& q, double arm)
    {
        for (int j = 0; j < nodesPerElement; ++j)
        {
            const auto node = q.segment<6>(dofsPerNode*triangle[j]);
            y.col(j) = node.head<3>() + arm*node.tail<3>();
        }
    }
};

//- The same everywhere
class UniformPressure : public PressureField
{
public:

    explicit UniformPressure(double pressure) : pressure_(pressure) {}

    double value(const Vec3&, double) const override { return pressure_; }

private:

    double pressure_;
};

Mat3 skew(const Vec3& v)
{
    Mat3 S;
    S << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
    return S;
}

} // namespace

FollowerPressure::FollowerPressure
(
    const ShellModel& model,
    const std::string& elementSet,
    double pressure,
    TimeFunctionPtr factor,
    double face
)
:
    FollowerPressure
    (
        model, elementSet, std::make_shared<UniformPressure>(pressure),
        std::move(factor), face
    )
{}

FollowerPressure::FollowerPressure
(
    const ShellModel& model,
    const std::string& elementSet,
    PressureFieldPtr pressure,
    TimeFunctionPtr factor,
    double face
)
:
    elements_(model.mesh().elementSet(elementSet)),
    pressure_(std::move(pressure)),
    factor_(std::move(factor)),
    face_(face)
{}

std::vector<double> FollowerPressure::pressures
(
    const ShellModel& model,
    int element,
    double time
) const
{
    const double factor = factor_->value(time);
    const Triangle& triangle = model.mesh().triangle(element);
    std::vector<double> values;
    for (const BasisPoint& p : basisPoints())
    {
        Vec3 X = Vec3::Zero();
        for (int j = 0; j < nodesPerElement; ++j)
        {
            X += p.N[j]*model.mesh().nodes()[triangle[j]];
        }
        values.push_back(factor*pressure_->value(X, time));
    }
    return values;
}

void FollowerPressure::addForce
(
    const ShellModel& model,
    const Vector& q,
    double time,
    Vector& force
) const
{
    for (int e : elements_)
    {
        const Triangle& triangle = model.mesh().triangle(e);
        const double arm = 0.5*model.thickness(e)*face_;
        const Surface surface(triangle, q, arm);
        Eigen::Matrix<double, 3, nodesPerElement> f;
        f.setZero();
        const std::vector<double> pressure = pressures(model, e, time);
        for (std::size_t k = 0; k < pressure.size(); ++k)
        {
            const BasisPoint& p = basisPoints()[k];
            const Vec3 y1 = surface.y*p.dN.col(0);
            const Vec3 y2 = surface.y*p.dN.col(1);
            f -= (pressure[k]*p.weight*y1.cross(y2))*p.N.transpose();
        }
        for (int j = 0; j < nodesPerElement; ++j)
        {
            auto node = force.segment<6>(dofsPerNode*triangle[j]);
            node.head<3>() += f.col(j);
            node.tail<3>() += arm*f.col(j);
        }
    }
}

void FollowerPressure::addTangent
(
    const ShellModel& model,
    const Vector& q,
    double time,
    double factor,
    SystemMatrix& K
) const
{
    for (int e : elements_)
    {
        const double arm = 0.5*model.thickness(e)*face_;
        const Surface surface(model.mesh().triangle(e), q, arm);

        // Minus df_i/dy_j, (S27)
        NodeBlocks D;
        for (auto& row : D) row.fill(Mat3::Zero());
        const std::vector<double> pressure = pressures(model, e, time);
        for (std::size_t k = 0; k < pressure.size(); ++k)
        {
            const BasisPoint& p = basisPoints()[k];
            const Mat3 y1 = skew(surface.y*p.dN.col(0));
            const Mat3 y2 = skew(surface.y*p.dN.col(1));
            for (int j = 0; j < nodesPerElement; ++j)
            {
                const Mat3 dArea = (factor*pressure[k]*p.weight)
                    *(p.dN(j, 1)*y1 - p.dN(j, 0)*y2);
                for (int i = 0; i < nodesPerElement; ++i)
                {
                    D[i][j] += p.N[i]*dArea;
                }
            }
        }
        addBlocks(e, arm, D, K);
    }
}

void FollowerPressure::addBlocks
(
    int element,
    double arm,
    const NodeBlocks& D,
    SystemMatrix& K
)
{
    const int nParts = arm == 0 ? 1 : 2;
    const double lever[2] = {1, arm};
    for (int i = 0; i < nodesPerElement; ++i)
    {
        for (int j = 0; j < nodesPerElement; ++j)
        {
            for (int part = 0; part < 9*nParts*nParts; ++part)
            {
                const int r = part%3;
                const int c = part/3%3;
                const int onDirectorRow = part/9%nParts;
                const int onDirectorColumn = part/9/nParts;
                K.addGeneralEntry
                (
                    element,
                    dofsPerNode*i + 3*onDirectorRow + r,
                    dofsPerNode*j + 3*onDirectorColumn + c,
                    lever[onDirectorRow]*lever[onDirectorColumn]*D[i][j](r, c)
                );
            }
        }
    }
}

} // namespace positionalShell
