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

#include "soilHydraulics.H"
#include "readChecked.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::soilHydraulics::soilHydraulics(const word& name, const dictionary& dict)
:
    name_(name),
    retention_(waterRetentionModel::New(dict.subDict("retention"))),
    permeability_
    (
        relativePermeabilityModel::New
        (
            dict.subDict("relativePermeability"),
            *retention_
        )
    ),
    Ks_
    (
        readChecked
        (
            dict,
            "Ks",
            [](const scalar x) { return x > 0; },
            "Ks > 0 [m/s]"
        )
    ),
    Ss_
    (
        readCheckedOrDefault
        (
            dict,
            "Ss",
            0,
            [](const scalar x) { return x >= 0; },
            "Ss >= 0 [1/m]"
        )
    )
{
    checkKeys
    (
        dict,
        {"Ks", "Ss", "anisotropy", "fields"},
        {"retention", "relativePermeability"}
    );
    warnUnlessUsual(dict, "Ks", Ks_, {1e-14, 0.1}, "1e-14 to 0.1 m/s");
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::soilHydraulics::writeInfo(Ostream& os) const
{
    os  << "    " << name_ << ": retention " << retention_->type()
        << ", relative permeability ";
    permeability_->writeInfo(os);
    os  << ", Ks " << Ks_ << " m/s, Ss " << Ss_ << " 1/m, air entry ";

    if (saturationHead() < 0)
    {
        os  << "at " << -saturationHead() << " m of suction" << nl;
    }
    else
    {
        os  << "none" << nl;
    }
}

// ************************************************************************* //
