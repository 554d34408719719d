/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "quiescentZones.H"
#include "PstreamReduceOps.H"

#include <algorithm>

template<int dim>
Foam::quiescentZones<dim>::quiescentZones
(
    gasGeometry<dim>& geometry,
    const dictionary& feSchemes
)
:
    geometry_(geometry),
    sleeping_(false),
    started_(false),
    still_(uniformRow(0))
{
    if (!feSchemes.getOrDefault<Switch>("quiescentZones", true))
    {
        forbid("quiescentZones is off in " + feSchemes.name().name());
    }
}


template<int dim>
void Foam::quiescentZones<dim>::forbid(const string& reason)
{
    if (reason_.empty())
    {
        reason_ = reason;
        Info<< "Quiescent zones: none, " << reason.c_str() << nl << endl;
        if (started_)
        {
            wakeAll();
        }
    }
}


template<int dim>
void Foam::quiescentZones<dim>::findStill(const gasState<dim>& state)
{
    // Of the gas at rest at the pressure that most nodes have the density that
    // most have; the master processor's for all
    std::vector<label> candidates;
    if (Pstream::master())
    {
        for (label a = 0; a < state.nNodes(); ++a)
        {
            bool rests = state.p(a) == state.pRef;
            for (int k = 0; k < dim; ++k)
            {
                rests = rests && state.rows[a][1 + k] == 0;
            }
            if (rests)
            {
                candidates.push_back(a);
            }
        }
    }
    if (candidates.size())
    {
        const auto middle = candidates.begin() + candidates.size()/2;
        std::nth_element
        (
            candidates.begin(), middle, candidates.end(),
            [&](const label a, const label b)
            {
                return state.rho(a) < state.rho(b);
            }
        );
        still_ = state.rows[*middle];
    }
    for (double& value : still_.v)
    {
        Pstream::scatter(value);
    }
}


template<int dim>
void Foam::quiescentZones<dim>::findNeighbours()
{
    const feMesh& mesh = geometry_.mesh();
    start_.setSize(mesh.nNodes() + 1, Zero);
    for (const edge& e : mesh.edges())
    {
        ++start_[e[0] + 1];
        ++start_[e[1] + 1];
    }
    for (label a = 0; a < mesh.nNodes(); ++a)
    {
        start_[a + 1] += start_[a];
    }
    labelList next(start_);
    neighbours_.setSize(2*mesh.nEdges());
    for (const edge& e : mesh.edges())
    {
        neighbours_[next[e[0]]++] = e[1];
        neighbours_[next[e[1]]++] = e[0];
    }
}


template<int dim>
void Foam::quiescentZones<dim>::seed(const label node)
{
    if (distance_[node] > 0)
    {
        distance_[node] = 0;
        asleep_[activeParts::block(node)] = false;
        front_.push_back(node);
    }
}


template<int dim>
void Foam::quiescentZones<dim>::spreadHere()
{
    while (front_.size())
    {
        next_.clear();
        for (const label a : front_)
        {
            const unsigned char d = distance_[a] + 1;
            for (label k = start_[a]; d < far_ && k < start_[a + 1]; ++k)
            {
                const label b = neighbours_[k];
                if (d < distance_[b])
                {
                    distance_[b] = d;
                    asleep_[activeParts::block(b)] = false;
                    next_.push_back(b);
                }
            }
        }
        front_.swap(next_);
    }
}


template<int dim>
void Foam::quiescentZones<dim>::spread()
{
    const sharedItems& exchange = geometry_.mesh().exchange();
    bool changed = true;
    while (changed)
    {
        spreadHere();
        for (const label a : exchange.shared())
        {
            shared_[a] = distance_[a];
        }
        exchange.min(shared_.data(), 1, 1);
        for (const label a : exchange.shared())
        {
            if (shared_[a] < distance_[a])
            {
                distance_[a] = shared_[a];
                asleep_[activeParts::block(a)] = false;
                front_.push_back(a);
            }
        }
        changed = returnReduce(front_.size() > 0, orOp<bool>());
    }
    wake();
}


template<int dim>
void Foam::quiescentZones<dim>::wake()
{
    activeParts& parts = geometry_.active();
    for (label b = 0; b < parts.nBlocks(); ++b)
    {
        if (parts.blockAsleep(b) && !asleep_[b])
        {
            watched_.push_back(b);
        }
    }
    parts.set(asleep_);
    sleeping_ = returnReduce(parts.nAsleep() > 0, orOp<bool>());
}


template<int dim>
void Foam::quiescentZones<dim>::start
(
    const gasState<dim>& state,
    const gasBoundary<dim>& boundary,
    const std::vector<double>& speed
)
{
    started_ = true;
    findStill(state);
    if (!(still_[0] > 0))
    {
        forbid("no gas is at rest at the pressure that most nodes have");
        return;
    }

    const label nNodes = geometry_.nNodes();
    const label nBlocks = geometry_.active().nBlocks();
    findNeighbours();
    distance_.assign(nNodes, far_);
    shared_.assign(nNodes, 0.0);
    speeds_ = speed;
    watched_.reserve(nBlocks);
    front_.reserve(nNodes);
    next_.reserve(nNodes);

    // What holds no node sleeps as well
    asleep_.assign(nBlocks, true);
    geometry_.active().set(asleep_);
    for (label a = 0; a < nNodes; ++a)
    {
        if (!isStill(state.rows[a]))
        {
            seed(a);
        }
    }
    for (const label a : boundary.acting(state))
    {
        seed(a);
    }
    spread();
}


template<int dim>
void Foam::quiescentZones<dim>::setSpeeds(std::vector<double>& speed) const
{
    if (!sleeping_)
    {
        return;
    }
    const label nNodes = geometry_.nNodes();
    for (const label b : watched_)
    {
        const activeParts::range r = geometry_.active().rows(b);
        for (label a = r.from; a < r.to && a < nNodes; ++a)
        {
            if (distance_[a] > 1)
            {
                speed[a] = speeds_[a];
            }
        }
    }
}


template<int dim>
void Foam::quiescentZones<dim>::update
(
    const gasState<dim>& state,
    const labelUList& prescribed
)
{
    if (!sleeping_)
    {
        return;
    }
    const label nNodes = geometry_.nNodes();
    std::size_t nWatched = 0;
    for (const label b : watched_)
    {
        const activeParts::range r = geometry_.active().rows(b);
        bool rests = false;
        for (label a = r.from; a < r.to && a < nNodes; ++a)
        {
            if (distance_[a] > 0)
            {
                if (isStill(state.rows[a]))
                {
                    rests = true;
                }
                else
                {
                    seed(a);
                }
            }
        }
        if (rests)
        {
            watched_[nWatched++] = b;
        }
    }
    watched_.resize(nWatched);
    for (const label a : prescribed)
    {
        if (!isStill(state.rows[a]))
        {
            seed(a);
        }
    }
    if (returnReduce(front_.size() > 0, orOp<bool>()))
    {
        spread();
    }
}


template<int dim>
void Foam::quiescentZones<dim>::wake(const labelUList& nodes)
{
    if (!sleeping_)
    {
        return;
    }
    for (const label a : nodes)
    {
        seed(a);
    }
    if (returnReduce(front_.size() > 0, orOp<bool>()))
    {
        spread();
    }
}


template<int dim>
void Foam::quiescentZones<dim>::wakeAll()
{
    sleeping_ = false;
    asleep_.assign(geometry_.active().nBlocks(), false);
    geometry_.active().set(asleep_);
}


template<int dim>
Foam::scalar Foam::quiescentZones<dim>::activeShare() const
{
    const activeParts& parts = geometry_.active();
    const label n = returnReduce(parts.nBlocks(), sumOp<label>());
    const label nAsleep = returnReduce(parts.nAsleep(), sumOp<label>());
    return 1 - scalar(nAsleep)/n;
}


template<int dim>
void Foam::quiescentZones<dim>::report(Ostream& os) const
{
    if (started_ && reason_.empty())
    {
        const scalar share = activeShare();
        os  << "Quiescent zones: " << 100*share << " % of the gas is active"
            << nl << endl;
    }
}


template class Foam::quiescentZones<1>;
template class Foam::quiescentZones<2>;
template class Foam::quiescentZones<3>;
