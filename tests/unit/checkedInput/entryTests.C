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
    Entries of a dictionary that are out of their range, misspelt or missing.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>

#include "dictionaryOf.H"
#include "readChecked.H"
#include "readChoice.H"

using Foam::checkKeys;
using Foam::dictionary;
using Foam::readChoice;
using Foam::readChoiceOrDefault;
using Foam::readChecked;
using Foam::readCheckedOrDefault;
using Foam::scalar;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    bool positive(const scalar value)
    {
        return value > 0;
    }

    //- The message of a refusal and where it lies, empty if there is none
    template<class Action>
    std::string refusal(const Action& action)
    {
        try
        {
            action();
        }
        catch (const Foam::IOerror& error)
        {
            return error.message() + error.ioFileName();
        }

        return std::string();
    }
}

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("A number in its range")
{
    const dictionary dict(dictionaryOf("Ks 1e-5; alpha -2; n nan; m word;"));

    CHECK(readChecked(dict, "Ks", positive, "positive") == 1e-5);
    CHECK(readCheckedOrDefault(dict, "Ss", 3, positive, "positive") == 3);

    for (const Foam::word key : {"alpha", "n", "m", "missing"})
    {
        CAPTURE(key);
        const std::string message
        (
            refusal([&]{ readChecked(dict, key, positive, "positive"); })
        );
        CHECK(message.find(key) != std::string::npos);
    }

    CHECK
    (
        refusal([&]{ readChecked(dict, "alpha", positive, "positive"); })
       .find("positive") != std::string::npos
    );
}


TEST_CASE("A word among those there are")
{
    const dictionary dict(dictionaryOf("flux upwind; law manning;"));

    CHECK(readChoice(dict, "flux", {"monotone", "upwind"}) == "upwind");
    CHECK(readChoiceOrDefault(dict, "time", "BDF2", {"BDF1", "BDF2"}) == "BDF2");

    const std::string message
    (
        refusal([&]{ readChoice(dict, "law", {"chezy", "darcyWeisbach"}); })
    );
    CHECK(message.find("manning") != std::string::npos);
    CHECK(message.find("darcyWeisbach") != std::string::npos);
}


TEST_CASE("Keys that nobody would read")
{
    const dictionary dict(dictionaryOf("Ks 1; soil { n 2; }"));

    CHECK(&checkKeys(dict, {"Ks"}, {"soil"}) == &dict);

    const std::string message(refusal([&]{ checkKeys(dict, {"K"}, {"soil"}); }));
    CHECK(message.find("Ks") != std::string::npos);

    // A dictionary in the place of a value and the other way round
    CHECK_FALSE(refusal([&]{ checkKeys(dict, {"Ks", "soil"}); }).empty());
    CHECK_FALSE(refusal([&]{ checkKeys(dict, {}, {"Ks", "soil"}); }).empty());
}

// ************************************************************************* //
