// SPDX-License-Identifier: GPL-3.0-or-later

#include "SystemMatrix.hpp"

#include <algorithm>

namespace positionalShell
{

SystemMatrix::SystemMatrix(std::shared_ptr<const SparsityMap> map)
:
    map_(std::move(map)),
    values_(map_->nowhere() + 1, 0.0),
    matrix_(map_->pattern())
{}

void SystemMatrix::setZero()
{
    std::fill(values_.begin(), values_.end(), 0.0);
    general_.clear();
}

void SystemMatrix::scale(double factor)
{
    if (factor == 1) return;
    for (double& value : values_) value *= factor;
    for (double& value : general_) value *= factor;
}

void SystemMatrix::addScaled(double factor, const SystemMatrix& other)
{
    for (std::size_t k = 0; k < values_.size(); ++k)
    {
        values_[k] += factor*other.values_[k];
    }
}

void SystemMatrix::addSymmetricBlock
(
    int element,
    int i,
    int j,
    const double* block
)
{
    constexpr int n = SparsityMap::entriesPerPair;
    const int pair = SparsityMap::pair(i, j);
    const int* places = map_->places(element) + pair*n;
    double* values = values_.data();
    for (int k = 0; k < n; ++k) values[places[k]] += block[k];
    for (int k : map_->doubled(element, pair)) values[places[k]] += block[k];
}

void SystemMatrix::addSymmetricEntry
(
    int element,
    int row,
    int column,
    double value
)
{
    const bool twice = row != column
     && map_->equation(element, row) == map_->equation(element, column);
    const int lower = map_->equation(element, row)
        < map_->equation(element, column)
        ? map_->place(element, column, row)
        : map_->place(element, row, column);
    values_[lower] += twice ? 2*value : value;
}

void SystemMatrix::addGeneralEntry
(
    int element,
    int row,
    int column,
    double value
)
{
    if (general_.empty()) general_.assign(values_.size(), 0.0);
    general_[map_->place(element, row, column)] += value;
}

void SystemMatrix::setDiagonal(int equation, double value)
{
    values_[map_->diagonal(equation)] = value;
}

void SystemMatrix::decouple(const std::function<bool(int)>& chosen)
{
    const SparseMatrix& pattern = map_->pattern();
    for (int column = 0; column < pattern.cols(); ++column)
    {
        const bool wholeColumn = chosen(column);
        for
        (
            int k = pattern.outerIndexPtr()[column];
            k < pattern.outerIndexPtr()[column + 1];
            ++k
        )
        {
            const int row = pattern.innerIndexPtr()[k];
            if (wholeColumn || chosen(row)) values_[k] = row == column ? 1 : 0;
        }
    }
}

const SparseMatrix& SystemMatrix::lower() const
{
    double* lower = matrix_.valuePtr();
    std::copy_n(values_.data(), map_->nowhere(), lower);
    const std::vector<int>& transposed = map_->transposed();
    for (int k = 0; k < map_->nowhere() && !general_.empty(); ++k)
    {
        lower[k] += 0.5*(general_[k] + general_[transposed[k]]);
    }
    return matrix_;
}

const SparseMatrix& SystemMatrix::matrix() const
{
    const SparseMatrix& pattern = map_->pattern();
    const std::vector<int>& transposed = map_->transposed();
    double* whole = matrix_.valuePtr();
    for (int column = 0; column < pattern.cols(); ++column)
    {
        for
        (
            int k = pattern.outerIndexPtr()[column];
            k < pattern.outerIndexPtr()[column + 1];
            ++k
        )
        {
            const bool upper = pattern.innerIndexPtr()[k] < column;
            whole[k] = values_[upper ? transposed[k] : k];
        }
    }
    for (int k = 0; k < map_->nowhere() && !general_.empty(); ++k)
    {
        whole[k] += general_[k];
    }
    return matrix_;
}

} // namespace positionalShell
