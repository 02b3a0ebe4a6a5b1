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

#include "barenblatt.H"
#include "Enum.H"
#include "MinMax.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace exactFields
{
    defineTypeNameAndDebug(barenblatt, 0);
    addToRunTimeSelectionTable(exactField, barenblatt, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The power r of the drive that the dictionary names
static Foam::scalar readPower(const Foam::dictionary& dict)
{
    enum drive { waterSurface, givenSlope };

    const Foam::Enum<drive> names
    {
        {waterSurface, "waterSurface"},
        {givenSlope, "givenSlope"}
    };

    return names.get("drive", dict) == waterSurface ? 0.5 : 0;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::exactFields::barenblatt::barenblatt(const dictionary& dict)
:
    d_(dict.getCheck<label>("dimensions", labelMinMax(1, 2))),
    r_(readPower(dict)),
    friction_(dict.get<scalar>("manning")),
    C_(dict.get<scalar>("constant")),
    a_(1/(2 - r_ + d_*(5.0/3.0 - r_))),
    q_(1/(1 - r_)),
    p_(2*q_/3)
{
    if (r_ == 0)
    {
        friction_ *= sqrt(dict.get<scalar>("slope"));
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::exactFields::barenblatt::radius(const vector& p) const
{
    return vector(p.x(), d_ == 1 ? 0 : p.y(), 0);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::exactFields::barenblatt::value
(
    const vector& p,
    const scalar t
) const
{
    const scalar T = t/friction_;
    const scalar s = mag(radius(p))*pow(T, -a_);
    const scalar inside =
        C_ - (p_ + 1)*pow(a_, q_)*pow(s, q_ + 1)/(q_ + 1);

    return inside > 0 ? pow(T, -d_*a_)*pow(inside, 1/(p_ + 1)) : 0;
}


Foam::scalar Foam::exactFields::barenblatt::residual
(
    const vector& p,
    const scalar t
) const
{
    const scalar highest = value(Zero, t);
    const scalar here = value(p, t);

    if (here < 0.3*highest || here > 0.99*highest)
    {
        return 0;
    }

    const scalar dx = 1e-3*mag(radius(p));
    const scalar dt = 1e-4*t;

    // Inflow from a direction against the slope of the water
    const auto flux = [&](const vector& at, const vector& along)
    {
        const auto slope = [&](const vector& direction)
        {
            return
                (value(at + dx*direction, t) - value(at - dx*direction, t))
               /(2*dx);
        };
        const scalar steepness =
            sqrt(sqr(slope(vector(1, 0, 0))) + sqr(slope(vector(0, 1, 0))));

        return
            pow(value(at, t), 5.0/3.0)*pow(steepness, -r_)*slope(along)
           /friction_;
    };

    const auto inflow = [&](const vector& along)
    {
        return (flux(p + dx*along, along) - flux(p - dx*along, along))/(2*dx);
    };

    return imbalance
    (
        VSMALL,
        {
            -(value(p, t + dt) - value(p, t - dt))/(2*dt),
            inflow(vector(1, 0, 0)),
            inflow(vector(0, 1, 0))
        }
    );
}

// ************************************************************************* //
