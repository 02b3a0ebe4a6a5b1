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

#include "haverkampCurve.H"
#include "readChecked.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::haverkampCurve::haverkampCurve
(
    const dictionary& dict,
    const word& constant,
    const word& exponent
)
:
    halfSuction_(0),
    exponent_(0)
{
    const auto positive = [](const scalar x) { return x > 0; };

    const scalar A =
        readChecked(dict, constant, positive, constant + " > 0");
    exponent_ = readChecked(dict, exponent, positive, exponent + " > 0");
    const scalar unit =
        readCheckedOrDefault(dict, "headUnit", 1, positive, "headUnit > 0 [m]");

    // A^(1/exponent), unless it overflows
    const scalar logHalf = std::log(A)/exponent_ + std::log(unit);

    if (mag(logHalf) > 200)
    {
        FatalIOErrorInFunction(dict)
            << "Entries '" << constant << "' " << A << " and '" << exponent
            << "' " << exponent_ << " of " << dict.name()
            << " put the suction at which the curve is one half at exp("
            << logHalf << ") m; that must lie between 1e-86 and 1e86 m" << nl
            << exit(FatalIOError);
    }

    halfSuction_ = std::exp(logHalf);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::haverkampCurve::logValue(const scalar s) const
{
    if (s <= 0)
    {
        return 0;
    }

    // -ln(1 + e^lx), lx = ln(s^gamma/A)
    const scalar lx = exponent_*std::log(s/halfSuction_);

    return
        lx > 0
      ? -lx - std::log1p(std::exp(-lx))
      : -std::log1p(std::exp(lx));
}


Foam::scalar Foam::haverkampCurve::dlogValueds(const scalar s) const
{
    if (s <= 0)
    {
        return 0;
    }

    const scalar lx = exponent_*std::log(s/halfSuction_);

    // e^lx/(1 + e^lx) without overflow
    const scalar share =
        lx > 0 ? 1/(1 + std::exp(-lx)) : std::exp(lx)/(1 + std::exp(lx));

    return -exponent_*share/s;
}

// ************************************************************************* //
