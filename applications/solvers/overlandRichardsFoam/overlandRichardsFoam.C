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

Application
    overlandRichardsFoam

Group
    grpSubsurfaceSolvers

Description
    Rain, overland flow and variably saturated flow in the soil, coupled both
    ways in one system of equations (Zhu2022 Eqs. 7-12).

    Solves Richards' equation in the cells of the mesh and the diffusion wave
    on the finite-area mesh of its ground patch. Without
    constant/overlandProperties there is seepage alone, without
    constant/soilProperties overland flow alone. Time steps adapt themselves
    and end on output times and changes of rain. The water balance is printed
    each step and written to postProcessing/waterBalance.

    With -steady the run looks for the state that the conditions of the start
    time lead to, writes it there and ends (see steadyState).

    Sample runs:
    \verbatim
        makeFaMesh
        setWaterTable
        overlandRichardsFoam

        overlandRichardsFoam -steady -steadyRain 1e-8
        overlandRichardsFoam

        decomposePar
        mpirun -np 2 overlandRichardsFoam -parallel
    \endverbatim

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "fvMesh.H"
#include "columnFvMesh.H"
#include "coupledFlow.H"
#include "hydrographs.H"
#include "restartState.H"
#include "solverStatistics.H"
#include "steadyState.H"
#include "timeStepControl.H"
#include "waterBalance.H"
#include "wholeTimes.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Rain, overland flow and variably saturated flow in the soil,"
        " coupled both ways in one system of equations"
    );

    steadyState::addOptions();

    #include "setRootCaseLists.H"

    setUnfinishedTimesAside(args);

    #include "createTime.H"
    checkStartTime(runTime);
    #include "createMesh.H"

    // * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

    restartState state(runTime);

    const bool steady = steadyState::wanted(args);
    if (steady)
    {
        state.clear();
    }

    coupledFlow water(mesh, state);

    if (steady)
    {
        steadyState(runTime, water, args).find();

        Info<< "End\n" << endl;
        return 0;
    }

    timeStepControl timeStep(runTime, water.controls(), state);
    waterBalance balance(water);
    hydrographs discharge(water, state);
    solverStatistics statistics(water, timeStep);

    Info<< "\nStarting time loop\n" << endl;

    while (runTime.run())
    {
        timeStep.begin(water);

        do
        {
            water.solve(timeStep.step());
        }
        while (timeStep.rejects(water));

        water.accept();
        timeStep.advance(water);

        Info<< "Time = " << runTime.timeName()
            << ", deltaT = " << runTime.deltaTValue() << nl << endl;

        statistics.update();
        balance.update();
        discharge.update();

        {
            const workTimes::section timed(water.times(), workTimes::output);
            writeWhole(runTime);
        }
        runTime.printExecutionTime(Info);
    }

    statistics.summary();

    Info<< "End\n" << endl;

    return 0;
}

// ************************************************************************* //
