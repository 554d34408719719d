/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "closestPointLoads.H"
#include "CubicTriangle.hpp"
#include "Quadrature.hpp"
#include "PstreamReduceOps.H"
#include "triPointRef.H"

#include <Eigen/Geometry>

namespace
{

//- A place in the directions that the scene has
Foam::point inScene(const Foam::feMesh& mesh, const Foam::point& x)
{
    Foam::point result(Foam::Zero);
    for (const Foam::direction d : mesh.axes())
    {
        result[d] = x[d];
    }
    return result;
}

Foam::point toFoam(const positionalShell::Vec3& v)
{
    return Foam::point(v[0], v[1], v[2]);
}

} // End namespace


Foam::closestPointLoads::closestPointLoads
(
    const positionalShell::ShellModel& model,
    const feMesh& mesh,
    const interfaceNodes& nodes,
    const pointField& places,
    const scalar tolerance
)
:
    model_(model),
    nCorners_(mesh.axes().size()),
    nWetted_(0)
{
    find(facets(mesh, nodes, places), mesh, tolerance);

    scalarField wetted(model.mesh().nNodes(), Zero);
    for (const source& s : sources_)
    {
        wetted[s.shellNode] = 1;
    }
    Pstream::listCombineGather(wetted, maxEqOp<scalar>());
    Pstream::listCombineScatter(wetted);
    nWetted_ = label(sum(wetted));
}


std::vector<Foam::closestPointLoads::facet> Foam::closestPointLoads::facets
(
    const feMesh& mesh,
    const interfaceNodes& nodes,
    const pointField& places
) const
{
    std::vector<facet> result;
    for (const fePatch* patch : nodes.patches())
    {
        forAll(patch->facetSimplex, i)
        {
            facet f;
            point centre(Zero);
            for (label b = 0; b < nCorners_; ++b)
            {
                f.nodes[b] = patch->facets[nCorners_*i + b];
                f.corners[b] = inScene(mesh, places[f.nodes[b]]);
                centre += f.corners[b]/nCorners_;
            }

            // From the opposite node, across the facet
            const label opposite = mesh.simplices()
            [
                (nCorners_ + 1)*patch->facetSimplex[i] + patch->opposite[i]
            ];
            vector n = centre - inScene(mesh, places[opposite]);
            vector along[2] = {Zero, Zero};
            for (label b = 1; b < nCorners_; ++b)
            {
                vector& e = along[b - 1];
                e = f.corners[b] - f.corners[0];
                e -= (b == 2 ? (e & along[0])*along[0] : vector(Zero));
                e /= mag(e);
                n -= (n & e)*e;
            }
            f.normal = n/mag(n);
            result.push_back(f);
        }
    }
    return result;
}


Foam::scalarField Foam::closestPointLoads::thickness() const
{
    const positionalShell::ShellMesh& mesh = model_.mesh();
    scalarField h(mesh.nNodes(), Zero);
    for (label e = 0; e < mesh.nElements(); ++e)
    {
        for (const int node : mesh.triangle(e))
        {
            h[node] = max(h[node], scalar(model_.thickness(e)));
        }
    }
    return h;
}


Foam::scalar Foam::closestPointLoads::closest
(
    const facet& f,
    const point& x,
    scalar* weights
) const
{
    weights[0] = 1;
    if (nCorners_ == 2)
    {
        const vector e = f.corners[1] - f.corners[0];
        weights[1] =
            min(max(((x - f.corners[0]) & e)/magSqr(e), scalar(0)), scalar(1));
        weights[0] = 1 - weights[1];
    }
    else if (nCorners_ == 3)
    {
        const triPointRef t(f.corners[0], f.corners[1], f.corners[2]);
        barycentric2D where;
        t.pointToBarycentric(t.nearestPoint(x).rawPoint(), where);
        for (label b = 0; b < 3; ++b)
        {
            weights[b] = where[b];
        }
    }
    vector way(-x);
    for (label b = 0; b < nCorners_; ++b)
    {
        way += weights[b]*f.corners[b];
    }
    return mag(way);
}


void Foam::closestPointLoads::find
(
    const std::vector<facet>& facets,
    const feMesh& mesh,
    const scalar tolerance
)
{
    // Nearer to the shell's normal than to its surface
    const scalar onFace = std::sqrt(0.5);

    const scalarField h(thickness());
    const positionalShell::Vector q = model_.initialState().position;
    const label n = model_.mesh().nNodes();
    List<source> candidates(2*n);
    scalarList distances(2*n, GREAT);
    forAll(distances, i)
    {
        const label k = i/2;
        const scalar sign = (i % 2 ? -1 : 1);
        const label at = positionalShell::dofsPerNode*k;
        const point x = inScene(mesh, toFoam(q.segment<3>(at)));
        const vector normal =
            sign*toFoam(q.segment<3>(at + 3).normalized());
        for (const facet& f : facets)
        {
            // The gas's outward normal points into the shell
            if ((f.normal & normal) < -onFace)
            {
                source s{k, sign, {}, {}};
                std::copy_n(f.nodes, nCorners_, s.nodes);
                const scalar d = closest(f, x, s.weights);
                if (d < distances[i])
                {
                    distances[i] = d;
                    candidates[i] = s;
                }
            }
        }
    }

    // The process with the closest point has the node, of equal ones the first
    scalarList least(distances);
    Pstream::listCombineGather(least, minEqOp<scalar>());
    Pstream::listCombineScatter(least);
    labelList teller(2*n, labelMax);
    forAll(least, i)
    {
        const bool near = least[i] <= (0.5 + tolerance)*h[i/2];
        if (near && distances[i] == least[i])
        {
            teller[i] = Pstream::myProcNo();
        }
    }
    Pstream::listCombineGather(teller, minEqOp<label>());
    Pstream::listCombineScatter(teller);
    forAll(teller, i)
    {
        if (teller[i] == Pstream::myProcNo())
        {
            sources_.push_back(candidates[i]);
        }
    }
}


Foam::scalarField Foam::closestPointLoads::pressures
(
    const taylorGalerkinGas& gas,
    const scalar pRef
) const
{
    scalarField p(model_.mesh().nNodes(), Zero);
    for (const source& s : sources_)
    {
        for (label b = 0; b < nCorners_; ++b)
        {
            p[s.shellNode] +=
                s.sign*s.weights[b]*(gas.acoustics(s.nodes[b]).p - pRef);
        }
    }
    Pstream::listCombineGather(p, plusEqOp<scalar>());
    Pstream::listCombineScatter(p);
    return p;
}


positionalShell::Vector Foam::closestPointLoads::generalisedForce
(
    const scalarField& pressures,
    const positionalShell::Vector& q
) const
{
    using namespace positionalShell;

    // Exact for a cubic pressure: 3 + 3 + 2 + 2
    static const std::vector<TrianglePoint> rule(triangleRuleOfDegree(10));
    positionalShell::Vector force =
        positionalShell::Vector::Zero(model_.dofs().nFull());
    for (label e = 0; e < model_.mesh().nElements(); ++e)
    {
        const Triangle& nodes = model_.mesh().triangle(e);
        for (const TrianglePoint& point : rule)
        {
            const auto N = CubicTriangle::values(point.xi1, point.xi2);
            const auto dN = CubicTriangle::gradients(point.xi1, point.xi2);
            Vec3 y1 = Vec3::Zero(), y2 = Vec3::Zero();
            scalar p = 0;
            for (int j = 0; j < nodesPerElement; ++j)
            {
                const Vec3 y = q.segment<3>(dofsPerNode*nodes[j]);
                y1 += dN(j, 0)*y;
                y2 += dN(j, 1)*y;
                p += N[j]*pressures[nodes[j]];
            }
            const Vec3 f = -point.weight*p*y1.cross(y2);
            for (int j = 0; j < nodesPerElement; ++j)
            {
                force.segment<3>(dofsPerNode*nodes[j]) += N[j]*f;
            }
        }
    }
    return force;
}
