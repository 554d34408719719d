// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sparse matrix on the equations of a shell with a fixed pattern: the places of
// every element entry are found once, refilling is a plain sum.
//
// Symmetric contributions go into the lower triangle only; matrix() completes
// the upper one. Unsymmetric contributions (followers) are kept beside them and
// cost nothing where there are none.

#ifndef positionalShell_SystemMatrix_hpp
#define positionalShell_SystemMatrix_hpp

#include "SparsityMap.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace positionalShell
{

class SystemMatrix
{
public:

    explicit SystemMatrix(std::shared_ptr<const SparsityMap> map);

    int nEquations() const { return int(map_->pattern().rows()); }

    void setZero();

    //- Multiply all entries
    void scale(double factor);

    //- Add factor times another symmetric matrix of the same pattern
    void addScaled(double factor, const SystemMatrix& other);

    //- Add the 7 x 7 block of the nodes i >= j of an element (places within the
    //  element) of a symmetric element matrix; block[7*column + row]
    void addSymmetricBlock(int element, int i, int j, const double* block);

    //- Add to one entry of a symmetric matrix by unknowns of one element
    //  (7*place + component): also stands for the transposed entry. row >= column.
    void addSymmetricEntry(int element, int row, int column, double value);

    //- Add to one entry of an unsymmetric part by unknowns of one element;
    //  prescribed unknowns are skipped
    void addGeneralEntry(int element, int row, int column, double value);

    void setDiagonal(int equation, double value);

    //- Replace the rows and columns of the chosen equations by those of the unit
    //  matrix. Symmetric parts only.
    void decouple(const std::function<bool(int equation)>& chosen);

    //- Whether only symmetric parts have been added since setZero
    bool symmetric() const { return general_.empty(); }

    //- The whole matrix
    const SparseMatrix& matrix() const;

    //- The pattern with valid values in the lower triangle of the symmetric part
    //  (K + K^T)/2; refers to the same storage as matrix()
    const SparseMatrix& lower() const;

private:

    std::shared_ptr<const SparsityMap> map_;

    //- By place, with one more for what goes nowhere; lower triangle
    std::vector<double> values_;

    //- By place, whole; empty while symmetric
    std::vector<double> general_;

    mutable SparseMatrix matrix_;
};

} // namespace positionalShell

#endif
