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
    Brooks and Corey's and Haverkamp's curves against values of 20
    digits, computed with mpmath (60 digits, slopes by central differences with
    a step of 1e-25, the integral by its quadrature) from the formulas

        Brooks-Corey  Se = (hb/s)**lam,  kr = Se**(l + 1 + 2/lam) (Burdine),
                                         kr = Se**(l + 2 + 2/lam) (Mualem)
        Haverkamp     Se = a/(a + s**b), kr = A/(A + s**g), s in cm

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>

#include "curveReference.H"
#include "soilDictionary.H"
#include "soilMessages.H"
#include "StringStream.H"

using doctest::Approx;
using Foam::scalar;
using Foam::soilHydraulics;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("Brooks and Corey with Burdine")
{
    const soilHydraulics soil("brooksCorey", brooksCoreySoil());

    for
    (
        const curveReference& r : std::initializer_list<curveReference>
    {
        {
            0.2, 0.84146635908464961439, 0.15853364091535038561,
            2.5243990772539488432, 0.33514504345685075202,
            0.66485495654314924798, 6.3677558256801642884,
            0.19573317954232480719
        },
        {
            1, 0.32037214975368059604, 0.67962785024631940396,
            0.19222328985220835763, 0.00073985529175859971401,
            0.99926014470824140029, 0.0028114501086826789132,
            0.57593037438420149011
        },
        {
            20, 0.053092937939746725712, 0.94690706206025327429,
            0.0015927881381924017714, 8.4184628724695198646e-9,
            0.99999999158153712753, 1.5995079457692087743e-9,
            2.4296468969873362856
        },
        {
            1e4, 0.0012754245006257908329, 0.99872457549937420917,
            7.6525470037547449972e-8, 4.6681713018762468137e-19,
            0.99999999999999999953, 1.7739050947129737892e-22,
            31.660612515644770822
        }
    }
    )
    {
        check(soil, r);
    }

    for (const scalar h : {-0.15, -0.1, 0.0, 2.0})
    {
        CHECK(soil.retention().Se(h) == 1);
        CHECK(soil.retention().dSedh(h) == 0);
        CHECK(soil.permeability().kr(h) == 1);
        CHECK(soil.permeability().dkrdh(h) == 0);
        CHECK(soil.retention().SeIntegral(h) == h);
    }
}


TEST_CASE("Brooks and Corey with Mualem")
{
    const soilHydraulics soil("mualem", brooksCoreySoil("0.6", "mualem"));

    check
    (
        soil,
        {
            1, 0.32037214975368059604, 0.67962785024631940396,
            0.19222328985220835763, 0.0013071318793450031987,
            0.9986928681206549968, 0.0045749615777075111956,
            0.57593037438420149011
        }
    );
}


TEST_CASE("Brooks and Corey with lambda = 1: the integral is a logarithm")
{
    const soilHydraulics soil("lambda1", brooksCoreySoil("1"));

    check
    (
        soil,
        {
            50, 0.003, 0.997, 0.00006, 2.43e-13, 0.999999999999757, 2.43e-14,
            1.0213714485471041041
        }
    );

    // Beside it nothing is lost: the exponent 1 - lambda is 1e-9
    const soilHydraulics beside("beside", brooksCoreySoil("0.999999999"));
    CHECK
    (
        -beside.retention().SeIntegral(-50) == Approx(1.0213714485).epsilon(1e-8)
    );
}


TEST_CASE("Haverkamp's sand")
{
    const soilHydraulics soil("haverkamp", haverkampSand());

    for
    (
        const curveReference& r : std::initializer_list<curveReference>
    {
        {
            1e-6, 1, 8.9723139090374147233e-23, 3.5530363079788162304e-16,
            1, 9.3317293288781703246e-26, 4.4232397018882527339e-19, 1e-6
        },
        {
            1e-3, 0.99999999993193803873, 6.8061961270549755222e-11,
            2.6952536661303260561e-7, 0.99999999998451318418,
            1.5486815817717464409e-11, 7.3407506974843932759e-8,
            0.00099999999998627783039
        },
        {
            0.1, 0.99437072082106171638, 0.0056292791789382836229,
            0.22166457963660867963, 0.95532021239706106961,
            0.044679787602938930391, 2.0231980982597522458,
            0.09988622185111714046
        },
        {
            0.4, 0.42174917168522362477, 0.57825082831477637523,
            2.4143803978937087799, 0.029071065610557279839,
            0.97092893438944272016, 0.33447737424466385169,
            0.33394690163531691423
        },
        {
            3, 0.00024979680127843667202, 0.99975020319872156333,
            0.00032964941174419020787, 2.1305032153337728186e-6,
            0.99999786949678466623, 3.3661879085379191883e-6,
            0.41089636908282595023
        },
        {
            1000, 2.5532629330547886331e-14, 0.99999999999997446737,
            1.0110921214896704829e-16, 2.3444332200884335261e-18, 1,
            1.1112613463219174888e-20, 0.41114957770482673581
        }
    }
    )
    {
        check(soil, r);
    }

    // Their infiltration, as Celia et al. (1990) restate it: psi = -61.5 cm is
    // theta = 0.10, psi = -20.7 cm is 0.267
    CHECK(soil.theta(-0.615) == Approx(0.10).epsilon(5e-3));
    CHECK(soil.theta(-0.207) == Approx(0.267).epsilon(2e-3));
}


TEST_CASE("curves that do not go together are refused")
{
    const auto soil = []
    (
        const std::string& retention,
        const std::string& permeability
    )
    {
        return messageOf
        (
            dictionaryOf
            (
                "retention { thetaS 0.4; thetaR 0.1;" + retention + "}"
                "relativePermeability {" + permeability + "} Ks 1e-5;"
            )
        );
    };

    const std::string vanGenuchten = "type vanGenuchten; alpha 2; n 1.5;";
    const std::string brooksCorey =
        "type brooksCorey; airEntryHead 0.2; lambda 0.5;";

    checkNames
    (
        soil(vanGenuchten, "type burdine;"),
        {"burdine needs", "brooksCorey", "is vanGenuchten"}
    );
    checkNames
    (
        soil("type gardner; alpha 1;", "type mualem;"),
        {"mualem needs", "vanGenuchten or brooksCorey", "is gardner"}
    );
    checkNames
    (
        soil(vanGenuchten, "type tabulated;"),
        {"needs a table", "is vanGenuchten"}
    );
    checkNames
    (
        soil(brooksCorey, "type tabulated; values ((0.1 0.4 1) (1 0.2 0.1));"),
        {"begins at 0.1 m", "leaves saturation at 0.2 m"}
    );

    // kr would rise in dry soil: l <= -2/m, -2 (1 + 1/lambda), -(1 + 2/lambda)
    checkNames
    (
        soil(vanGenuchten, "type mualem; l -6;"), {"'l'", "is -6", "l > -6"}
    );
    checkNames
    (
        soil(brooksCorey, "type mualem; l -7;"), {"'l'", "is -7", "l > -6"}
    );
    checkNames
    (
        soil(brooksCorey, "type burdine; l -5;"), {"'l'", "is -5", "l > -5"}
    );
    CHECK(soil(vanGenuchten, "type mualem; l -5.9;") == "no error");

    // What does go together
    const std::string haverkamp = "type haverkamp; A 1; gamma 3;";
    const std::string own = "type tabulated; values ((0.2 0.4 1) (9 0.2 1e-3));";

    for (const std::string& retention : {vanGenuchten, brooksCorey})
    {
        for (const std::string& permeability : {haverkamp, own})
        {
            CHECK(soil(retention, permeability) == "no error");
        }
    }
    checkNames(soil(brooksCorey + "lambda 0;", "type burdine;"), {"lambda > 0"});
    checkNames
    (
        soil(brooksCorey + "airEntryHead 0;", "type burdine;"),
        {"airEntryHead > 0"}
    );
    checkNames
    (
        soil
        (
            "type haverkamp; alpha 1e300; beta 0.001;", "type gardner; alpha 1;"
        ),
        {"'alpha'", "'beta'", "1e-86 and 1e86"}
    );
}


TEST_CASE("the log names the models, l, Ss and the air entry")
{
    const auto info = [](const Foam::dictionary& dict)
    {
        Foam::OStringStream os;
        soilHydraulics("loam", dict).writeInfo(os);
        return os.str();
    };

    checkNames
    (
        info(stiffSoil("0.02")),
        {
            "loam", "vanGenuchten", "mualem with l 0.5", "Ss 0.0001 1/m",
            "Ks 1.4e-06 m/s", "air entry at 0.02 m"
        }
    );
    checkNames(info(embankment()), {"air entry none"});
    checkNames
    (
        info(brooksCoreySoil()),
        {"brooksCorey", "burdine with l 2", "air entry at 0.15 m"}
    );
}

// ************************************************************************* //
