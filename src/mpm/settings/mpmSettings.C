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

#include "mpmSettings.H"
#include "mpmNames.H"

#include <cmath>
#include <stdexcept>

// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

const std::vector<std::string>& mpm::Settings::symmetries()
{
    static const std::vector<std::string> names{"none", "axisymmetric"};
    return names;
}


const std::vector<std::string>& mpm::Settings::shapeFunctions()
{
    static const std::vector<std::string> names
    {
        "quadraticBSpline", "cubicBSpline", "linear", "uGIMP", "cpGIMP"
    };
    return names;
}


const std::vector<std::string>& mpm::Settings::transferSchemes()
{
    static const std::vector<std::string> names
    {
        "APIC", "TPIC", "AFLIP", "FLIP", "XPIC", "PIC"
    };
    return names;
}


const std::vector<std::string>& mpm::Settings::stressUpdates()
{
    static const std::vector<std::string> names{"USL", "MUSL", "USF"};
    return names;
}


const std::vector<std::string>& mpm::Settings::antiLockings()
{
    static const std::vector<std::string> names{"none", "node", "cell"};
    return names;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int mpm::Settings::reach() const
{
    return
        shapeFunction == "linear" ? 1
      : shapeFunction == "cubicBSpline" ? 3
      : 2;
}


void mpm::Settings::validate(const int dimension) const
{
    if (dimension != 2 && dimension != 3)
    {
        outOfRange("dimension", dimension, "2 (plane strain) or 3");
    }
    require
    (
        cellSize > 0 && std::isfinite(cellSize),
        "cellSize", cellSize, "> 0 [m]"
    );
    for (int d = 0; d < 3; ++d)
    {
        require(std::isfinite(origin[d]), "origin", origin[d], "finite");
        require(std::isfinite(gravity[d]), "gravity", gravity[d], "finite");
        require
        (
            std::isfinite(frontDirection[d]),
            "frontDirection", frontDirection[d], "finite"
        );
    }
    if (dimension == 2)
    {
        require
        (
            gravity[2] == 0,
            "gravity[2]", gravity[2], "0 in a section (y is up)"
        );
    }

    choose("symmetry", symmetry, symmetries());
    if (axisymmetric())
    {
        require
        (
            dimension == 2,
            "symmetry axisymmetric: dimension", dimension, "2"
        );
        require
        (
            gravity[0] == 0,
            "symmetry axisymmetric: gravity[0]", gravity[0],
            "0: along the axis"
        );
    }
    choose("shapeFunction", shapeFunction, shapeFunctions());
    choose("transferScheme", transferScheme, transferSchemes());
    choose("stressUpdate", stressUpdate, stressUpdates());
    choose("antiLocking", antiLocking, antiLockings());
    if (energyAccount && stressUpdate != "USL")
    {
        throw std::invalid_argument
        (
            "energyAccount with stressUpdate " + stressUpdate
          + ": the account goes with USL only"
        );
    }

    require(flipTime > 0, "flipTime", flipTime, "> 0 [s]");
    require
    (
        flipBlend <= 1,
        "flipBlend", flipBlend, "0 (PIC) to 1 (FLIP), or negative: unused"
    );
    require
    (
        xpicOrder >= 1 && xpicOrder <= 20,
        "xpicOrder", xpicOrder, "1 (PIC) to 20"
    );
    require(cfl > 0 && cfl <= 1.2, "cfl", cfl, "0 < cfl <= 1.2");
    require
    (
        maxDeltaT >= 0,
        "maxDeltaT", maxDeltaT, ">= 0 [s], 0: no limit"
    );
    require(sortInterval >= 1, "sortInterval", sortInterval, ">= 1");
    require(threads >= 1, "threads", threads, ">= 1");
    require(maxImbalance > 1, "maxImbalance", maxImbalance, "> 1");
    require
    (
        massCutOff >= 0 && massCutOff < 1,
        "massCutOff", massCutOff, "0 <= massCutOff < 1"
    );
    require(movedDistance >= 0, "movedDistance", movedDistance, ">= 0 [m]");
    require(restVelocity >= 0, "restVelocity", restVelocity, ">= 0 [m/s]");
    require
    (
        sleepVelocity >= 0 && std::isfinite(sleepVelocity),
        "sleepVelocity", sleepVelocity, ">= 0 [m/s], 0: nothing sleeps"
    );
    require(sleepDelay > 0, "sleepDelay", sleepDelay, "> 0 [s]");
}


// ************************************************************************* //
