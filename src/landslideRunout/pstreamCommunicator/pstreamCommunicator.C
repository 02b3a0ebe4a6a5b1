/*---------------------------------------------------------------------------*\
    slideFoam | from rain to runout
    Copyright (C) 2026 the slideFoam authors
-------------------------------------------------------------------------------
License
    This file is part of slideFoam.

    slideFoam is free software: you can redistribute it and/or modify it
    under the terms of the GNU General Public License as published by the
    Free Software Foundation, either version 3 of the License, or (at your
    option) any later version.

    slideFoam is distributed in the hope that it will be useful, but WITHOUT
    ANY WARRANTY; without even the implied warranty of MERCHANTABILITY or
    FITNESS FOR A PARTICULAR PURPOSE. See the GNU General Public License for
    more details.

    You should have received a copy of the GNU General Public License along
    with slideFoam. If not, see <http://www.gnu.org/licenses/>.

\*---------------------------------------------------------------------------*/

#include "pstreamCommunicator.H"
#include "Pstream.H"
#include "UIPstream.H"
#include "UOPstream.H"
#include "labelList.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// Messages of more bytes, whose number must be an int, are sent in pieces
static const std::size_t largestPiece = std::size_t(1) << 30;

// What two ranks know of maxima and sums, as bytes
static void combine
(
    mpm::Buffer& mine,
    const mpm::Buffer& theirs,
    const std::size_t nMaxima
)
{
    for (std::size_t i = 0; i < mine.size()/sizeof(double); ++i)
    {
        char* at = mine.data() + i*sizeof(double);
        const char* other = theirs.data() + i*sizeof(double);

        if (i < nMaxima)
        {
            double a, b;
            std::memcpy(&a, at, sizeof(a));
            std::memcpy(&b, other, sizeof(b));
            a = std::max(a, b);
            std::memcpy(at, &a, sizeof(a));
        }
        else
        {
            std::int64_t a, b;
            std::memcpy(&a, at, sizeof(a));
            std::memcpy(&b, other, sizeof(b));
            a += b;
            std::memcpy(at, &a, sizeof(a));
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::pstreamCommunicator::send(const mpm::Buffer& buffer, const int to)
{
    for (std::size_t at = 0; at < buffer.size(); at += largestPiece)
    {
        UOPstream::write
        (
            UPstream::commsTypes::nonBlocking,
            to,
            buffer.data() + at,
            std::min(largestPiece, buffer.size() - at)
        );
    }
}


void Foam::pstreamCommunicator::receive(mpm::Buffer& buffer, const int from)
{
    for (std::size_t at = 0; at < buffer.size(); at += largestPiece)
    {
        UIPstream::read
        (
            UPstream::commsTypes::nonBlocking,
            from,
            buffer.data() + at,
            std::min(largestPiece, buffer.size() - at)
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int Foam::pstreamCommunicator::rank() const
{
    return UPstream::parRun() ? UPstream::myProcNo() : 0;
}


int Foam::pstreamCommunicator::size() const
{
    return UPstream::parRun() ? UPstream::nProcs() : 1;
}


void Foam::pstreamCommunicator::reduce
(
    std::vector<double>& maxima,
    std::vector<std::int64_t>& sums
)
{
    const int nRanks = size();

    if (nRanks == 1)
    {
        return;
    }

    const int me = rank();
    const std::size_t nMaxima = maxima.size();

    mpm::Buffer mine;
    mpm::append(mine, maxima.data(), maxima.size());
    mpm::append(mine, sums.data(), sums.size());
    mpm::Buffer theirs(mine.size());

    const auto swap =
        [&](const int other)
        {
            const label start = UPstream::nRequests();
            receive(theirs, other);
            send(mine, other);
            UPstream::waitRequests(start);
            combine(mine, theirs, nMaxima);
        };
    const auto sendTo =
        [&](const int other)
        {
            const label start = UPstream::nRequests();
            send(mine, other);
            UPstream::waitRequests(start);
        };
    const auto receiveFrom =
        [&](mpm::Buffer& buffer, const int other)
        {
            const label start = UPstream::nRequests();
            receive(buffer, other);
            UPstream::waitRequests(start);
        };

    // Ranks beyond a power of two have others speak for them
    int power = 1;
    while (2*power <= nRanks)
    {
        power *= 2;
    }
    const int nSpokenFor = nRanks - power;

    if (me >= power)
    {
        sendTo(me - power);
        receiveFrom(mine, me - power);
    }
    else
    {
        if (me < nSpokenFor)
        {
            receiveFrom(theirs, me + power);
            combine(mine, theirs, nMaxima);
        }
        for (int bit = 1; bit < power; bit *= 2)
        {
            swap(me ^ bit);
        }
        if (me < nSpokenFor)
        {
            sendTo(me + power);
        }
    }

    std::size_t at = 0;
    mpm::take(mine, at, maxima.data(), maxima.size());
    mpm::take(mine, at, sums.data(), sums.size());
}


void Foam::pstreamCommunicator::exchange
(
    const std::vector<int>& ranks,
    const std::vector<mpm::Buffer>& sent,
    std::vector<mpm::Buffer>& received
)
{
    const label start = UPstream::nRequests();

    for (std::size_t i = 0; i < ranks.size(); ++i)
    {
        receive(received[i], ranks[i]);
    }
    for (std::size_t i = 0; i < ranks.size(); ++i)
    {
        send(sent[i], ranks[i]);
    }

    UPstream::waitRequests(start);
}


std::vector<mpm::Buffer> Foam::pstreamCommunicator::allToAll
(
    const std::vector<mpm::Buffer>& sent
)
{
    if (size() == 1)
    {
        return sent;
    }

    // A label may be too short for the size of a buffer
    labelList pieces(size());
    labelList rest(size());
    forAll(pieces, r)
    {
        pieces[r] = sent[r].size()/largestPiece;
        rest[r] = sent[r].size() % largestPiece;
    }
    labelList itsPieces(size());
    labelList itsRest(size());
    UPstream::allToAll(pieces, itsPieces);
    UPstream::allToAll(rest, itsRest);

    std::vector<mpm::Buffer> received(size());
    const label start = UPstream::nRequests();

    for (int r = 0; r < size(); ++r)
    {
        if (r != rank())
        {
            received[r].resize(itsPieces[r]*largestPiece + itsRest[r]);
            receive(received[r], r);
        }
    }
    for (int r = 0; r < size(); ++r)
    {
        if (r != rank())
        {
            send(sent[r], r);
        }
    }
    received[rank()] = sent[rank()];

    UPstream::waitRequests(start);

    return received;
}

// ************************************************************************* //
