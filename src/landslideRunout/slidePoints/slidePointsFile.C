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
#include "outputFolder.H"
#include "readChecked.H"
#include "HashSet.H"

#include <fstream>
#include <limits>
#include <map>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// Names of the components of vectors and of symmetric tensors
static const FixedList<word, 3> vectorComponents({"x", "y", "z"});
static const FixedList<word, 6> tensorComponents
(
    {"xx", "xy", "xz", "yy", "yz", "zz"});


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
    scalar result = 0;

    try
    {
        result = std::stod(value, &end);
    }
    catch (const std::exception&)
    {
        end = 0;
    }

    if (end == 0 || end != value.size() || !std::isfinite(result))
    {
        throw std::invalid_argument(column + ": '" + value + "' is no number");
    }

    const bool positive = (column == "volume" || column == "rho");
    const bool notNegative = (column == "equivalentPlasticStrain");

    if ((positive && result <= 0) || (notNegative && result < 0))
    {
        throw std::invalid_argument
        (
            column + ": " + value + " is not " + (positive ? "> 0" : ">= 0")
        );
    }

    number(pointi, column) = result;
}


Foam::scalar& Foam::slidePoints::number
(
    const label pointi,
    const word& column
)
{
    const auto last = column.find('_');

    if (column.size() == 1)
    {
        return position_[pointi][vectorComponents.find(column)];
    }
    if (last != std::string::npos)
    {
        const word component(column.substr(last + 1));

        return
            column.startsWith("velocity")
          ? velocity_[pointi][vectorComponents.find(component)]
          : sigma_[pointi][tensorComponents.find(component)];
    }

    scalarField& field =
    (
        column == "volume" ? volume_
      : column == "theta" ? theta_
      : column == "rho" ? rho_
      : column == "porePressure" ? porePressure_
      : column == "frictionAngle" ? frictionAngle_
      : column == "equivalentPlasticStrain" ? plasticStrain_
      : cohesionIntercept_
    );

    return field[pointi];
}


Foam::List<Foam::wordList> Foam::slidePoints::fileColumns() const
{
    const bool section = (frame_.dimension() == 2);
    wordList places({"x", "y", "soil"});
    wordList velocities({"velocity_x", "velocity_y"});
    wordList stresses({"sigma_xx", "sigma_yy", "sigma_zz", "sigma_xy"});

    if (!section)
    {
        places.append("z");
        velocities.append("velocity_z");
        stresses.append(wordList({"sigma_yz", "sigma_xz"}));
    }

    List<wordList> result({places, velocities, stresses});

    for
    (
        const word& name :
        wordList
        ({
            "volume", "theta", "rho", "porePressure", "cohesionIntercept",
            "frictionAngle", "equivalentPlasticStrain"
        })
    )
    {
        result.append(wordList(1, name));
    }
    if (section)
    {
        result.append(wordList(1, word("z")));
    }

    return result;
}


void Foam::slidePoints::checkColumns
(
    const fileName& file,
    const wordList& names
) const
{
    const List<wordList> columns(fileColumns());
    const wordHashSet given(names);

    wordList valid;
    for (const wordList& together : columns)
    {
        valid.append(together);
    }

    for (const word& name : names)
    {
        if (!valid.found(name))
        {
            FatalIOErrorInFunction(dict_)
                << "file: " << file << ", line 1: unknown column " << name << nl
                << "    Valid columns: " << flatOutput(valid)
                << exit(FatalIOError);
        }
    }
    if (given.size() != names.size())
    {
        FatalIOErrorInFunction(dict_)
            << "file: " << file << ", line 1: a column is named twice in "
            << flatOutput(names)
            << exit(FatalIOError);
    }

    forAll(columns, i)
    {
        // Place and soil are needed, of the others all that go together
        bool needed = (i == 0);
        for (const word& name : columns[i])
        {
            needed = needed || given.found(name);
        }

        for (const word& name : columns[i])
        {
            if (needed && !given.found(name))
            {
                FatalIOErrorInFunction(dict_)
                    << "file: " << file << ", line 1: lacks the column " << name
                    << exit(FatalIOError);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::slidePoints::read(const fileName& casePath, const scalar rhoWater)
{
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
    checkColumns(file, names);

    DynamicList<DynamicList<word>> rows;
    DynamicList<label> lineNumbers;

    // The line of names is the first
    for (label lineNumber = 2; std::getline(is, line); ++lineNumber)
    {
        if (line.find_first_not_of(" \t\r") != std::string::npos)
        {
            rows.append(splitLine(line));
            lineNumbers.append(lineNumber);
        }
    }

    setSize(rows.size());
    velocity_.setSize(given.found("velocity_x") ? size() : 0, Zero);
    sigma_.setSize(given.found("sigma_xx") ? size() : 0, Zero);
    plasticStrain_.setSize
    (
        given.found("equivalentPlasticStrain") ? size() : 0,
        Zero
    );

    forAll(rows, pointi)
    {
        const string where
        (
            file + ", line " + Foam::name(lineNumbers[pointi]) + ": "
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

        checkCellSize(position_[pointi]);

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


void Foam::slidePoints::write
(
    const fileName& file,
    const mpm::Run& run,
    const bool axisymmetric
) const
{
    // The engine's order of a stress is xx yy zz xy yz zx
    struct source
    {
        word column;
        std::string field;
        label component;
    };

    DynamicList<source> sources
    ({
        {"x", "position", 0}, {"y", "position", 1},
        {"velocity_x", "velocity", 0}, {"velocity_y", "velocity", 1},
        {"sigma_xx", "sigma", 0}, {"sigma_yy", "sigma", 1},
        {"sigma_zz", "sigma", 2}, {"sigma_xy", "sigma", 3},
        {"volume", "volume", 0}, {"rho", "rho", 0},
        {"porePressure", "porePressure", 0},
        {"cohesionIntercept", "cohesionIntercept", 0},
        {"frictionAngle", "frictionAngle", 0},
        {"equivalentPlasticStrain", "equivalentPlasticStrain", 0}
    });

    if (frame_.dimension() == 3)
    {
        sources.append
        ({
            {"z", "position", 2}, {"velocity_z", "velocity", 2},
            {"sigma_yz", "sigma", 4}, {"sigma_xz", "sigma", 5}
        });
    }

    // Only the master has the values
    std::map<std::string, std::vector<double>> fields
    ({
        {"zone", run.field("zone")}
    });
    for (const source& s : sources)
    {
        if (!fields.count(s.field))
        {
            fields[s.field] = run.field(s.field);
        }
    }

    if (!run.master())
    {
        return;
    }
    if (axisymmetric)
    {
        // From one radian to a section 1 m thick
        for (std::size_t i = 0; i < run.nPoints(); ++i)
        {
            fields["volume"][i] /= fields["position"][3*i];
        }
    }

    const std::vector<mpm::Material> soils(materials());
    makeOutputFolder(file.path());
    const fileName unfinished(file + ".unfinished");
    {
        std::ofstream os(unfinished);
        os.precision(std::numeric_limits<scalar>::max_digits10);

        os << "soil";
        for (const source& s : sources)
        {
            os << ',' << s.column;
        }
        for (std::size_t i = 0; i < run.nPoints(); ++i)
        {
            os << '\n' << soils[std::size_t(fields["zone"][i])].name;
            for (const source& s : sources)
            {
                const std::size_t n = mpm::Run::nComponents(s.field);
                os << ',' << fields[s.field][n*i + s.component];
            }
        }
        os << '\n';

        if (!os.flush())
        {
            FatalErrorInFunction
                << "Can't write the file " << unfinished
                << exit(FatalError);
        }
    }

    replaceByComplete(unfinished, file);
}

// ************************************************************************* //
