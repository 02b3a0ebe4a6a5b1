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
#include "cpuTime.H"
#include "mpmChecked.H"
#include "pstreamCommunicator.H"
#include "slideRecord.H"
#include "slideState.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::landslideRunout::report(const mpm::StartReport& start)
{
    Info<< "    Start state: "
        << (start.atRest ? "at rest" : "not quite at rest") << " after "
        << start.time << " s (" << label(start.steps) << " steps, "
        << start.resets << " kinetic resets)" << nl
        << "        rms velocity left " << start.rmsVelocity
        << " m/s, out of balance " << start.outOfBalance << nl
        << "        settlement " << start.settlement << " m, "
        << 100*start.yieldedFraction << " % of the points have yielded" << nl
        << "        outside the strength let go with: "
        << 100*start.outsideFraction << " % of the points, by up to "
        << start.maxExcess << " Pa" << endl;
}


void Foam::landslideRunout::start
(
    mpm::Run& run,
    slideState& state,
    slideRecord& record,
    const mpm::StartSettings& settings
) const
{
    bool restored = false;

    mpmChecked
    (
        properties_,
        "restoring a sliding state",
        [&]()
        {
            restored = state.restore(run, control_, record);
        }
    );

    record.goOnFrom(restored ? run.time() : -1);

    if (restored)
    {
        Info<< "    Going on from the state at " << run.time()
            << " s of sliding" << endl;
        return;
    }

    mpmChecked
    (
        properties_.subOrEmptyDict("initialState"),
        "bringing the soil to rest",
        [&]()
        {
            report(run.establishStart(settings));
        }
    );
}


Foam::landslideRunout::outcome Foam::landslideRunout::slide
(
    const slidePoints& points,
    const std::vector<mpm::WallSettings>& walls
) const
{
    const cpuTime clock;
    const mpm::PointData data(points.data());
    const mpm::Settings runSettings(settings(points));
    const mpm::StartSettings beginning(startSettings(points));

    Info<< "    " << points.size() << " points, cells of "
        << points.cellSize() << " m, " << label(walls.size()) << " walls; "
        << runSettings.shapeFunction.c_str() << ' '
        << runSettings.transferScheme.c_str() << ", stress update "
        << runSettings.stressUpdate.c_str() << endl;

    std::unique_ptr<mpm::Run> run;

    mpmChecked
    (
        properties_,
        "making the slide",
        [&]()
        {
            run = mpm::Run::New
            (
                frame_.dimension(),
                runSettings,
                data,
                points.materials(),
                walls,
                std::make_shared<pstreamCommunicator>()
            );
        }
    );

    // Sliding states of other labels than the usual one get a folder each
    const word stateName
    (
        name_ == typeName ? word("mpm") : word("mpm_" + name_)
    );

    slideState state(time_, stateName, digest(data, walls));

    if (!state.kept())
    {
        Info<< "    No sliding states are kept: there is no folder "
            << time_.timePath() << endl;
    }

    mpmChecked
    (
        properties_.subDict("slide"),
        "checking slide",
        [&]()
        {
            run->checkDuration("endTime", control_.endTime());
        }
    );

    slideRecord record(outputFolder()/time_.timeName(), frame_);

    start(*run, state, record, beginning);
    record.startLoads(*run);

    mpm::Diagnostics d(run->diagnostics());

    if (run->nRanks() > 1)
    {
        Info<< "    " << run->nRanks() << " ranks, of which " << d.idleRanks
            << " have no points" << endl;
    }

    const auto write =
        [&]()
        {
            record.write(*run);
            state.save(*run);
        };

    if (state.row() == 0)
    {
        record.add(d, *run);
        mpmChecked(properties_, "writing the slide", write);
    }

    while (!control_.isOver(state.row(), state.atRest()))
    {
        ++state.row();

        mpmChecked
        (
            properties_,
            "sliding",
            [&]()
            {
                run->advance(control_.rowTime(state.row()));
                d = run->diagnostics();
            }
        );

        state.lookForRest(control_, d, verdict_.stableBelow());
        record.add(d, *run);

        if
        (
            control_.writesPoints(state.row())
         || control_.isOver(state.row(), state.atRest())
        )
        {
            Info<< "    Sliding time = " << run->time()
                << "  largest displacement = " << d.maxDisplacement
                << "  largest velocity = " << d.maxVelocity
                << "  front = " << d.front << endl;

            mpmChecked(properties_, "writing the slide", write);
        }
    }

    record.writeFinal(*run);
    if (control_.writesFinalState())
    {
        points.write
        (
            outputFolder()/time_.timeName()/"final.csv",
            *run,
            runSettings.axisymmetric()
        );
    }

    Info<< "    " << label(run->stepNumber()) << " steps to "
        << run->time() << " s of sliding"
        << (state.atRest() ? ", at rest" : "") << nl;

    if (state.atRest())
    {
        Info<< "        the largest displacement would change by no more than "
            << state.missed() << " m" << nl;
    }

    Info
        << "        largest plastic strain " << d.maxPlasticStrain
        << ", moved points " << label(d.movedPoints)
        << ", asleep " << label(d.sleepingPoints) << nl
        << "        put back: " << label(d.clampedByWalls)
        << " times by walls, " << label(d.clampedByGrid)
        << " times by the grid's largest extent" << nl;

    for (const mpm::WallLoad& load : run->wallLoads())
    {
        Info<< "        largest force on " << load.wall.c_str() << ' '
            << load.maxForce << " N at " << load.maxForceTime << " s" << nl;
    }

    Info<< (
               run->nRanks() > 1
             ? "        blocks changed hands " + Foam::name(label(d.rebalances))
             + " times; largest share of the work over the mean "
             + Foam::name(d.imbalance) + "\n"
             : string()
           ).c_str()
        << "        CPU time " << clock.elapsedCpuTime() << " s" << endl;

    if (d.energyAccount)
    {
        Info<< "    Energy lost [J]: yielding " << d.plasticEnergy
            << ", friction on walls " << d.frictionEnergy
            << ", impact on walls " << d.impactEnergy
            << ", transfers " << d.transferEnergy
            << ", integration in time " << d.integrationEnergy
            << ", not accounted for " << d.energyRemainder << endl;
    }

    return outcome
    {
        d.maxDisplacement,
        d.movedPoints ? d.front : outcome::noFront
    };
}

// ************************************************************************* //
