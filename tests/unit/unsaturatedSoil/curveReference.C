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

#include "curveReference.H"

#include <doctest/doctest.h>

using doctest::Approx;
using Foam::scalar;

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void check(const Foam::soilHydraulics& soil, const curveReference& r)
{
    // The argument of the curves, as n ln(alpha s), is known to some 1e-15, and
    // an exponential of a sum of a few such terms to some 1e-14
    const scalar tolerance = 1e-13;

    const scalar h = -r.s;
    const auto& retention = soil.retention();
    const auto& permeability = soil.permeability();

    const auto same = [&](const scalar value, const scalar reference)
    {
        CHECK(value/reference == Approx(1).epsilon(tolerance));
    };

    CAPTURE(soil.name());
    CAPTURE(h);

    same(retention.Se(h), r.Se);
    same(retention.desaturation(h), r.desaturation);
    same(retention.dSedh(h), r.dSedh);
    same(permeability.kr(h), r.kr);
    same(permeability.reduction(h), r.reduction);
    same(permeability.dkrdh(h), r.dkrdh);

    // Where it has no closed form: eight-point Gauss over a hundred panels
    same(-retention.SeIntegral(h), r.SeIntegral);
}

// ************************************************************************* //
