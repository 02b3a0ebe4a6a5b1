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

#include "mpmLevelSet.H"
#include "mpmNames.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim>
std::int64_t mpm::LevelSet<Dim>::index
(
    const std::array<int, Dim>& at,
    const std::array<int, Dim>& n
)
{
    std::int64_t i = 0;
    for (int d = Dim - 1; d >= 0; --d)
    {
        i = i*n[d] + at[d];
    }
    return i;
}


template<int Dim>
template<class Function>
void mpm::LevelSet<Dim>::forPlaces
(
    const std::array<int, Dim>& n,
    const Function& f
)
{
    std::int64_t size = 1;
    for (const int k : n)
    {
        size *= k;
    }
    for (std::int64_t i = 0; i < size; ++i)
    {
        std::array<int, Dim> at;
        std::int64_t rest = i;
        for (int d = 0; d < Dim; ++d)
        {
            at[d] = int(rest % n[d]);
            rest /= n[d];
        }
        f(at);
    }
}


template<int Dim>
double mpm::LevelSet<Dim>::interpolate
(
    const double* values,
    const std::array<int, Dim>& n,
    const std::array<int, Dim>& cell,
    const Vector<Dim>& s,
    Vector<Dim>& gradient
)
{
    double value = 0;
    gradient = Vector<Dim>{};
    for (int corner = 0; corner < 1 << Dim; ++corner)
    {
        std::array<int, Dim> at(cell);
        double weight = 1;
        Vector<Dim> slope;
        slope.fill(1);
        for (int d = 0; d < Dim; ++d)
        {
            const bool upper = (corner >> d) & 1;
            const double w = upper ? s[d] - cell[d] : 1 - (s[d] - cell[d]);
            at[d] += upper;
            weight *= w;
            for (int e = 0; e < Dim; ++e)
            {
                slope[e] *= e == d ? (upper ? 1 : -1) : w;
            }
        }
        const double v = values[index(at, n)];
        value += weight*v;
        for (int d = 0; d < Dim; ++d)
        {
            gradient[d] += slope[d]*v;
        }
    }
    return value;
}


template<int Dim>
double mpm::LevelSet<Dim>::fromBox
(
    const Vector<Dim>& x,
    Vector<Dim>& normal
) const
{
    double square = 0;
    for (int d = 0; d < Dim; ++d)
    {
        normal[d] = x[d] - std::min(upper_[d], std::max(lower_[d], x[d]));
        square += normal[d]*normal[d];
    }
    const double length = std::sqrt(square);
    for (double& n : normal)
    {
        n /= length;
    }
    return length;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<int Dim>
mpm::LevelSet<Dim>::LevelSet
(
    const std::string& name,
    const std::function<double(const Point3&)>& distance,
    const Point3& lower,
    const Point3& upper,
    const double spacing
)
:
    spacing_(spacing)
{
    // A brick all round, so that whatever lies beyond is far from the surface
    const double brick = edge*spacing_;
    std::array<int, Dim> nCorners, nEdge;
    nEdge.fill(edge + 1);
    double nAll = 1;
    for (int d = 0; d < Dim; ++d)
    {
        lower_[d] = lower[d];
        upper_[d] = upper[d];
        const double n = std::ceil((upper[d] - lower[d])/brick) + 2;
        nAll *= n + 1;
        require
        (
            nAll <= maxSamples,
            "wall " + name + ": number of samples", nAll,
            "<= 2.5e8: a larger cell or a smaller surface"
        );
        nBricks_[d] = int(n);
        nCorners[d] = nBricks_[d] + 1;
        origin_[d] = 0.5*(lower[d] + upper[d] - n*brick);
    }

    const auto at = [&](const std::array<int, Dim>& i, const double step)
    {
        Vector<Dim> x(origin_);
        for (int d = 0; d < Dim; ++d)
        {
            x[d] += step*i[d];
        }
        return x;
    };
    const auto value = [&](const Vector<Dim>& x)
    {
        Point3 p{{0, 0, 0}};
        std::copy(x.begin(), x.end(), p.begin());
        return distance(p);
    };

    forPlaces
    (
        nCorners,
        [&](const std::array<int, Dim>& i)
        {
            corners_.push_back(value(at(i, brick)));
        }
    );

    // The surface is not nearer to a brick than this if its nearest corner is
    // farther from it than the diagonal and a spacing
    const double far = std::sqrt(double(Dim))*brick + spacing_;
    forPlaces
    (
        nBricks_,
        [&](const std::array<int, Dim>& i)
        {
            double nearest = std::fabs(corners_[index(i, nCorners)]);
            for (int corner = 1; corner < 1 << Dim; ++corner)
            {
                std::array<int, Dim> c(i);
                for (int d = 0; d < Dim; ++d)
                {
                    c[d] += (corner >> d) & 1;
                }
                nearest = std::min
                (
                    nearest, std::fabs(corners_[index(c, nCorners)])
                );
            }
            if (nearest > far)
            {
                first_.push_back(-1);
                return;
            }

            first_.push_back(std::int64_t(samples_.size()));
            require
            (
                double(samples_.size()) <= maxSamples,
                "wall " + name + ": number of samples",
                double(samples_.size()),
                "<= 2.5e8: a larger cell or a smaller surface"
            );
            const Vector<Dim> corner(at(i, brick));
            forPlaces
            (
                nEdge,
                [&](const std::array<int, Dim>& j)
                {
                    Vector<Dim> x(corner);
                    for (int d = 0; d < Dim; ++d)
                    {
                        x[d] += spacing_*j[d];
                    }
                    samples_.push_back(value(x));
                }
            );
        }
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim>
double mpm::LevelSet<Dim>::distance
(
    const Vector<Dim>& x,
    Vector<Dim>& normal
) const
{
    std::array<int, Dim> brick, nCorners;
    Vector<Dim> s;
    for (int d = 0; d < Dim; ++d)
    {
        s[d] = (x[d] - origin_[d])/(edge*spacing_);
        if (!(s[d] >= 0 && s[d] < nBricks_[d]))
        {
            return fromBox(x, normal);
        }
        brick[d] = int(s[d]);
        nCorners[d] = nBricks_[d] + 1;
    }

    double value = 0;
    const std::int64_t first = first_[index(brick, nBricks_)];
    if (first < 0)
    {
        value = interpolate(corners_.data(), nCorners, brick, s, normal);
    }
    else
    {
        std::array<int, Dim> cell, nEdge;
        nEdge.fill(edge + 1);
        for (int d = 0; d < Dim; ++d)
        {
            s[d] = edge*(s[d] - brick[d]);
            cell[d] = std::min(int(s[d]), edge - 1);
        }
        value = interpolate(samples_.data() + first, nEdge, cell, s, normal);
    }

    double square = 0;
    for (const double n : normal)
    {
        square += n*n;
    }
    const double length = std::sqrt(square);
    for (int d = 0; d < Dim; ++d)
    {
        // As far from two sides: any direction will do
        normal[d] = length > 0 ? normal[d]/length : d == Dim - 1;
    }
    return value;
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::LevelSet<2>;
template class mpm::LevelSet<3>;


// ************************************************************************* //
