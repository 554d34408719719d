/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "treeOperator.H"
#include "termSelector.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<int dim>
Foam::treeOperator<dim>::treeOperator
(
    const attractingPoints& moving,
    const attractingPoints& fixed,
    const UList<slidingPoints>& sliding,
    const pointField& targets,
    const inverseDistanceSettings& settings
)
:
    // The points of a leaf take no more weights than their expansion
    moving_
    (
        moving.positions,
        moving.strengths,
        settings.e1,
        multipole<dim>::nTerms
    )
{
    const attractor<dim> fixedPoints
    (
        fixed.positions,
        fixed.strengths,
        settings.e2,
        leafOfSums
    );

    // Half of what is allowed for the planes, where there are any
    planeResistance<dim> planes(sliding, settings.e2, settings.tolerance/2);
    termSelector<dim> selector
    (
        moving_,
        fixedPoints,
        planes.empty() ? settings.tolerance : settings.tolerance/2
    );

    rows_.reserve(targets.size());
    for (const point& p : targets)
    {
        const coordinates target = sourceTree<dim>::toCoordinates(p);
        selector.select(target);
        addRow(target, selector);
        if (!planes.empty())
        {
            planes.sum(target, selector.weight(), selector.bound());
            inverses_.push_back(planes.inverse());
            statistics_.nFixedTerms += planes.nTerms();
            statistics_.worstBound =
                max(statistics_.worstBound, selector.bound() + planes.bound());
        }
    }
    terms_.shrink_to_fit();
    stored_.shrink_to_fit();

    statistics_.nStored = stored_.size();
    statistics_.nBytes =
        rows_.size()*sizeof(row)
      + terms_.size()*sizeof(label)
      + stored_.size()*sizeof(scalar)
      + inverses_.size()*sizeof(typename planeResistance<dim>::matrix);
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

template<int dim>
void Foam::treeOperator<dim>::addRow
(
    const coordinates& target,
    const termSelector<dim>& chosen
)
{
    const std::size_t firstTerm = terms_.size();
    for (const label clusteri : chosen.movingExpanded())
    {
        terms_.push_back(clusteri);
    }
    for (const label clusteri : chosen.movingSummed())
    {
        terms_.push_back(-1 - clusteri);
    }

    const label n = nWeights(firstTerm);
    const bool store = n <= maxStored;
    if (store)
    {
        std::size_t end = stored_.size();
        stored_.resize(end + n);
        for (std::size_t i = firstTerm; i < terms_.size(); ++i)
        {
            evaluate(terms_[i], target, stored_.data() + end);
            end += columnsOf(terms_[i]).size;
        }
    }
    rows_.push_back({target, terms_.size(), 1/chosen.weight(), store});

    statistics_.nWeights += n;
    statistics_.nFixedTerms += chosen.nFixedTerms();
    statistics_.worstBound = max(statistics_.worstBound, chosen.bound());
}


template<int dim>
Foam::label Foam::treeOperator<dim>::nWeights
(
    const std::size_t firstTerm
) const
{
    label n = 0;
    for (std::size_t i = firstTerm; i < terms_.size(); ++i)
    {
        n += columnsOf(terms_[i]).size;
    }
    return n;
}


template<int dim>
typename Foam::treeOperator<dim>::columns
Foam::treeOperator<dim>::columnsOf(const label term) const
{
    const sourceTree<dim>& tree = moving_.tree();
    if (term >= 0)
    {
        return {tree.momentRow(term), multipole<dim>::nTerms};
    }
    return {tree.pointRow(-1 - term), moving_[-1 - term].size()};
}


template<int dim>
void Foam::treeOperator<dim>::evaluate
(
    const label term,
    const coordinates& target,
    scalar* weights
) const
{
    if (term >= 0)
    {
        const auto w = moving_.momentWeights(moving_[term], target);
        std::copy(w.begin(), w.end(), weights);
        return;
    }

    const auto& c = moving_[-1 - term];
    for (label i = c.begin; i < c.end; ++i)
    {
        *weights++ = moving_.pointWeight(i, target);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int dim>
void Foam::treeOperator<dim>::apply
(
    const UList<vector>& movingValues,
    vectorField& targetValues
) const
{
    const List<coordinates> values(moving_.tree().rows(movingValues));
    scalarList evaluated(max(moving_.tree().size(), multipole<dim>::nTerms));
    const scalar* stored = stored_.data();
    std::size_t termi = 0;

    targetValues.setSize(rows_.size());
    forAll(targetValues, k)
    {
        const row& r = rows_[k];
        coordinates sum(Zero);
        for (; termi < r.end; ++termi)
        {
            const columns block = columnsOf(terms_[termi]);
            const coordinates* value = values.cdata() + block.begin;
            const scalar* weight = stored;
            if (r.isStored)
            {
                stored += block.size;
            }
            else
            {
                evaluate(terms_[termi], r.target, evaluated.data());
                weight = evaluated.cdata();
            }

            for (label i = 0; i < block.size; ++i)
            {
                for (int a = 0; a < dim; ++a)
                {
                    sum[a] += weight[i]*value[i][a];
                }
            }
        }

        targetValues[k] = Zero;
        for (int a = 0; a < dim; ++a)
        {
            if (inverses_.empty())
            {
                targetValues[k][a] = r.scale*sum[a];
                continue;
            }
            for (int b = 0; b < dim; ++b)
            {
                targetValues[k][a] += inverses_[k][a*dim + b]*sum[b];
            }
        }
    }
}


template class Foam::treeOperator<1>;
template class Foam::treeOperator<2>;
template class Foam::treeOperator<3>;
