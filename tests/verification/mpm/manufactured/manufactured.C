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
    Manufactured solutions for every shape function and transfer: those that
    should be of second order are, and those that should fail are seen to.

\*---------------------------------------------------------------------------*/

#include "methodCases.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using methodCases::Method;
using methodCases::Outcome;
using verification::Checks;

//- What to expect of a method
enum class Expected { second, first, fails };


void check
(
    Checks& checks,
    const std::string& name,
    const Outcome& coarse,
    const Outcome& fine,
    const Expected expected,
    const double leastOrder
)
{
    const double order = verification::order(coarse.error, fine.error);
    checks.report(name + "error at the finer", fine.error);

    if (expected == Expected::second)
    {
        checks.within
        (
            name + "observed order",
            order,
            leastOrder,
            4,
            "second order; 4 points a cell are an uneven quadrature, which "
            "takes some of it or adds to it from level to level"
        );
        checks.less
        (
            name + "error of the displacement over its amplitude",
            fine.error,
            0.05,
            "not converged otherwise"
        );
    }
    else if (expected == Expected::first)
    {
        checks.within
        (
            name + "observed order, fails as it should",
            order,
            -4,
            1.25,
            "the filter of PIC acts once a step, and steps shrink with cells"
        );
    }
    else
    {
        checks.within
        (
            name + "observed order (0: broke), fails as it should",
            fine.failed ? 0 : order,
            -5,
            0.6,
            "points that cross cells shake linear shapes; sizes along the "
            "axes do not fit points that turn and shear"
        );
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

void verification::manufactured(Checks& checks, const bool longVersion)
{
    checks.less
    (
        "square: residual of the momentum balance over the body force",
        methodCases::residualAxisAligned(),
        1e-3,
        "differences of differences of 1e-3 of the amplitude"
    );
    checks.less
    (
        "vortex: residual of the momentum balance over the body force",
        methodCases::residualVortex(),
        1e-3,
        "differences of differences of 1e-3 of the radius"
    );

    for (const std::string& shape : mpm::Settings::shapeFunctions())
    {
        for (const std::string& transfer : mpm::Settings::transferSchemes())
        {
            const Method method{shape, transfer};
            const bool linear = shape == "linear";
            const bool pic = transfer == "PIC";

            // On the square cells are pressed by a third: where weights know
            // nothing of the points' size, few points a cell end the
            // convergence
            const bool follows = shape == "cubicBSpline" || shape == "cpGIMP";
            const int cells = longVersion && follows ? 32 : 16;
            check
            (
                checks,
                method.name() + ": square: ",
                methodCases::axisAligned(method, cells),
                methodCases::axisAligned(method, 2*cells),
                linear ? Expected::fails
              : pic ? Expected::first
              : Expected::second,
                follows ? 1.6 : 0.7
            );

            // The vortex turns and shears; sizes along the axes do not, and by
            // 64 cells all but PIC have broken
            const bool shears = shape == "cpGIMP" && !pic;
            if
            (
                longVersion
             || transfer == "APIC"
             || (transfer == "FLIP" && !shears)
             || pic
            )
            {
                const int rings = longVersion && shears ? 32 : 16;
                check
                (
                    checks,
                    method.name() + ": vortex: ",
                    methodCases::vortex(method, rings),
                    methodCases::vortex(method, 2*rings),
                    linear || shears ? Expected::fails
                  : pic ? Expected::first
                  : Expected::second,
                    1.3
                );
            }
        }
    }
}

// ************************************************************************* //
