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

    PressureHistory at(const Vec3&, const Vec3&) const override
    {
        const double pressure = pressure_;
        return [pressure](double) { return pressure; };
    }

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
    const PressureFieldPtr& pressure,
    TimeFunctionPtr factor,
    double face
)
:
    elements_(model.mesh().elementSet(elementSet)),
    factor_(std::move(factor)),
    face_(face),
    lastTime_(0)
{
    for (int e : elements_)
    {
        const Triangle& triangle = model.mesh().triangle(e);
        for (const BasisPoint& p : basisPoints())
        {
            Vec3 X = Vec3::Zero();
            Eigen::Matrix<double, 3, 2> dX = Eigen::Matrix<double, 3, 2>::Zero();
            for (int j = 0; j < nodesPerElement; ++j)
            {
                const Vec3& node = model.mesh().nodes()[triangle[j]];
                X += p.N[j]*node;
                dX += node*p.dN.row(j);
            }
            const Vec3 normal = dX.col(0).cross(dX.col(1)).normalized();
            places_.push_back(pressure->at(X, normal));
        }
    }
}

const std::vector<double>& FollowerPressure::pressures(double time) const
{
    if (last_.empty() || time != lastTime_)
    {
        const double factor = factor_->value(time);
        last_.clear();
        for (const PressureHistory& pressure : places_)
        {
            last_.push_back(factor*pressure(time));
        }
        lastTime_ = time;
    }
    return last_;
}

void FollowerPressure::addForce
(
    const ShellModel& model,
    const Vector& q,
    double time,
    Vector& force
) const
{
    const std::vector<BasisPoint>& basis = basisPoints();
    const double* pressure = pressures(time).data();
    for (std::size_t k = 0; k < elements_.size(); ++k)
    {
        const Triangle& triangle = model.mesh().triangle(elements_[k]);
        const double arm = 0.5*model.thickness(elements_[k])*face_;
        const Surface surface(triangle, q, arm);
        Eigen::Matrix<double, 3, nodesPerElement> f;
        f.setZero();
        for (std::size_t i = 0; i < basis.size(); ++i)
        {
            const BasisPoint& p = basis[i];
            const double weight = *pressure++*p.weight;
            const Vec3 y1 = surface.y*p.dN.col(0);
            const Vec3 y2 = surface.y*p.dN.col(1);
            f -= (weight*y1.cross(y2))*p.N.transpose();
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
    const std::vector<BasisPoint>& basis = basisPoints();
    const double* pressure = pressures(time).data();
    for (std::size_t k = 0; k < elements_.size(); ++k)
    {
        const int e = elements_[k];
        const double arm = 0.5*model.thickness(e)*face_;
        const Surface surface(model.mesh().triangle(e), q, arm);

        // Minus df_i/dy_j, (S27)
        NodeBlocks D;
        for (auto& row : D) row.fill(Mat3::Zero());
        for (std::size_t l = 0; l < basis.size(); ++l)
        {
            const BasisPoint& p = basis[l];
            const double weight = factor**pressure++*p.weight;
            const Mat3 y1 = skew(surface.y*p.dN.col(0));
            const Mat3 y2 = skew(surface.y*p.dN.col(1));
            for (int j = 0; j < nodesPerElement; ++j)
            {
                const Mat3 dArea =
                    weight*(p.dN(j, 1)*y1 - p.dN(j, 0)*y2);
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
