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

#include "anisotropy.H"
#include "scalarList.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    //- Positive definite by Sylvester's criterion, and finite
    bool positiveDefinite(const Foam::symmTensor& t)
    {
        for (const Foam::scalar part : t)
        {
            if (!std::isfinite(part))
            {
                return false;
            }
        }

        return
            t.xx() > 0
         && t.xx()*t.yy() - Foam::sqr(t.xy()) > 0
         && det(t) > 0;
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::symmTensor Foam::readAnisotropy(const dictionary& dict)
{
    const word key("anisotropy");

    if (!dict.found(key))
    {
        return symmTensor(1, 0, 0, 1, 0, 1);
    }

    const scalarList parts(dict.get<scalarList>(key));

    if (parts.size() != 3 && parts.size() != 6)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' of " << dict.name() << " has "
            << parts.size() << " numbers: give three factors (x y z) or the"
            << " six parts (xx xy xz yy yz zz) of a symmetric tensor" << nl
            << exit(FatalIOError);
    }

    const symmTensor tensor
    (
        parts.size() == 3
      ? symmTensor(parts[0], 0, 0, parts[1], 0, parts[2])
      : symmTensor
        (
            parts[0], parts[1], parts[2], parts[3], parts[4], parts[5]
        )
    );

    if (!positiveDefinite(tensor))
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' of " << dict.name() << " is " << parts
            << ", outside its range: a positive definite tensor (all factors"
            << " > 0), for water flows down the gradient in every direction"
            << nl << exit(FatalIOError);
    }

    return tensor;
}

// ************************************************************************* //
