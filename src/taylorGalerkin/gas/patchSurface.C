/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "patchSurface.H"
#include "ListOps.H"
#include <algorithm>

template<int dim>
Foam::patchSurface<dim>::patchSurface(const fePatch& patch)
:
    nodeOfFacet_(patch.facets.size()),
    pairOfFacet_(nPairs*patch.facetSimplex.size())
{
    for (const label a : patch.nodes)
    {
        nodes_.push_back(node{a, Vec::Zero(), Vec::Zero()});
    }

    std::vector<std::pair<label, label>> ends;
    forAll(patch.facetSimplex, i)
    {
        const label* facet = &patch.facets[dim*i];
        for (int a = 0; a < dim; ++a)
        {
            nodeOfFacet_[dim*i + a] = findLower(patch.nodes, facet[a] + 1);
            for (int b = a + 1; b < dim; ++b)
            {
                ends.push_back(std::minmax(facet[a], facet[b]));
            }
        }
    }
    std::vector<std::pair<label, label>> sorted(ends);
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    for (const auto& e : sorted)
    {
        pairs_.push_back
        (
            pair
            {
                e.first, e.second, findLower(patch.nodes, e.first + 1),
                findLower(patch.nodes, e.second + 1), Vec::Zero()
            }
        );
    }
    for (std::size_t k = 0; k < ends.size(); ++k)
    {
        pairOfFacet_[k] =
            std::lower_bound(sorted.begin(), sorted.end(), ends[k])
          - sorted.begin();
    }
}


template<int dim>
void Foam::patchSurface<dim>::sum(const List<facetIntegrals<dim>>& facets)
{
    for (node& n : nodes_)
    {
        n.M = Vec::Zero();
    }
    for (pair& p : pairs_)
    {
        p.M = Vec::Zero();
    }
    label atNode = 0, atPair = 0;
    for (const facetIntegrals<dim>& f : facets)
    {
        for (int a = 0; a < dim; ++a)
        {
            nodes_[nodeOfFacet_[atNode++]].M += f.M[a][a];
            for (int b = a + 1; b < dim; ++b)
            {
                pairs_[pairOfFacet_[atPair++]].M += f.M[a][b];
            }
        }
    }
    for (node& n : nodes_)
    {
        n.S = n.M;
    }
    for (const pair& p : pairs_)
    {
        nodes_[p.placeOfA].S += p.M;
        nodes_[p.placeOfB].S += p.M;
    }
}


template class Foam::patchSurface<1>;
template class Foam::patchSurface<2>;
template class Foam::patchSurface<3>;
