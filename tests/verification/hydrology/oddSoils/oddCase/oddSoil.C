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

#include "oddSoil.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using std::string;

//- An entry with a number by oddness
string entry
(
    oddDraw& draw,
    const string& key,
    const oddDraw::range& plausible,
    const oddDraw::range& odd,
    const oddDraw::range& absurd
)
{
    return key + ' ' + text(draw.byLevel(plausible, odd, absurd)) + "; ";
}


//- Measured points between two suctions, theta falling from thetaS
string table(oddDraw& draw, const double thetaS)
{
    const int rows = 2 + int(draw.byLevel({4, 20}, {1, 60}, {0, 3}));
    const double first = draw.byLevel({0.01, 0.2}, {1e-3, 2}, {1e-6, 50});
    const double last = first*draw.byLevel({1e4, 1e6}, {10, 1e8}, {1.001, 1e10});
    const double leastTheta = thetaS*draw.byLevel({0.1, 0.4}, {0.01, 0.9}, {1e-6, 0.999});
    const double logKr = -draw.byLevel({8, 25}, {2, 60}, {1e-3, 600});

    string result = "values (";
    for (int i = 0; i < rows; ++i)
    {
        // Uneven, but falling
        const double x = double(i)/(rows - 1);
        const double y = std::pow(x, 0.8);
        char row[96];
        std::snprintf
        (
            row, sizeof(row), "(%.10g %.10g %.10g) ",
            first*std::pow(last/first, x),
            thetaS + y*(leastTheta - thetaS),
            std::exp(logKr*y)
        );
        result += row;
    }

    return
        result + "); interpolation "
      + draw.choice<string>({"linear", "monotoneCubic"}) + "; ";
}


//- Replace the value of the n-th occurrence of an entry, if it is there
bool replace(string& text, const string& key, const string& value)
{
    const std::size_t at = text.find(' ' + key + ' ');

    if (at == string::npos)
    {
        return false;
    }

    const std::size_t from = at + key.size() + 2;
    text.replace(from, text.find(';', from) - from, value);

    return true;
}

} // End anonymous namespace

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

string oddSoil(oddDraw& draw)
{
    const double thetaS = draw.byLevel({0.3, 0.6}, {0.05, 0.95}, {1e-4, 1});
    const double thetaR =
        thetaS*draw.byLevel({0.02, 0.4}, {1e-6, 0.9}, {1e-9, 0.99999});

    const string waterContents =
        " thetaS " + text(thetaS) + "; thetaR " + text(thetaR) + "; ";

    const string airEntry =
        entry(draw, "airEntryHead", {0.005, 0.5}, {1e-3, 5}, {1e-6, 1e4});

    string retention, permeability;

    switch (int(draw.uniform()*7))
    {
        case 0:
        case 1:
        case 2:
            retention =
                "type vanGenuchten;" + waterContents
              + entry(draw, "alpha", {0.2, 15}, {0.01, 100}, {1e-6, 1e6})
              + entry(draw, "n", {1.05, 3}, {1.005, 9}, {1.000001, 100})
              + (draw.chance(0.3) ? airEntry : "");
            permeability =
                "type mualem; "
              + entry(draw, "l", {0.5, 0.5}, {-0.5, 5}, {-2, 50});
            break;

        case 3:
            retention =
                "type brooksCorey;" + waterContents + airEntry
              + entry(draw, "lambda", {0.1, 3}, {0.01, 10}, {1e-6, 100});
            permeability = draw.choice<string>
            ({
                "type burdine; ",
                "type mualem; ",
                "type gardner; "
              + entry(draw, "alpha", {0.5, 10}, {0.01, 100}, {1e-5, 1e5})
            });
            break;

        case 4:
            retention =
                "type gardner;" + waterContents
              + entry(draw, "alpha", {0.5, 10}, {0.01, 100}, {1e-5, 1e5});
            permeability =
                "type gardner; "
              + entry(draw, "alpha", {0.5, 10}, {0.01, 100}, {1e-5, 1e5});
            break;

        case 5:
            retention =
                "type haverkamp;" + waterContents + "headUnit 0.01; "
              + entry(draw, "alpha", {1e2, 1e7}, {1, 1e9}, {1e-6, 1e20})
              + entry(draw, "beta", {1, 5}, {0.3, 9}, {0.01, 60});
            permeability =
                "type haverkamp; headUnit 0.01; "
              + entry(draw, "A", {1e2, 1e7}, {1, 1e9}, {1e-6, 1e20})
              + entry(draw, "gamma", {1.5, 7}, {0.3, 12}, {0.01, 80});
            break;

        default:
            retention = "type tabulated; " + table(draw, thetaS);
            permeability = "type tabulated; ";
    }

    const string Ks =
        entry(draw, "Ks", {1e-8, 1e-3}, {1e-11, 0.1}, {1e-20, 1e3});
    const string Ss = draw.choice<string>
    ({
        "",
        entry(draw, "Ss", {1e-6, 1e-3}, {1e-9, 0.1}, {1e-20, 10})
    });

    return
        "{ retention { " + retention + "}\n  relativePermeability { "
      + permeability + "}\n  " + Ks + Ss + "}\n";
}


void spoil(oddDraw& draw, string& soils, string& psi, string& overland)
{
    struct error
    {
        string* file;
        string key;
        std::vector<string> values;
    };

    const std::vector<string> notPositive({"0", "-1", "nan", "inf", "word", ""});

    const std::vector<error> errors
    ({
        {&soils, "thetaS", {"1.2", "0", "-0.4", "nan", "1e300"}},
        {&soils, "thetaR", {"0.99", "-0.1", "nan", "word"}},
        {&soils, "alpha", notPositive},
        {&soils, "n", {"1", "0.5", "-3", "nan"}},
        {&soils, "lambda", notPositive},
        {&soils, "beta", notPositive},
        {&soils, "gamma", notPositive},
        {&soils, "l", {"-1e9", "nan", "inf"}},
        {&soils, "Ks", notPositive},
        {&soils, "Ss", {"-1e-5", "nan", "inf"}},
        {&soils, "type", {"vanGenucht", "3"}},
        {&soils, "values", {"((1 0.3 1) (2 0.4 0.5))", "()", "((1 2 3 4))"}},
        {&psi, "internalField", {"uniform nan", "uniform", "uniform (1 0 0)"}},
        {&psi, "type", {"zeroGradient", "noflow"}},
        {&overland, "manning", notPositive},
        {&overland, "rainfall", {"constant -1", "constant nan", "drizzle"}}
    });

    // Not every case has every entry
    for (int trial = 0; trial < 200; ++trial)
    {
        const error& e = errors[std::size_t(draw.uniform()*errors.size())];

        if (replace(*e.file, e.key, draw.choice(e.values)))
        {
            return;
        }
    }
}

// ************************************************************************* //
