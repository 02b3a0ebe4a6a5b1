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
    What the soil dictionaries refuse, and that the message names key, value
    and range or the valid names.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>

#include "soilDictionary.H"

#include <string>

using Foam::soilHydraulics;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    const std::string goodRetention =
        "type vanGenuchten; thetaS 0.4; thetaR 0.1; alpha 2; n 1.5;";

    //- The message of the error that a soil of these entries raises
    std::string messageOf
    (
        const std::string& retention,
        const std::string& permeability = "type mualem;",
        const std::string& rest = "Ks 1e-5;"
    )
    {
        const Foam::dictionary dict
        (
            dictionaryOf
            (
                "retention {" + retention + "}"
                "relativePermeability {" + permeability + "}" + rest
            )
        );

        try
        {
            const soilHydraulics soil("soil", dict);
        }
        catch (const Foam::IOerror& error)
        {
            return error.message();
        }

        return "no error";
    }

    bool names(const std::string& message, const std::string& text)
    {
        return message.find(text) != std::string::npos;
    }
}

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("a good soil is accepted")
{
    CHECK(messageOf(goodRetention) == "no error");
}


TEST_CASE("numbers out of their range are refused")
{
    struct bad
    {
        std::string entry, key, value, range;
    };

    for
    (
        const bad& b : std::initializer_list<bad>
    {
        {"thetaS 1.2;", "thetaS", "1.2", "0 < thetaS <= 1"},
        {"thetaS 0;", "thetaS", "0", "0 < thetaS <= 1"},
        {"thetaR 0.4;", "thetaR", "0.4", "0 <= thetaR < thetaS"},
        {"thetaR -0.1;", "thetaR", "-0.1", "0 <= thetaR < thetaS"},
        {"alpha 0;", "alpha", "0", "alpha > 0"},
        {"n 1;", "n", "1", "n > 1"},
        {"airEntryHead -0.1;", "airEntryHead", "-0.1", "airEntryHead >= 0"}
    }
    )
    {
        // Of an entry given twice the later one counts
        const std::string message = messageOf(goodRetention + b.entry);

        CAPTURE(message);
        CHECK(names(message, "'" + b.key + "'"));
        CHECK(names(message, " is " + b.value));
        CHECK(names(message, b.range));
    }

    const std::string m =
        messageOf("type vanGenuchten; thetaS 0.4; thetaR 0; alpha 2; m 1;");
    CHECK(names(m, "0 < m < 1"));

    CHECK
    (
        names(messageOf(goodRetention, "type mualem;", "Ks 0;"), "Ks > 0")
    );
    CHECK
    (
        names
        (
            messageOf(goodRetention, "type mualem;", "Ks 1; Ss -1;"),
            "Ss >= 0"
        )
    );
    CHECK(messageOf(goodRetention, "type mualem; l nan;") != "no error");
}


TEST_CASE("m and n may both be given if they agree")
{
    const std::string soil =
        "type vanGenuchten; thetaS 0.4; thetaR 0; alpha 2;";

    CHECK(messageOf(soil + "m 0.468; n 1.8797;") == "no error");

    const std::string message = messageOf(soil + "m 0.468; n 2;");
    CHECK(names(message, "disagree"));
    CHECK(names(message, "0.468"));

    CHECK(names(messageOf(soil), "Neither 'm'"));
}


TEST_CASE("an unknown model is answered by the valid ones")
{
    const std::string retention =
        messageOf("type brooksCori; thetaS 0.4; thetaR 0;");

    CHECK(names(retention, "brooksCori"));
    CHECK(names(retention, "brooksCorey"));
    CHECK(names(retention, "haverkamp"));
    CHECK(names(retention, "tabulated"));
    CHECK(names(retention, "vanGenuchten"));
    CHECK(names(retention, "gardner"));

    const std::string permeability =
        messageOf(goodRetention, "type burdin;");

    CHECK(names(permeability, "burdin"));
    CHECK(names(permeability, "burdine"));
    CHECK(names(permeability, "mualem"));
    CHECK(names(permeability, "gardner"));
}


TEST_CASE("a missing entry is named")
{
    CHECK
    (
        names
        (
            messageOf("type vanGenuchten; thetaS 0.4; thetaR 0; n 2;"),
            "alpha"
        )
    );
    CHECK(names(messageOf(goodRetention, "type mualem;", ""), "Ks"));
}

// ************************************************************************* //
