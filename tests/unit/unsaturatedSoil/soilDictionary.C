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


Foam::dictionary brooksCoreySoil
(
    const std::string& lambda,
    const std::string& permeability
)
{
    return dictionaryOf
    (
        "retention { type brooksCorey; thetaS 0.41; thetaR 0.05;"
        " airEntryHead 0.15; lambda " + lambda + "; }"
        "relativePermeability { type " + permeability + "; }"
        "Ks 2e-5;"
    );
}


Foam::dictionary haverkampSand()
{
    return dictionaryOf
    (
        "retention { type haverkamp; thetaS 0.287; thetaR 0.075;"
        " alpha 1.611e6; beta 3.96; headUnit 0.01; }"
        "relativePermeability { type haverkamp; A 1.175e6; gamma 4.74;"
        " headUnit 0.01; }"
        "Ks 9.44e-5;"
    );
}


Foam::dictionary tabulatedSoil
(
    const std::string& table,
    const std::string& Ss
)
{
    return dictionaryOf
    (
        "retention { type tabulated; " + table + " }"
        "relativePermeability { type tabulated; }"
        "Ks 1e-5; Ss " + Ss + ";"
    );
}


std::string loamTable()
{
    return
        "values"
        " ("
        "  (0.05 0.43 1) (0.1 0.42 0.5) (0.3 0.39 0.1) (1 0.32 5e-3)"
        "  (3 0.25 2e-4) (10 0.19 8e-6) (50 0.15 1e-7) (150 0.13 3e-9)"
        " );"
        " thetaR 0.05;";
}

// ************************************************************************* //
