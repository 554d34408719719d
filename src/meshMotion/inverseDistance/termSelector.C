/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "termSelector.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

template<int dim>
void Foam::termSelector<dim>::start(const coordinates& x)
{
    x_ = x;
    candidates_.clear();
    clearSums();
    movingExpanded_.clear();
    movingSummed_.clear();
    nFixedTerms_ = 0;
    weight_ = 0;

    for (const bool isMoving : {true, false})
    {
        if (side(isMoving).tree().empty())
        {
            continue;
        }
        if (tolerance_ > 0)
        {
            // Open at first what must not be expanded at all
            open(0, isMoving, 0.5*VGREAT);
        }
        else
        {
            sumPoints(0, isMoving);
        }
    }
}


template<int dim>
void Foam::termSelector<dim>::clearSums()
{
    errorSum_ = lowSum_ = maxError_ = 0;
}


template<int dim>
void Foam::termSelector<dim>::open
(
    const label clusteri,
    const bool isMoving,
    const scalar threshold
)
{
    const attractor<dim>& a = side(isMoving);
    const auto& cluster = a[clusteri];
    if (cluster.isLeaf())
    {
        sumPoints(clusteri, isMoving);
        return;
    }

    // Moving points stand above and below the fraction's line
    const scalar error = (isMoving ? 2 : 1)*a.error(cluster, x_);
    if (error <= threshold)
    {
        keep(candidate{error, a.low(cluster, x_), clusteri, isMoving});
        return;
    }
    open(cluster.firstHalf, isMoving, threshold);
    open(cluster.secondHalf, isMoving, threshold);
}


template<int dim>
void Foam::termSelector<dim>::keep(const candidate& c)
{
    candidates_.append(c);
    errorSum_ += c.error;
    lowSum_ += c.low;
    maxError_ = max(maxError_, c.error);
}


template<int dim>
void Foam::termSelector<dim>::refine(const scalar threshold)
{
    previous_.swap(candidates_);
    candidates_.clear();
    clearSums();

    for (const candidate& c : previous_)
    {
        if (c.error <= threshold)
        {
            keep(c);
        }
        else
        {
            const auto& cluster = side(c.isMoving)[c.cluster];
            open(cluster.firstHalf, c.isMoving, threshold);
            open(cluster.secondHalf, c.isMoving, threshold);
        }
    }
}


template<int dim>
void Foam::termSelector<dim>::sumPoints
(
    const label cluster,
    const bool isMoving
)
{
    weight_ += side(isMoving).summedWeight(cluster, x_);
    if (isMoving)
    {
        movingSummed_.append(cluster);
    }
    else
    {
        nFixedTerms_ += fixed_.tree().clusters()[cluster].size();
    }
}


template<int dim>
void Foam::termSelector<dim>::finish()
{
    scalar error = 0;
    for (const candidate& c : candidates_)
    {
        weight_ += side(c.isMoving).expandedWeight(c.cluster, x_);
        error += c.error;
        if (c.isMoving)
        {
            movingExpanded_.append(c.cluster);
        }
        else
        {
            ++nFixedTerms_;
        }
    }
    bound_ = error/weight_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<int dim>
Foam::termSelector<dim>::termSelector
(
    const attractor<dim>& moving,
    const attractor<dim>& fixed,
    const scalar tolerance
)
:
    moving_(moving),
    fixed_(fixed),
    tolerance_(tolerance)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int dim>
void Foam::termSelector<dim>::select(const coordinates& x)
{
    start(x);

    while (errorSum_ > tolerance_*(weight_ + lowSum_ - errorSum_))
    {
        // Far above the even share of what is allowed, so that few more are
        // opened than needed; below the worst, so that this ends
        refine
        (
            min
            (
                16*tolerance_*(weight_ + lowSum_)/candidates_.size(),
                0.5*maxError_
            )
        );
    }
    finish();
}


template class Foam::termSelector<1>;
template class Foam::termSelector<2>;
template class Foam::termSelector<3>;
