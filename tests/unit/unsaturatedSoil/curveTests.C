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
    The curves against values of 50 digits and more, and against themselves.

    The reference values were computed with mpmath (60 digits; the integral by
    its quadrature with 80) from the formulas as printed in Zhu2022 Eqs. 10 to
    12, with the air entry as in Ippisch et al. (2006), and from central
    differences of them with a step of 1e-25 for the slope of kr:

        Se = (1 + (alpha*s)**n)**(-m)/Sc
        C  = alpha*m/(1 - m)*(Sc*Se)**(1/m)*(1 - (Sc*Se)**(1/m))**m/Sc
        kr = Se**l*(p(Sc*Se)/p(Sc))**2,   p(S) = 1 - (1 - S**(1/m))**m

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>

#include "curveReference.H"
#include "soilDictionary.H"

#include <cmath>

using doctest::Approx;
using Foam::scalar;
using Foam::soilHydraulics;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    scalar slope(const soilHydraulics& soil, const scalar h, const scalar dh)
    {
        return (soil.storage(h + dh) - soil.storage(h - dh))/(2*dh);
    }
}

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("van Genuchten and Mualem, m = 0.012")
{
    const soilHydraulics soil("stiff", stiffSoil());

    for
    (
        const curveReference& r : std::initializer_list<curveReference>
    {
        {
            1e-6, 0.99999999180252496179, 8.1974750382124072251e-9,
            0.0082970366444050652281, 0.024535489869860303739, 0.97546451013013969626,
            3208.96783936349515, 9.9999999592600287994e-7
        },
        {
            1e-3, 0.99999108842854163794, 8.9115714583620599393e-6,
            0.0090164206121003032152, 0.0068616445933392552099, 0.99313835540666074479,
            1.84416411537841015, 0.00099999557055338111669
        },
        {
            0.021, 0.99980730856014492031, 0.00019269143985507969275,
            0.0092121669169359203286, 0.0023481800881634922225, 0.99765181991183650778,
            0.0524954622422036561, 0.020997983483562093056
        },
        {
            0.1, 0.99909283701747019629, 0.00090716298252980370737,
            0.0088391738319987585986, 0.00095713765017200488122, 0.99904286234982799512,
            0.00675487966088912537, 0.09995433822649470722
        },
        {
            1, 0.99291900160282170599, 0.0070809983971782940073,
            0.0053892721753908547145, 0.000092196822823090237564, 0.99990780317717690976,
            0.000127794647421190021, 0.99612979455675437209
        },
        {
            5.5, 0.97967291721506280748, 0.020327082784937192518,
            0.0017726773109770871061, 5.6423431920674125652e-6, 0.99999435765680793259,
            1.88577219952833481e-6, 5.4290423438299944102
        },
        {
            100, 0.94789313578341747955, 0.052106864216582520445,
            0.00011379684061283285024, 1.8979867107887453676e-8, 0.99999998102013289211,
            3.83093770515993195e-10, 95.891040446109231337
        }
    }
    )
    {
        check(soil, r);
    }
}


TEST_CASE("van Genuchten and Mualem, m = 0.468")
{
    const soilHydraulics soil("embankment", embankment());

    for
    (
        const curveReference& r : std::initializer_list<curveReference>
    {
        {
            1e-6, 0.999999999999230866, 7.6913400058565342941e-13,
            1.445740602602867725e-6, 0.99999389053415428776, 6.1094658457122415084e-6,
            5.37448468659981672, 9.9999999999973291169e-7
        },
        {
            1e-3, 0.9999996649577886125, 3.3504221138750260857e-7,
            0.00062977826190255951178, 0.99734025678561939879, 0.0026597432143806012134,
            2.33838143963447282, 0.00099999988365372490258
        },
        {
            0.021, 0.9998975753238710913, 0.00010242467612890870219,
            0.0091665076284838692347, 0.96158132587805444123, 0.038418674121945558772,
            1.59556896377863383, 0.020999253028012645905
        },
        {
            0.1, 0.99808049472424454327, 0.001919505275755456735,
            0.035972383385288697118, 0.85236636910348705934, 0.14763363089651294066,
            1.24937826314910502, 0.099933264203167108217
        },
        {
            1, 0.88070314620444347648, 0.11929685379555652352,
            0.18417464142026253579, 0.22486069599751140336, 0.77513930400248859664,
            0.338026944804269976, 0.95526862442018168863
        },
        {
            5.5, 0.36363811945929833484, 0.63636188054070166516,
            0.05146490550219788033, 0.0018671848343777818983, 0.9981328151656222181,
            0.00129936137123933624, 3.4892210656099996725
        },
        {
            100, 0.030013645425957927112, 0.96998635457404207289,
            0.00026388256136721794286, 1.1805791891618272663e-8, 0.99999998819420810838,
            4.95543840364565825e-10, 10.770184230988354072
        }
    }
    )
    {
        check(soil, r);
    }
}


TEST_CASE("an air entry of 2 cm, m = 0.012")
{
    const soilHydraulics soil("airEntry", stiffSoil("0.02"));

    for
    (
        const curveReference& r : std::initializer_list<curveReference>
    {
        {
            0.021, 0.99999078527032302151, 9.2147296769784915627e-6,
            0.0092138574607687765637, 0.97747990876557967475, 0.022520091234420325252,
            21.8523527653486655, 0.020999995392493433919
        },
        {
            0.1, 0.99927618261349555679, 0.00072381738650444321437,
            0.0088407959270979863431, 0.39842890572245267207, 0.60157109427754732793,
            2.81186233880910688, 0.099970839579633803568
        },
        {
            1, 0.99310121422552174435, 0.0068987857744782556463,
            0.0053902611718910094338, 0.038378888576673728071, 0.96162111142332627193,
            0.0531972402507217361, 0.99631075492420756841
        },
        {
            5.5, 0.97985269902137912933, 0.020147300978620870669,
            0.0017730026186623188081, 0.0023487453694063274202, 0.99765125463059367258,
            0.000784992789453924968, 5.4300367971616260601
        },
        {
            100, 0.94806708561621516951, 0.05193291438378483049,
            0.00011381772370677059404, 7.9007733957536819803e-6, 0.99999209922660424632,
            1.59470930590125457e-7, 95.90863576809409045
        }
    }
    )
    {
        check(soil, r);
    }
}


TEST_CASE("curves are continuous at the air entry and saturated above it")
{
    const soilHydraulics soil("airEntry", stiffSoil("0.02"));
    const auto& retention = soil.retention();

    CHECK(soil.saturationHead() == -0.02);

    for (const scalar h : {-0.02, -0.01, 0.0, 3.0})
    {
        CHECK(retention.Se(h) == 1);
        CHECK(retention.desaturation(h) == 0);
        CHECK(retention.dSedh(h) == 0);
        CHECK(soil.permeability().kr(h) == 1);
        CHECK(soil.permeability().reduction(h) == 0);
        CHECK(retention.SeIntegral(h) == h);
    }

    // Below it they leave 1 with the slopes of the reference table: 22 1/m for
    // kr and 0.0092 1/m for Se at most
    const scalar h = -0.02 - 1e-9;
    CHECK(retention.desaturation(h) > 0);
    CHECK(retention.desaturation(h) < 1e-11);
    CHECK(soil.permeability().reduction(h) > 0);
    CHECK(soil.permeability().reduction(h) < 3e-8);
}


TEST_CASE("without air entry the curves start at zero")
{
    const soilHydraulics soil("stiff", stiffSoil());

    CHECK(soil.saturationHead() == 0);
    CHECK(soil.retention().Se(0) == 1);
    CHECK(soil.permeability().kr(0) == 1);
    CHECK(soil.dKdh(0) == 0);
}


TEST_CASE("extreme heads raise no floating-point exception")
{
    const soilHydraulics stiff("stiff", stiffSoil());
    const soilHydraulics sand
    (
        "sand",
        dictionaryOf
        (
            "retention { type vanGenuchten; thetaS 0.43; thetaR 0.045;"
            " alpha 14.5; n 9; }"
            "relativePermeability { type mualem; l -1; }"
            "Ks 8.25e-5;"
        )
    );

    for (const soilHydraulics* soil : {&stiff, &sand})
    {
        for (const scalar s : {1e-300, 1e-100, 1e-12, 1e6, 1e30})
        {
            CAPTURE(s);
            const scalar Se = soil->retention().Se(-s);
            const scalar kr = soil->permeability().kr(-s);

            CHECK((Se >= 0 && Se <= 1));
            CHECK((kr >= 0 && kr <= 1));
            CHECK(soil->retention().dSedh(-s) >= 0);
            CHECK(soil->permeability().dkrdh(-s) >= 0);
            CHECK(std::isfinite(soil->storage(-s)));
        }
    }
}


TEST_CASE("the storage is the integral of the capacity")
{
    // W' = C + Se Ss (the bracket of Zhu2022 Eq. 8). The central difference
    // over 1e-4 of the head has an error of some 1e-8 of the slope's scale
    for (const std::string Ss : {"0", "1e-5", "0.1"})
    {
        const soilHydraulics soil("embankment", embankment(Ss));

        for (const scalar h : {-0.02, -0.4, -2.0, -11.0})
        {
            CAPTURE(h);
            CHECK
            (
                slope(soil, h, 1e-4*std::abs(h))
             == Approx(soil.dStoragedh(h)).epsilon(2e-7)
            );
        }
    }

    // Saturated: theta_s + Ss h
    const soilHydraulics soil("embankment", embankment());
    CHECK(soil.storage(3) == Approx(0.36 + 3e-5).epsilon(1e-15));
    CHECK(soil.dStoragedh(3) == 1e-5);
}


TEST_CASE("Gardner's exponential curves")
{
    const soilHydraulics soil("gardner", gardnerSoil());

    for (const scalar h : {-1e-9, -0.3, -4.0})
    {
        CHECK(soil.retention().Se(h) == Approx(std::exp(2*h)));
        CHECK(soil.permeability().kr(h) == Approx(std::exp(2*h)));
        CHECK(soil.theta(h) == Approx(0.06 + 0.34*std::exp(2*h)));
        CHECK(soil.retention().capacity(h) == Approx(0.68*std::exp(2*h)));
        CHECK(soil.dKdh(h) == Approx(2e-5*std::exp(2*h)));
        CHECK
        (
            soil.retention().desaturation(h)/std::expm1(2*h)
         == Approx(-1)
        );
        CHECK
        (
            soil.retention().SeIntegral(h)/std::expm1(2*h)
         == Approx(0.5)
        );
    }

    CHECK(soil.retention().Se(0.1) == 1);
    CHECK(soil.K(0.1) == 1e-5);
    CHECK(soil.storage(0.1) == 0.4);
}

// ************************************************************************* //
