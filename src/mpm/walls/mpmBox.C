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

#include "mpmBox.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<int Dim>
mpm::Box<Dim>::Box(const Point3& lower, const Point3& upper)
{
    for (int d = 0; d < Dim; ++d)
    {
        centre_[d] = 0.5*(lower[d] + upper[d]);
        half_[d] = 0.5*(upper[d] - lower[d]);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim>
double mpm::Box<Dim>::distance
(
    const Vector<Dim>& x,
    Vector<Dim>& normal
) const
{
    // How far beyond the pair of faces across each direction
    Vector<Dim> beyond, side;
    double most = 0, square = 0, roundOff = 0;
    for (int d = 0; d < Dim; ++d)
    {
        const double place = x[d] - centre_[d];
        side[d] = place < 0 ? -1 : 1;
        beyond[d] = std::fabs(place) - half_[d];
        most = d == 0 ? beyond[d] : std::max(most, beyond[d]);
        square += beyond[d] > 0 ? beyond[d]*beyond[d] : 0;

        // 1e-12 of the coordinates is their round-off
        roundOff += 1e-12*(half_[d] + std::fabs(x[d]));
    }

    if (most > roundOff)
    {
        const double length = std::sqrt(square);
        for (int d = 0; d < Dim; ++d)
        {
            normal[d] = beyond[d] > 0 ? side[d]*beyond[d]/length : 0;
        }
        return length;
    }

    int nNearest = 0;
    for (int d = 0; d < Dim; ++d)
    {
        const bool nearest = beyond[d] >= most - roundOff;
        normal[d] = nearest ? side[d] : 0;
        nNearest += nearest;
    }
    for (double& n : normal)
    {
        n /= std::sqrt(double(nNearest));
    }
    return most;
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::Box<2>;
template class mpm::Box<3>;


// ************************************************************************* //
