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

#include "pointTable.H"

#include <iomanip>
#include <limits>
#include <ostream>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointTable::pointTable(const pointField& points)
:
    points_(points),
    columns_()
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pointTable::writeColumns
(
    std::ostream& os,
    const std::string& headerStart,
    const std::string& separator
) const
{
    os  << headerStart << 'x' << separator << 'y' << separator << 'z';

    for (const column& c : columns_)
    {
        for (const word& cmpt : c.components)
        {
            os  << separator << c.name;

            if (!cmpt.empty())
            {
                os  << '_' << cmpt;
            }
        }
    }

    os  << std::setprecision(std::numeric_limits<scalar>::max_digits10);

    forAll(points_, pointi)
    {
        const point& p = points_[pointi];

        os  << '\n' << p.x() << separator << p.y() << separator << p.z();

        for (const column& c : columns_)
        {
            const label n = c.components.size();

            for (label i = pointi*n; i < (pointi + 1)*n; ++i)
            {
                os  << separator << c.values[i];
            }
        }
    }

    os  << '\n';
}

// ************************************************************************* //
