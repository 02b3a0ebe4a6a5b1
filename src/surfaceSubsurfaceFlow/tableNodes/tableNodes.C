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

#include "tableNodes.H"
#include "TableBase.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalarList Foam::tableNodes(const Function1<scalar>& function)
{
    const auto* table =
        dynamic_cast<const Function1Types::TableBase<scalar>*>(&function);

    return table ? scalarList(table->x()) : scalarList();
}


Foam::scalar Foam::nextNode(const UList<scalar>& nodes, const scalar t)
{
    const auto next = std::upper_bound(nodes.cbegin(), nodes.cend(), t);

    return next == nodes.cend() ? VGREAT : *next;
}

// ************************************************************************* //
