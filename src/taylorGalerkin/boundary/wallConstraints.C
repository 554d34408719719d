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
    walls_(walls),
    hasNormals_(false)
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

    // No radial velocity on the axis
    for (label a = 0; a < geometry.nNodes(); ++a)
    {
        if (onAxis(a) && indexOf.insert(a, nodes.size()))
        {
            nodes.append(a);
            facets.append(DynamicList<labelPair>());
        }
    }

    // A processor may hold a wall's node without a facet of the wall
    const sharedItems& exchange = geometry.mesh().exchange();
    std::vector<double> isWall(geometry.nNodes(), 0.0);
    for (const label node : nodes)
    {
        isWall[node] = 1;
    }
    exchange.max(isWall.data(), 1, 1);
    DynamicList<label> shared;
    for (const label node : exchange.shared())
    {
        if (isWall[node] > 0)
        {
            if (indexOf.insert(node, nodes.size()))
            {
                nodes.append(node);
                facets.append(DynamicList<labelPair>());
            }
            shared.append(indexOf[node]);
        }
    }
    sharedNodes_.transfer(shared);

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
std::vector<std::vector<typename Foam::wallConstraints<dim>::nodeFacet>>
Foam::wallConstraints<dim>::facets(const std::vector<bool>& wanted) const
{
    const feMesh& mesh = geometry_.mesh();
    std::vector<std::vector<nodeFacet>> result(nodes_.size());
    forAll(nodes_, n)
    {
        if (!wanted[n])
        {
            continue;
        }
        for (const labelPair& wf : facetsOfNode_[n])
        {
            const fePatch& patch = *walls_[wf.first()];
            const label i = wf.second();
            Vec centre = Vec::Zero(), own = Vec::Zero();
            const label first = (dim + 1)*patch.facetSimplex[i];
            for (int a = 0; a <= dim; ++a)
            {
                // At the corners: a node of a cyclic patch has several places
                const Vec x = mesh.components<dim>
                (
                    mesh.corners()[mesh.simplexCorners()[first + a]]
                );
                if (a != patch.opposite[i])
                {
                    centre += x/dim;
                }
                if (mesh.simplices()[first + a] == nodes_[n])
                {
                    own = x;
                }
            }
            centre -= own;
            result[n].push_back
            (
                nodeFacet{geometry_.presentFacetArea(patch, i), centre}
            );
        }
    }

    if (Pstream::parRun())
    {
        // Facets of the shared nodes: (global node, area, centre) from all
        List<List<scalarList>> all(Pstream::nProcs());
        DynamicList<scalarList> own;
        for (const label n : sharedNodes_)
        {
            for (const nodeFacet& f : result[n])
            {
                const label node = mesh.globalNode()[nodes_[n]];
                scalarList entry(1 + 2*dim, scalar(node));
                for (int k = 0; k < dim; ++k)
                {
                    entry[1 + k] = f.area[k];
                    entry[1 + dim + k] = f.centre[k];
                }
                own.append(entry);
            }
        }
        all[Pstream::myProcNo()] = own;
        Pstream::gatherList(all);
        Pstream::scatterList(all);

        Map<label> placeOf;
        for (const label n : sharedNodes_)
        {
            placeOf.insert(mesh.globalNode()[nodes_[n]], n);
        }
        forAll(all, proci)
        {
            if (proci == Pstream::myProcNo())
            {
                continue;
            }
            for (const scalarList& entry : all[proci])
            {
                const auto n = placeOf.cfind(label(entry[0]));
                if (n.found())
                {
                    result[*n].push_back
                    (
                        nodeFacet
                        {
                            Eigen::Map<const Vec>(&entry[1]),
                            Eigen::Map<const Vec>(&entry[1 + dim])
                        }
                    );
                }
            }
        }
    }

    // The same order whatever the decomposition
    for (auto& list : result)
    {
        std::sort
        (
            list.begin(), list.end(),
            [](const nodeFacet& a, const nodeFacet& b)
            {
                return std::lexicographical_compare
                (
                    a.centre.data(), a.centre.data() + dim,
                    b.centre.data(), b.centre.data() + dim
                );
            }
        );
    }
    return result;
}


template<int dim>
std::vector<typename Foam::wallConstraints<dim>::piece>
Foam::wallConstraints<dim>::smoothPieces(const std::vector<nodeFacet>& facets)
{
    const double sameWall =
        std::cos(featureAngle*constant::mathematical::pi/180);

    std::vector<piece> pieces;
    for (const nodeFacet& f : facets)
    {
        const Vec& S = f.area;
        const Vec& centre = f.centre;

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
            const Vec away = pieces[j].centres/pieces[j].nFacets;
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
Foam::wallConstraints<dim>::constraintsOf
(
    const label node,
    const std::vector<nodeFacet>& facets
) const
{
    wallNode result;
    result.node = node;
    result.nNormals = 0;

    // Orthonormal basis of what is constrained
    std::vector<Vec> normals(constrainedNormals(smoothPieces(facets)));
    if (onAxis(node))
    {
        normals.insert(normals.begin(), Vec::Unit(geometry_.radial()));
    }
    for (Vec n : normals)
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
    // Walls that stay keep their normals. Of shared nodes the facets of other
    // processors may have moved.
    std::vector<bool> wanted(nodes_.size(), !hasNormals_);
    for (const label n : sharedNodes_)
    {
        wanted[n] = true;
    }
    if (hasNormals_)
    {
        forAll(nodes_, n)
        {
            for (const labelPair& wf : facetsOfNode_[n])
            {
                const label* nodes =
                    &walls_[wf.first()]->facets[dim*wf.second()];
                for (int b = 0; b < dim; ++b)
                {
                    wanted[n] =
                        wanted[n] || geometry_.w(nodes[b]).squaredNorm() > 0;
                }
            }
        }
    }

    const std::vector<std::vector<nodeFacet>> around(facets(wanted));
    forAll(nodes_, i)
    {
        if (wanted[i])
        {
            constraints_[i] = constraintsOf(nodes_[i], around[i]);
        }
    }
    hasNormals_ = true;
}


template class Foam::wallConstraints<1>;
template class Foam::wallConstraints<2>;
template class Foam::wallConstraints<3>;
