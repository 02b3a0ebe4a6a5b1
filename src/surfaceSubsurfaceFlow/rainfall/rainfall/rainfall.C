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

#include "rainfall.H"
#include "hyetograph.H"
#include "TableBase.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rainfall::rainfall(const dictionary& dict)
:
    dict_(dict),
    rate_(Function1<scalar>::New("rainfall", dict)),
    breakPoints_()
{
    if (isA<Function1Types::hyetograph>(*rate_))
    {
        breakPoints_ =
            refCast<const Function1Types::hyetograph>(*rate_).breakPoints();
    }
    else if
    (
        const auto* table =
            dynamic_cast<const Function1Types::TableBase<scalar>*>(rate_.get())
    )
    {
        breakPoints_ = table->x();

        for (const scalar t : breakPoints_)
        {
            if (table->value(t) < 0)
            {
                FatalIOErrorInFunction(dict_)
                    << "rainfall is " << table->value(t) << " m/s at t = "
                    << t << " s; rain must be >= 0" << exit(FatalIOError);
            }
        }
    }
    else
    {
        // Of a constant the whole, of any other function its beginning
        depth(0, 1);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::rainfall::depth(const scalar t1, const scalar t2) const
{
    const scalar result = rate_->integrate(t1, t2);

    if (!(result >= 0))
    {
        FatalIOErrorInFunction(dict_)
            << "rainfall amounts to " << result << " m between t = " << t1
            << " s and " << t2 << " s; rain must be >= 0"
            << exit(FatalIOError);
    }

    return result;
}


Foam::scalar Foam::rainfall::nextBreakPoint(const scalar t) const
{
    for (const scalar breakPoint : breakPoints_)
    {
        if (breakPoint > t)
        {
            return breakPoint;
        }
    }

    return VGREAT;
}


void Foam::rainfall::write(Ostream& os) const
{
    rate_->writeData(os);
}

// ************************************************************************* //
