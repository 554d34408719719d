/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "convexBody.H"
#include "MinMaxOps.H"
#include "PstreamReduceOps.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;

namespace
{

//- Longest edge of a cut simplex over the body's radius
const Foam::scalar chord = 0.02;


//- Along the axis of a cylindrical line: between its empty sides
Foam::direction axialDirection(const Foam::feMesh& mesh)
{
    Foam::direction d = 0;
    while (mesh.poly().solutionD()[d] > 0)
    {
        ++d;
    }
    return d;
}

} // End namespace


Foam::convexBody::convexBody
(
    const shapes shape,
    const point& centre,
    const vector& axis,
    const scalar start,
    const scalar end
)
:
    shape_(shape),
    centre_(centre),
    axis_(axis),
    start_(start),
    end_(end)
{}


Foam::convexBody Foam::convexBody::Ball
(
    const point& centre,
    const scalar radius
)
{
    return convexBody(ball, centre, vector::zero, 0, radius);
}


Foam::convexBody Foam::convexBody::Cylinder
(
    const point& centre,
    const vector& axis,
    const scalar radius
)
{
    return convexBody(cylinder, centre, axis/mag(axis), 0, radius);
}


Foam::convexBody Foam::convexBody::Slab
(
    const point& centre,
    const vector& axis,
    const scalar start,
    const scalar end
)
{
    return convexBody(slab, centre, axis/mag(axis), start, end);
}


Foam::convexBody Foam::convexBody::round
(
    const feMesh& mesh,
    const point& centre,
    const scalar radius
)
{
    vector inScene(Zero);
    for (const direction d : mesh.axes())
    {
        inScene[d] = 1;
    }
    if (mesh.curvature())
    {
        const direction radial = mesh.axes()[mesh.radial()];
        vector offAxis(centre);
        if (mesh.dim() == 2)
        {
            offAxis[mesh.axes()[1 - mesh.radial()]] = 0;
        }
        else if (mesh.curvature() == 1)
        {
            offAxis[axialDirection(mesh)] = 0;
        }
        if (offAxis != vector::zero)
        {
            FatalErrorInFunction
                << "The centre " << centre << " is not on the axis of the "
                << "wedge: the body would be a ring" << nl
                << "    r is along " << vector::componentNames[radial]
                << exit(FatalError);
        }
        if (mesh.dim() == 1 && mesh.curvature() == 1)
        {
            vector axis(Zero);
            axis[axialDirection(mesh)] = 1;
            return Cylinder(centre, axis, radius);
        }
        return Ball(centre, radius);
    }
    switch (mesh.dim())
    {
        case 1:
            return Slab(centre, inScene, -radius, radius);
        case 2:
            return Cylinder(centre, vector::one - inScene, radius);
        default:
            return Ball(centre, radius);
    }
}


const char* Foam::convexBody::name() const
{
    const char* names[] = {"slab", "cylinder", "ball"};
    return names[shape_];
}


Foam::scalar Foam::convexBody::r(const point& x) const
{
    const vector d(x - centre_);
    switch (shape_)
    {
        case slab: return d & axis_;
        case cylinder: return mag(d - (d & axis_)*axis_);
        default: return mag(d);
    }
}


Foam::vector Foam::convexBody::along(const point& x) const
{
    if (shape_ == slab)
    {
        return axis_;
    }
    vector d(x - centre_);
    d -= (d & axis_)*axis_;
    return d/max(mag(d), VSMALL);
}


Foam::scalar Foam::convexBody::outside(const point& x) const
{
    const scalar s = r(x);
    return shape_ == slab ? max(s - end_, start_ - s) : s - end_;
}


Foam::scalar Foam::convexBody::resolution() const
{
    // A slab's sides are plane; the simplex must only not reach both
    return shape_ == slab ? 0.5*(end_ - start_) : chord*end_;
}


Foam::scalar Foam::convexBody::volume(const scalar across) const
{
    switch (shape_)
    {
        case slab: return (end_ - start_)*across;
        case cylinder: return pi*sqr(end_)*across;
        default: return 4.0/3.0*pi*pow3(end_)*across;
    }
}


Foam::scalar Foam::convexBody::across(const feMesh& mesh) const
{
    if (shape_ == ball)
    {
        return 1;
    }
    if (mesh.curvature() && mesh.dim() == 1)
    {
        return mesh.poly().bounds().span()[axialDirection(mesh)];
    }
    if (mesh.dim() < 3 && !mesh.curvature())
    {
        return mesh.depth();
    }

    return extent(mesh, centre_, axis_).mag();
}


Foam::scalar Foam::convexBody::sector(const feMesh& mesh) const
{
    // depth is the angle, for a cylinder on a line times its length
    switch (mesh.curvature())
    {
        case 0:
            return 1;
        case 1:
            return
                shape_ == slab ? 1
              : mesh.dim() == 2 ? mesh.depth()/(2*pi)
              : mesh.depth()/(2*pi*across(mesh));
        default:
            return mesh.depth()/(4*pi);
    }
}


Foam::MinMax<Foam::scalar> Foam::extent
(
    const feMesh& mesh,
    const point& centre,
    const vector& axis
)
{
    scalarMinMax range;
    for (const point& x : mesh.nodes())
    {
        range.add((x - centre) & axis);
    }
    reduce(range, minMaxOp<scalar>());
    return range;
}
