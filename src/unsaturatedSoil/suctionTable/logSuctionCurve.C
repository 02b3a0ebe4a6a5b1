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

#include "logSuctionCurve.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::logSuctionCurve::intervalOf(const scalar s) const
{
    const label next =
        std::upper_bound(s_.begin(), s_.end(), s) - s_.begin();

    return min(max(next - 1, label(0)), s_.size() - 2);
}


Foam::scalarList Foam::logSuctionCurve::slopes(const UList<scalar>& y) const
{
    const label first = fromZero_ ? 1 : 0;
    const label n = s_.size();

    scalarList result(n, Zero);

    const auto width = [&](const label i) { return logS_[i + 1] - logS_[i]; };
    const auto chord = [&](const label i)
    {
        return (y[i + 1] - y[i])/width(i);
    };

    // A weighted harmonic mean of the chords on both sides; at the ends the
    // chord itself
    for (label i = first + 1; i < n - 1; ++i)
    {
        const scalar before = chord(i - 1);
        const scalar after = chord(i);

        if (before*after > 0)
        {
            const scalar w1 = 2*width(i) + width(i - 1);
            const scalar w2 = width(i) + 2*width(i - 1);
            result[i] = (w1 + w2)/(w1/before + w2/after);
        }
    }

    if (n - first > 1)
    {
        result[first] = chord(first);
        result[n - 1] = chord(n - 2);
    }

    return result;
}


Foam::scalar Foam::logSuctionCurve::partOf
(
    const label i,
    const scalar s
) const
{
    const auto& c = c_[i];

    if (fromZero_ && i == 0)
    {
        return s*(c[0] + 0.5*c[1]*s);
    }

    // Of a cubic p over t = ln(s/s_i): s (p - dp + d2p - d3p)
    const auto primitive = [&](const scalar t)
    {
        const scalar p = c[0] + t*(c[1] + t*(c[2] + t*c[3]));
        const scalar dp = c[1] + t*(2*c[2] + 3*t*c[3]);
        const scalar d2p = 2*c[2] + 6*t*c[3];

        return std::exp(t)*(p - dp + d2p - 6*c[3]);
    };

    return s_[i]*(primitive(std::log(s/s_[i])) - primitive(0));
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::logSuctionCurve::logSuctionCurve
(
    const UList<scalar>& suction,
    const UList<scalar>& values,
    const bool cubic
)
:
    s_(suction),
    logS_(suction.size(), -GREAT),
    c_(suction.size() - 1),
    integral_(suction.size(), Zero),
    fromZero_(suction.first() <= 0)
{
    for (label i = fromZero_ ? 1 : 0; i < s_.size(); ++i)
    {
        logS_[i] = std::log(s_[i]);
    }

    const scalarList m(slopes(values));

    forAll(c_, i)
    {
        auto& c = c_[i];
        c = Zero;
        c[0] = values[i];

        if (fromZero_ && i == 0)
        {
            c[1] = (values[1] - values[0])/s_[1];
        }
        else
        {
            const scalar w = logS_[i + 1] - logS_[i];
            const scalar chord = (values[i + 1] - values[i])/w;

            c[1] = cubic ? m[i] : chord;

            if (cubic)
            {
                c[2] = (3*chord - 2*m[i] - m[i + 1])/w;
                c[3] = (m[i] + m[i + 1] - 2*chord)/sqr(w);
            }
        }

        integral_[i + 1] = integral_[i] + partOf(i, s_[i + 1]);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::logSuctionCurve::value(const scalar s) const
{
    const scalar inside = min(max(s, s_.first()), s_.last());
    const label i = intervalOf(inside);
    const auto& c = c_[i];

    const scalar t = fromZero_ && i == 0 ? inside : std::log(inside/s_[i]);

    return c[0] + t*(c[1] + t*(c[2] + t*c[3]));
}


Foam::scalar Foam::logSuctionCurve::slope(const scalar s) const
{
    if (s <= s_.first() || s > s_.last())
    {
        return 0;
    }

    const label i = intervalOf(s);
    const auto& c = c_[i];

    if (fromZero_ && i == 0)
    {
        return c[1];
    }

    const scalar t = std::log(s/s_[i]);

    return (c[1] + t*(2*c[2] + 3*t*c[3]))/s;
}


Foam::scalar Foam::logSuctionCurve::integral(const scalar s) const
{
    const scalar inside = min(max(s, s_.first()), s_.last());
    const label i = intervalOf(inside);

    return integral_[i] + partOf(i, inside) + (s - inside)*value(s);
}

// ************************************************************************* //
