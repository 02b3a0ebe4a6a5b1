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

#include "haverkampRetention.H"
#include "readChecked.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace waterRetentionModels
{
    defineTypeNameAndDebug(haverkampRetention, 0);
    addToRunTimeSelectionTable
    (
        waterRetentionModel,
        haverkampRetention,
        dictionary
    );
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::waterRetentionModels::haverkampRetention::haverkampRetention
(
    const dictionary& dict
)
:
    waterRetentionModel(dict),
    curve_(dict, "alpha", "beta")
{
    checkKeys(dict, {"type", "thetaS", "thetaR", "alpha", "beta", "headUnit"});
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::waterRetentionModels::haverkampRetention::SeIntegral
(
    const scalar h
) const
{
    // Below this suction 1 - Se is under round-off (exp(-37) = 1e-16)
    const scalar full =
        curve_.halfSuction()*std::exp(-37/curve_.exponent());

    return
        -h <= full ? h : -(full + integrateSe(full, -h, curve_.exponent()));
}

// ************************************************************************* //
