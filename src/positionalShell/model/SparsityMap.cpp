// SPDX-License-Identifier: GPL-3.0-or-later

#include "SparsityMap.hpp"

#include <algorithm>

namespace positionalShell
{

SparsityMap::SparsityMap(const ShellMesh& mesh, const DofMap& dofs)
:
    triangles_(mesh.triangles()),
    equation_(dofs.equations())
{
    makePattern(dofs.nEquations());
    makePlaces();
    makeTransposed();
}

std::array<int, dofsPerElement> SparsityMap::equations(int element) const
{
    std::array<int, dofsPerElement> equations;
    for (int i = 0; i < dofsPerElement; ++i)
    {
        equations[i] = equation(element, i);
    }
    return equations;
}

void SparsityMap::makePattern(int nEquations)
{
    std::vector<std::vector<int>> rows(nEquations);
    for (std::size_t e = 0; e < triangles_.size(); ++e)
    {
        std::vector<int> own;
        for (int q : equations(int(e)))
        {
            if (q >= 0) own.push_back(q);
        }
        std::sort(own.begin(), own.end());
        own.erase(std::unique(own.begin(), own.end()), own.end());
        for (int column : own)
        {
            rows[column].insert(rows[column].end(), own.begin(), own.end());
        }
    }

    std::vector<int> counts(nEquations);
    for (int column = 0; column < nEquations; ++column)
    {
        std::vector<int>& r = rows[column];
        std::sort(r.begin(), r.end());
        r.erase(std::unique(r.begin(), r.end()), r.end());
        counts[column] = int(r.size());
    }

    pattern_.resize(nEquations, nEquations);
    pattern_.reserve(counts);
    for (int column = 0; column < nEquations; ++column)
    {
        for (int row : rows[column]) pattern_.insert(row, column) = 0;
    }
    pattern_.makeCompressed();
}

int SparsityMap::place(int row, int column) const
{
    const int* inner = pattern_.innerIndexPtr();
    const int* begin = inner + pattern_.outerIndexPtr()[column];
    const int* end = inner + pattern_.outerIndexPtr()[column + 1];
    return int(std::lower_bound(begin, end, row) - inner);
}

int SparsityMap::place(int element, int row, int column) const
{
    const int high = std::max(row, column);
    const int low = std::min(row, column);
    const int entry =
        pair(high/dofsPerNode, low/dofsPerNode)*entriesPerPair
      + dofsPerNode*(low%dofsPerNode) + high%dofsPerNode;
    const int lower = places(element)[entry];
    const bool above =
        equation(element, row) < equation(element, column);
    return above && lower != nowhere() ? transposed_[lower] : lower;
}

void SparsityMap::makePlaces()
{
    places_.reserve(triangles_.size()*entriesPerElement);
    doubledStart_.push_back(0);
    for (std::size_t e = 0; e < triangles_.size(); ++e)
    {
        for (int j = 0; j < nodesPerElement; ++j)
        {
            for (int i = j; i < nodesPerElement; ++i) addPair(int(e), i, j);
        }
    }
}

void SparsityMap::addPair(int element, int i, int j)
{
    for (int k = 0; k < entriesPerPair; ++k)
    {
        const int row = dofsPerNode*i + k%dofsPerNode;
        const int column = dofsPerNode*j + k/dofsPerNode;
        const int r = equation(element, row);
        const int c = equation(element, column);
        const bool wanted = row >= column && r >= 0 && c >= 0;
        places_.push_back
        (
            wanted ? place(std::max(r, c), std::min(r, c)) : nowhere()
        );
        if (wanted && row != column && r == c) doubled_.push_back(k);
    }
    doubledStart_.push_back(int(doubled_.size()));
}

void SparsityMap::makeTransposed()
{
    transposed_.resize(pattern_.nonZeros());
    for (int column = 0; column < pattern_.cols(); ++column)
    {
        for
        (
            int k = pattern_.outerIndexPtr()[column];
            k < pattern_.outerIndexPtr()[column + 1];
            ++k
        )
        {
            transposed_[k] = place(column, pattern_.innerIndexPtr()[k]);
        }
    }
}

} // namespace positionalShell
