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

#include "zonedRain.H"
#include "readChecked.H"
#include "groundPlan.H"
#include "groundField.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace rainfalls
{
    defineTypeNameAndDebug(zones, 0);
    addToRunTimeSelectionTable(rainfall, zones, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rainfalls::zones::zones
(
    const word&,
    const dictionary& dict,
    const groundPlan& plan
)
:
    rains_(),
    faces_(),
    areas_()
{
    checkKeys
    (
        dict,
        {"type", "elsewhere"},
        {"zones", "elsewhere", "elsewhereCoeffs"}
    );

    const dictionary& zoneDict = dict.subDict("zones");
    const wordList names(zoneDict.toc());

    // The rain of each face, that of elsewhere last
    labelList which(plan.size(), names.size());

    forAll(names, rainI)
    {
        const boolList inside
        (
            facesInZone(plan.mesh(), plan.faces(), names[rainI], zoneDict)
        );

        forAll(inside, i)
        {
            if (inside[i])
            {
                which[i] = rainI;
            }
        }
    }

    faces_ = invertOneToMany(names.size() + 1, which);

    const label nElsewhere =
        returnReduce(faces_.last().size(), sumOp<label>());

    if (nElsewhere > 0 && !dict.found("elsewhere"))
    {
        FatalIOErrorInFunction(dict)
            << nElsewhere << " faces of the ground lie in none of the zones "
            << names << ": the entry 'elsewhere' must give their rain"
            << exit(FatalIOError);
    }

    if (nElsewhere == 0)
    {
        faces_.setSize(names.size());
    }

    rains_.setSize(faces_.size());
    areas_.setSize(faces_.size(), Zero);

    forAll(rains_, rainI)
    {
        const bool inZone = (rainI < names.size());

        rains_.set
        (
            rainI,
            rainfall::New
            (
                inZone ? names[rainI] : word("elsewhere"),
                inZone ? zoneDict : dict,
                groundPlan(plan, faces_[rainI])
            )
        );

        for (const label i : faces_[rainI])
        {
            areas_[rainI] += plan.area(i);
        }
        reduce(areas_[rainI], sumOp<scalar>());
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::rainfalls::zones::addDepth
(
    const scalar t1,
    const scalar t2,
    UList<scalar>& depth
) const
{
    forAll(rains_, rainI)
    {
        UIndirectList<scalar> all(depth, faces_[rainI]);
        scalarField some(all);

        rains_[rainI].addDepth(t1, t2, some);
        all = some;
    }
}


Foam::scalar Foam::rainfalls::zones::nextBreakPoint(const scalar t) const
{
    scalar result = VGREAT;

    for (const rainfall& rain : rains_)
    {
        result = min(result, rain.nextBreakPoint(t));
    }

    return result;
}


Foam::rainfall::record Foam::rainfalls::zones::recorded() const
{
    record result;
    result.given = true;
    result.begin = -VGREAT;
    result.end = VGREAT;

    forAll(rains_, rainI)
    {
        const record one(rains_[rainI].recorded());

        result.given = result.given && one.given;
        result.begin = max(result.begin, one.begin);
        result.end = min(result.end, one.end);
        result.depth += one.depth*areas_[rainI]/sum(areas_);
    }

    return result;
}

// ************************************************************************* //
