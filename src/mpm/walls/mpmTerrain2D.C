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

#include "mpmTerrain.H"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

mpm::Terrain<2>::Terrain
(
    const std::string& name,
    const std::vector<Point3>& vertices,
    const std::vector<std::array<int, 3>>&,
    const Vector<2>& up
)
:
    across_{{up[1], -up[0]}}
{
    for (const Point3& v : vertices)
    {
        vertices_.push_back({{v[0], v[1]}});
    }

    const auto horizontal = [this](const Vector<2>& v)
    {
        return v[0]*across_[0] + v[1]*across_[1];
    };

    if (horizontal(vertices_.front()) > horizontal(vertices_.back()))
    {
        std::reverse(vertices_.begin(), vertices_.end());
    }

    for (const Vector<2>& v : vertices_)
    {
        if (!along_.empty() && !(horizontal(v) > along_.back()))
        {
            std::ostringstream message;
            message
                << "wall " << name << ": the terrain line is vertical or "
                << "turns back at (" << v[0] << ' ' << v[1]
                << "); each vertex must lie farther along than the last";
            throw std::invalid_argument(message.str());
        }
        along_.push_back(horizontal(v));
    }

    for (std::size_t i = 0; i + 1 < vertices_.size(); ++i)
    {
        const Vector<2>& a = vertices_[i];
        const Vector<2>& b = vertices_[i + 1];
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);

        // The piece turned by a right angle, on the side of up
        Vector<2> n{{-(b[1] - a[1])/length, (b[0] - a[0])/length}};
        if (n[0]*up[0] + n[1]*up[1] < 0)
        {
            n = {{-n[0], -n[1]}};
        }
        normals_.push_back(n);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double mpm::Terrain<2>::distance
(
    const Vector<2>& x,
    Vector<2>& normal
) const
{
    const double s = x[0]*across_[0] + x[1]*across_[1];
    const int nPieces = int(normals_.size());

    // Piece above or below x
    const int home = std::min
    (
        nPieces - 1,
        std::max
        (
            0,
            int
            (
                std::upper_bound(along_.begin(), along_.end(), s)
              - along_.begin()
            ) - 1
        )
    );

    double best = std::numeric_limits<double>::max();
    Vector<2> away{{0, 0}};
    int piece = home;
    int corner = -1;

    const auto look = [&](const int i)
    {
        const Vector<2>& a = vertices_[i];
        const Vector<2>& b = vertices_[i + 1];
        const double bx = b[0] - a[0], by = b[1] - a[1];
        const double position =
            ((x[0] - a[0])*bx + (x[1] - a[1])*by)/(bx*bx + by*by);

        // The end pieces go on for ever
        double t = position;
        if (i > 0)
        {
            t = std::max(t, 0.0);
        }
        if (i < nPieces - 1)
        {
            t = std::min(t, 1.0);
        }

        const Vector<2> r{{x[0] - a[0] - t*bx, x[1] - a[1] - t*by}};
        const double square = r[0]*r[0] + r[1]*r[1];
        if (square < best)
        {
            best = square;
            away = r;
            piece = i;
            corner = t == position ? -1 : (t == 0 ? i : i + 1);
        }
    };

    // Outwards, until the next piece is farther away horizontally than the
    // nearest so far is in all
    look(home);
    for (int i = home + 1; i < nPieces; ++i)
    {
        const double gap = along_[i] - s;
        if (gap > 0 && gap*gap > best)
        {
            break;
        }
        look(i);
    }
    for (int i = home - 1; i >= 0; --i)
    {
        const double gap = s - along_[i + 1];
        if (gap > 0 && gap*gap > best)
        {
            break;
        }
        look(i);
    }

    // In a section the two pieces of a corner weigh the same
    Vector<2> side = normals_[piece];
    if (corner > 0 && corner < nPieces)
    {
        for (int d = 0; d < 2; ++d)
        {
            side[d] = normals_[corner - 1][d] + normals_[corner][d];
        }
    }

    const double length = std::sqrt(best);
    const double sign = away[0]*side[0] + away[1]*side[1] < 0 ? -1 : 1;

    // On the line itself the direction is that of the piece; 1e-12 of the
    // place's coordinates is their round-off
    const double roundOff =
        1e-12*(1 + std::fabs(x[0]) + std::fabs(x[1]));
    if (length <= roundOff)
    {
        normal = normals_[piece];
    }
    else
    {
        normal = {{sign*away[0]/length, sign*away[1]/length}};
    }

    return sign*length;
}


// ************************************************************************* //
