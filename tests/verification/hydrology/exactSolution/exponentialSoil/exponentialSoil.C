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

#include "exponentialSoil.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::exponentialSoil::exponentialSoil(const dictionary& dict)
:
    alpha_(dict.get<scalar>("alpha")),
    Ks_(dict.get<scalar>("Ks")),
    porosity_(dict.get<scalar>("porosity"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::exponentialSoil::value
(
    const vector& p,
    const scalar t
) const
{
    return log(conductivity(p, t))/alpha_;
}


Foam::scalar Foam::exponentialSoil::residual
(
    const vector& p,
    const scalar t
) const
{
    const scalar dx = 1e-3/alpha_;
    const scalar dt = min(1e-2*t, 1e-4*porosity_/(alpha_*Ks_));

    // Net inflow along a direction
    const auto inflow = [&](const vector& direction, const scalar gravity)
    {
        const auto flux = [&](const scalar side)
        {
            const scalar here = value(p, t);
            const scalar there = value(p + side*dx*direction, t);
            const scalar middle = value(p + 0.5*side*dx*direction, t);
            return
                Ks_*exp(alpha_*middle)
               *(side*(there - here)/dx + gravity);
        };
        return (flux(1) - flux(-1))/dx;
    };

    const auto theta = [&](const scalar time)
    {
        return porosity_*exp(alpha_*value(p, time));
    };

    return imbalance
    (
        1e-6*Ks_*alpha_,
        {
            dt > 0 ? -(theta(t + dt) - theta(t - dt))/(2*dt) : 0,
            inflow(vector(1, 0, 0), 0),
            inflow(vector(0, 1, 0), 0),
            inflow(vector(0, 0, 1), 1)
        }
    );
}

// ************************************************************************* //
