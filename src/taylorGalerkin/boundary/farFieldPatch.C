/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "farFieldPatch.H"
#include "farFieldPointPatchFields.H"

namespace
{

//! Facets whose unit normals differ by less are parts of one plane
constexpr double samePlane = 1e-8;

} // End namespace


template<int dim>
Foam::farFieldPatch<dim>::farFieldPatch
(
    const gasGeometry<dim>& geometry,
    const gasDynamics::PerfectGas& eos,
    const fePatch& patch,
    pointScalarField& p,
    pointVectorField& U,
    pointScalarField& T
)
:
    geometry_(geometry),
    eos_(eos),
    patch_(patch),
    p_(p),
    U_(U),
    T_(T),
    outer_(patch.nodes.size()),
    varies_(false),
    areSummed_(false)
{
    findParts();
    readOuterStates(geometry.mesh().poly().time().value());
    readAfterflow();
}


template<int dim>
void Foam::farFieldPatch<dim>::findParts()
{
    partOfFacet_.setSize(patch_.facets.size());
    std::vector<std::vector<std::pair<Vec, label>>> ofNode(patch_.nodes.size());
    forAll(patch_.facetSimplex, i)
    {
        const Vec n = geometry_.presentFacetArea(patch_, i).normalized();
        for (int a = 0; a < dim; ++a)
        {
            const label place =
                findLower(patch_.nodes, patch_.facets[dim*i + a] + 1);
            auto& known = ofNode[place];
            auto found = known.begin();
            while
            (
                found != known.end() && (found->first - n).norm() > samePlane
            )
            {
                ++found;
            }
            if (found == known.end())
            {
                known.emplace_back(n, label(parts_.size()));
                found = known.end() - 1;
                parts_.push_back(part{place, Vec::Zero(), 0});
            }
            partOfFacet_[dim*i + a] = found->second;
        }
    }
}


template<int dim>
void Foam::farFieldPatch<dim>::sumParts() const
{
    const bool moving = geometry_.moving();
    if (areSummed_ && !moving)
    {
        return;
    }
    for (part& piece : parts_)
    {
        piece.S = Vec::Zero();
        piece.swept = 0;
    }
    const label patchi = geometry_.patchNumber(patch_);
    forAll(patch_.facetSimplex, i)
    {
        const auto& M = geometry_.facet(patchi, i).M;
        const label* facet = &patch_.facets[dim*i];
        for (int a = 0; a < dim; ++a)
        {
            part& piece = parts_[partOfFacet_[dim*i + a]];
            for (int b = 0; b < dim; ++b)
            {
                piece.S += M[a][b];
                if (moving)
                {
                    piece.swept += M[a][b].dot(geometry_.w(facet[b]));
                }
            }
        }
    }
    areSummed_ = !moving;
}


template<int dim>
template<class Visit>
void Foam::farFieldPatch<dim>::forPoints(const Visit& visit) const
{
    const labelList& nodeOfPoint = geometry_.mesh().nodeOfPoint();
    const labelList& points =
        p_.boundaryField()[patch_.index].patch().meshPoints();
    forAll(points, pointi)
    {
        const label node = nodeOfPoint[points[pointi]];
        visit(pointi, findLower(patch_.nodes, node + 1));
    }
}


template<int dim>
void Foam::farFieldPatch<dim>::readOuterStates(const scalar time)
{
    auto outerOf = [&](auto& field) -> const auto&
    {
        using Type = typename std::decay_t<decltype(field)>::value_type;
        auto& pf = refCast<farFieldPointPatchField<Type>>
        (
            field.boundaryFieldRef(false)[patch_.index]
        );
        pf.setTime(time);
        varies_ = varies_ || pf.varies();
        return pf.outer();
    };
    const auto& p = outerOf(p_);
    const auto& U = outerOf(U_);
    const auto& T = outerOf(T_);
    const feMesh& mesh = geometry_.mesh();
    const labelList& points =
        p_.boundaryField()[patch_.index].patch().meshPoints();
    forPoints([&](const label pointi, const label place)
    {
        outer_[place] = gasDynamics::conserved<dim>
        (
            eos_,
            eos_.density(p[pointi], T[pointi]),
            mesh.components<dim>
            (
                U[pointi], mesh.poly().points()[points[pointi]]
            ),
            p[pointi]
        );
    });
}


template<int dim>
void Foam::farFieldPatch<dim>::readAfterflow()
{
    const auto& curved = refCast<const farFieldPointPatchField<scalar>>
    (
        p_.boundaryField()[patch_.index]
    ).curved();
    const auto& ofT = refCast<const farFieldPointPatchField<scalar>>
    (
        T_.boundaryField()[patch_.index]
    ).curved();
    if (!ofT.arePlane())
    {
        FatalErrorInFunction
            << "Patch " << patch_.name << " has the entry waves in "
            << T_.objectPath() << nl << "    It belongs to p: remove it there"
            << exit(FatalError);
    }
    if (curved.arePlane())
    {
        return;
    }
    if (dim + geometry_.curvature() <= curved.spreading())
    {
        FatalErrorInFunction
            << "Waves at patch " << patch_.name << " are " << curved.name()
            << " (" << p_.objectPath() << "), but the scene has "
            << dim + geometry_.curvature() << " dimension(s)" << nl
            << "    Choose waves that spread in a scene like it"
            << exit(FatalError);
    }
    afterflow_.assign(patch_.nodes.size(), 0.0);
    forPoints([&](const label pointi, const label place)
    {
        afterflow_[place] = curved.afterflow()[pointi];
    });
    oldAfterflow_ = afterflow_;
    atMiddle_.assign(patch_.nodes.size(), Vec::Zero());
    const gasRow rest = uniformRow(1);
    for (std::size_t i = 0; i < afterflow_.size(); ++i)
    {
        Vec way;
        rateOfAfterflow(i, rest, way);
        atMiddle_[i] = afterflow_[i]*way;
    }
}


template<int dim>
void Foam::farFieldPatch<dim>::writeAfterflow()
{
    auto& curved = refCast<farFieldPointPatchField<scalar>>
    (
        p_.boundaryFieldRef(false)[patch_.index]
    ).curved();
    forPoints([&](const label pointi, const label place)
    {
        curved.afterflow()[pointi] = afterflow_[place];
    });
}


template<int dim>
double Foam::farFieldPatch<dim>::rateOfAfterflow
(
    const label place,
    const gasRow& state,
    Vec& way
) const
{
    const feMesh& mesh = geometry_.mesh();
    const auto& curved = refCast<const farFieldPointPatchField<scalar>>
    (
        p_.boundaryField()[patch_.index]
    ).curved();
    const label node = patch_.nodes[place];
    way = geometry_.position(node) - mesh.components<dim>(curved.origin());
    const double r = way.norm();
    if (r < SMALL)
    {
        FatalErrorInFunction
            << "origin " << curved.origin() << " of the waves at patch "
            << patch_.name << " (" << p_.objectPath() << ") is a point of it"
            << nl << "    Change origin" << exit(FatalError);
    }
    way /= r;
    const State& outer = outer_[place];
    const double p = gasDynamics::pressure<dim>(eos_, outer);
    const double c = eos_.soundSpeed(p, outer[0]);
    const double pi = gasDynamics::strengthOfWave
    (
        eos_, state[gasKernel::place<dim>::p], p, c
    );
    return 0.5*curved.spreading()*c*pi/r;
}


template<int dim>
void Foam::farFieldPatch<dim>::beginStep(const gasRows& states, const scalar dt)
{
    for (std::size_t i = 0; i < afterflow_.size(); ++i)
    {
        const label node = patch_.nodes[i];
        if (!geometry_.active().asleep(node))
        {
            Vec way;
            const double rate = rateOfAfterflow(i, states[node], way);
            afterflow_[i] += 0.5*dt*rate;
            atMiddle_[i] = afterflow_[i]*way;
        }
    }
}


template<int dim>
void Foam::farFieldPatch<dim>::endStep(const gasRows& states, const scalar dt)
{
    if (!isCurved())
    {
        return;
    }
    for (std::size_t i = 0; i < afterflow_.size(); ++i)
    {
        const label node = patch_.nodes[i];
        if (!geometry_.active().asleep(node))
        {
            Vec way;
            afterflow_[i] += 0.5*dt*rateOfAfterflow(i, states[node], way);
        }
    }
    writeAfterflow();
}


template<int dim>
void Foam::farFieldPatch<dim>::addFluxes
(
    const gasRows& states,
    const double pRef,
    gasRows& sum
) const
{
    constexpr int n = gasKernel::place<dim>::nConserved;
    constexpr int force = gasKernel::place<dim>::force;
    const activeParts& active = geometry_.active();
    sumParts();
    for (const part& piece : parts_)
    {
        const label node = patch_.nodes[piece.place];
        const Vec& S = piece.S;

        // The area is zero on the axis of a scene with one
        if (active.asleep(node) || S.squaredNorm() == 0)
        {
            continue;
        }

        // The velocity along S that sweeps the same volume
        const Vec w = piece.swept/S.squaredNorm()*S;
        const Eigen::Map<const State> inner(states[node].v);
        const State f = gasDynamics::farFieldFlux<dim>
        (
            eos_, inner, outer_[piece.place], S, w,
            isCurved() ? atMiddle_[piece.place] : Vec(Vec::Zero())
        );
        gasRow& row = sum[node];
        const double p = states[node][gasKernel::place<dim>::p] - pRef;
        for (int k = 0; k < n; ++k)
        {
            row[k] -= f[k];
        }
        for (int k = 0; k < dim; ++k)
        {
            row[1 + k] += pRef*S[k];
            row[force + k] -= p*S[k];
        }
    }
}


template class Foam::farFieldPatch<1>;
template class Foam::farFieldPatch<2>;
template class Foam::farFieldPatch<3>;
