// SPDX-License-Identifier: GPL-3.0-or-later

#include "RigidMotion.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <stdexcept>

namespace positionalShell
{

namespace
{

//- u s(t) + p sin(phi) + v (1 - cos(phi)), one component of (C9)
class RigidComponent : public TimeFunction
{
public:

    RigidComponent
    (
        double u, TimeFunctionPtr s, double p, double v, TimeFunctionPtr phi
    )
    :
        u_(u), s_(std::move(s)), p_(p), v_(v), phi_(std::move(phi))
    {}

    double value(double t) const override
    {
        const double a = phi_->value(t);
        return u_*s_->value(t) + p_*std::sin(a) + v_*(1 - std::cos(a));
    }

    double firstDerivative(double t) const override
    {
        return u_*s_->firstDerivative(t) + phi_->firstDerivative(t)*slope(t);
    }

    double secondDerivative(double t) const override
    {
        const double a = phi_->value(t);
        const double rate = phi_->firstDerivative(t);
        return u_*s_->secondDerivative(t)
            + phi_->secondDerivative(t)*slope(t)
            + rate*rate*(v_*std::cos(a) - p_*std::sin(a));
    }

private:

    double u_;
    TimeFunctionPtr s_;
    double p_;
    double v_;
    TimeFunctionPtr phi_;

    double slope(double t) const
    {
        const double a = phi_->value(t);
        return p_*std::cos(a) + v_*std::sin(a);
    }
};

TimeFunctionPtr orZero(const TimeFunctionPtr& function)
{
    return function ? function : constant(0);
}

TimeFunctionPtr component
(
    const RigidMotion& motion,
    const Vec3& direction,
    const Vec3& arm,
    int c
)
{
    if (!(motion.axis.norm() > 0))
    {
        throw std::invalid_argument("rigid motion: the axis is zero");
    }
    const Vec3 n = motion.axis.normalized();
    const Vec3 across = n.cross(arm);
    return std::make_shared<RigidComponent>
    (
        direction[c], orZero(motion.displacement),
        across[c], n.cross(across)[c], orZero(motion.angle)
    );
}

} // namespace

TimeFunctionPtr RigidMotion::ofPosition(const Vec3& arm, int c) const
{
    return component(*this, direction, arm, c);
}

TimeFunctionPtr RigidMotion::ofDirector(const Vec3& director, int c) const
{
    return component(*this, Vec3::Zero(), director, c);
}

} // namespace positionalShell
