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

#include "fieldToPointMapping.H"
#include "meshPointLocator.H"
#include "StringStream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fieldToPointMapping::checkOutside
(
    const polyMesh& mesh,
    const UList<point>& points,
    const outsidePolicy& policy
) const
{
    const label first = outside_.find_first();

    if (first != -1)
    {
        OStringStream message;
        message
            << "Point " << first << " at " << points[first]
            << " lies in no cell of the "
            << meshPointLocator::boundsMessage(mesh).c_str() << nl
            << "    (" << outside_.count() << " of " << points.size()
            << " points are outside).";

        policy.stop(message.str());
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fieldToPointMapping::fieldToPointMapping
(
    const fvMesh& mesh,
    const pointField& points,
    const outsidePolicy& policy,
    const labelUList& cellGroups
)
:
    nPoints_(points.size()),
    localPoints_(),
    cellIndex_(),
    displacement_(),
    reconstruction_(nullptr),
    outside_()
{
    meshPointLocator locator(mesh, points);
    outside_ = locator.outside();

    if (policy.is(outsidePolicy::ERROR))
    {
        checkOutside(mesh, points, policy);
    }
    else if (policy.is(outsidePolicy::NEAREST))
    {
        locator.moveOutsideToNearest();
    }

    const labelList& cells = locator.cells();

    // The cells that hold points, numbered as they are met
    Map<label> indexOf(2*min(mesh.nCells(), points.size()));
    DynamicList<label> usedCells;
    DynamicList<label> localPoints;

    forAll(cells, pointi)
    {
        if (cells[pointi] != -1)
        {
            localPoints.append(pointi);

            if (indexOf.insert(cells[pointi], usedCells.size()))
            {
                usedCells.append(cells[pointi]);
            }
        }
    }

    localPoints_.transfer(localPoints);
    cellIndex_.setSize(localPoints_.size());
    displacement_.setSize(localPoints_.size());

    forAll(localPoints_, i)
    {
        const label pointi = localPoints_[i];
        const label celli = cells[pointi];

        cellIndex_[i] = indexOf[celli];
        displacement_[i] =
            locator.positions()[pointi] - mesh.cellCentres()[celli];
    }

    reconstruction_.reset
    (
        new linearReconstruction(mesh, usedCells, cellGroups)
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::fieldToPointMapping::mapCellLabels
(
    const labelUList& cellValues,
    const label outsideValue
) const
{
    Field<label> local(localPoints_.size());

    forAll(local, i)
    {
        local[i] = cellValues[reconstruction_->cells()[cellIndex_[i]]];
    }

    Field<label> values(nPoints_, outsideValue);
    gather(local, values);

    return values;
}

// ************************************************************************* //
