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

#include "terrainLayers.H"
#include "FlatOutput.H"
#include "readChecked.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// The surface that the dictionary names under the key
static const terrainSurface& namedSurface
(
    const dictionary& dict,
    const word& key,
    const HashPtrTable<terrainSurface>& surfaces
)
{
    const word name(dict.get<word>(key));

    if (!surfaces.found(name))
    {
        FatalIOErrorInFunction(dict)
            << "No surface '" << name << "' for '" << key
            << "'; the surfaces are "
            << flatOutput(surfaces.sortedToc())
            << exit(FatalIOError);
    }

    return *surfaces[name];
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::terrainLayers::terrainLayers
(
    const dictionary& dict,
    const HashPtrTable<terrainSurface>& surfaces,
    const label nLayers
)
:
    ground_(namedSurface(dict, "ground", surfaces)),
    base_(namedSurface(dict, "base", surfaces)),
    depths_(dict.get<scalarList>("depths")),
    expansion_
    (
        dict.getCheckOrDefault<scalar>
        (
            "expansion",
            1,
            [](const scalar ratio) { return ratio > 0; }
        )
    ),
    fractions_()
{
    checkKeys(dict, {"ground", "base", "depths", "expansion"});

    const label nBelow = nLayers + 1 - depths_.size();

    if (depths_.empty() || depths_[0] != 0 || nBelow < 1)
    {
        FatalIOErrorInFunction(dict)
            << "'depths' " << flatOutput(depths_) << " must begin with 0 and have no more"
            << " entries than the mesh's " << nLayers << " layers"
            << exit(FatalIOError);
    }

    for (label i = 1; i < depths_.size(); ++i)
    {
        if (depths_[i] <= depths_[i-1])
        {
            FatalIOErrorInFunction(dict)
                << "'depths' " << flatOutput(depths_) << " must increase"
                << exit(FatalIOError);
        }
    }

    fractions_.resize(nBelow);

    scalar thickness = 1;
    scalar sum = 0;
    for (scalar& fraction : fractions_)
    {
        sum += thickness;
        fraction = sum;
        thickness *= expansion_;
    }
    for (scalar& fraction : fractions_)
    {
        fraction /= sum;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::terrainLayers::elevation
(
    const label i,
    const scalar x,
    const scalar y
) const
{
    const scalar zGround = ground_.elevation(x, y);

    if (i < depths_.size())
    {
        return zGround - depths_[i];
    }

    const scalar zTop = zGround - depths_.last();
    const scalar zBase = base_.elevation(x, y);

    if (zBase >= zTop)
    {
        FatalErrorInFunction
            << "At (" << x << ' ' << y << ") the base '" << base_.name()
            << "' lies at " << zBase << " m, not below the deepest of the"
            << " given depths, which is at " << zTop << " m"
            << exit(FatalError);
    }

    const scalar fraction = fractions_[i - depths_.size()];

    return (1 - fraction)*zTop + fraction*zBase;
}


// ************************************************************************* //
