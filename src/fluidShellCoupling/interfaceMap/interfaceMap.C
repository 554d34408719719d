/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "interfaceMap.H"
#include "PstreamReduceOps.H"

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
    findSpheres(tolerance);

    std::vector<positionalShell::Projection> found(nodePositions.size());
    scalarList excesses(nodePositions.size());
    int hint = -1;
    forAll(nodePositions, i)
    {
        const point& node = nodePositions[i];
        found[i] = locator.locate(toEigen(node), hint);
        if (excess(found[i], tolerance) > 0)
        {
            found[i] = bodyOf(node, locator, found[i], tolerance);
        }
        excesses[i] = excess(found[i], tolerance);
        hint = found[i].point.element;
    }
    stopOff(nodePositions, excesses, found, tolerance);

    const positionalShell::Vector q = model.initialState().position;
    forAll(nodePositions, i)
    {
        points_[i] = found[i].point;
        initial_[i] = toFoam(map_.position(points_[i], q));
        worstOffset_ = max(worstOffset_, mag(initial_[i] - nodePositions[i]));
        largestXi3_ = max(largestXi3_, mag(points_[i].xi3));
    }
    reduce(worstOffset_, maxOp<scalar>());
    reduce(largestXi3_, maxOp<scalar>());
}


void Foam::interfaceMap::findSpheres(const scalar tolerance)
{
    const positionalShell::ShellMesh& mesh = model_.mesh();
    centres_.setSize(mesh.nElements(), Zero);
    radii_.setSize(mesh.nElements(), Zero);
    forAll(centres_, e)
    {
        const positionalShell::Triangle& nodes = mesh.triangle(e);
        for (const int node : nodes)
        {
            centres_[e] += toFoam(mesh.nodes()[node])/scalar(nodes.size());
        }
        for (const int node : nodes)
        {
            radii_[e] =
                max(radii_[e], mag(toFoam(mesh.nodes()[node]) - centres_[e]));
        }
        // A curved element bulges beyond its nodes by less than its size
        radii_[e] = 2*radii_[e] + (1 + tolerance)*model_.thickness(e);
    }
}


Foam::scalar Foam::interfaceMap::excess
(
    const positionalShell::Projection& p,
    const scalar tolerance
) const
{
    const scalar thickness = model_.thickness(p.point.element);
    return max
    (
        p.offset.norm()/thickness - tolerance,
        mag(p.point.xi3) - (1 + tolerance)
    );
}


positionalShell::Projection Foam::interfaceMap::bodyOf
(
    const point& node,
    const positionalShell::SurfaceLocator& locator,
    const positionalShell::Projection& nearest,
    const scalar tolerance
) const
{
    positionalShell::Projection best = nearest;
    forAll(centres_, e)
    {
        if (mag(node - centres_[e]) < radii_[e])
        {
            const positionalShell::Projection other =
                locator.project(toEigen(node), e);
            if (excess(other, tolerance) < excess(best, tolerance))
            {
                best = other;
            }
        }
    }
    return best;
}


void Foam::interfaceMap::stopOff
(
    const pointField& nodePositions,
    const UList<scalar>& excesses,
    const std::vector<positionalShell::Projection>& found,
    const scalar tolerance
) const
{
    label nOff = 0;
    label worst = -1;
    forAll(excesses, i)
    {
        if (!(excesses[i] <= 0))
        {
            ++nOff;
            worst = (worst < 0 || excesses[i] > excesses[worst] ? i : worst);
        }
    }
    const scalar here = (worst < 0 ? 0 : excesses[worst]);
    const bool isWorst =
        here > 0 && here == returnReduce(here, maxOp<scalar>());
    const label nAll = returnReduce(nodePositions.size(), sumOp<label>());
    reduce(nOff, sumOp<label>());
    if (nOff == 0)
    {
        return;
    }
    if (isWorst || !Pstream::parRun())
    {
        const positionalShell::SurfacePoint& p = found[worst].point;
        FatalErrorInFunction
            << nOff << " of " << nAll << " interface nodes are not on the "
            << "shell" << nl
            << "    Worst is the node at " << nodePositions[worst]
            << ": the nearest point of the shell, in element " << p.element
            << " of " << model_.section(p.element).elementSet.c_str()
            << ", is " << found[worst].offset.norm() << " m away, xi3 = "
            << p.xi3 << " (-1 and 1 are its faces)" << nl
            << "    The shell's thickness there is "
            << model_.thickness(p.element) << " m; mapTolerance allows "
            << tolerance << " thicknesses" << nl
            << "    Check the interface patches, the shell's mesh and its "
            << "thickness" << exit(FatalError);
    }

    // Wait to be ended by the process that has the worst
    returnReduce(true, andOp<bool>());
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
    if (Pstream::parRun())
    {
        List<scalar> all(label(generalised.size()));
        std::copy_n(generalised.data(), all.size(), all.begin());
        Pstream::listCombineGather(all, plusEqOp<scalar>());
        Pstream::listCombineScatter(all);
        std::copy_n(all.cbegin(), all.size(), generalised.data());
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
