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

#include "mpmCommunicator.H"

#include <string>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::vector<mpm::Buffer> mpm::Communicator::exchangeSized
(
    const std::vector<int>& ranks,
    const std::vector<Buffer>& sent
)
{
    std::vector<Buffer> sizes(ranks.size());
    std::vector<Buffer> itsSizes(ranks.size(), Buffer(sizeof(std::uint64_t)));
    for (std::size_t i = 0; i < ranks.size(); ++i)
    {
        const std::uint64_t n = sent[i].size();
        append(sizes[i], &n, 1);
    }
    exchange(ranks, sizes, itsSizes);

    std::vector<Buffer> received(ranks.size());
    for (std::size_t i = 0; i < ranks.size(); ++i)
    {
        std::uint64_t n = 0;
        std::size_t at = 0;
        take(itsSizes[i], at, &n, 1);
        received[i].resize(n);
    }
    exchange(ranks, sent, received);
    return received;
}


std::vector<mpm::Buffer> mpm::Communicator::gather(const Buffer& mine)
{
    std::vector<Buffer> sent(size());
    sent[0] = mine;
    std::vector<Buffer> received(allToAll(sent));
    if (!master())
    {
        received.clear();
    }
    return received;
}


void mpm::Communicator::broadcast(Buffer& buffer, const int from)
{
    std::vector<Buffer> sent(size());
    if (rank() == from)
    {
        sent.assign(size(), buffer);
    }
    buffer = allToAll(sent)[from];
}


void mpm::Communicator::agree(const std::function<void()>& f)
{
    if (size() == 1)
    {
        f();
        return;
    }

    constexpr double none = -1;
    enum Kind { fine, badInput, failed };

    std::string message;
    Kind kind = fine;
    try
    {
        f();
    }
    catch (const std::invalid_argument& e)
    {
        kind = badInput;
        message = e.what();
    }
    catch (const std::exception& e)
    {
        kind = failed;
        message = e.what();
    }

    // The first rank with an error has the largest of these
    std::vector<double> first{kind == fine ? none : double(size() - rank())};
    std::vector<std::int64_t> nothing;
    reduce(first, nothing);
    if (first[0] == none)
    {
        return;
    }

    Buffer text;
    text.push_back(char(kind));
    text.insert(text.end(), message.begin(), message.end());
    broadcast(text, size() - int(first[0]));

    message.assign(text.begin() + 1, text.end());
    if (text[0] == badInput)
    {
        throw std::invalid_argument(message);
    }
    throw std::runtime_error(message);
}


// ************************************************************************* //
