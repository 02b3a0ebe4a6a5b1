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

#include "groundPlan.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::groundPlan::groundPlan
(
    const polyMesh& mesh,
    const labelUList& faces,
    const vector& up
)
:
    mesh_(mesh),
    faces_(faces),
    up_(up)
{
    // The horizontal axis that is closest to x unless that is vertical
    const vector x
    (
        mag(up_.x()) < 0.9 ? vector(1, 0, 0) : vector(0, 1, 0)
    );

    axis1_ = x - (x & up_)*up_;
    axis1_ /= mag(axis1_);
    axis2_ = up_ ^ axis1_;
}


Foam::groundPlan::groundPlan(const groundPlan& all, const labelUList& which)
:
    groundPlan(all.mesh_, UIndirectList<label>(all.faces_, which)(), all.up_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::vector2D> Foam::groundPlan::corners(const label i) const
{
    const face& f = mesh_.faces()[faces_[i]];

    List<vector2D> result(f.size());
    forAll(result, k)
    {
        result[k] = position(mesh_.points()[f[k]]);
    }

    return result;
}

// ************************************************************************* //
