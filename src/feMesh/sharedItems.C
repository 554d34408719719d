/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "sharedItems.H"
#include "PstreamBuffers.H"
#include "DynamicList.H"
#include "ListOps.H"
#include "Map.H"
#include "UIPstream.H"
#include "UOPstream.H"

#include <algorithm>
#include <numeric>

namespace
{

using namespace Foam;

//- A key that a processor has sent, with its place among those it sent
struct sentKey
{
    labelPair key;
    label rank;
    label place;

    bool operator<(const sentKey& other) const
    {
        return
            key.first() != other.key.first()
          ? key.first() < other.key.first()
          : key.second() != other.key.second()
          ? key.second() < other.key.second()
          : rank < other.rank;
    }
};

//- For each sender the replies (place, number of holders, holders) about the
//  keys that more than one processor has sent
List<DynamicList<label>> matchKeys(std::vector<sentKey>& sent)
{
    List<DynamicList<label>> replies(Pstream::nProcs());
    std::sort(sent.begin(), sent.end());

    for (size_t begin = 0, end = 0; begin < sent.size(); begin = end)
    {
        while (end < sent.size() && sent[end].key == sent[begin].key)
        {
            ++end;
        }
        for (size_t i = begin; i < end && end - begin > 1; ++i)
        {
            DynamicList<label>& reply = replies[sent[i].rank];
            reply.append(sent[i].place);
            reply.append(end - begin);
            for (size_t j = begin; j < end; ++j)
            {
                reply.append(sent[j].rank);
            }
        }
    }
    return replies;
}

//- Send a list to each processor, receive one from each
template<class T>
List<List<T>> sendToEach(const UList<DynamicList<T>>& outgoing)
{
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    forAll(outgoing, ranki)
    {
        UOPstream to(ranki, buffers);
        to << static_cast<const UList<T>&>(outgoing[ranki]);
    }
    buffers.finishedSends();

    List<List<T>> incoming(outgoing.size());
    forAll(incoming, ranki)
    {
        UIPstream from(ranki, buffers);
        from >> incoming[ranki];
    }
    return incoming;
}

} // End namespace


Foam::sharedItems::sharedItems(const label nItems)
:
    start_(1, Zero),
    sourceStart_(1, Zero),
    owned_(nItems, true)
{}


Foam::sharedItems::sharedItems
(
    const label nItems,
    const labelUList& candidates,
    const UList<labelPair>& keys
)
:
    sharedItems(nItems)
{
    if (Pstream::parRun())
    {
        sort(keys, candidates, holders(keys));
    }
}


Foam::labelListList Foam::sharedItems::holders(const UList<labelPair>& keys)
{
    // Each key has a processor where all that hold it meet
    const label nRanks = Pstream::nProcs();
    List<DynamicList<labelPair>> outgoing(nRanks);
    List<DynamicList<label>> sentFrom(nRanks);
    forAll(keys, i)
    {
        const label meeting = keys[i].first() % nRanks;
        outgoing[meeting].append(keys[i]);
        sentFrom[meeting].append(i);
    }

    const List<List<labelPair>> incoming(sendToEach(outgoing));
    std::vector<sentKey> sent;
    forAll(incoming, ranki)
    {
        forAll(incoming[ranki], place)
        {
            sent.push_back({incoming[ranki][place], ranki, place});
        }
    }

    const List<List<label>> replies(sendToEach(matchKeys(sent)));
    labelListList result(keys.size());
    forAll(replies, ranki)
    {
        const labelList& reply = replies[ranki];
        for (label at = 0; at < reply.size(); at += 2 + reply[at + 1])
        {
            result[sentFrom[ranki][reply[at]]] =
                SubList<label>(reply, reply[at + 1], at + 2);
        }
    }
    return result;
}


void Foam::sharedItems::sort
(
    const UList<labelPair>& keys,
    const labelUList& candidates,
    const labelListList& holders
)
{
    // In the order of the keys, which is the same on both sides of a message
    std::vector<label> byKey(keys.size());
    std::iota(byKey.begin(), byKey.end(), 0);
    std::sort
    (
        byKey.begin(), byKey.end(), [&](const label a, const label b)
        {
            return
                keys[a].first() != keys[b].first()
              ? keys[a].first() < keys[b].first()
              : keys[a].second() < keys[b].second();
        }
    );

    List<DynamicList<label>> withRank(Pstream::nProcs());
    Map<label> candidateOf;
    DynamicList<label> shared;
    for (const label i : byKey)
    {
        for (const label ranki : holders[i])
        {
            if (ranki != Pstream::myProcNo())
            {
                withRank[ranki].append(candidates[i]);
            }
        }
        if (holders[i].size())
        {
            shared.append(candidates[i]);
            candidateOf.insert(candidates[i], i);
            owned_[candidates[i]] = (holders[i][0] == Pstream::myProcNo());
        }
    }

    DynamicList<label> ranks, start, items;
    Map<DynamicList<label>> placesOf;
    start.append(0);
    forAll(withRank, ranki)
    {
        if (withRank[ranki].empty())
        {
            continue;
        }
        for (const label itemi : withRank[ranki])
        {
            placesOf(itemi).append(items.size());
            items.append(itemi);
        }
        ranks.append(ranki);
        start.append(items.size());
    }

    Foam::sort(shared);
    DynamicList<label> source, sourceStart;
    sourceStart.append(0);
    for (const label itemi : shared)
    {
        label next = 0;
        for (const label ranki : holders[candidateOf[itemi]])
        {
            source.append
            (
                ranki == Pstream::myProcNo() ? -1 : placesOf[itemi][next++]
            );
        }
        sourceStart.append(source.size());
    }

    ranks_.transfer(ranks);
    start_.transfer(start);
    items_.transfer(items);
    shared_.transfer(shared);
    source_.transfer(source);
    sourceStart_.transfer(sourceStart);
}


Foam::label Foam::sharedItems::nOwned() const
{
    return std::count(owned_.begin(), owned_.end(), true);
}


void Foam::sharedItems::exchange
(
    const double* data,
    const label stride,
    const label n
) const
{
    const size_t size = size_t(items_.size())*n;
    if (sendBuffer_.size() < size)
    {
        sendBuffer_.resize(size);
        receiveBuffer_.resize(size);
    }

    const label firstRequest = UPstream::nRequests();
    const auto commsType = UPstream::commsTypes::nonBlocking;
    forAll(ranks_, i)
    {
        UIPstream::read
        (
            commsType,
            ranks_[i],
            reinterpret_cast<char*>(&receiveBuffer_[size_t(start_[i])*n]),
            sizeof(double)*n*(start_[i + 1] - start_[i])
        );
    }

    double* to = sendBuffer_.data();
    for (const label itemi : items_)
    {
        const double* from = data + size_t(stride)*itemi;
        to = std::copy(from, from + n, to);
    }

    forAll(ranks_, i)
    {
        UOPstream::write
        (
            commsType,
            ranks_[i],
            reinterpret_cast<const char*>(&sendBuffer_[size_t(start_[i])*n]),
            sizeof(double)*n*(start_[i + 1] - start_[i])
        );
    }
    UPstream::waitRequests(firstRequest);
}


template<class CombineOp>
void Foam::sharedItems::reduce
(
    double* data,
    const label stride,
    const label n,
    const CombineOp& combine
) const
{
    if (ranks_.empty())
    {
        return;
    }
    exchange(data, stride, n);

    forAll(shared_, i)
    {
        double* own = data + size_t(stride)*shared_[i];
        for (label c = 0; c < n; ++c)
        {
            auto copy = [&](const label k)
            {
                const label place = source_[k];
                return place < 0 ? own[c] : receiveBuffer_[size_t(place)*n + c];
            };
            double result = copy(sourceStart_[i]);
            for (label k = sourceStart_[i] + 1; k < sourceStart_[i + 1]; ++k)
            {
                result = combine(result, copy(k));
            }
            own[c] = result;
        }
    }
}


void Foam::sharedItems::sum
(
    double* data,
    const label stride,
    const label n
) const
{
    reduce(data, stride, n, [](double a, double b) { return a + b; });
}


void Foam::sharedItems::min
(
    double* data,
    const label stride,
    const label n
) const
{
    reduce(data, stride, n, [](double a, double b) { return b < a ? b : a; });
}


void Foam::sharedItems::max
(
    double* data,
    const label stride,
    const label n
) const
{
    reduce(data, stride, n, [](double a, double b) { return b > a ? b : a; });
}


void Foam::sharedItems::min(labelList& data) const
{
    std::vector<double> values(data.begin(), data.end());
    min(values.data(), 1, 1);
    std::copy(values.begin(), values.end(), data.begin());
}


void Foam::sharedItems::max(labelList& data) const
{
    std::vector<double> values(data.begin(), data.end());
    max(values.data(), 1, 1);
    std::copy(values.begin(), values.end(), data.begin());
}
