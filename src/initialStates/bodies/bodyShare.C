/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "bodyShare.H"
#include "nodeVolumes.H"
#include "simplexPiece.H"
#include "stateInput.H"
#include "mathematicalConstants.H"

namespace
{

//- A piece of a simplex that the edge of a body may cut
template<int dim>
struct piece
:
    Foam::simplexPiece<dim>
{
    using Foam::simplexPiece<dim>::simplexPiece;

    Foam::point x[dim + 1];
    Foam::scalar outside[dim + 1];

    //- Split at the point (1 - t) i + t j between two corners: the part with
    //  that point in place of corner i
    piece part(const int i, const int j, const double t) const
    {
        piece p(*this);
        p.bary[i] = (1 - t)*this->bary[i] + t*this->bary[j];
        p.radius[i] = (1 - t)*this->radius[i] + t*this->radius[j];
        p.x[i] = (1 - t)*x[i] + t*x[j];
        p.volume = this->volume*(1 - t);
        return p;
    }
};


//- Add the part where the linear function through the corners' values is
//  negative: split at the zero of an edge until no edge has one
template<int dim>
void addLinear
(
    const piece<dim>& p,
    const int curvature,
    typename piece<dim>::Bary& sum
)
{
    int in = -1;
    int out = -1;
    for (int a = 0; a <= dim; ++a)
    {
        in = (p.outside[a] < 0 ? a : in);
        out = (p.outside[a] > 0 ? a : out);
    }
    if (in < 0)
    {
        return;
    }
    if (out < 0)
    {
        p.addIntegrals(curvature, sum);
        return;
    }
    const double t = p.outside[in]/(p.outside[in] - p.outside[out]);
    piece<dim> first(p.part(in, out, t));
    piece<dim> second(p.part(out, in, 1 - t));
    first.outside[in] = second.outside[out] = 0;
    addLinear(first, curvature, sum);
    addLinear(second, curvature, sum);
}


//- Add the part of the piece that is in the body
template<int dim>
void addInside
(
    const piece<dim>& p,
    const Foam::convexBody& body,
    const int curvature,
    typename piece<dim>::Bary& sum
)
{
    const auto range =
        std::minmax_element(std::begin(p.outside), std::end(p.outside));

    if (*range.second <= 0)
    {
        p.addIntegrals(curvature, sum);     // the body is convex
        return;
    }

    int i = 0;
    int j = 1;
    Foam::scalar longest = -1;
    for (int a = 0; a <= dim; ++a)
    {
        for (int b = a + 1; b <= dim; ++b)
        {
            const Foam::scalar length = mag(p.x[a] - p.x[b]);
            if (length > longest)
            {
                longest = length;
                i = a;
                j = b;
            }
        }
    }

    if (*range.first > longest)
    {
        return;             // no point is further from a corner than that
    }
    if (longest <= body.resolution())
    {
        addLinear(p, curvature, sum);
        return;
    }
    piece<dim> first(p.part(i, j, 0.5));
    piece<dim> second(p.part(j, i, 0.5));
    first.outside[i] = second.outside[j] = body.outside(first.x[i]);
    addInside(first, body, curvature, sum);
    addInside(second, body, curvature, sum);
}


template<int dim>
void addVolumesInside
(
    const Foam::feMesh& mesh,
    const Foam::convexBody& body,
    Foam::scalarField& inside
)
{
    using namespace Foam;

    // At the corners: a node of a cyclic patch stands at several places
    scalarField outside(mesh.nCorners());
    forAll(outside, i)
    {
        outside[i] = body.outside(mesh.corners()[i]);
    }

    for (label s = 0; s < mesh.nSimplices(); ++s)
    {
        const label* nodes = &mesh.simplices()[(dim + 1)*s];
        const label* corners = &mesh.simplexCorners()[(dim + 1)*s];
        piece<dim> whole(mesh, s, plainVolume<dim>(mesh, s));
        for (int a = 0; a <= dim; ++a)
        {
            whole.x[a] = mesh.corners()[corners[a]];
            whole.outside[a] = outside[corners[a]];
        }

        typename piece<dim>::Bary share = piece<dim>::Bary::Zero();
        addInside(whole, body, mesh.curvature(), share);
        for (int a = 0; a <= dim; ++a)
        {
            inside[nodes[a]] += share[a];
        }
    }
}

} // End namespace


Foam::tmp<Foam::scalarField> Foam::volumeInside
(
    const feMesh& mesh,
    const convexBody& body
)
{
    auto tinside = tmp<scalarField>::New(mesh.nNodes(), Zero);
    switch (mesh.dim())
    {
        case 1: addVolumesInside<1>(mesh, body, tinside.ref()); break;
        case 2: addVolumesInside<2>(mesh, body, tinside.ref()); break;
        default: addVolumesInside<3>(mesh, body, tinside.ref()); break;
    }
    return tinside;
}


Foam::bodyShare::bodyShare
(
    const gasNodes& nodes,
    const convexBody& body,
    const dictionary& dict
)
:
    f_(volumeInside(nodes.mesh(), body)),
    sector_(body.sector(nodes.mesh())),
    across_(body.across(nodes.mesh()))
{
    sumCopies(nodes.mesh(), f_);
    f_ /= nodes.volume();
    meshVolume_ = nodes.integral(f_);

    if (!(meshVolume_ > 0))
    {
        FatalIOErrorInFunction(dict)
            << "The " << body.name() << " is nowhere in the mesh, whose points "
            << "lie in " << nodes.mesh().poly().bounds() << exit(FatalIOError);
    }

    // A slab that the mesh is wider than has no cross section but the mesh's
    if (body.shape() == convexBody::slab && nodes.mesh().dim() > 1)
    {
        across_ = meshVolume_/(body.end() - body.start());
    }

    measured_ = meshVolume_/(sector_*body.volume(across_));
    fraction_ = findFraction(body, dict);
    volume_ = fraction_*sector_*body.volume(across_);

    if (mag(correction() - 1) > 0.1)
    {
        FatalIOErrorInFunction(dict)
            << "The mesh holds " << measured_ << " of the " << body.name()
            << ", fraction is " << fraction_ << ": more than 10 % apart" << nl
            << "    Check the centre, the size and the fraction"
            << exit(FatalIOError);
    }
}


Foam::scalar Foam::bodyShare::findFraction
(
    const convexBody& body,
    const dictionary& dict
) const
{
    if (dict.found("fraction"))
    {
        const scalar fraction = positive(dict, "fraction");
        if (fraction > 1)
        {
            FatalIOErrorInFunction(dict)
                << "fraction is " << fraction << ", but must be in (0 1]"
                << exit(FatalIOError);
        }
        return fraction;
    }

    for (const scalar fraction : {1.0, 0.5, 0.25, 0.125})
    {
        if (mag(measured_ - fraction) < 0.01*fraction)
        {
            return fraction;
        }
    }

    FatalIOErrorInFunction(dict)
        << "The mesh holds " << measured_ << " of the " << body.name() << nl
        << "    Give this part exactly as the entry fraction; only 1, 0.5, "
        << "0.25 and 0.125 (symmetry planes through the centre) are taken by "
        << "themselves" << exit(FatalIOError);

    return 0;
}


Foam::scalar Foam::bodyShare::nodesPerRadius
(
    const gasNodes& nodes,
    const convexBody& body
) const
{
    const label dim = nodes.mesh().dim();
    if (nodes.mesh().curvature())
    {
        // Volumes of nodes grow with the radius: the nodes are counted, on the
        // radius or in a half circle
        const scalar n = nodes.integral(f_/nodes.volume())/fraction_;
        return
            dim == 1
          ? n
          : Foam::sqrt(2*n/constant::mathematical::pi);
    }
    const scalar nodeVolume =
        nodes.integral(f_*nodes.volume())/meshVolume_;
    const scalar depth = (dim < 3 ? nodes.mesh().depth() : 1);
    return body.end()/Foam::pow(nodeVolume/depth, 1.0/dim);
}


void Foam::bodyShare::print(const convexBody& body) const
{
    Info<< "    " << body.name() << ", " << part() << " of it in the mesh: "
        << volume_ << " m3, on the nodes " << meshVolume_ << " m3" << endl;
}
