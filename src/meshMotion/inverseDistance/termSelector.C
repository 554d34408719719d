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
    movingExpanded_.clear();
    movingSummed_.clear();
    nFixedTerms_ = 0;
    weight_ = bound_ = 0;

    for (const bool isMoving : {true, false})
    {
        if (side(isMoving).tree().empty())
        {
            continue;
        }
        if (tolerance_ > 0)
        {
            candidates_.append(makeCandidate(0, isMoving));
        }
        else
        {
            sumPoints(0, isMoving);
        }
    }
}


template<int dim>
typename Foam::termSelector<dim>::candidate
Foam::termSelector<dim>::makeCandidate
(
    const label cluster,
    const bool isMoving
) const
{
    candidate c;
    c.cluster = cluster;
    c.isMoving = isMoving;
    c.low = -1;
    c.error = side(isMoving).error(side(isMoving)[cluster], x_);
    if (isMoving)
    {
        // Moving points stand above and below the fraction's line
        c.error *= 2;
    }
    return c;
}


template<int dim>
void Foam::termSelector<dim>::refine(const scalar threshold)
{
    refined_.clear();
    errorSum_ = lowSum_ = maxError_ = 0;
    for (const candidate& c : candidates_)
    {
        refine(c, threshold);
    }
    candidates_.swap(refined_);
}


template<int dim>
void Foam::termSelector<dim>::refine
(
    const candidate& c,
    const scalar threshold
)
{
    const auto& cluster = side(c.isMoving)[c.cluster];
    if (cluster.isLeaf())
    {
        sumPoints(c.cluster, c.isMoving);
        return;
    }
    if (c.error <= threshold)
    {
        refined_.append(c);
        if (c.low < 0)
        {
            refined_.last().low = side(c.isMoving).low(cluster, x_);
        }
        errorSum_ += c.error;
        lowSum_ += refined_.last().low;
        maxError_ = max(maxError_, c.error);
        return;
    }

    refine(makeCandidate(cluster.firstHalf, c.isMoving), threshold);
    refine(makeCandidate(cluster.secondHalf, c.isMoving), threshold);
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


template<int dim>
void Foam::termSelector<dim>::preferPoints()
{
    label nWeights = movingExpanded_.size()*multipole<dim>::nTerms;
    for (const label cluster : movingSummed_)
    {
        nWeights += moving_.tree().clusters()[cluster].size();
    }
    if (moving_.tree().size() > nWeights)
    {
        return;
    }

    for (const label cluster : movingExpanded_)
    {
        weight_ +=
            moving_.summedWeight(cluster, x_)
          - moving_.expandedWeight(cluster, x_);
    }
    movingExpanded_.clear();
    movingSummed_ = labelList(1, Zero);
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

    // Open first what must not be expanded at all
    scalar threshold = 0.5*VGREAT;
    while (true)
    {
        refine(threshold);
        const scalar allowed = tolerance_*(weight_ + lowSum_ - errorSum_);
        if (errorSum_ <= allowed)
        {
            break;
        }

        // Far above the even share of what is allowed, so that few more are
        // opened than needed; at least the worst, so that this ends
        threshold = min
        (
            16*tolerance_*(weight_ + lowSum_)/candidates_.size(),
            0.5*maxError_
        );
    }
    finish();
    preferPoints();
}


template class Foam::termSelector<1>;
template class Foam::termSelector<2>;
template class Foam::termSelector<3>;
