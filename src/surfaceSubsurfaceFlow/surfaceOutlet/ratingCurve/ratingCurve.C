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

#include "ratingCurve.H"
#include "readChecked.H"
#include "csvTable.H"
#include "readChoice.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace surfaceOutlets
{
    defineTypeNameAndDebug(ratingCurve, 0);
    addToRunTimeSelectionTable(surfaceOutlet, ratingCurve, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::Tuple2<Foam::scalar, Foam::scalar>>
Foam::surfaceOutlets::ratingCurve::readFile(const dictionary& dict)
{
    const csvTable table(dict);
    const label depths = table.column("depthColumn", 0);
    const label discharges = table.column("dischargeColumn", 1);

    List<Tuple2<scalar, scalar>> points(table.size());
    forAll(points, row)
    {
        points[row].first() = table.number(row, depths);
        points[row].second() = table.number(row, discharges);
    }

    return points;
}


void Foam::surfaceOutlets::ratingCurve::check(const dictionary& dict) const
{
    if
    (
        points_.size() < 2
     || points_[0].first() < 0
     || points_[0].second() != 0
    )
    {
        FatalIOErrorInFunction(dict)
            << "Outlet " << patchName() << ": the rating curve needs two"
            << " points or more, the first with a depth >= 0 and no discharge;"
            << " it is " << points_ << exit(FatalIOError);
    }

    for (label i = 1; i < points_.size(); ++i)
    {
        if
        (
            points_[i].first() <= points_[i - 1].first()
         || points_[i].second() < points_[i - 1].second()
        )
        {
            FatalIOErrorInFunction(dict)
                << "Outlet " << patchName() << ": point " << i << " of the"
                << " rating curve, " << points_[i] << ", follows "
                << points_[i - 1] << ": the depth must be larger and the"
                << " discharge not smaller" << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::surfaceOutlets::ratingCurve::ratingCurve
(
    const word& patchName,
    const scalar length,
    const dictionary& dict
)
:
    surfaceOutlet(patchName, length, dict),
    points_
    (
        dict.found("file")
      ? readFile(dict)
      : List<Tuple2<scalar, scalar>>(dict.lookup("curve"))
    )
{
    checkKeys
    (
        dict,
        {
            "type", "curve", "discharge", "file", "separator", "depthColumn",
            "dischargeColumn"
        }
    );

    check(dict);

    const bool total =
        readChoice(dict, "discharge", {"perWidth", "total"}) == "total";

    for (Tuple2<scalar, scalar>& point : points_)
    {
        point.second() /= total ? max(length, VSMALL) : 1;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::surfaceOutlets::ratingCurve::outflow
(
    const edgeWater& water,
    scalar& dDepth
) const
{
    dDepth = 0;

    if (water.depth <= points_[0].first())
    {
        return 0;
    }

    label i = 1;
    while (i < points_.size() - 1 && points_[i].first() < water.depth)
    {
        ++i;
    }

    const Tuple2<scalar, scalar>& low = points_[i - 1];
    const Tuple2<scalar, scalar>& high = points_[i];

    dDepth = (high.second() - low.second())/(high.first() - low.first());

    return low.second() + dDepth*(water.depth - low.first());
}

// ************************************************************************* //
