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

#include "soilDictionary.H"
#include "IStringStream.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::dictionary dictionaryOf(const std::string& text)
{
    return Foam::dictionary(Foam::IStringStream(text)());
}


Foam::dictionary stiffSoil(const std::string& airEntryHead)
{
    return dictionaryOf
    (
        "retention { type vanGenuchten; thetaS 0.63; thetaR 0.19; alpha 0.81;"
        " m 0.012; airEntryHead " + airEntryHead + "; }"
        "relativePermeability { type mualem; }"
        "Ks 1.4e-6; Ss 1e-4;"
    );
}


Foam::dictionary embankment(const std::string& Ss)
{
    return dictionaryOf
    (
        "retention { type vanGenuchten; thetaS 0.36; thetaR 0.035;"
        " alpha 0.538; m 0.468; }"
        "relativePermeability { type mualem; l 0.5; }"
        "Ks 1.12e-5; Ss " + Ss + ";"
    );
}


Foam::dictionary gardnerSoil()
{
    return dictionaryOf
    (
        "retention { type gardner; thetaS 0.4; thetaR 0.06; alpha 2; }"
        "relativePermeability { type gardner; alpha 2; }"
        "Ks 1e-5;"
    );
}

// ************************************************************************* //
