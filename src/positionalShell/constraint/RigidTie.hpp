// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nodes that move as one rigid body with a point: positions about their centre (the
// mean of the nodes) and directors are turned by one finite rotation, (C1). Thickness
// strains stay free. Holds geometry only; TieElimination takes it into the equations.

#ifndef positionalShell_RigidTie_hpp
#define positionalShell_RigidTie_hpp

#include "ShellMesh.hpp"

#include <string>
#include <vector>

namespace positionalShell
{

//- What acts on a tie: a force at its centre plus arm, and a moment fixed in space
struct TieForce
{
    int tie = 0;
    Vec3 force = Vec3::Zero();
    Vec3 arm = Vec3::Zero();
    Vec3 moment = Vec3::Zero();

    Vec3 momentAboutCentre() const;
};

class RigidTie
{
public:

    using Mat3 = Eigen::Matrix3d;

    //- Translation of the centre and rotation vector; or force and moment about the
    //  centre
    struct Six
    {
        Vec3 linear = Vec3::Zero();
        Vec3 angular = Vec3::Zero();
    };

    //- point: in the initial state. Throws std::invalid_argument for a set whose
    //  positions and directors do not define a rotation (a single node).
    RigidTie(const ShellMesh& mesh, const std::string& nodeSet, const Vec3& point);

    const std::string& nodeSet() const { return nodeSet_; }
    const std::vector<int>& nodes() const { return nodes_; }

    // In a state, full vector of positions

        Vec3 centre(const Vector& q) const;

        //- Rotation since the initial state, (C2)
        Mat3 rotation(const Vector& q) const;

        //- Place of the point
        Vec3 point(const Vector& q) const;

        //- Resultant of a full force vector over the nodes, about the centre, (C4)
        Six resultant(const Vector& q, const Vector& force) const;

        //- Forces on the nodes with this resultant, added to a full vector, (C7)
        void spread(const Vector& q, const Six& force, Vector& full) const;

        //- Rigid motion next to a full vector of rates or small increments, (C8)
        Six rigidPart(const Vector& q, const Vector& rate) const;

        //- Positions after a motion of the centre and a rotation, (C3): the entries
        //  of the nodes of q become those of before, moved
        void move(const Vector& before, const Six& motion, Vector& q) const;

        //- Accelerations that belong to rigid velocities alone: omega x v
        void addCentripetal(const Vector& velocity, const Vec3& omega, Vector& a) const;

private:

    std::string nodeSet_;
    std::vector<int> nodes_;
    Vec3 point_;                // from the centre, initial
    Vector initial_;            // full vector

    //- Square of the length that makes directors count as positions in fits
    double weight_;

    //- Sum of squares of arms and directors as a tensor of inertia
    Mat3 inertia(const Vector& q) const;
};

} // namespace positionalShell

#endif
