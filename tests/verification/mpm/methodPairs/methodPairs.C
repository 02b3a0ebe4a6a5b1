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
    Every pair of shape function, transfer and order of updates: a bar that
    vibrates and flies through the cells, a column under its own weight, and
    an axisymmetric cylinder that vibrates radially.

\*---------------------------------------------------------------------------*/

#include "methodCases.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace methodCases;
using verification::Checks;
using verification::order;

void checkBar(Checks& checks, const Method& method)
{
    const bool linear = method.shape == "linear";
    const std::string name = method.name() + ": bar: ";
    const Outcome coarse = bar(method, 32);
    const Outcome fine = bar(method, 64);

    if (method.transfer == "PIC")
    {
        checks.within
        (
            name + "energy lost in one period, fails as it should",
            -fine.energyDrift,
            0.1,
            0.9,
            "the filter of PIC acts once a step"
        );
        checks.within
        (
            name + "loss over that with cells twice as long",
            fine.energyDrift/coarse.energyDrift,
            0.4,
            linear ? 1.3 : 0.75,
            "it falls with the length of the cells and steps, not with its "
            "square; linear shapes add their shaking"
        );
        return;
    }
    if (linear && method.affine())
    {
        // What the points carry from a nearly empty node into the next cell
        checks.within
        (
            name + "has broken (1), as it should",
            fine.failed,
            1,
            1,
            "the gradient in a cell with a nearly empty node has no bound, "
            "and points cross 13 cells in a period"
        );
        return;
    }
    if (linear)
    {
        checks.within
        (
            name + "order of the displacement, fails as it should",
            order(coarse.error, fine.error),
            -4,
            1.4,
            "points cross 13 cells in a period"
        );
        return;
    }
    checks.within
    (
        name + "order of the displacement",
        order(coarse.error, fine.error),
        method.update == "USF" ? 1.2 : 1.6,
        2.6,
        "second order in the cell; USF leads by a step"
    );
    checks.less
    (
        name + "change of the energy in one period",
        fine.energyDrift,
        5e-3,
        "the affine filter takes most: (k h)^2 of it"
    );
}


void checkCylinder(Checks& checks, const Method& method)
{
    const Outcome coarse = cylinder(method, 16);
    const Outcome fine = cylinder(method, 32);
    const bool first = method.transfer == "PIC" || method.update == "USF";
    const std::string name = method.name() + ": cylinder: ";

    checks.within
    (
        name + "order of the displacement",
        order(coarse.error, fine.error),
        first ? 0.8 : method.shape == "linear" ? 0.5 : 1.1,
        3,
        first
      ? "first order: PIC filters once a step, USF leads by one"
      : "second order; linear shapes end early"
    );
    checks.less
    (
        name + "error of the displacement",
        fine.error,
        first ? 0.05 : 2e-3,
        "32 cells along the radius"
    );
}


void checkColumn(Checks& checks, const Method& method)
{
    const Outcome coarse = column(method, 16);
    const Outcome fine = column(method, 32);
    const std::string name = method.name() + ": column: ";

    if (method.shape == "linear")
    {
        checks.within
        (
            name + "error of the stress, fails as it should",
            fine.error,
            0.05,
            1,
            "points that have crossed cells leave others empty"
        );
        return;
    }
    const bool gaps = method.shape == "uGIMP";
    checks.within
    (
        name + "order of the stress",
        order(coarse.error, fine.error),
        method.shape == "cubicBSpline" ? 1.5 : gaps ? 0.1 : 0.6,
        2.5,
        "second order where the weights fit pressed cells; points of uGIMP "
        "overlap, as they keep their first size"
    );
    checks.less
    (
        name + "mean error over the stress at the base",
        fine.error,
        gaps ? 0.02 : 8e-3,
        "half the weight of one of 32 cells is 1.6 %"
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

void verification::methodPairs(Checks& checks, const bool longVersion)
{
    for (const std::string& shape : mpm::Settings::shapeFunctions())
    {
        for (const std::string& transfer : mpm::Settings::transferSchemes())
        {
            for (const std::string& update : mpm::Settings::stressUpdates())
            {
                const Method method{shape, transfer, update};
                checkBar(checks, method);
                if (update == "USL" || longVersion)
                {
                    checkCylinder(checks, method);
                }
                if (update == "USL")
                {
                    checkColumn(checks, method);
                }
            }
        }
    }
}

// ************************************************************************* //
