// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motion of points attached to the shell, and its transpose for forces, (S28):
//
//     x = N_j x_j + h0/2 xi3 N_j g_j
//
// The thickness-strain term of (S2) is left out: the map is linear in q, so a
// force applied at the point and its generalised force do the same work, and carry
// the same force and moment, to round-off whatever the motion.

#ifndef positionalShell_MotionMap_hpp
#define positionalShell_MotionMap_hpp

#include "ShellModel.hpp"

namespace positionalShell
{

//- Point of the shell body: element, parametric coordinates, and place through
//  the thickness (-1 lower face, +1 upper face; larger values are allowed and
//  mean points carried along off the body)
struct SurfacePoint
{
    int element = -1;
    double xi1 = 0;
    double xi2 = 0;
    double xi3 = 0;
};

class MotionMap
{
public:

    //- The model must live as long as the map
    explicit MotionMap(const ShellModel& model) : model_(model) {}

    Vec3 position(const SurfacePoint& p, const Vector& q) const;
    Vec3 velocity(const SurfacePoint& p, const Vector& dqdt) const;

    //- generalisedForce += transpose of the map applied to the force
    void addForce
    (
        const SurfacePoint& p,
        const Vec3& force,
        Vector& generalisedForce
    ) const;

    //- Unit normal of the surface xi3 = const in state q, upper side
    Vec3 normal(const SurfacePoint& p, const Vector& q) const;

private:

    const ShellModel& model_;

    Vec3 combine(const SurfacePoint& p, const Vector& full) const;
};

} // namespace positionalShell

#endif
