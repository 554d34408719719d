// SPDX-License-Identifier: GPL-3.0-or-later
//
// Supports and ties of a shell, by node sets. They combine in any order:
//
//     DofMap dofs = Constraints(mesh).clamped("root").planeStrainStrip(Axis::z)
//         .dofMap();
//
// The thickness-strain rate a is never fixed by a clamp: fixing it makes the
// edge too stiff with an error of the order of the element size (theory page,
// section on clamped edges).
//
// Conflict (a moving and a fixed condition, or two different motions, on the
// same unknown): std::invalid_argument naming node and component.

#ifndef positionalShell_Constraints_hpp
#define positionalShell_Constraints_hpp

#include "DofMap.hpp"
#include "RigidMotion.hpp"
#include "ShellMesh.hpp"

#include <string>
#include <vector>

namespace positionalShell
{

class Constraints
{
public:

    //- The mesh must live as long as this object; the DofMap does not need it
    explicit Constraints(const ShellMesh& mesh);

    //- Position and director fixed, a free
    Constraints& clamped(const std::string& nodeSet);

    //- Position fixed, director and a free
    Constraints& hinged(const std::string& nodeSet);

    //- Position and director stay in the plane with this normal
    Constraints& symmetryPlane(const std::string& nodeSet, Axis normal);

    //- Single components fixed at their initial values
    Constraints& fixed
    (
        const std::string& nodeSet,
        const std::vector<Component>& components
    );

    //- Displacement of a component from its initial value as a function of time
    Constraints& prescribed
    (
        const std::string& nodeSet,
        Component component,
        TimeFunctionPtr displacement
    );

    //- All nodes of the set share the increment of the component
    Constraints& tied(const std::string& nodeSet, Component component);

    //- Exact plane strain across a strip of any width, (S21): position and
    //  director along the direction are fixed, and nodes at the same place of
    //  the plane share their other unknowns. Throws when a node has no partner
    //  in that sense, i.e. when the mesh is not made of lines along the direction.
    Constraints& planeStrainStrip(Axis direction);

    //- The set moves as one rigid body, free as a whole, (C1). Its nodes may be
    //  in no other condition but those on a. point (initial state): where a
    //  TieLoad acts.
    Constraints& rigidTie(const std::string& nodeSet, const Vec3& point);

    //- The set moves as one rigid body with the point, as given, (C9)
    Constraints& rigidMotion(const std::string& nodeSet, const RigidMotion& motion);

    DofMap dofMap() const;

private:

    struct Motion
    {
        bool isSet = false;
        TimeFunctionPtr displacement;   // null: fixed
    };

    const ShellMesh& mesh_;
    std::vector<Motion> motion_;
    mutable std::vector<int> parent_;   // union-find forest of shared unknowns
    std::vector<RigidTie> ties_;

    int root(int unknown) const;
    void share(int unknown1, int unknown2);
    void set(int node, Component c, const TimeFunctionPtr& displacement);
    void checkTies() const;
    [[noreturn]] void conflict(int unknown) const;
};

} // namespace positionalShell

#endif
