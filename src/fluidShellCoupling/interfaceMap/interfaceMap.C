/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "interfaceMap.H"

#include <Eigen/Geometry>

namespace
{

Foam::vector toFoam(const positionalShell::Vec3& v)
{
    return Foam::vector(v[0], v[1], v[2]);
}

positionalShell::Vec3 toEigen(const Foam::vector& v)
{
    return positionalShell::Vec3(v.x(), v.y(), v.z());
}

} // End namespace


Foam::interfaceMap::interfaceMap
(
    const positionalShell::ShellModel& model,
    const pointField& nodePositions,
    const scalar tolerance
)
:
    model_(model),
    map_(model),
    points_(nodePositions.size()),
    initial_(nodePositions.size()),
    worstOffset_(0),
    largestXi3_(0)
{
    const positionalShell::SurfaceLocator locator(model);
    const positionalShell::Vector q = model.initialState().position;
    int hint = -1;

    forAll(nodePositions, i)
    {
        const positionalShell::Projection p =
            locator.locate(toEigen(nodePositions[i]), hint);
        hint = p.point.element;
        points_[i] = p.point;
        initial_[i] = toFoam(map_.position(p.point, q));

        const scalar thickness = model.thickness(p.point.element);
        const scalar offset = mag(initial_[i] - nodePositions[i]);
        if (offset > tolerance*thickness || mag(p.point.xi3) > 1 + tolerance)
        {
            FatalErrorInFunction
                << "The interface node at " << nodePositions[i]
                << " is not on the shell:" << nl
                << "    the nearest point of the shell is " << offset
                << " m away, xi3 = " << p.point.xi3
                << " (-1 and 1 are its faces)" << nl
                << "    The shell's thickness there is " << thickness
                << " m; mapTolerance allows " << tolerance
                << " thicknesses" << nl
                << "    Check the interface patches, the shell's mesh and its "
                << "thickness" << exit(FatalError);
        }
        worstOffset_ = max(worstOffset_, offset);
        largestXi3_ = max(largestXi3_, mag(p.point.xi3));
    }
}


Foam::tmp<Foam::vectorField> Foam::interfaceMap::displacement
(
    const positionalShell::Vector& q
) const
{
    auto tvalues = tmp<vectorField>::New(size());
    vectorField& values = tvalues.ref();
    forAll(values, i)
    {
        values[i] = toFoam(map_.position(points_[i], q)) - initial_[i];
    }
    return tvalues;
}


Foam::tmp<Foam::vectorField> Foam::interfaceMap::velocity
(
    const positionalShell::Vector& dqdt
) const
{
    auto tvalues = tmp<vectorField>::New(size());
    vectorField& values = tvalues.ref();
    forAll(values, i)
    {
        values[i] = toFoam(map_.velocity(points_[i], dqdt));
    }
    return tvalues;
}


positionalShell::Vector Foam::interfaceMap::generalisedForce
(
    const vectorField& forces
) const
{
    positionalShell::Vector generalised =
        positionalShell::Vector::Zero(model_.dofs().nFull());
    forAll(forces, i)
    {
        map_.addForce(points_[i], toEigen(forces[i]), generalised);
    }
    return generalised;
}


Foam::vector Foam::interfaceMap::resultant
(
    const positionalShell::Vector& force
)
{
    vector sum(Zero);
    for (int i = 0; i < force.size(); i += positionalShell::dofsPerNode)
    {
        sum += vector(force[i], force[i + 1], force[i + 2]);
    }
    return sum;
}


Foam::vector Foam::interfaceMap::moment
(
    const positionalShell::Vector& force,
    const positionalShell::Vector& q
)
{
    positionalShell::Vec3 sum = positionalShell::Vec3::Zero();
    for (int i = 0; i < force.size(); i += positionalShell::dofsPerNode)
    {
        sum += q.segment<3>(i).cross(force.segment<3>(i));
        sum += q.segment<3>(i + 3).cross(force.segment<3>(i + 3));
    }
    return toFoam(sum);
}
