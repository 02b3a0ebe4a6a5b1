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

#include "srivastavaYeh.H"
#include "mathematicalConstants.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace exactFields
{
    defineTypeNameAndDebug(srivastavaYeh, 0);
    addToRunTimeSelectionTable(exactField, srivastavaYeh, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::exactFields::srivastavaYeh::srivastavaYeh(const dictionary& dict)
:
    exponentialSoil(dict),
    length_(alpha_*dict.get<scalar>("length")),
    before_(dict.get<scalar>("before")),
    after_(dict.get<scalar>("after")),
    roots_(80)
{
    // sin(x) + (2/L) x cos(x) has one root in ((k + 1/2) pi, (k + 1) pi)
    forAll(roots_, k)
    {
        scalar low = (k + 0.5)*constant::mathematical::pi;
        scalar high = (k + 1)*constant::mathematical::pi;
        const scalar atLow = sin(low);

        for (label i = 0; i < 60; ++i)
        {
            const scalar x = 0.5*(low + high);
            const scalar atX = sin(x) + 2/length_*x*cos(x);
            (atX*atLow > 0 ? low : high) = x;
        }

        roots_[k] = 0.5*(low + high)/length_;
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::exactFields::srivastavaYeh::conductivity
(
    const vector& p,
    const scalar t
) const
{
    const scalar z = alpha_*p.z();
    const scalar time = alpha_*Ks_*t/porosity_;

    // The series needs ever more terms towards the start, where it is the
    // difference of two steady states
    if (time <= 0)
    {
        return before_ - (before_ - 1)*exp(-z);
    }

    scalar sum = 0;
    for (const scalar l : roots_)
    {
        sum +=
            sin(l*z)*sin(l*length_)*exp(-sqr(l)*time)
           /(1 + 0.5*length_ + 2*sqr(l)*length_);
    }

    return
        after_ - (after_ - 1)*exp(-z)
      - 4*(after_ - before_)*exp(0.5*(length_ - z))*exp(-0.25*time)*sum;
}

// ************************************************************************* //
