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

#include "mpmMaterial.H"
#include "mpmNames.H"
#include "softening.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

const std::vector<std::string>& mpm::Material::constitutiveModels()
{
    static const std::vector<std::string> names
    {
        "MohrCoulomb", "DruckerPrager", "linearElastic", "neoHookean"
    };
    return names;
}


const std::vector<std::string>& mpm::Material::druckerPragerFits()
{
    static const std::vector<std::string> names
    {
        "planeStrain", "inner", "middle", "outer"
    };
    return names;
}


const std::vector<std::string>& mpm::SofteningSettings::regularisations()
{
    static const std::vector<std::string> names{"nonlocal", "crackBand"};
    return names;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void mpm::Material::validate() const
{
    const std::string zone("material " + name + ": ");

    choose
    (
        zone + "constitutiveModel",
        constitutiveModel,
        constitutiveModels()
    );
    require(E > 0, zone + "E", E, "> 0 [Pa]");
    require(nu >= 0 && nu < 0.5, zone + "nu", nu, "0 <= nu < 0.5");
    require
    (
        dilationAngle >= 0 && dilationAngle < 90,
        zone + "dilationAngle", dilationAngle, "0 .. frictionAngle [deg]"
    );
    require
    (
        tensileStrength >= 0,
        zone + "tensileStrength", tensileStrength, ">= 0 [Pa]"
    );
    choose(zone + "druckerPragerFit", druckerPragerFit, druckerPragerFits());
    require(viscosity >= 0, zone + "viscosity", viscosity, ">= 0 [Pa s]");

    require
    (
        softening.length >= 0,
        zone + "softening length", softening.length, "> 0 [m]"
    );
    if (softening.length > 0)
    {
        choose
        (
            zone + "regularisation",
            softening.regularisation,
            SofteningSettings::regularisations()
        );
        require
        (
            softening.residualCohesion >= 0,
            zone + "residualCohesion", softening.residualCohesion,
            ">= 0 [Pa]"
        );
        require
        (
            softening.residualFrictionAngle >= 0
         && softening.residualFrictionAngle < 90,
            zone + "residualFrictionAngle", softening.residualFrictionAngle,
            "0 .. frictionAngle [deg]"
        );
        require
        (
            softening.residualDilationAngle >= 0
         && softening.residualDilationAngle
         <= std::min(dilationAngle, softening.residualFrictionAngle),
            zone + "residualDilationAngle", softening.residualDilationAngle,
            "0 .. dilationAngle and residualFrictionAngle [deg]"
        );
        require
        (
            softening.peakStrain >= 0,
            zone + "peakStrain", softening.peakStrain, ">= 0"
        );
        require
        (
            softening.residualStrain > softening.peakStrain,
            zone + "residualStrain", softening.residualStrain,
            "> peakStrain"
        );
    }
}


void mpm::Material::validate(const double cellSize) const
{
    validate();
    require
    (
        !softening.nonlocal()
     || softening.length >= Softening::leastCells*cellSize,
        "material " + name + ": softening length",
        softening.length,
        ">= 1.5 cellSize for a nonlocal regularisation [m]"
    );
}


// ************************************************************************* //
