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

Application
    oddCase

Description
    Writes an odd case for overlandRichardsFoam into a folder, by a seed: soils
    of every model, layers, an initial state, boundaries, rain, roots and
    evaporation, on one of the meshes of the test. Uses the standard library
    only: a seed means the same case on every machine.

    How odd is drawn as well, and printed with the mesh:
        plausible   as somebody would write it
        odd         the ends of what is known of soils and weather
        absurd      allowed by the models, but no soil
        invalid     a plausible case with one entry that cannot be

Usage
    oddCase <seed> <folder>

\*---------------------------------------------------------------------------*/

#include "oddDraw.H"
#include "oddSoil.H"

#include <fstream>
#include <iostream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using std::string;

//- Write a dictionary file with its header
void write
(
    const string& path,
    const string& type,
    const string& object,
    const string& text
)
{
    std::ofstream file(path);
    file<< "FoamFile { version 2.0; format ascii; class " << type
        << "; object " << object << "; }\n\n" << text;

    if (!file.good())
    {
        std::cerr<< "cannot write " << path << '\n';
        std::exit(1);
    }
}


//- A rate over time [m/s], as the value of an entry
string rate(oddDraw& draw, const double end)
{
    const double r =
        draw.byLevel({1e-9, 1e-5}, {1e-12, 1e-3}, {1e-15, 10});

    return draw.choice<string>
    ({
        "constant 0",
        "constant " + text(r),
        "{ type hyetograph; values ((" + text(0.3*end) + " 0) ("
      + text(0.5*end) + ' ' + text(r) + ")); }",
        "{ type hyetograph; interval " + text(end/8)
      + "; depths (0 1 0 " + text(1000*r*end/8) + " 0 0 1 0); }",
        "table ((0 0) (" + text(0.5*end) + ' ' + text(r) + ") ("
      + text(end) + " 0))"
    });
}


//- The upper boundary of psi
string upperPatch(oddDraw& draw, const bool overland, const double end)
{
    if (overland)
    {
        return "type groundSurface;";
    }

    const double head = draw.byLevel({-5, 0.1}, {-50, 5}, {-1e5, 1e3});

    // A prescribed flux may have no solution: not plausible
    return draw.choice<string>
    ({
        "type surfaceRain; rainfall " + rate(draw, end) + ';',
        "type surfaceRain; rainfall " + rate(draw, end) + ';',
        "type fixedValue; value uniform " + text(head) + ';',
        "type seepageFace;",
        draw.plausible()
      ? "type noFlow;"
      : "type darcyFlux; flux constant "
      + text(draw.byLevel({0, 0}, {-1e-7, 1e-6}, {-1e-3, 1e-3})) + ';'
    });
}


//- The lower boundary of psi, and the sides
string lowerPatch(oddDraw& draw)
{
    return draw.choice<string>
    ({
        "type noFlow;",
        "type noFlow;",
        "type freeDrainage;",
        "type fixedPiezometricHead; head constant "
      + text(draw.byLevel({-1, 2}, {-10, 10}, {-1e4, 1e3})) + ';',
        "type seepageFace;"
    });
}


//- Roots and evaporation
string sources(oddDraw& draw, const bool ground, const double end)
{
    string result;

    if (draw.chance(0.5))
    {
        result +=
            "grass { type transpiration; rate " + rate(draw, end)
          + "; rootDepth " + text(draw.byLevel({0.2, 2}, {0.01, 9}, {1e-3, 90}))
          + "; }\n";
    }
    if (ground && draw.chance(0.7))
    {
        result +=
            "sun { type evaporation; rate " + rate(draw, end)
          + "; relativeHumidity "
          + text(draw.byLevel({0.3, 0.9}, {0.01, 0.99}, {1e-6, 0.999999}))
          + "; }\n";
    }

    return result;
}

} // End anonymous namespace

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    if (argc != 3)
    {
        std::cerr<< "Usage: oddCase <seed> <folder>\n";
        return 1;
    }

    const string folder = string(argv[2]) + '/';
    oddDraw draw(std::stoull(argv[1]));

    const string mesh =
        draw.choice<string>({"column", "slope", "steep", "prisms", "tets"});
    const double scale =
        draw.choice<double>({1, 1, draw.byLevel({0.3, 3}, {0.1, 30}, {0.01, 1e3})});
    const double end =
        draw.choice<double>({3600, 86400, draw.plausible() ? 86400 : 1e6});
    const bool overland = draw.chance(0.5);
    const bool layered = draw.chance(0.6);

    string soils = "soils\n{\n";
    for (const string zone : {"lower", "middle", "upper"})
    {
        if (layered || zone == "lower")
        {
            soils += zone + " { hydraulic\n" + oddSoil(draw) + "}\n";
        }
    }
    soils += "}\n";

    const double level = scale*draw.choice<double>({-3, 0, 1.5, 4});
    const double head = draw.choice<double>
    ({
        0, -1, -10,
        draw.plausible() ? -3.0 : -100.0,
        draw.plausible() ? -30.0 : -1e4,
        draw.level() == oddDraw::absurd ? -1e8 : 0.5
    });
    const bool waterTable = draw.chance(0.5);

    string psi =
        "dimensions [0 1 0 0 0 0 0];\ninternalField uniform " + text(head)
      + ";\nboundaryField\n{\n"
        "    ground { " + upperPatch(draw, overland, end) + " }\n"
        "    base { " + lowerPatch(draw) + " }\n"
        "    \"(left|right)\" { " + lowerPatch(draw) + " }\n"
        "    \"(sides|frontAndBack)\" { type empty; }\n}\n";

    string overlandText =
        "groundPatch ground;\noverlandFlowModel "
      + draw.choice<string>({"diffusionWave", "kinematicWave"})
      + ";\nmanning " + text(draw.byLevel({0.02, 0.3}, {1e-3, 10}, {1e-9, 1e6}))
      + ";\nrainfall " + rate(draw, end) + ";\noutlets\n{\n"
      + (mesh == "column" || draw.chance(0.3)
          ? ""
          : "right { type " + draw.choice<string>({"criticalDepth",
            "normalDepth; slope 0.1"}) + "; }")
      + "\n}\n";

    const bool hasSources = draw.chance(0.4);
    const bool ground =
        overland || psi.find("surfaceRain") != string::npos;
    const string sourceText = hasSources ? sources(draw, ground, end) : "";

    const string controls =
        "application overlandRichardsFoam;\nstartFrom startTime;\nstartTime 0;\n"
        "stopAt endTime;\nendTime " + text(end) + ";\ndeltaT "
      + text(draw.choice<double>({1, 60, 600})) + ";\nadjustTimeStep yes;\n"
        "writeControl adjustableRunTime;\nwriteInterval " + text(end/2)
      + ";\nwriteFormat ascii;\nwritePrecision 10;\ntimePrecision 9;\n"
        "runTimeModifiable no;\n";

    if (draw.level() == oddDraw::invalid)
    {
        spoil(draw, soils, psi, overland ? overlandText : soils);
    }

    write(folder + "constant/soilProperties", "dictionary", "soilProperties",
        soils);
    write(folder + "0/psi", "volScalarField", "psi", psi);
    write(folder + "system/controlDict", "dictionary", "controlDict", controls);
    if (overland)
    {
        write(folder + "constant/overlandProperties", "dictionary",
            "overlandProperties", overlandText);
    }
    if (!sourceText.empty())
    {
        write(folder + "constant/waterSources", "dictionary", "waterSources",
            sourceText);
    }

    // For the script: how odd, which mesh, its scale, single or layered soil,
    // and the level of a water table
    std::cout
        << draw.levelName() << ' ' << mesh << ' ' << text(scale) << ' '
        << (layered ? "layered" : "single") << ' '
        << (waterTable ? text(level) : "none") << '\n';

    return 0;
}

// ************************************************************************* //
