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

#include "slopeSafety.H"
#include "criticalSurface.H"
#include "factorOfSafetyTable.H"
#include "fieldToPointMapping.H"
#include "functionObject.H"
#include "fvMesh.H"
#include "IOdictionary.H"
#include "mpmChecked.H"
#include "readChecked.H"
#include "soilMechanics.H"
#include "soilZones.H"
#include "Time.H"
#include "uniformDimensionedFields.H"

#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * Static Data Members  * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(slopeSafety, 0);
}


// * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * * //

namespace Foam
{

// Names of the columns after time, method and FOS, with their values
static std::vector<std::pair<const char*, scalar>> surfaceColumns
(
    const slopeStability::slipResult& r
)
{
    return
    {
        {"centreX", r.centre.x()},
        {"centreY", r.centre.y()},
        {"radius", r.radius},
        {"entryX", r.entry.x()},
        {"entryY", r.entry.y()},
        {"exitX", r.exit.x()},
        {"exitY", r.exit.y()},
        {"depth", r.depth},
        {"lambda", r.lambda},
        {"slices", scalar(r.nSlices)},
        {"evaluated", scalar(r.evaluated)}
    };
}


static std::string header()
{
    std::string line("time\tmethod\tFOS");
    for (const auto& column : surfaceColumns(slopeStability::slipResult()))
    {
        line += std::string("\t") + column.first;
    }

    return line;
}

} // End namespace Foam


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::slopeSafety::check() const
{
    // Wrong names are answered at once, not at the first output
    mpmChecked
    (
        dict_,
        "reading the settings of " + name_,
        [this]()
        {
            searchSettings().check();

            for (const word& method : methods())
            {
                slopeStability::stabilityMethod::New(method);
            }
        }
    );
}


Foam::wordList Foam::slopeSafety::methods() const
{
    const wordList names
    (
        dict_.getOrDefault<wordList>("methods", {"bishop", "spencer"})
    );

    if (names.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "methods () names none; at least one is needed"
            << exit(FatalIOError);
    }

    return names;
}


Foam::vector Foam::slopeSafety::readGravity(const Time& time)
{
    return uniformDimensionedVectorField
    (
        IOobject
        (
            "g",
            time.constant(),
            time,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    ).value();
}


Foam::autoPtr<Foam::mappingSection> Foam::slopeSafety::readSection() const
{
    if (dict_.found("section"))
    {
        return autoPtr<mappingSection>::New(dict_.subDict("section"), g_);
    }

    // A layer between empty patches has one horizontal axis
    const scalar horizontal = 1e-6;

    if (mesh_.nGeometricD() == 2)
    {
        for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
        {
            vector axis(Zero);
            axis[cmpt] = 1;

            if
            (
                mesh_.geometricD()[cmpt] == 1
             && mag(axis & g_) < horizontal*mag(g_)
            )
            {
                return autoPtr<mappingSection>::New(point(Zero), axis, g_);
            }
        }
    }

    FatalIOErrorInFunction(dict_)
        << "Entry section { origin; direction; } is required: the mesh is not"
        << " one layer between empty patches with a horizontal axis"
        << exit(FatalIOError);

    return nullptr;
}


void Foam::slopeSafety::readLimits
(
    const word& key,
    scalar& low,
    scalar& high
) const
{
    if (!dict_.found(key))
    {
        return;
    }

    const auto limits(dict_.get<vector2D>(key));

    if (limits.x() >= limits.y())
    {
        FatalIOErrorInFunction(dict_)
            << key << ' ' << limits
            << ": the first limit must be below the second"
            << exit(FatalIOError);
    }

    low = limits.x();
    high = limits.y();
}


void Foam::slopeSafety::checkLimits
(
    const scalar xMin,
    const scalar xMax
) const
{
    for (const word& key : {"entryLimits", "exitLimits"})
    {
        scalar low = xMin;
        scalar high = xMax;
        readLimits(key, low, high);

        if (low >= xMax || high <= xMin)
        {
            FatalIOErrorInFunction(dict_)
                << key << " (" << low << ' ' << high << ") lie outside of the"
                << " section, whose ground goes from x = " << xMin << " to "
                << xMax
                << exit(FatalIOError);
        }
    }
}


slopeStability::searchSettings Foam::slopeSafety::searchSettings() const
{
    slopeStability::searchSettings settings;

    settings.minDepth = readCheckedOrDefault
    (
        dict_,
        "minDepth",
        settings.minDepth,
        [](const scalar depth){ return depth >= 0; },
        ">= 0 m"
    );
    readLimits("entryLimits", settings.entryMin, settings.entryMax);
    readLimits("exitLimits", settings.exitMin, settings.exitMax);

    const dictionary& sampling = dict_.subOrEmptyDict("sampling");
    checkKeys(sampling, {"spacing", "nLevels", "nSlices"});
    sampling.readIfPresent("nSlices", settings.nSlices);

    return settings;
}


std::string Foam::slopeSafety::row
(
    const slopeStability::slipResult& result
) const
{
    // As in the tables of the slides
    const int nDigits = 12;

    std::ostringstream os;
    os  << std::setprecision(nDigits) << mesh_.time().value() << '\t'
        << result.method << '\t';

    if (result.found)
    {
        os << result.FOS;
    }
    for (const auto& column : surfaceColumns(result))
    {
        os << '\t';
        if (result.found)
        {
            os << column.second;
        }
    }

    return os.str();
}


void Foam::slopeSafety::report(const slopeStability::slipResult& result) const
{
    std::ostringstream os;
    os  << "    " << result.method << ": ";

    if (result.found)
    {
        // Rounding at a bend of the ground is no length
        const auto length = [](const scalar x)
        {
            return mag(x) < 1e-6 ? 0 : x;
        };

        os  << std::setprecision(5) << "FOS = " << result.FOS
            << ", from (" << length(result.entry.x()) << ' '
            << length(result.entry.y()) << ") to ("
            << length(result.exit.x()) << ' ' << length(result.exit.y())
            << "), depth = " << result.depth << ", radius = "
            << result.radius;

        if (result.entryAtLimit || result.exitAtLimit)
        {
            os  << " (" << (result.entryAtLimit ? "entry " : "")
                << (result.exitAtLimit ? "exit " : "")
                << "at the limit of the search)";
        }
    }
    else
    {
        os  << "no admissible slip surface";
        if (!result.evaluated)
        {
            os  << ": no circle of the minimum depth within the limits";
        }
        for (const auto& reason : result.refused)
        {
            os  << ", " << reason.first << ' ' << reason.second;
        }
    }

    Info<< os.str().c_str() << nl;
}


// * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * * //

Foam::slopeSafety::slopeSafety
(
    const word& name,
    const fvMesh& mesh,
    const dictionary& settings,
    const fileName& dictFile
)
:
    name_(name),
    mesh_(mesh),
    dict_(),
    g_(readGravity(mesh.time())),
    section_()
{
    IOobject io
    (
        word("slopeStabilityDict"),
        mesh.time().system(),
        mesh.time(),
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    if (!dictFile.empty())
    {
        io = IOobject
        (
            dictFile,
            mesh.time(),
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        );
    }

    if (!dictFile.empty() || io.typeHeaderOk<IOdictionary>(true))
    {
        dict_ = IOdictionary(io);
        checkKeys
        (
            dict_,
            {
                "methods", "minDepth", "entryLimits", "exitLimits", "zones",
                "groundPatch", "soilProperties", "psi", "theta", "h"
            },
            {"FoamFile", "section", "sampling"}
        );
        dict_.merge(settings);
    }
    else
    {
        dict_ = settings;
    }

    section_ = readSection();
    check();
}


Foam::slopeSafety::~slopeSafety()
{}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

std::optional<Foam::scalar> Foam::slopeSafety::execute
(
    const word& start
)
{
    const Time& time = mesh_.time();
    const std::shared_ptr<slopeStability::slopeSection> section(makeSection());

    Info<< typeName << ' ' << name_ << ": Time = " << time.timeName() << nl;

    scalar factorOfSafety = -1;

    if (Pstream::master())
    {
        std::vector<std::string> rows;

        for (const word& method : methods())
        {
            slopeStability::slipResult result;

            mpmChecked
            (
                dict_,
                "searching the slip surface of " + name_,
                [&]()
                {
                    result = slopeStability::criticalSurface
                    (
                        *section,
                        searchSettings()
                    ).find(*slopeStability::stabilityMethod::New(method));
                }
            );

            report(result);
            if (rows.empty() && result.found)
            {
                factorOfSafety = result.FOS;
            }
            rows.push_back(row(result));
        }

        factorOfSafetyTable table
        (
            time.globalPath()/functionObject::outputPrefix/name_/start
           /"factorOfSafety.dat",
            header()
        );
        table.set(time.value(), rows);
        table.write();
    }

    Info<< endl;
    Pstream::scatter(factorOfSafety);

    return
        factorOfSafety >= 0
      ? std::optional<scalar>(factorOfSafety)
      : std::nullopt;
}

// ************************************************************************* //
