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

#include "anisotropicFlow.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace exactFields
{
    defineTypeNameAndDebug(anisotropicFlow, 0);
    addToRunTimeSelectionTable(exactField, anisotropicFlow, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::exactFields::anisotropicFlow::readSaturated(const dictionary& dict)
{
    level_ = dict.get<scalar>("level");
    gradient_ = dict.get<vector>("gradient");
    size_ = dict.get<scalar>("size");
    k_ = dict.get<vector>("wave");

    Q_ = dict.get<symmTensor>("quadratic");
    Q_.xx() = 0;
    Q_.xx() = -(A_ && Q_)/A_.xx();

    l_ = (A_ & k_) ^ vector(0, 1, 0);
    l_ *= sqrt((k_ & A_ & k_)/(l_ & A_ & l_));
}


void Foam::exactFields::anisotropicFlow::readUnsaturated
(
    const dictionary& dict
)
{
    dry_ = dict.get<scalar>("dry");
    offset_ = dict.get<scalar>("offset");

    const scalarList growth(dict.get<scalarList>("growth"));
    m_ = vector(growth[0], growth[1], 0);

    // The wetter of the two roots
    const vector Am(A_ & m_);
    const scalar half = Am.z() + 0.5*alpha_*A_.zz();

    m_.z() =
        (sqrt(sqr(half) - A_.zz()*((m_ & Am) + alpha_*Am.z())) - half)
       /A_.zz();
}


Foam::scalar Foam::exactFields::anisotropicFlow::flux
(
    const label component,
    const vector& p
) const
{
    const scalar step = 1e-3;
    const auto H = [&](const vector& place)
    {
        return value(place, 0) + place.z();
    };

    const vector gradient
    (
        difference(H, p, vector(step, 0, 0)),
        difference(H, p, vector(0, step, 0)),
        difference(H, p, vector(0, 0, step))
    );

    const scalar kr = alpha_ > 0 ? exp(alpha_*value(p, 0)) : 1;

    return kr*(A_ & gradient)[component];
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::exactFields::anisotropicFlow::anisotropicFlow(const dictionary& dict)
:
    A_(dict.get<symmTensor>("anisotropy")),
    alpha_(dict.getOrDefault<scalar>("alpha", 0)),
    level_(0),
    gradient_(Zero),
    Q_(Zero),
    size_(0),
    k_(Zero),
    l_(Zero),
    dry_(0),
    m_(Zero),
    offset_(0)
{
    if (alpha_ > 0)
    {
        readUnsaturated(dict);
    }
    else
    {
        readSaturated(dict);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::exactFields::anisotropicFlow::value
(
    const vector& p,
    const scalar
) const
{
    if (alpha_ > 0)
    {
        return log(dry_ + (1 - dry_)*exp((m_ & p) - offset_))/alpha_;
    }

    return
        level_ + (gradient_ & p) + (p & Q_ & p)
      + size_*exp(k_ & p)*cos(l_ & p)
      - p.z();
}


Foam::scalar Foam::exactFields::anisotropicFlow::residual
(
    const vector& p,
    const scalar
) const
{
    const scalar step = 1e-3;

    const auto change = [&](const label component)
    {
        vector direction(Zero);
        direction[component] = step;
        const auto along = [&](const vector& place)
        {
            return flux(component, place);
        };
        return difference(along, p, direction);
    };

    return imbalance(1e-6, {change(0), change(1), change(2)});
}

// ************************************************************************* //
