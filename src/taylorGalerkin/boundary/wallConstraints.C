/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "wallConstraints.H"
#include "labelPair.H"
#include "Map.H"
#include "mathematicalConstants.H"

#include <algorithm>

template<int dim>
Foam::wallConstraints<dim>::wallConstraints
(
    const gasGeometry<dim>& geometry,
    const List<const fePatch*>& walls
)
:
    geometry_(geometry),
    walls_(walls)
{
    Map<label> indexOf;
    DynamicList<label> nodes;
    DynamicList<DynamicList<labelPair>> facets;

    forAll(walls_, walli)
    {
        const fePatch& patch = *walls_[walli];
        forAll(patch.facetSimplex, i)
        {
            for (int b = 0; b < dim; ++b)
            {
                const label node = patch.facets[dim*i + b];
                if (indexOf.insert(node, nodes.size()))
                {
                    nodes.append(node);
                    facets.append(DynamicList<labelPair>());
                }
                facets[indexOf[node]].append(labelPair(walli, i));
            }
        }
    }

    nodes_.transfer(nodes);
    facetsOfNode_.setSize(facets.size());
    forAll(facets, i)
    {
        facetsOfNode_[i] = facets[i];
    }
    constraints_.resize(nodes_.size());
    update();
}


template<int dim>
std::vector<typename Foam::wallConstraints<dim>::piece>
Foam::wallConstraints<dim>::smoothPieces(const label index) const
{
    const double sameWall =
        std::cos(featureAngle*constant::mathematical::pi/180);

    std::vector<piece> pieces;
    for (const labelPair& wf : facetsOfNode_[index])
    {
        const fePatch& patch = *walls_[wf.first()];
        const label i = wf.second();
        const Vec S = geometry_.presentFacetArea(patch, i);
        Vec centre = Vec::Zero();
        for (int b = 0; b < dim; ++b)
        {
            centre += geometry_.position(patch.facets[dim*i + b])/dim;
        }

        auto home = std::find_if
        (
            pieces.begin(), pieces.end(),
            [&](const piece& p)
            {
                return p.area.normalized().dot(S.normalized()) > sameWall;
            }
        );
        if (home == pieces.end())
        {
            pieces.push_back({S, centre, 1});
        }
        else
        {
            home->area += S;
            home->centres += centre;
            ++home->nFacets;
        }
    }
    return pieces;
}


template<int dim>
std::vector<typename Foam::wallConstraints<dim>::Vec>
Foam::wallConstraints<dim>::constrainedNormals
(
    const Vec& x,
    const std::vector<piece>& pieces
)
{
    std::vector<Vec> normals;
    std::vector<bool> merged(pieces.size(), false);
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
        if (merged[i])
        {
            continue;
        }
        const Vec n = pieces[i].area.normalized();
        Vec mean = n;
        for (std::size_t j = i + 1; j < pieces.size(); ++j)
        {
            // The other piece lies on the outer side of this one's plane: the
            // gas turns through more than half a circle between them
            const Vec away = pieces[j].centres/pieces[j].nFacets - x;
            if (away.dot(n) > 1e-3*away.norm())
            {
                mean += pieces[j].area.normalized();
                merged[j] = true;
            }
        }
        normals.push_back(mean.normalized());
    }
    return normals;
}


template<int dim>
typename Foam::wallConstraints<dim>::wallNode
Foam::wallConstraints<dim>::constraintsOf(const label index) const
{
    wallNode result;
    result.node = nodes_[index];
    result.nNormals = 0;

    // Orthonormal basis of what is constrained
    for
    (
        Vec n : constrainedNormals
        (
            geometry_.position(result.node), smoothPieces(index)
        )
    )
    {
        for (int k = 0; k < result.nNormals; ++k)
        {
            n -= n.dot(result.normals[k])*result.normals[k];
        }
        if (n.norm() > 1e-3 && result.nNormals < dim)
        {
            result.normals[result.nNormals++] = n.normalized();
        }
    }
    return result;
}


template<int dim>
void Foam::wallConstraints<dim>::update()
{
    forAll(nodes_, i)
    {
        constraints_[i] = constraintsOf(i);
    }
}


template<int dim>
void Foam::wallConstraints<dim>::apply
(
    std::vector<gasDynamics::State<dim>>& U
) const
{
    for (const wallNode& c : constraints_)
    {
        gasDynamics::State<dim>& s = U[c.node];
        const Vec& w = geometry_.w(c.node);
        for (int k = 0; k < c.nNormals; ++k)
        {
            const Vec relative = s.template segment<dim>(1) - s[0]*w;
            s.template segment<dim>(1) -=
                relative.dot(c.normals[k])*c.normals[k];
        }
    }
}


template class Foam::wallConstraints<1>;
template class Foam::wallConstraints<2>;
template class Foam::wallConstraints<3>;
