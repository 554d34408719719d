// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pattern of the matrices of a model (both triangles, compressed columns) and the
// place in it of every entry of the lower triangle of every element matrix.

#ifndef positionalShell_SparsityMap_hpp
#define positionalShell_SparsityMap_hpp

#include "DofMap.hpp"
#include "ShellMesh.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace positionalShell
{

class SparsityMap
{
public:

    //- Entries of the lower triangle of an element matrix by node pairs
    //  (i >= j): 7 x 7 per pair, rows of i, columns of j, column by column
    static constexpr int entriesPerPair = dofsPerNode*dofsPerNode;
    static constexpr int pairsPerElement =
        nodesPerElement*(nodesPerElement + 1)/2;
    static constexpr int entriesPerElement = pairsPerElement*entriesPerPair;

    //- Place of a node pair, i >= j: column j after column j, the order in
    //  which the element kernel makes them
    static constexpr int pair(int i, int j)
    {
        return j*nodesPerElement - j*(j - 1)/2 + i - j;
    }

    SparsityMap(const ShellMesh& mesh, const DofMap& dofs);

    const SparseMatrix& pattern() const { return pattern_; }

    //- Place in the values for each entry of the lower triangle of the element
    //  matrix; nowhere() for a prescribed unknown, and on the diagonal pairs for
    //  an entry that its transpose stands for
    const int* places(int element) const
    {
        return &places_[std::size_t(element)*entriesPerElement];
    }

    //- One past the last value: what is added there is of no interest
    int nowhere() const { return int(pattern_.nonZeros()); }

    //- Entries of a node pair of the element to be added once more: two different
    //  unknowns that share one equation meet on the diagonal from both sides
    struct Range
    {
        const int* first;
        const int* last;
        const int* begin() const { return first; }
        const int* end() const { return last; }
    };
    Range doubled(int element, int pair) const
    {
        const int* start = &doubledStart_[element*pairsPerElement + pair];
        return {doubled_.data() + start[0], doubled_.data() + start[1]};
    }

    //- Place of any entry (unknowns 7*place + component) of an element
    int place(int element, int row, int column) const;

    //- Place of the diagonal of an equation
    int diagonal(int equation) const { return place(equation, equation); }

    //- For each value, the place of the transposed entry
    const std::vector<int>& transposed() const { return transposed_; }

    //- Equation of an unknown (7*place + component) of an element, or -1
    int equation(int element, int unknown) const
    {
        return equation_
        [
            dofsPerNode*triangles_[element][unknown/dofsPerNode]
          + unknown%dofsPerNode
        ];
    }

    //- Equations of the unknowns of an element, -1 when prescribed
    std::array<int, dofsPerElement> equations(int element) const;

private:

    std::vector<Triangle> triangles_;
    std::vector<int> equation_;
    SparseMatrix pattern_;
    std::vector<int> places_;
    std::vector<int> doubled_;
    std::vector<int> doubledStart_;
    std::vector<int> transposed_;

    void makePattern(int nEquations);
    void makePlaces();
    void addPair(int element, int i, int j);
    void makeTransposed();

    //- Place of (row, column) by equations
    int place(int row, int column) const;
};

} // namespace positionalShell

#endif
