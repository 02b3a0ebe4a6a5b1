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

#include "landslideRunout.H"
#include "fvMesh.H"
#include "functionObject.H"
#include "Time.H"
#include "timeTable.H"
#include "wholeCase.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(landslideRunout, 0);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fileName Foam::landslideRunout::outputFolder() const
{
    return time_.globalPath()/functionObject::outputPrefix/name_;
}


void Foam::landslideRunout::writeSummary
(
    const std::optional<scalar>& factorOfSafety,
    const slideControl::decision& decision,
    const std::optional<outcome>& end
) const
{
    if (!Pstream::master())
    {
        return;
    }

    const auto text =
        [](const std::optional<scalar>& value)
        {
            return value ? timeTable::text(*value) : string();
        };

    std::optional<scalar> maxDisplacement;
    std::optional<scalar> front;

    if (end)
    {
        maxDisplacement = end->maxDisplacement;
        if (end->front != outcome::noFront)
        {
            front = end->front;
        }

        timeTable verdicts
        (
            outputFolder()/"verdict.dat",
            {
                "time", "verdict", "maxDisplacement", "height", "stableBelow",
                "failedAbove"
            }
        );
        verdicts.set
        (
            time_.value(),
            {
                verdict_.judge(end->maxDisplacement),
                text(maxDisplacement),
                text(verdict_.height()),
                text(verdict_.stableBelow()),
                text(verdict_.failedAbove())
            }
        );
        verdicts.write();
    }

    timeTable summary
    (
        outputFolder()/"summary.dat",
        {"time", "FOS", "ran", "reason", "maxDisplacement", "front"}
    );
    summary.set
    (
        time_.value(),
        {
            text(factorOfSafety),
            decision.run ? "1" : "0",
            decision.reason,
            text(maxDisplacement),
            text(front)
        }
    );
    summary.write();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::landslideRunout::landslideRunout
(
    const word& name,
    const Time& time,
    const fvMesh* meshPtr,
    const dictionary& options
)
:
    name_(name),
    time_(time),
    meshPtr_(meshPtr),
    psiName_(options.getOrDefault<word>("psi", "psi")),
    thetaName_(options.getOrDefault<word>("theta", "theta")),
    stabilityName_(options.getOrDefault<word>("stability", "slopeStability")),
    soilPropertiesName_(constantName(options, "soilProperties")),
    properties_(readProperties(time, options)),
    rhoWater_(0),
    g_(readGravity()),
    frame_(properties_, g_),
    soils_(),
    control_(properties_.subDict("slide")),
    verdict_(properties_.subOrEmptyDict("verdict"))
{
    readSoils();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::landslideRunout::execute
(
    const std::optional<scalar>& factorOfSafety
)
{
    const slideControl::decision decision
    (
        control_.decide(time_.value(), factorOfSafety)
    );

    Info<< typeName << ' ' << name_ << ": time " << time_.timeName() << ", "
        << (decision.run ? "slide" : "no slide")
        << " (" << decision.reason << ")" << endl;

    std::optional<outcome> end;

    if (decision.run)
    {
        const slidePoints start(points());
        const std::vector<mpm::WallSettings> allWalls(walls(start));

        verdict_.setRelief(start.relief());

        // On all ranks, also if each has read the whole case for itself
        const parallelSwitch shared(UPstream::nProcs() > 1);

        const outcome result(slide(start, allWalls));
        end = result;

        Info<< "    Verdict at time " << time_.timeName() << ": "
            << verdict_.judge(result.maxDisplacement)
            << " (largest displacement " << result.maxDisplacement
            << " m; stable below " << verdict_.stableBelow()
            << " m, failed above " << verdict_.failedAbove() << " m)" << endl;
    }

    writeSummary(factorOfSafety, decision, end);

    Info<< endl;
}

// ************************************************************************* //
