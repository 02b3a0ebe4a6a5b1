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

#include "nonOrthogonalFlux.H"
#include "emptyPolyPatch.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Where the permeabilities differ by more than this a front begins to pass,
//  and by twice that it is one
static const scalar front = 2;


//- The part of a way's area off its line; round-off of the mesh's points is
//  none
static vector restOf(const facePaths::side& way)
{
    const scalar negligible = 1e-6;

    const vector rest(way.coArea - way.transmissibility*way.delta);

    return
        mag(rest) > negligible*mag(way.coArea)
      ? rest
      : vector(Zero);
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::nonOrthogonalFlux::setFace
(
    const label facei,
    const facePaths& paths,
    const bool open
)
{
    facePaths::side way(paths.first(facei));

    rest_[facei] = Zero;

    if (open)
    {
        way.delta = paths.delta(facei);
        way.transmissibility = paths.transmissibility(facei);

        rest_[facei] = restOf(way);
        direction_[facei] =
            way.delta/(way.transmissibility*magSqr(way.delta));
    }
    else
    {
        direction_[facei] = way.coArea/magSqr(way.coArea);
    }
}


void Foam::nonOrthogonalFlux::setChange
(
    const label facei,
    const facePaths& paths,
    const scalar KsOwner,
    const scalar KsOther
)
{
    const facePaths::side first(paths.first(facei));
    const facePaths::side second(paths.second(facei));

    rest_[facei] = Zero;
    direction_[facei] = first.coArea/magSqr(first.coArea);

    changes_.append
    (
        change
        {
            facei,
            restOf(first),
            restOf(second),
            KsOwner*first.transmissibility,
            KsOther*second.transmissibility,
            second.coArea/magSqr(second.coArea)
        }
    );
}


void Foam::nonOrthogonalFlux::setInverse()
{
    const labelList& owner = mesh_.faceOwner();
    const labelList& neighbour = mesh_.faceNeighbour();

    const auto square = [](const vector& direction)
    {
        return sqr(direction)/magSqr(direction);
    };

    inverse_ = Zero;

    forAll(owner, facei)
    {
        inverse_[owner[facei]] += square(direction_[facei]);
        if (facei < neighbour.size())
        {
            inverse_[neighbour[facei]] += square(direction_[facei]);
        }
    }

    for (const change& c : changes_)
    {
        if (c.face < neighbour.size())
        {
            inverse_[neighbour[c.face]] +=
                square(c.secondDirection) - square(direction_[c.face]);
        }
    }

    for (symmTensor& t : inverse_)
    {
        t = inv(t);
    }
}


Foam::tmp<Foam::scalarField> Foam::nonOrthogonalFlux::mostPermeable
(
    const scalarField& kr,
    const scalarField& boundaryKr
) const
{
    const labelList& owner = mesh_.faceOwner();
    const labelList& neighbour = mesh_.faceNeighbour();

    auto tmost = tmp<scalarField>::New(kr);
    scalarField& most = tmost.ref();

    forAll(neighbour, facei)
    {
        const label own = owner[facei];
        const label nei = neighbour[facei];

        most[own] = max(most[own], kr[nei]);
        most[nei] = max(most[nei], kr[own]);
    }

    forAll(boundaryKr, b)
    {
        scalar& own = most[owner[b + mesh_.nInternalFaces()]];
        own = max(own, boundaryKr[b]);
    }

    return tmost;
}


Foam::tmp<Foam::vectorField> Foam::nonOrthogonalFlux::cellVelocity
(
    const scalarField& pointFlux
) const
{
    const labelList& owner = mesh_.faceOwner();
    const labelList& neighbour = mesh_.faceNeighbour();

    auto tvelocity = tmp<vectorField>::New(mesh_.nCells(), Zero);
    vectorField& velocity = tvelocity.ref();

    forAll(owner, facei)
    {
        const vector part(pointFlux[facei]*direction_[facei]);

        velocity[owner[facei]] += part;
        if (facei < neighbour.size())
        {
            velocity[neighbour[facei]] += part;
        }
    }

    // A change of soil: the whole flux, in each side's direction
    for (const change& c : changes_)
    {
        velocity[owner[c.face]] += correction_[c.face]*direction_[c.face];

        if (c.face < neighbour.size())
        {
            velocity[neighbour[c.face]] +=
                (pointFlux[c.face] + correction_[c.face])*c.secondDirection
              - pointFlux[c.face]*direction_[c.face];
        }
    }

    forAll(velocity, celli)
    {
        velocity[celli] = inverse_[celli] & velocity[celli];
    }

    return tvelocity;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nonOrthogonalFlux::nonOrthogonalFlux(const fvMesh& mesh)
:
    mesh_(mesh),
    rest_(mesh.nFaces(), Zero),
    direction_(mesh.nFaces(), Zero),
    changes_(),
    active_(false),
    changesSoil_(false),
    inverse_(mesh.nCells(), Zero),
    lagged_(mesh.nFaces(), Zero),
    laggedKr_(mesh.nFaces(), Zero),
    boundShare_(mesh.nFaces(), Zero),
    bound_(mesh.nFaces(), Zero),
    correction_(mesh.nFaces(), Zero),
    unsettled_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::nonOrthogonalFlux::setGeometry
(
    const facePaths& paths,
    const UList<bool>& open,
    const UList<bool>& same,
    const UList<scalar>& Ks,
    const UList<scalar>& otherKs
)
{
    const labelList& owner = mesh_.faceOwner();

    changes_.clear();

    forAll(owner, facei)
    {
        const label b = facei - mesh_.nInternalFaces();

        if (!paths.twoSided(facei))
        {
            setFace(facei, paths, open[b]);
        }
        else if (same[facei] && paths.uniform(facei))
        {
            setFace(facei, paths, true);
        }
        else
        {
            setChange
            (
                facei,
                paths,
                Ks[owner[facei]],
                b < 0 ? Ks[mesh_.faceNeighbour()[facei]] : otherKs[b]
            );
        }
    }

    // The gradient across the direction that is not modelled is zero
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(patch))
        {
            forAll(patch, i)
            {
                const vector& area = patch.faceAreas()[i];
                direction_[patch.start() + i] = area/magSqr(area);
            }
        }
    }

    changesSoil_ = false;
    for (const change& c : changes_)
    {
        changesSoil_ = changesSoil_ || mag(c.first) > 0 || mag(c.second) > 0;
    }
    reduce(changesSoil_, orOp<bool>());

    active_ = changesSoil_ || gMax(mag(rest_)()) > 0;

    setInverse();
}


void Foam::nonOrthogonalFlux::update
(
    const scalarField& pointFlux,
    const scalarField& kr,
    const scalarField& boundaryKr,
    const scalar weight
)
{
    if (!active_)
    {
        return;
    }

    const labelList& owner = mesh_.faceOwner();
    const label nInternal = mesh_.nInternalFaces();

    const vectorField velocity(cellVelocity(pointFlux));
    const scalarField most(mostPermeable(kr, boundaryKr));

    // On the other side; a boundary face has the cell's own
    vectorField otherVelocity;
    scalarField otherMost;
    syncTools::swapBoundaryCellList(mesh_, velocity, otherVelocity);
    syncTools::swapBoundaryCellList(mesh_, most, otherMost);

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (!patch.coupled())
        {
            forAll(patch, i)
            {
                const label b = patch.start() + i - nInternal;
                otherVelocity[b] = velocity[patch.faceCells()[i]];
                otherMost[b] = most[patch.faceCells()[i]];
            }
        }
    }

    const auto otherKr = [&](const label facei)
    {
        return
            facei < nInternal
          ? kr[mesh_.faceNeighbour()[facei]]
          : boundaryKr[facei - nInternal];
    };

    // The velocity that a more permeable cell beside it gives a cell is none
    // between drier ones
    const auto mobile = [&](const label facei, const scalar krMost)
    {
        const scalar krMore = max(kr[owner[facei]], otherKr(facei));
        return min(front*krMore/krMost, scalar(1));
    };

    const auto first = [&](const label facei) -> vector
    {
        const label own = owner[facei];
        return mobile(facei, most[own])*velocity[own];
    };

    const auto second = [&](const label facei) -> vector
    {
        if (facei < nInternal)
        {
            const label nei = mesh_.faceNeighbour()[facei];
            return mobile(facei, most[nei])*velocity[nei];
        }

        const label b = facei - nInternal;
        return mobile(facei, otherMost[b])*otherVelocity[b];
    };

    scalarField renewed(owner.size());

    forAll(owner, facei)
    {
        renewed[facei] = 0.5*(first(facei) + second(facei)) & rest_[facei];
    }

    for (const change& c : changes_)
    {
        // Each side counts by its resistance
        const scalar C1 = c.firstConductance*kr[owner[c.face]];
        const scalar C2 = c.secondConductance*otherKr(c.face);

        renewed[c.face] =
            (C2*(first(c.face) & c.first) + C1*(second(c.face) & c.second))
           /(C1 + C2);
    }

    // Of all faces: how much that changes, and what passes
    scalarList sums(2, Zero);

    forAll(owner, facei)
    {
        const scalar difference = renewed[facei] - lagged_[facei];

        sums[0] += mag(difference);
        sums[1] += mag(pointFlux[facei]);

        // Without round-off of what was, which a restart does not know
        lagged_[facei] =
            weight < 1 ? lagged_[facei] + weight*difference : renewed[facei];

        const scalar krOwner = kr[owner[facei]];
        const scalar krOther = otherKr(facei);
        const scalar krFront = front*min(krOwner, krOther);
        const scalar beyond = max(krOwner, krOther) - krFront;

        laggedKr_[facei] = lagged_[facei] > 0 ? krOwner : krOther;
        boundShare_[facei] = min(max(beyond, scalar(0)), krFront)/krFront;
    }

    bound_ = mag(pointFlux);

    Pstream::listCombineGather(sums, plusEqOp<scalar>());
    Pstream::listCombineScatter(sums);
    unsettled_ = sums[0]/max(sums[1], VSMALL);
}


void Foam::nonOrthogonalFlux::addTo
(
    richardsFlux::flux& f,
    const label facei,
    const mobility& first,
    const mobility& second
)
{
    const scalar lagged = lagged_[facei];

    if (lagged == 0)
    {
        correction_[facei] = 0;
        return;
    }

    const bool firstIsLess = (first.kr < second.kr);
    const bool fromLess = ((lagged > 0) == firstIsLess);

    const mobility& less = firstIsLess ? first : second;
    const mobility& more = firstIsLess ? second : first;
    const mobility& loser = fromLess ? less : more;

    const scalar krFront = front*less.kr;
    const bool atFront = (more.kr > krFront);
    const scalar laggedKr = laggedKr_[facei];

    // The correction, and its derivatives over the unknowns of the less and the
    // more permeable side
    scalar value = lagged;
    scalar dLess = 0;
    scalar dMore = 0;

    // It falls with the mobility of the side that it drains
    if (atFront && fromLess && front*laggedKr < more.kr)
    {
        value *= krFront/more.kr;
        dLess = value*less.slope;
        dMore = -value*more.slope;
    }
    else if (loser.kr < laggedKr)
    {
        value *= loser.kr/laggedKr;
        (fromLess ? dLess : dMore) = value*loser.slope;
    }

    // At a front it is bounded
    if (mag(value) > bound_[facei])
    {
        const scalar share = boundShare_[facei];
        const scalar bound = value > 0 ? bound_[facei] : -bound_[facei];

        value += share*(bound - value);
        dLess *= 1 - share;
        dMore *= 1 - share;
    }

    correction_[facei] = value;

    f.value += value;
    f.dFirst += firstIsLess ? dLess : dMore;
    f.dSecond += firstIsLess ? dMore : dLess;
}

// ************************************************************************* //
