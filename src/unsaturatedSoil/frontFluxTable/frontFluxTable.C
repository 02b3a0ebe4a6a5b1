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

#include "frontFluxTable.H"
#include "DynamicList.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "ListOps.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    using Foam::scalar;
    using Foam::scalarList;

    // Values that differ by less than this are one: mesh geometry is not
    // known better
    const scalar sameD = 1e-6;

    // A sorted copy in which values that are the same appear once
    scalarList distinct(const Foam::UList<scalar>& values)
    {
        scalarList sorted(values);
        std::sort(sorted.begin(), sorted.end());

        Foam::DynamicList<scalar> result;

        for (const scalar D : sorted)
        {
            if (result.empty() || D > (1 + sameD)*result.last())
            {
                result.append(D);
            }
        }

        return scalarList(result);
    }
}

// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::scalar Foam::frontFluxTable::bernoulli(const scalar P)
{
    // P exp(-P)/(1 - exp(-P)); the series' first terms where that is 0/0
    return
        P < 1e-8 ? 1 - 0.5*P : P*std::exp(-P)/(-std::expm1(-P));
}


Foam::scalarList Foam::frontFluxTable::nodes
(
    const UList<scalar>& D,
    const label maxExact,
    const label perDecade
)
{
    scalar largest = 0;

    for (const scalar value : D)
    {
        largest = max(largest, value);
    }

    reduce(largest, maxOp<scalar>());

    // Level faces up to the mesh's round-off
    DynamicList<scalar> inclined(D.size());

    for (const scalar value : D)
    {
        if (value > sameD*largest)
        {
            inclined.append(value);
        }
    }

    List<scalarList> ofProcessor(Pstream::nProcs());
    scalarList& mine = ofProcessor[Pstream::myProcNo()];
    mine = distinct(inclined);

    // One value too many tells the others that a grid is needed
    mine.resize(min(mine.size(), maxExact + 1));
    Pstream::gatherList(ofProcessor);
    Pstream::scatterList(ofProcessor);

    DynamicList<scalar> all;

    for (const scalarList& values : ofProcessor)
    {
        all.append(values);
    }

    const scalarList exact(distinct(all));

    if (exact.size() <= maxExact)
    {
        return exact;
    }

    // Three decades below the largest D gravity hardly bends the potential
    // within a cell: linear in D from there to 0
    const label last = label(std::ceil(perDecade*std::log10(largest)));
    const label first = last - 3*perDecade;

    scalarList grid(last - first + 1);

    forAll(grid, i)
    {
        grid[i] = std::pow(10, scalar(first + i)/perDecade);
    }

    return grid;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::frontFluxTable::frontFluxTable
(
    const soilTable& table,
    const UList<scalar>& D
)
:
    table_(table),
    D_(D),
    beta_(D.size()),
    B_(D.size())
{
    const label n = table.nNodes();
    const scalarList& K = table.K();
    const scalarList& head = table.heads();

    forAll(D_, i)
    {
        scalarList& beta = beta_[i];
        scalarList& B = B_[i];
        beta.resize(n);
        B.resize(n);

        beta[0] = 0;

        for (label j = 0; j < n - 1; ++j)
        {
            B[j] = bernoulli(D_[i]*table.dKdPhi()[j]);
            beta[j + 1] =
                beta[j] + B[j]*0.5*(K[j] + K[j + 1])*(head[j + 1] - head[j]);
        }

        // Drier than the table K is constant
        B[n - 1] = 1;
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::frontFluxTable::weights Foam::frontFluxTable::weightsOf
(
    const scalar D
) const
{
    if (D <= 0 || D_.empty())
    {
        return {-1, 0};
    }

    if (D < D_.first())
    {
        return {-1, D/D_.first()};
    }

    if (D >= D_.last())
    {
        return {D_.size() - 1, 0};
    }

    const label next =
        std::upper_bound(D_.begin(), D_.end(), D) - D_.begin();

    return
    {
        next - 1,
        std::log(D/D_[next - 1])/std::log(D_[next]/D_[next - 1])
    };
}

// ************************************************************************* //
