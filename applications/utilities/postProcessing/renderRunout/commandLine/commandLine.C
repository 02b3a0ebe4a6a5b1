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

#include "commandLine.H"

#include <stdexcept>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

runoutPicture::panelSettings& runoutPicture::commandLine::panel()
{
    return settings_.panels.empty() ? common_ : settings_.panels.back();
}


std::string runoutPicture::commandLine::text()
{
    if (words_.empty())
    {
        throw std::invalid_argument
        (
            "Option " + current_ + " needs more arguments: "
          + options_.at(current_).arguments
        );
    }

    const std::string word(words_.front());
    words_.pop_front();
    return word;
}


double runoutPicture::commandLine::number()
{
    std::string word(text());

    // Several numbers in quotes are several words
    const auto blank = word.find_first_of(" \t");
    if (blank != std::string::npos)
    {
        const auto next = word.find_first_not_of(" \t", blank);
        if (next != std::string::npos)
        {
            words_.push_front(word.substr(next));
        }
        word.resize(blank);
    }

    std::size_t used = 0;
    double value = 0;

    try
    {
        value = std::stod(word, &used);
    }
    catch (const std::exception&)
    {
        used = 0;
    }

    if (used != word.size() || !std::isfinite(value))
    {
        throw std::invalid_argument
        (
            "Option " + current_ + ": '" + word + "' is not a number; expected "
          + options_.at(current_).arguments
        );
    }

    return value;
}


int runoutPicture::commandLine::whole(const int low)
{
    const double value = number();

    if (value != std::floor(value) || value < low)
    {
        throw std::invalid_argument
        (
            "Option " + current_ + " is " + std::to_string(value)
          + "; allowed is a whole number >= " + std::to_string(low)
        );
    }

    return int(value);
}


void runoutPicture::commandLine::addPictureOptions()
{
    // Smaller ones leave no room for the text
    const int minWidth = 300;
    const int minFontSize = 8;

    options_["-output"] =
    {
        "<file.png>", "the picture to write (required)",
        [this]() { settings_.output = text(); }
    };
    options_["-title"] =
    {
        "<text>", "title above all panels",
        [this]() { settings_.title = text(); }
    };
    options_["-width"] =
    {
        "<pixels>", "width of the picture, default 1600",
        [this]() { settings_.width = whole(minWidth); }
    };
    options_["-fontSize"] =
    {
        "<pixels>", "height of the font, default 24",
        [this]() { settings_.fontSize = whole(minFontSize); }
    };
    options_["-columns"] =
    {
        "<n>", "panels in a row, default 1",
        [this]() { settings_.columns = whole(1); }
    };
    options_["-panel"] =
    {
        "<title>", "begin a panel; what follows holds for it alone",
        [this]()
        {
            settings_.panels.push_back(common_);
            settings_.panels.back().title = text();
        }
    };
    options_["-window"] =
    {
        "<xMin xMax yMin yMax>", "the part to show, default all",
        [this]()
        {
            const double xMin = number();
            const double xMax = number();
            const double yMin = number();
            const double yMax = number();

            if (!(xMin < xMax && yMin < yMax))
            {
                throw std::invalid_argument
                (
                    "Option -window needs xMin < xMax and yMin < yMax"
                );
            }
            panel().window = {xMin, xMax, yMin, yMax};
        }
    };
}


void runoutPicture::commandLine::addDataOptions()
{
    options_["-mesh"] =
    {
        "<file>",
        "mesh (.vtu .vtp .vtk); of volume cells a section is shown",
        [this]() { panel().mesh = text(); }
    };
    options_["-points"] =
    {
        "<file>", "material points (.vtp .vtu .vtk)",
        [this]() { panel().points = text(); }
    };
    options_["-array"] =
    {
        "<name>",
        "the quantity, of the points if there are any, else of the mesh",
        [this]() { panel().array.name = text(); }
    };
    options_["-component"] =
    {
        "<x|y|z>", "of a vector, default its magnitude",
        [this]() { panel().array.component = text(); }
    };
    options_["-factor"] =
    {
        "<number>", "values are multiplied by it, e.g. 0.001 from Pa to kPa",
        [this]() { panel().array.factor = number(); }
    };
    options_["-view"] =
    {
        "<xy|xz|yz|...>", "coordinates to the right and upwards, default xy",
        [this]() { panel().view = viewAxes(text()); }
    };
    options_["-slice"] =
    {
        "<coordinate>", "where volume cells are cut, default the middle",
        [this]() { panel().slice = number(); }
    };
    options_["-smooth"] =
    {
        "", "interpolate cell values",
        [this]() { panel().smooth = true; }
    };
    options_["-flat"] =
    {
        "", "one colour a cell even if there are values at the nodes",
        [this]() { panel().flat = true; }
    };
    options_["-pointSize"] =
    {
        "<m>", "diameter of the points, default from their spacing",
        [this]()
        {
            const double size = number();
            if (!(size > 0))
            {
                throw std::invalid_argument
                (
                    "Option -pointSize is " + std::to_string(size)
                  + "; it must be > 0"
                );
            }
            panel().pointSize = size;
        }
    };
}


void runoutPicture::commandLine::addColourOptions()
{
    std::string maps;
    for (const std::string& name : colourMap::names())
    {
        maps += ' ' + name;
    }

    options_["-map"] =
    {
        "<name>", "colour map, default viridis; one of" + maps,
        [this]() { panel().colours.map = text(); }
    };
    options_["-reverse"] =
    {
        "", "last colour first",
        [this]() { panel().colours.reversed = true; }
    };
    options_["-range"] =
    {
        "<low high>", "range of the colours, default that of the data",
        [this]()
        {
            const double low = number();
            const double high = number();
            if (!(low < high))
            {
                throw std::invalid_argument
                (
                    "Option -range needs low < high"
                );
            }
            panel().colours.range = {low, high};
        }
    };
    options_["-logarithmic"] =
    {
        "", "equal ratios instead of equal differences",
        [this]() { panel().colours.logarithmic = true; }
    };
    options_["-bands"] =
    {
        "<n>", "n bands of one colour instead of a continuous map",
        [this]() { panel().colours.bands = whole(1); }
    };
    options_["-hideBelow"] =
    {
        "<value>", "smaller values are left grey, e.g. dry ground",
        [this]() { panel().colours.hideBelow = number(); }
    };
    options_["-label"] =
    {
        "<text>", "quantity and unit beside the colour bar",
        [this]() { panel().colours.label = text(); }
    };
}


void runoutPicture::commandLine::addOverlayOptions()
{
    options_["-edges"] =
    {
        "", "draw the edges of the mesh",
        [this]() { panel().edges = true; }
    };
    options_["-isoline"] =
    {
        "<value>", "line of equal value of the mesh's quantity; repeatable",
        [this]() { panel().isolines.push_back(number()); }
    };
    options_["-contours"] =
    {
        "<m>", "contour lines of the height across the view, this far apart",
        [this]() { panel().contours = number(); }
    };
    options_["-lineFile"] =
    {
        "<file>", "lines (.vtp .vtk, or text with x y); repeatable",
        [this]() { panel().lineFiles.push_back(text()); }
    };
    options_["-line"] =
    {
        "<'x y x y ...'>", "a line through places; repeatable",
        [this]() { panel().lines.push_back(parseLine(text())); }
    };
    options_["-dashed"] =
    {
        "<'x y x y ...'>", "a dashed line, e.g. a water table; repeatable",
        [this]() { panel().dashedLines.push_back(parseLine(text())); }
    };
    options_["-mark"] =
    {
        "<x y text>", "a marked place; repeatable",
        [this]()
        {
            const double x = number();
            const double y = number();
            panel().marks.push_back({{x, y}, text()});
        }
    };
}


void runoutPicture::commandLine::check() const
{
    if (settings_.output.empty())
    {
        throw std::invalid_argument("Option -output <file.png> is missing");
    }

    for (const panelSettings& p : settings_.panels)
    {
        const std::string where(p.title.empty() ? "" : " in panel " + p.title);

        if (p.mesh.empty() && p.points.empty())
        {
            throw std::invalid_argument
            (
                "Neither -mesh nor -points is given" + where
            );
        }
        if (!p.isolines.empty() && (p.mesh.empty() || !p.points.empty()))
        {
            throw std::invalid_argument
            (
                "Option -isoline" + where
              + " needs a panel with -mesh and without -points"
            );
        }
        if (p.contours < 0 || (p.contours > 0 && p.mesh.empty()))
        {
            throw std::invalid_argument
            (
                "Option -contours" + where
              + " needs a distance > 0 and a -mesh"
            );
        }

        // An unknown name shows up before any file is read
        colourMap(p.colours.map.empty() ? "viridis" : p.colours.map, false);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

runoutPicture::commandLine::commandLine(int argc, char* argv[])
:
    words_(argv + 1, argv + argc)
{
    addPictureOptions();
    addDataOptions();
    addColourOptions();
    addOverlayOptions();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool runoutPicture::commandLine::wantsHelp() const
{
    return words_.empty()
        || std::find(words_.begin(), words_.end(), "-help") != words_.end();
}


std::string runoutPicture::commandLine::help() const
{
    std::string result
    (
        "\nUsage: renderRunout -output <file.png> [options]"
        " [-panel <title> [options]] ...\n\n"
        "Draws material points and sections or plan views of meshes as PNG,\n"
        "without a display. Options before the first -panel hold for all\n"
        "panels, those after it for that panel; without -panel there is one.\n"
        "Panels with the same colours and label share a colour bar.\n\n"
        "Example: the three states of a slope\n"
        "    renderRunout -output states.png -array equivalentPlasticStrain"
        " \\\n"
        "        -map strain -range 0 1 -label 'plastic strain' \\\n"
        "        -panel 'a' -points a.vtp -panel 'b' -points b.vtp\n\n"
        "Options:\n"
    );

    for (const auto& [name, o] : options_)
    {
        result += "    " + name + ' ' + o.arguments + "\n        "
            + o.meaning + '\n';
    }

    return result;
}


runoutPicture::pictureSettings runoutPicture::commandLine::read()
{
    while (!words_.empty())
    {
        current_ = words_.front();
        words_.pop_front();

        const auto found = options_.find(current_);

        if (found == options_.end())
        {
            std::string valid;
            for (const auto& [name, o] : options_)
            {
                valid += ' ' + name;
            }
            throw std::invalid_argument
            (
                "Unknown option " + current_ + "\n    Valid options:" + valid
            );
        }

        found->second.apply();
    }

    if (settings_.panels.empty())
    {
        settings_.panels.push_back(common_);
    }

    check();
    return settings_;
}


// ************************************************************************* //
