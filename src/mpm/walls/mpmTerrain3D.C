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
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace mpm
{
namespace
{

typedef Vector<3> V;

V operator-(const V& a, const V& b)
{
    return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}

V operator+(const V& a, const V& b)
{
    return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
}

V operator*(const double s, const V& a)
{
    return {{s*a[0], s*a[1], s*a[2]}};
}

double dot(const V& a, const V& b)
{
    return a[0]*b[0] + a[1]*b[1] + a[2]*b[2];
}

V cross(const V& a, const V& b)
{
    return
    {{
        a[1]*b[2] - a[2]*b[1],
        a[2]*b[0] - a[0]*b[2],
        a[0]*b[1] - a[1]*b[0]
    }};
}

} // End anonymous namespace
} // End namespace mpm


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::array<double, 2> mpm::Terrain<3>::plan(const Vector<3>& x) const
{
    return {{dot(x, east_), dot(x, north_)}};
}


void mpm::Terrain<3>::orient(const std::string& name, const Vector<3>& up)
{
    for (std::size_t i = 0; i < triangles_.size(); ++i)
    {
        Triangle& t = triangles_[i];
        const V area = cross(t.p[1] - t.p[0], t.p[2] - t.p[0]);
        const double size = std::sqrt(dot(area, area));
        const double upward = dot(area, up);

        // Steeper than 89.9 degrees is a wall, not ground
        constexpr double least = 1e-3;
        if (!(std::fabs(upward) > least*size))
        {
            std::ostringstream message;
            message
                << "wall " << name << ": triangle " << i
                << " of the terrain is vertical or has no area";
            throw std::invalid_argument(message.str());
        }
        t.normal = ((upward > 0 ? 1 : -1)/size)*area;
    }
}


void mpm::Terrain<3>::meanNormals
(
    const std::vector<std::array<int, 3>>& corners
)
{
    std::map<std::pair<int, int>, V> ofEdge;
    std::map<std::pair<int, int>, int> uses;
    std::map<int, V> ofCorner;
    std::set<int> rimCorners;

    const auto edge = [&corners](const std::size_t t, const int i)
    {
        return std::minmax(corners[t][i], corners[t][(i + 1)%3]);
    };

    for (std::size_t t = 0; t < triangles_.size(); ++t)
    {
        const Triangle& triangle = triangles_[t];
        for (int i = 0; i < 3; ++i)
        {
            const V a = triangle.p[(i + 1)%3] - triangle.p[i];
            const V b = triangle.p[(i + 2)%3] - triangle.p[i];
            const V c = cross(a, b);
            const double angle = std::atan2(std::sqrt(dot(c, c)), dot(a, b));

            V& e = ofEdge[edge(t, i)];
            e = e + triangle.normal;
            ++uses[edge(t, i)];
            V& n = ofCorner[corners[t][i]];
            n = n + angle*triangle.normal;
        }
    }

    for (const auto& use : uses)
    {
        if (use.second == 1)
        {
            rimCorners.insert(use.first.first);
            rimCorners.insert(use.first.second);
        }
    }

    for (std::size_t t = 0; t < triangles_.size(); ++t)
    {
        for (int i = 0; i < 3; ++i)
        {
            triangles_[t].edgeNormals[i] = ofEdge[edge(t, i)];
            triangles_[t].cornerNormals[i] = ofCorner[corners[t][i]];
            triangles_[t].rimEdge[i] = uses[edge(t, i)] == 1;
            triangles_[t].rimCorner[i] =
                rimCorners.count(corners[t][i]) > 0;
        }
    }
}


void mpm::Terrain<3>::fillBins()
{
    constexpr double most = std::numeric_limits<double>::max();
    std::array<double, 2> low{{most, most}}, high{{-most, -most}};
    for (const Triangle& t : triangles_)
    {
        for (const V& p : t.p)
        {
            for (int d = 0; d < 2; ++d)
            {
                low[d] = std::min(low[d], plan(p)[d]);
                high[d] = std::max(high[d], plan(p)[d]);
            }
        }
    }

    // About one triangle a bin
    binSize_ = std::sqrt
    (
        (high[0] - low[0])*(high[1] - low[1])/double(triangles_.size())
    );
    binOrigin_ = low;
    for (int d = 0; d < 2; ++d)
    {
        nBins_[d] = 1 + int((high[d] - low[d])/binSize_);
    }
    bins_.resize(std::size_t(nBins_[0])*nBins_[1]);

    for (std::size_t i = 0; i < triangles_.size(); ++i)
    {
        std::array<int, 2> first{{nBins_[0], nBins_[1]}}, last{{0, 0}};
        for (const V& p : triangles_[i].p)
        {
            for (int d = 0; d < 2; ++d)
            {
                const int b = int((plan(p)[d] - binOrigin_[d])/binSize_);
                first[d] = std::min(first[d], b);
                last[d] = std::max(last[d], std::min(b, nBins_[d] - 1));
            }
        }
        for (int y = first[1]; y <= last[1]; ++y)
        {
            for (int x = first[0]; x <= last[0]; ++x)
            {
                bins_[x + std::size_t(nBins_[0])*y].push_back(int(i));
            }
        }
    }
}


double mpm::Terrain<3>::nearest
(
    const Triangle& t,
    const Vector<3>& x,
    Vector<3>& place,
    Vector<3>& side,
    bool& atRim
)
{
    // Inside the prism over the triangle?
    bool inside = true;
    for (int i = 0; i < 3; ++i)
    {
        const V along = t.p[(i + 1)%3] - t.p[i];
        V inward = cross(t.normal, along);
        if (dot(inward, t.p[(i + 2)%3] - t.p[i]) < 0)
        {
            inward = -1.0*inward;
        }
        inside = inside && dot(inward, x - t.p[i]) >= 0;
    }
    if (inside)
    {
        const double height = dot(t.normal, x - t.p[0]);
        place = x - height*t.normal;
        side = t.normal;
        atRim = false;
        return height*height;
    }

    // Else the nearest of the edges, with their ends
    double best = std::numeric_limits<double>::max();
    for (int i = 0; i < 3; ++i)
    {
        const V along = t.p[(i + 1)%3] - t.p[i];
        const double s = dot(x - t.p[i], along)/dot(along, along);
        const double onEdge = std::min(1.0, std::max(0.0, s));
        const V p = t.p[i] + onEdge*along;
        const double square = dot(x - p, x - p);
        if (square < best)
        {
            best = square;
            place = p;
            side =
                s <= 0 ? t.cornerNormals[i]
              : s >= 1 ? t.cornerNormals[(i + 1)%3]
              : t.edgeNormals[i];
            atRim =
                s <= 0 ? t.rimCorner[i]
              : s >= 1 ? t.rimCorner[(i + 1)%3]
              : t.rimEdge[i];
        }
    }
    return best;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

mpm::Terrain<3>::Terrain
(
    const std::string& name,
    const std::vector<Point3>& vertices,
    const std::vector<std::array<int, 3>>& triangles,
    const Vector<3>& up
)
{
    // The coordinate direction least along up gives the first horizontal one
    int least = 0;
    for (int d = 1; d < 3; ++d)
    {
        if (std::fabs(up[d]) < std::fabs(up[least]))
        {
            least = d;
        }
    }
    V e{{0, 0, 0}};
    e[least] = 1;
    const V horizontal = e - dot(e, up)*up;
    east_ = (1/std::sqrt(dot(horizontal, horizontal)))*horizontal;
    north_ = cross(up, east_);

    triangles_.resize(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
        for (int i = 0; i < 3; ++i)
        {
            triangles_[t].p[i] = vertices[triangles[t][i]];
        }
    }

    orient(name, up);
    meanNormals(triangles);
    fillBins();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double mpm::Terrain<3>::distance
(
    const Vector<3>& x,
    Vector<3>& normal
) const
{
    const std::array<double, 2> s = plan(x);
    std::array<int, 2> home;
    for (int d = 0; d < 2; ++d)
    {
        const double b = std::floor((s[d] - binOrigin_[d])/binSize_);
        home[d] = int(std::min(nBins_[d] - 1.0, std::max(0.0, b)));
    }

    double best = std::numeric_limits<double>::max();
    V place{{0, 0, 0}}, side{{0, 0, 0}};
    int nearestOne = 0;
    bool atRim = false;

    // Rings of bins outwards: what ring r holds is at least the distance
    // from x to the border of the rings before it away
    const int nRings = std::max(nBins_[0], nBins_[1]);
    for (int r = 0; r < nRings; ++r)
    {
        double border = std::numeric_limits<double>::max();
        for (int d = 0; d < 2; ++d)
        {
            const double low = binOrigin_[d] + (home[d] - r + 1)*binSize_;
            const double high = binOrigin_[d] + (home[d] + r)*binSize_;
            border = std::min(border, std::min(s[d] - low, high - s[d]));
        }
        if (r > 0 && border > 0 && border*border > best)
        {
            break;
        }

        for (int j = -r; j <= r; ++j)
        {
            const int y = home[1] + j;
            if (y < 0 || y >= nBins_[1])
            {
                continue;
            }
            const int stride = std::abs(j) == r ? 1 : std::max(1, 2*r);
            for (int i = -r; i <= r; i += stride)
            {
                const int b = home[0] + i;
                if (b < 0 || b >= nBins_[0])
                {
                    continue;
                }
                for (const int t : bins_[b + std::size_t(nBins_[0])*y])
                {
                    V p, n;
                    bool rim = false;
                    const double square =
                        nearest(triangles_[t], x, p, n, rim);
                    if (square < best)
                    {
                        best = square;
                        atRim = rim;
                        place = p;
                        side = n;
                        nearestOne = t;
                    }
                }
            }
        }
    }

    if (atRim)
    {
        normal = triangles_[nearestOne].normal;
        return dot(normal, x - place);
    }

    const V away = x - place;
    const double length = std::sqrt(best);
    const double sign = dot(away, side) < 0 ? -1 : 1;

    // On the surface itself the direction is that of the triangle; 1e-12 of
    // the place's coordinates is their round-off
    const double roundOff =
        1e-12*(1 + std::fabs(x[0]) + std::fabs(x[1]) + std::fabs(x[2]));
    normal =
        length <= roundOff
      ? triangles_[nearestOne].normal
      : (sign/length)*away;

    return sign*length;
}


// ************************************************************************* //
