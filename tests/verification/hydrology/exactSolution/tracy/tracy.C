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

#include "tracy.H"
#include "mathematicalConstants.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace exactFields
{
    defineTypeNameAndDebug(tracy, 0);
    addToRunTimeSelectionTable(exactField, tracy, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::exactFields::tracy::tracy(const dictionary& dict)
:
    exponentialSoil(dict),
    waveX_(constant::mathematical::pi/dict.get<scalar>("length")),
    waveY_
    (
        dict.found("width")
      ? constant::mathematical::pi/dict.get<scalar>("width")
      : 0
    ),
    height_(dict.get<scalar>("height")),
    dry_(exp(alpha_*dict.get<scalar>("dry")))
{}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::exactFields::tracy::conductivity
(
    const vector& p,
    const scalar t
) const
{
    const scalar across =
        sin(waveX_*p.x())*(waveY_ > 0 ? sin(waveY_*p.y()) : 1);

    // At the start only the top is wet
    if (t <= 0)
    {
        return dry_ + (p.z() > (1 - SMALL)*height_ ? (1 - dry_)*across : 0);
    }

    const scalar b2 = 0.25*sqr(alpha_) + sqr(waveX_) + sqr(waveY_);
    const scalar rate = Ks_/(alpha_*porosity_);

    // sinh over sinh, without the overflow of high boxes
    const scalar b = sqrt(b2);
    scalar w =
        exp(-b*(height_ - p.z()))*(-expm1(-2*b*p.z()))/(-expm1(-2*b*height_));

    scalar decay = 1;
    for (label k = 1; k <= 100000 && decay > 1e-16; ++k)
    {
        const scalar l = k*constant::mathematical::pi/height_;
        decay = exp(-(b2 + sqr(l))*rate*t);
        w +=
            2/height_*(k % 2 ? -1 : 1)*l/(b2 + sqr(l))
           *sin(l*p.z())*decay;
    }

    return
        dry_
      + (1 - dry_)*across*exp(0.5*alpha_*(height_ - p.z()))*max(w, scalar(0));
}

// ************************************************************************* //
