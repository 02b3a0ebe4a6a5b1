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

#include "mpmSideTable.H"
#include "mpmBinary.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim>
void mpm::SideTable<Dim>::share
(
    Communicator& communicator,
    const std::vector<Entry>& mine
)
{
    Buffer bytes;
    append(bytes, mine.data(), mine.size());

    entries_.clear();
    const std::vector<Buffer> sent(communicator.size(), bytes);
    for (const Buffer& buffer : communicator.allToAll(sent))
    {
        for (std::size_t at = 0; at < buffer.size();)
        {
            Entry entry;
            take(buffer, at, &entry, 1);
            entries_[{entry.block, {entry.node, entry.wall}}] = entry;
        }
    }
}


template<int Dim>
void mpm::SideTable<Dim>::write(std::ostream& os) const
{
    std::vector<Entry> all;
    for (const auto& entry : entries_)
    {
        all.push_back(entry.second);
    }
    writeBinary(os, all);
}


template<int Dim>
void mpm::SideTable<Dim>::read(Communicator& communicator, std::istream& is)
{
    std::vector<Entry> all;
    communicator.agree
    (
        [&]()
        {
            if (communicator.master())
            {
                readBinary(is, all);
            }
        }
    );
    share(communicator, all);
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::SideTable<2>;
template class mpm::SideTable<3>;


// ************************************************************************* //
