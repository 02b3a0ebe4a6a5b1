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

#include "solverStatistics.H"
#include "IOmanip.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solverStatistics::solverStatistics
(
    const coupledFlow& water,
    const timeStepControl& timeStep
)
:
    water_(water),
    timeStep_(timeStep),
    table_
    (
        water.mesh().time(),
        "solverStatistics",
        {
            "time",
            "dt",
            "nonlinearIterations",
            "linearIterations",
            "rejectedSteps",
            "cpuTime"
        }
    ),
    nSteps_(0),
    nIterations_(0),
    nLinear_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverStatistics::update()
{
    const Time& runTime = water_.mesh().time();
    const stepPerformance& p = water_.latest();
    const label nRejected = timeStep_.nRejected();

    ++nSteps_;
    nIterations_ += p.iterations;
    nLinear_ += p.linearIterations;

    Info<< "Newton: Solving for water, Initial residual = "
        << p.initialResidual << ", Final residual = " << p.finalResidual
        << ", No Iterations " << p.iterations
        << ", linear iterations " << p.linearIterations
        << ", rejected steps " << nRejected << endl;

    table_.write
    ({
        runTime.value(),
        runTime.deltaTValue(),
        scalar(p.iterations),
        scalar(p.linearIterations),
        scalar(nRejected),
        runTime.elapsedCpuTime()
    });
}


void Foam::solverStatistics::summary() const
{
    const auto share = [](const scalar part, const scalar all)
    {
        return label(0.5 + 100*part/max(all, VSMALL));
    };

    label nRejected = 0;
    for (const label n : timeStep_.rejections())
    {
        nRejected += n;
    }

    Info<< "Steps: " << nSteps_ << " accepted, " << nRejected << " rejected";
    for (label i = 0; i < timeStepControl::nRejections; ++i)
    {
        const auto reason = timeStepControl::rejection(i);
        Info<< (i ? ", " : ": ") << timeStep_.rejections()[i] << " for "
            << timeStepControl::rejectionNames[reason];
    }

    Info<< nl << "Newton iterations: " << nIterations_
        << ", linear iterations " << nLinear_ << nl;

    for (const coupledSolver::usage& solver : water_.linearSolver().solvers())
    {
        Info<< "Linear solver " << solver.name << ": " << solver.solutions
            << " solutions, " << solver.iterations << " iterations" << nl;
    }

    const label precision = Info().precision(3);
    const scalar total = workTimes::now();
    scalar rest = total;

    const auto print = [&](const word& name, const scalar seconds)
    {
        Info<< "    " << setw(24) << name.c_str() << ' ' << setw(10)
            << seconds << setw(6) << share(seconds, total) << nl;
    };

    Info<< "CPU time of this process [s, %]:" << nl;
    for (label i = 0; i < workTimes::nKinds; ++i)
    {
        const scalar seconds = water_.times().seconds()[i];
        print(workTimes::kindNames[workTimes::kind(i)], seconds);
        rest -= seconds;
    }
    print("other", rest);
    print("total", total);
    Info<< endl;
    Info().precision(precision);
}

// ************************************************************************* //
