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

#include "mpmFusedCycle.H"
#include "mpmLinearFlipCycle.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

template<int Dim>
std::unique_ptr<mpm::Cycle<Dim>> mpm::Cycle<Dim>::New
(
    const Settings& settings
)
{
    if
    (
        settings.shapeFunction == "quadraticBSpline"
     && settings.transferScheme == "APIC"
     && settings.stressUpdate == "USL"
     && !settings.axisymmetric()
    )
    {
        return std::make_unique<FusedCycle<Dim>>(settings);
    }
    if
    (
        settings.shapeFunction == "linear"
     && settings.transferScheme == "FLIP"
     && settings.stressUpdate == "USF"
     && settings.antiLocking == "none"
     && !settings.axisymmetric()
    )
    {
        return std::make_unique<LinearFlipCycle<Dim>>(settings);
    }
    return NewGeneric(settings);
}


template<int Dim>
std::unique_ptr<mpm::Cycle<Dim>> mpm::Cycle<Dim>::NewGeneric
(
    const Settings& settings
)
{
    const std::string& shape = settings.shapeFunction;
    if (shape == "linear")
    {
        return std::make_unique<GenericCycle<Dim, LinearShape>>(settings);
    }
    if (shape == "uGIMP" || shape == "cpGIMP")
    {
        return std::make_unique<GenericCycle<Dim, GIMPShape>>(settings);
    }
    if (shape == "cubicBSpline")
    {
        return std::make_unique<GenericCycle<Dim, CubicBSpline>>(settings);
    }
    return std::make_unique<GenericCycle<Dim, QuadraticBSpline>>(settings);
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::Cycle<2>;
template class mpm::Cycle<3>;


// ************************************************************************* //
