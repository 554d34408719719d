/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "activeParts.H"

#include <algorithm>

namespace
{

using range = Foam::activeParts::range;

//- Append, joined to the last one where they meet
void append(std::vector<range>& ranges, const range& r)
{
    if (ranges.size() && r.from <= ranges.back().to)
    {
        ranges.back().to = std::max(r.to, ranges.back().to);
    }
    else if (r.from < r.to)
    {
        ranges.push_back(r);
    }
}

} // End namespace


Foam::activeParts::activeParts
(
    const label nRows,
    const std::vector<int>& first
)
:
    nRows_(nRows),
    nAsleep_(0)
{
    const label n = (nRows + blockSize - 1)/blockSize;
    asleep_.assign(n, false);
    firstEdge_.resize(n + 1);
    for (label b = 0; b < n; ++b)
    {
        firstEdge_[b] =
            std::lower_bound(first.begin(), first.end(), b*blockSize)
          - first.begin();
    }
    firstEdge_[n] = first.size();

    // No more than this is ever needed
    nodes_.reserve(n);
    edges_.reserve(n);
    findRanges();
}


void Foam::activeParts::findRanges()
{
    constexpr long group = gasKernel::groupSize;
    nodes_.clear();
    edges_.clear();
    nAsleep_ = 0;
    for (label b = 0; b < nBlocks(); ++b)
    {
        if (asleep_[b])
        {
            ++nAsleep_;
            continue;
        }
        append(nodes_, rows(b));
        append
        (
            edges_,
            range
            {
                group*(firstEdge_[b]/group),
                group*((firstEdge_[b + 1] + group - 1)/group)
            }
        );
    }
}


void Foam::activeParts::set(const std::vector<char>& asleep)
{
    asleep_ = asleep;
    findRanges();
}
