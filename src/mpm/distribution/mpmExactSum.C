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

#include "mpmExactSum.H"

#include <cmath>
#include <limits>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

constexpr int limbBits = 32;

//- Exponent of the last bit of the first limb
constexpr int lowest = -1074;

//- Bits of a double's fraction
constexpr int fractionBits = 53;

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void mpm::ExactSum::add(const double term)
{
    if (!std::isfinite(term))
    {
        ++limbs_.back();
        return;
    }

    int exponent = 0;
    const double fraction = std::frexp(std::fabs(term), &exponent);
    std::uint64_t bits =
        std::uint64_t(std::ldexp(fraction, fractionBits));
    int shift = exponent - fractionBits - lowest;
    if (shift < 0)
    {
        // A denormal number: its last bits are zero
        bits >>= -shift;
        shift = 0;
    }

    const std::int64_t sign = term < 0 ? -1 : 1;
    const unsigned __int128 wide =
        static_cast<unsigned __int128>(bits) << (shift % limbBits);
    std::int64_t* limb = limbs_.data() + shift/limbBits;
    limb[0] += sign*std::int64_t(std::uint32_t(wide));
    limb[1] += sign*std::int64_t(std::uint32_t(wide >> limbBits));
    limb[2] += sign*std::int64_t(std::uint32_t(wide >> 2*limbBits));
}


double mpm::ExactSum::value() const
{
    if (limbs_.back() != 0)
    {
        return std::numeric_limits<double>::quiet_NaN();
    }

    // One sign for all limbs, each below 2^32
    std::array<std::int64_t, nLimbs> limbs(limbs_);
    constexpr std::int64_t base = std::int64_t(1) << limbBits;
    const auto carry = [&limbs]()
    {
        for (std::size_t i = 0; i + 2 < nLimbs; ++i)
        {
            const std::int64_t up =
                limbs[i] >= 0 ? limbs[i]/base : -((-limbs[i] + base - 1)/base);
            limbs[i] -= up*base;
            limbs[i + 1] += up;
        }
    };
    carry();
    const bool negative = limbs[nLimbs - 2] < 0;
    if (negative)
    {
        for (std::int64_t& limb : limbs)
        {
            limb = -limb;
        }
        carry();
    }

    double sum = 0;
    for (std::size_t i = nLimbs - 1; i-- > 0;)
    {
        if (limbs[i] != 0)
        {
            sum += std::ldexp(double(limbs[i]), int(i)*limbBits + lowest);
        }
    }
    return negative ? -sum : sum;
}


// ************************************************************************* //
