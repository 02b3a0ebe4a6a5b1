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

#include "slidePoints.H"
#include "Pstream.H"
#include "mpmChecked.H"
#include "readChecked.H"
#include "HashSet.H"

#include <fstream>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// The values of a line, separated by commas, without blanks around them
static DynamicList<word> splitLine(const std::string& line)
{
    DynamicList<word> values;
    std::istringstream is(line);
    std::string value;

    while (std::getline(is, value, ','))
    {
        const auto first = value.find_first_not_of(" \t\r");
        const auto last = value.find_last_not_of(" \t\r");

        values.append
        (
            first == std::string::npos
          ? word()
          : word(value.substr(first, last - first + 1), false)
        );
    }

    return values;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::slidePoints::setColumn
(
    const label pointi,
    const word& column,
    const string& value
)
{
    if (column == "soil")
    {
        forAll(soils_, soili)
        {
            if (soils_.set(soili) && soils_[soili].name() == value)
            {
                soil_[pointi] = soili;
                return;
            }
        }

        throw std::invalid_argument
        (
            "soil " + value + " has no mechanical entry in soilProperties"
        );
    }

    std::size_t end = 0;
    scalar number = 0;

    try
    {
        number = std::stod(value, &end);
    }
    catch (const std::exception&)
    {
        end = 0;
    }

    if (end == 0 || end != value.size() || !std::isfinite(number))
    {
        throw std::invalid_argument(column + ": '" + value + "' is no number");
    }

    const FixedList<word, 3> axes({"x", "y", "z"});
    const label axis = axes.find(column);

    if (axis != -1)
    {
        position_[pointi][axis] = number;
        return;
    }

    scalarField& field =
    (
        column == "volume" ? volume_
      : column == "theta" ? theta_
      : column == "rho" ? rho_
      : column == "porePressure" ? porePressure_
      : column == "frictionAngle" ? frictionAngle_
      : cohesionIntercept_
    );

    field[pointi] = number;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::slidePoints::read(const fileName& casePath, const scalar rhoWater)
{
    const wordList valid
    ({
        "x", "y", "z", "soil", "volume", "theta", "rho", "porePressure",
        "cohesionIntercept", "frictionAngle"
    });

    fileName file(dict_.get<fileName>("file"));
    file.expand();
    if (!file.isAbsolute())
    {
        file = casePath/file;
    }

    std::ifstream is(file);
    std::string line;

    if (!std::getline(is, line))
    {
        FatalIOErrorInFunction(dict_)
            << "file: can't read " << file
            << exit(FatalIOError);
    }

    const wordList names(splitLine(line));
    const wordHashSet given(names);

    for (const word& name : names)
    {
        if (!valid.found(name))
        {
            FatalIOErrorInFunction(dict_)
                << "file: " << file << " has an unknown column " << name << nl
                << "    Valid columns: " << flatOutput(valid)
                << exit(FatalIOError);
        }
    }

    for (const word& needed : wordList({"x", "y", "soil"}))
    {
        if (!given.found(needed))
        {
            FatalIOErrorInFunction(dict_)
                << "file: " << file << " lacks the column " << needed
                << exit(FatalIOError);
        }
    }

    DynamicList<DynamicList<word>> rows;
    while (std::getline(is, line))
    {
        if (line.find_first_not_of(" \t\r") != std::string::npos)
        {
            rows.append(splitLine(line));
        }
    }

    setSize(rows.size());

    forAll(rows, pointi)
    {
        // The line of names is the first
        const string where
        (
            file + ", row " + Foam::name(pointi + 2) + ": "
        );

        mpmChecked
        (
            dict_,
            "reading points",
            [&]()
            {
                if (rows[pointi].size() != names.size())
                {
                    throw std::invalid_argument
                    (
                        where + Foam::name(rows[pointi].size())
                      + " values for "
                      + Foam::name(names.size()) + " columns"
                    );
                }

                try
                {
                    forAll(names, i)
                    {
                        setColumn(pointi, names[i], rows[pointi][i]);
                    }
                }
                catch (const std::invalid_argument& e)
                {
                    throw std::invalid_argument(where + e.what());
                }
            }
        );

        const scalar cohesionIntercept = cohesionIntercept_[pointi];
        const scalar frictionAngle = frictionAngle_[pointi];

        setStrength(pointi);

        if (given.found("cohesionIntercept"))
        {
            cohesionIntercept_[pointi] = cohesionIntercept;
        }
        if (given.found("frictionAngle"))
        {
            frictionAngle_[pointi] = frictionAngle;
        }
        if (!given.found("rho"))
        {
            rho_[pointi] =
                soils_[soil_[pointi]].bulkDensity(theta_[pointi], rhoWater);
        }
    }
}

// ************************************************************************* //
