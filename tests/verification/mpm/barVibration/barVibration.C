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

Description
    Axial vibration of a bar, fixed at x = 0 and free at x = L, in its first
    mode: v = v0 sin(pi x/2L), period T = 4 L/sqrt(E/rho) = 10 s.

    The axial displacement is 0.16 m at most, so geometry changes the period
    by (strain 0.01)^2 only.

\*---------------------------------------------------------------------------*/

#include "verification.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double length = 25;
const double E = 100;
const double rho = 1;
const double v0 = 0.1;
const double exactPeriod = 10;

struct Vibration
{
    double period;

    //- Energy (kinetic, affine and elastic) kept over the periods, and
    //  amplitude of the momentum
    double energyKept;
};


double energy(const mpm::Diagnostics& d)
{
    return d.kineticEnergy + d.affineKineticEnergy + d.elasticEnergy;
}


Vibration vibrate
(
    const int cells,
    const int periods,
    const std::string& shapeFunction,
    const std::string& transferScheme,
    const std::string& stressUpdate,
    const double flipBlend
)
{
    mpm::Settings settings;
    settings.cellSize = length/cells;
    settings.shapeFunction = shapeFunction;
    settings.transferScheme = transferScheme;
    settings.stressUpdate = stressUpdate;
    settings.flipBlend = flipBlend;
    settings.cfl = 0.2;

    // One row of cells; without Poisson's effect no side wall is needed
    mpm::PointData points = verification::seed
    (
        2,
        settings.cellSize,
        2,
        {{0, 0, 0}},
        {{length, settings.cellSize, 0}},
        [](const mpm::Point3&) { return true; },
        rho
    );
    for (const mpm::Point3& x : points.position)
    {
        points.velocity.push_back
        (
            {{v0*std::sin(0.5*std::acos(-1.0)*x[0]/length), 0, 0}}
        );
    }

    mpm::Material bar;
    bar.constitutiveModel = "linearElastic";
    bar.E = E;

    auto run = mpm::Run::New
    (
        2,
        settings,
        points,
        {bar},
        {verification::plane("end", "rough", {{0, 0, 0}}, {{1, 0, 0}})}
    );

    // The momentum starts at its largest and is zero at odd quarters. From
    // the first zero to the last there is a whole number of half periods
    const double energyAtStart = energy(run->diagnostics());
    const double endTime = periods*exactPeriod;
    double firstZero = 0, lastZero = 0;
    int zeros = 0;
    double momentum = run->diagnostics().momentum[0];
    while (run->time() < endTime)
    {
        const double before = run->time();
        run->step(endTime - before);
        const double now = run->diagnostics().momentum[0];
        if (momentum*now <= 0 && momentum != 0)
        {
            lastZero =
                before + (run->time() - before)*momentum/(momentum - now);
            if (zeros++ == 0)
            {
                firstZero = lastZero;
            }
        }
        momentum = now;
    }

    return
    {
        2*(lastZero - firstZero)/(zeros - 1),
        energy(run->diagnostics())/energyAtStart
    };
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

void verification::barVibration(Checks& checks, const bool longVersion)
{
    const int periods = 10;
    const std::string smooth = "quadraticBSpline";

    double last = 0;
    for (const int cells : {25, 50, 100})
    {
        const Vibration apic =
            vibrate(cells, periods, smooth, "APIC", "USL", -1);
        const double error = apic.period/exactPeriod - 1;
        const std::string name = "APIC, " + std::to_string(cells) + " cells: ";
        checks.report(name + "relative error of the period", error);
        checks.report(name + "energy kept over ten periods", apic.energyKept);
        if (last != 0)
        {
            checks.within
            (
                name + "order of the period",
                order(last, error),
                1.8,
                2.6,
                "second order, at the fixed end too"
            );
        }
        last = error;

        if (cells == 100)
        {
            checks.less
            (
                name + "error of the period",
                error,
                1e-4,
                "second order: the fixed end mirrors the bar in front of it"
            );
            checks.within
            (
                name + "energy kept over ten periods",
                apic.energyKept,
                0.98,
                1.001,
                "APIC filters what the grid can not carry, little of this mode"
            );
        }
    }

    const Vibration flip = vibrate(100, periods, smooth, "FLIP", "USF", 1);
    checks.less
    (
        "FLIP, USF, 100 cells: drift of the energy over ten periods",
        flip.energyKept - 1,
        1e-3,
        "no filter at all, symplectic steps"
    );
    checks.less
    (
        "FLIP, USF, 100 cells: error of the period",
        flip.period/exactPeriod - 1,
        1e-4,
        "second order, without a filter"
    );

    const Vibration last100 = vibrate(100, periods, smooth, "FLIP", "MUSL", 1);
    checks.report
    (
        "FLIP, MUSL, 100 cells: energy kept over ten periods",
        last100.energyKept
    );

    const Vibration pic = vibrate(50, 1, smooth, "FLIP", "MUSL", 0);
    checks.report("PIC, 50 cells: energy kept over one period", pic.energyKept);

    // The free end moves by 0.16 m, and the points nearest to the rim of a cell
    // are 0.25 m from it: none crosses
    for (const std::string transfer : {"APIC", "TPIC", "AFLIP"})
    {
        const Vibration linear =
            vibrate(25, periods, "linear", transfer, "USL", -1);
        const std::string name =
            "linear, " + transfer + ", no point crosses a cell: ";
        checks.less
        (
            name + "error of the period",
            linear.period/exactPeriod - 1,
            4e-4,
            "25 cells; that of two-noded elements with lumped masses is "
            "(k h)^2/24 = 1.6e-4"
        );
        checks.within
        (
            name + "energy kept over ten periods",
            linear.energyKept,
            0.99,
            1.001,
            "the filter of the nodes, on coarse cells"
        );
    }

    if (longVersion)
    {
        const Vibration paper =
            vibrate(50, periods, "linear", "FLIP", "USF", 1);
        checks.less
        (
            "linear, FLIP, USF, 50 cells: error of the period",
            paper.period/exactPeriod - 1,
            2e-3,
            "linear shapes end on the wall's node; points that cross cells "
            "shake them"
        );
        checks.within
        (
            "linear, FLIP, USF, 50 cells: energy kept",
            paper.energyKept,
            0.9,
            1.1,
            "points that cross cells; known of linear shapes"
        );
    }
}

// ************************************************************************* //
