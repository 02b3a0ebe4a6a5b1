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

#include "rasterRain.H"
#include "readChecked.H"
#include "rainUnit.H"
#include "readChoice.H"
#include "csvTable.H"
#include "groundPlan.H"
#include "planOverlap.H"
#include "Tuple2.H"
#include "addToRunTimeSelectionTable.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace rainfalls
{
    defineTypeNameAndDebug(raster, 0);
    addToRunTimeSelectionTable(rainfall, raster, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fileNameList Foam::rainfalls::raster::readGrids(const dictionary& dict)
{
    const List<Tuple2<scalar, fileName>> grids(dict.lookup("grids"));

    if (grids.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'grids' is empty" << exit(FatalIOError);
    }

    fileNameList files(grids.size());
    times_.setSize(grids.size() + 1);

    forAll(grids, gridi)
    {
        files[gridi] = caseFile(grids[gridi].second());
        times_[gridi] = grids[gridi].first();
    }
    times_.last() = dict.get<scalar>("end");

    for (label i = 1; i < times_.size(); ++i)
    {
        if (times_[i] <= times_[i - 1])
        {
            FatalIOErrorInFunction(dict)
                << "Grid " << i - 1 << " of 'grids' begins at "
                << times_[i - 1] << " s and ends at " << times_[i]
                << " s; its end must be later" << exit(FatalIOError);
        }
    }

    return files;
}


Foam::Map<Foam::label> Foam::rainfalls::raster::setShares
(
    const asciiGrid& grid,
    const groundPlan& plan
)
{
    // A smaller share of a face is round-off
    const scalar roundOff = 1e-9;

    const vector2D origin
    (
        dict_.getOrDefault<vector2D>("origin", vector2D(0, 0))
      - vector2D(grid.west(), grid.south())
    );
    const scalar size = grid.cellSize();

    Map<label> used;

    forAll(shares_, facei)
    {
        List<vector2D> corners(plan.corners(facei));

        vector2D low(GREAT, GREAT);
        vector2D high(-GREAT, -GREAT);
        vector2D centre(0, 0);
        for (vector2D& corner : corners)
        {
            corner += origin;
            low = min(low, corner);
            high = max(high, corner);
            centre += corner/corners.size();
        }

        const label west = max(label(floor(low.x()/size)), 0);
        const label south = max(label(floor(low.y()/size)), 0);
        const label east =
            min(label(floor(high.x()/size)), grid.nColumns() - 1);
        const label north =
            min(label(floor(high.y()/size)), grid.nRows() - 1);

        const scalar area = planOverlap(corners, low, high);
        scalar outside = 1;

        for (label row = south; row <= north; ++row)
        {
            for (label column = west; column <= east; ++column)
            {
                const vector2D corner(column*size, row*size);
                const scalar weight =
                    planOverlap
                    (
                        corners,
                        corner,
                        corner + vector2D(size, size)
                    )/area;

                if (weight > roundOff)
                {
                    const label celli = grid.cell(row, column);

                    used.insert(celli, used.size());
                    shares_[facei].append({used[celli], weight});
                    outside -= weight;
                }
            }
        }

        if (outside > roundOff)
        {
            setOutside(grid, centre, facei, outside, used);
        }
    }

    return used;
}


void Foam::rainfalls::raster::setOutside
(
    const asciiGrid& grid,
    const vector2D& centre,
    const label facei,
    const scalar weight,
    Map<label>& used
)
{
    const word policy
    (
        readChoiceOrDefault
        (
            dict_,
            "outside",
            "error",
            {"error", "zero", "nearest"}
        )
    );

    if (policy == "error")
    {
        FatalIOErrorInFunction(dict_)
            << "A face of the ground at ("
            << centre.x() + grid.west() << ' ' << centre.y() + grid.south()
            << ") in the grids' coordinates is not covered by the grid "
            << grid.file() << ", x " << grid.west() << " .. " << grid.east()
            << ", y " << grid.south() << " .. " << grid.north()
            << ". Entry 'outside' can say what falls there: zero or nearest"
            << exit(FatalIOError);
    }
    else if (policy == "nearest")
    {
        const auto clamped = [&](const scalar position, const label n)
        {
            return min(max(label(floor(position/grid.cellSize())), 0), n - 1);
        };
        const label celli = grid.cell
        (
            clamped(centre.y(), grid.nRows()),
            clamped(centre.x(), grid.nColumns())
        );

        used.insert(celli, used.size());
        shares_[facei].append({used[celli], weight});
    }
}


Foam::scalarField Foam::rainfalls::raster::readRates
(
    const asciiGrid& grid,
    const Map<label>& used,
    const scalar interval
) const
{
    const word policy
    (
        readChoiceOrDefault(dict_, "noData", "error", {"error", "zero"})
    );

    scalarField rates(used.size());

    forAllConstIters(used, iter)
    {
        const label celli = iter.key();
        const bool known = grid.hasData(celli);
        const scalar value = known ? grid.value(celli) : 0;

        if ((!known && policy == "error") || !(value >= 0))
        {
            const label row = celli/grid.nColumns();

            FatalIOErrorInFunction(dict_)
                << "Grid " << grid.file() << ", row " << grid.nRows() - row
                << " of " << grid.nRows() << ", column "
                << celli - row*grid.nColumns() + 1 << ": "
                << (known ? "rain must be >= 0, and it is " : "no data, ")
                << grid.value(celli) << ", where there is ground."
                << " Entry 'noData' can say that zero falls from cells without"
                << " data" << exit(FatalIOError);
        }

        rates[iter.val()] = rainRate(dict_, value, interval);
    }

    return rates;
}


Foam::scalar Foam::rainfalls::raster::rate
(
    const label facei,
    const label gridi
) const
{
    scalar result = 0;

    for (const share& s : shares_[facei])
    {
        result += s.weight*rates_[gridi][s.cell];
    }

    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rainfalls::raster::raster
(
    const word&,
    const dictionary& dict,
    const groundPlan& plan
)
:
    dict_(dict),
    times_(),
    shares_(plan.size()),
    rates_(),
    total_(0)
{
    checkKeys
    (
        dict,
        {
            "type", "unit", "grids", "end", "origin", "outside", "noData",
            "gapPolicy"
        }
    );

    const fileNameList files(readGrids(dict));
    const asciiGrid first(files[0], dict);
    const Map<label> used(setShares(first, plan));

    scalar area = 0;
    rates_.setSize(files.size());

    forAll(files, gridi)
    {
        const asciiGrid grid(files[gridi], dict);
        const scalar interval = times_[gridi + 1] - times_[gridi];

        if (!grid.matches(first))
        {
            FatalIOErrorInFunction(dict)
                << "The grid " << grid.file() << " has not the cells of "
                << first.file() << exit(FatalIOError);
        }

        rates_[gridi] = readRates(grid, used, interval);

        forAll(shares_, facei)
        {
            total_ += plan.area(facei)*rate(facei, gridi)*interval;
        }
    }

    forAll(shares_, facei)
    {
        for (const share& s : shares_[facei])
        {
            area += s.weight*plan.area(facei);
        }
    }

    total_ =
        returnReduce(total_, sumOp<scalar>())
       /max(returnReduce(area, sumOp<scalar>()), VSMALL);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::rainfalls::raster::addDepth
(
    const scalar t1,
    const scalar t2,
    UList<scalar>& depth
) const
{
    const bool early = (t1 < times_.first());
    const bool late = (t2 > times_.last());
    const word policy
    (
        readChoiceOrDefault
        (
            dict_,
            "gapPolicy",
            "error",
            {"error", "zero", "hold"}
        )
    );

    if ((early || late) && policy == "error")
    {
        FatalIOErrorInFunction(dict_)
            << "The run needs the rain from t = " << t1 << " s to " << t2
            << " s; the grids hold from " << times_.first() << " s to "
            << times_.last() << " s. Entry 'gapPolicy' can say what falls"
            << " beyond: zero, or hold for the first and last grid"
            << exit(FatalIOError);
    }

    forAll(rates_, gridi)
    {
        scalar begin = max(t1, times_[gridi]);
        scalar end = min(t2, times_[gridi + 1]);

        if (policy == "hold")
        {
            begin = gridi == 0 ? t1 : begin;
            end = gridi == rates_.size() - 1 ? t2 : end;
        }

        if (end > begin)
        {
            forAll(depth, facei)
            {
                depth[facei] += (end - begin)*rate(facei, gridi);
            }
        }
    }
}


Foam::scalar Foam::rainfalls::raster::nextBreakPoint(const scalar t) const
{
    const auto next = std::upper_bound(times_.cbegin(), times_.cend(), t);

    return next == times_.cend() ? VGREAT : *next;
}


Foam::rainfall::record Foam::rainfalls::raster::recorded() const
{
    record result;
    result.given = true;
    result.begin = times_.first();
    result.end = times_.last();
    result.depth = total_;

    return result;
}

// ************************************************************************* //
