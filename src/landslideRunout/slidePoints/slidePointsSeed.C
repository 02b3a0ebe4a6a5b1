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

#include "slidePoints.H"
#include "fvMesh.H"
#include "meshPointLocator.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::pointField Foam::slidePoints::lattice(const Pair<vector>& corners) const
{
    // Point i is at (i + 0.5)*spacing, so cells begin at multiples of cellSize
    checkCellSize(corners.first());
    checkCellSize(corners.second());

    const scalar h = spacing();
    Vector<label> first(Zero);
    Vector<label> last(Zero);
    scalar n = 1;

    for (direction cmpt = 0; cmpt < frame_.dimension(); ++cmpt)
    {
        first[cmpt] = std::ceil(corners.first()[cmpt]/h - 0.5);
        last[cmpt] = std::floor(corners.second()[cmpt]/h - 0.5);
        n *= max(scalar(0), scalar(last[cmpt]) - first[cmpt] + 1);
    }

    if (n > labelMax)
    {
        FatalIOErrorInFunction(dict_)
            << "cellSize " << cellSize_ << " m is too small: " << n
            << " points between " << corners.first() << " and "
            << corners.second()
            << exit(FatalIOError);
    }

    // A section has no third direction
    const scalar z = (frame_.dimension() == 3 ? h : 0);

    DynamicList<point> points;

    for (label k = first.z(); k <= last.z(); ++k)
    {
        for (label j = first.y(); j <= last.y(); ++j)
        {
            for (label i = first.x(); i <= last.x(); ++i)
            {
                points.append(point((i + 0.5)*h, (j + 0.5)*h, (k + 0.5)*z));
            }
        }
    }

    return pointField(std::move(points));
}


Foam::boolList Foam::slidePoints::participating() const
{
    boolList result(soils_.size(), false);
    wordList names(soils_.size());

    forAll(soils_, soili)
    {
        if (soils_.set(soili))
        {
            names[soili] = soils_[soili].name();
            result[soili] = true;
        }
    }

    if (!dict_.found("zones"))
    {
        return result;
    }

    result = false;
    const wordList zones(dict_.get<wordList>("zones"));

    for (const word& zone : zones)
    {
        const label soili = names.find(zone);

        if (soili == -1)
        {
            FatalIOErrorInFunction(dict_)
                << "zones: " << zone << " is no soil with a mechanical entry."
                << " Valid names: " << flatOutput(names)
                << exit(FatalIOError);
        }

        result[soili] = true;
    }

    return result;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::Pair<Foam::vector> Foam::slidePoints::limits(const fvMesh& mesh) const
{
    const FixedList<word, 3> keys({"xLimits", "yLimits", "zLimits"});
    const label dimension = frame_.dimension();

    Pair<vector> given(vector::uniform(-GREAT), vector::uniform(GREAT));

    for (direction cmpt = 0; cmpt < dimension; ++cmpt)
    {
        if (dict_.found(keys[cmpt]))
        {
            const auto range(dict_.get<vector2D>(keys[cmpt]));

            if (range.x() >= range.y())
            {
                FatalIOErrorInFunction(dict_)
                    << keys[cmpt] << ' ' << range
                    << ": the first limit must be below the second"
                    << exit(FatalIOError);
            }

            given.first()[cmpt] = range.x();
            given.second()[cmpt] = range.y();
        }
    }

    // A mesh of fewer directions may lie beside the section
    const bool cut = (dimension == 2 && mesh.nGeometricD() == 3);

    vector low(vector::uniform(GREAT));
    vector high(vector::uniform(-GREAT));

    for (label celli = 0; celli < mesh.nCells(); ++celli)
    {
        const boundBox box(meshPointLocator::cellBounds(mesh, celli));

        if (cut && !frame_.cuts(box))
        {
            continue;
        }

        const Pair<vector> corners(frame_.limits(box));
        bool meets = true;

        for (direction cmpt = 0; cmpt < dimension; ++cmpt)
        {
            meets = meets
             && corners.first()[cmpt] <= given.second()[cmpt]
             && corners.second()[cmpt] >= given.first()[cmpt];
        }

        if (meets)
        {
            low = min(low, corners.first());
            high = max(high, corners.second());
        }
    }

    reduce(low, minOp<vector>());
    reduce(high, maxOp<vector>());

    if (low.x() > high.x())
    {
        // Nothing there: a box without inside
        return Pair<vector>(vector::one, vector::zero);
    }

    return Pair<vector>(max(low, given.first()), min(high, given.second()));
}


void Foam::slidePoints::seed(const fvMesh& mesh, const labelUList& cellSoil)
{
    const boolList takesPart(participating());
    const pointField candidates(lattice(limits(mesh)));
    const meshPointLocator locator(mesh, frame_.toSpace(candidates)());

    labelList soils(candidates.size(), -1);

    forAll(soils, i)
    {
        const label celli = locator.cells()[i];

        if (celli != -1 && takesPart[cellSoil[celli]])
        {
            soils[i] = cellSoil[celli];
        }
    }

    Pstream::listCombineGather(soils, maxEqOp<label>());
    Pstream::listCombineScatter(soils);

    label n = 0;
    for (const label soili : soils)
    {
        n += (soili >= 0);
    }
    setSize(n);

    if (!size())
    {
        FatalIOErrorInFunction(dict_)
            << "No cell of a soil that takes part is at a point of the lattice"
            << " with spacing " << spacing() << " m" << nl
            << "    in the " << meshPointLocator::boundsMessage(mesh).c_str()
            << ". Look at section, limits, cellSize and zones"
            << exit(FatalIOError);
    }

    n = 0;
    forAll(soils, i)
    {
        if (soils[i] >= 0)
        {
            position_[n] = candidates[i];
            soil_[n] = soils[i];
            ++n;
        }
    }
}

// ************************************************************************* //
