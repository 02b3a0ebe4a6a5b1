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

#include "landslideRunout.H"
#include "cellValues.H"
#include "factorOfSafetyTable.H"
#include "fvMesh.H"
#include "functionObject.H"
#include "mpmChecked.H"
#include "readChecked.H"
#include "slideWall.H"
#include "soilZones.H"
#include "OSspecific.H"
#include "SHA1.H"
#include "StringStream.H"
#include "Switch.H"
#include "Time.H"
#include "uniformDimensionedFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// The bytes of an array of numbers
template<class Type>
static void append(SHA1& sha, const std::vector<Type>& values)
{
    sha.append
    (
        reinterpret_cast<const char*>(values.data()),
        values.size()*sizeof(Type)
    );
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::landslideRunout::constantIO(const word& name) const
{
    return IOobject
    (
        name,
        time_.constant(),
        time_,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
}


Foam::word Foam::landslideRunout::constantName
(
    const dictionary& options,
    const word& key
)
{
    const fileName file(options.getOrDefault<fileName>(key, key));

    if (file.path() != "." && file.path() != "constant")
    {
        FatalIOErrorInFunction(options)
            << key << ' ' << file << " is not a file in constant: its path is "
            << file.path()
            << exit(FatalIOError);
    }

    return file.name();
}


Foam::IOdictionary Foam::landslideRunout::readProperties
(
    const Time& time,
    const dictionary& options
)
{
    const IOdictionary dict
    (
        readDictionary
        (
            IOobject
            (
                constantName(options, "mpmProperties"),
                time.constant(),
                time,
                IOobject::MUST_READ,
                IOobject::NO_WRITE,
                false
            )
        )
    );

    const wordList dictionaries
    ({
        "section", "points", "numerics", "initialState", "walls", "slide",
        "verdict"
    });

    // Other values may be variables that entries refer to
    wordList values({"dimension"});
    for (const entry& e : dict)
    {
        if (!e.isDict() && !dictionaries.found(e.keyword()))
        {
            values.append(e.keyword());
        }
    }

    checkKeys(dict, values, dictionaries);

    return dict;
}


Foam::vector Foam::landslideRunout::readGravity() const
{
    return uniformDimensionedVectorField(constantIO("g")).value();
}


void Foam::landslideRunout::readSoils()
{
    const IOdictionary dict(readDictionary(constantIO(soilPropertiesName_)));
    const dictionary& soilsDict = dict.subDict("soils");

    const scalar defaultRhoWater = 1000;
    rhoWater_ = readCheckedOrDefault
    (
        dict,
        "rhoWater",
        defaultRhoWater,
        [](const scalar x){ return x > 0; },
        "> 0 kg/m3"
    );

    const wordList names(soilsDict.toc());
    bool any = false;

    soils_.setSize(names.size());

    forAll(names, soili)
    {
        const dictionary& soilDict = soilsDict.subDict(names[soili]);

        if (soilMechanics::given(soilDict))
        {
            soils_.set(soili, new soilMechanics(names[soili], soilDict));
            any = true;
        }
    }

    if (!any)
    {
        FatalIOErrorInFunction(soilsDict)
            << "No soil has an entry mechanical, so none can slide. Soils: "
            << flatOutput(names)
            << exit(FatalIOError);
    }
}


mpm::Settings Foam::landslideRunout::settings(const slidePoints& points) const
{
    const dictionary& dict = properties_.subOrEmptyDict("numerics");

    checkKeys
    (
        dict,
        {
            "symmetry", "shapeFunction", "transferScheme", "stressUpdate",
            "antiLocking", "flipTime", "flipBlend", "xpicOrder", "cfl",
            "maxDeltaT", "sortInterval", "threads", "maxImbalance",
            "massCutOff", "movedDistance", "restVelocity", "sleepVelocity",
            "sleepDelay", "frontDirection", "energyAccount"
        }
    );

    mpm::Settings s;

    s.cellSize = points.cellSize();
    s.gravity = toMpm(frame_.gravity());

    for
    (
        const auto& choice :
        {
            std::make_pair("symmetry", &s.symmetry),
            std::make_pair("shapeFunction", &s.shapeFunction),
            std::make_pair("transferScheme", &s.transferScheme),
            std::make_pair("stressUpdate", &s.stressUpdate),
            std::make_pair("antiLocking", &s.antiLocking)
        }
    )
    {
        word name(*choice.second);
        dict.readIfPresent(choice.first, name);
        *choice.second = name;
    }

    dict.readIfPresent("flipTime", s.flipTime);
    dict.readIfPresent("flipBlend", s.flipBlend);
    dict.readIfPresent("xpicOrder", s.xpicOrder);
    dict.readIfPresent("cfl", s.cfl);
    dict.readIfPresent("maxDeltaT", s.maxDeltaT);
    dict.readIfPresent("sortInterval", s.sortInterval);
    dict.readIfPresent("threads", s.threads);
    dict.readIfPresent("maxImbalance", s.maxImbalance);
    dict.readIfPresent("massCutOff", s.massCutOff);
    dict.readIfPresent("movedDistance", s.movedDistance);
    dict.readIfPresent("restVelocity", s.restVelocity);
    s.energyAccount = dict.getOrDefault<Switch>("energyAccount", false);
    dict.readIfPresent("sleepVelocity", s.sleepVelocity);
    dict.readIfPresent("sleepDelay", s.sleepDelay);

    if (dict.found("frontDirection"))
    {
        s.frontDirection = toMpm(frame_.readPoint(dict, "frontDirection"));
    }

    mpmChecked
    (
        dict,
        "checking numerics",
        [&]()
        {
            s.validate(frame_.dimension());
        }
    );

    if
    (
        s.shapeFunction == "linear"
     && (
            s.transferScheme == "APIC"
         || s.transferScheme == "TPIC"
         || s.transferScheme == "AFLIP"
        )
    )
    {
        IOWarningInFunction(dict)
            << "shapeFunction linear with transferScheme "
            << s.transferScheme.c_str() << ": the velocity gradient that the"
            << " points carry has no bound where a node is nearly empty, and"
            << " breaks slides whose points cross cells" << endl;
    }

    return s;
}


mpm::StartSettings Foam::landslideRunout::startSettings
(
    const slidePoints& points
) const
{
    const dictionary& dict = properties_.subOrEmptyDict("initialState");

    checkKeys
    (
        dict,
        {
            "type", "K0", "elasticTime", "relaxationTime", "restVelocity",
            "addedCohesion"
        },
        {"stableStrength"}
    );

    mpm::StartSettings s;

    s.type = dict.getOrDefault<word>("type", s.type);
    dict.readIfPresent("K0", s.K0);
    dict.readIfPresent("elasticTime", s.elasticTime);
    dict.readIfPresent("relaxationTime", s.relaxationTime);
    dict.readIfPresent("restVelocity", s.restVelocity);
    dict.readIfPresent("addedCohesion", s.addedCohesion);

    if (const dictionary* stablePtr = dict.findDict("stableStrength"))
    {
        points.strengthOf
        (
            *stablePtr,
            s.stableCohesionIntercept,
            s.stableFrictionAngle
        );
    }

    mpmChecked
    (
        dict,
        "checking initialState",
        [&]()
        {
            s.validate(points.size());
        }
    );

    return s;
}


std::vector<mpm::WallSettings> Foam::landslideRunout::walls
(
    const slidePoints& points
) const
{
    const dictionary& dict = properties_.subDict("walls");
    std::vector<mpm::WallSettings> result;

    checkKeys(dict, wordList(), dict.toc());

    for (const word& name : dict.toc())
    {
        const dictionary& wallDict = dict.subDict(name);
        const std::size_t first = result.size();

        slideWall::New(name, wallDict)->append(result, points, meshPtr_);

        mpmChecked
        (
            wallDict,
            "checking walls",
            [&]()
            {
                for (std::size_t i = first; i < result.size(); ++i)
                {
                    result[i].validate(frame_.dimension());
                }
            }
        );
    }

    return result;
}


Foam::word Foam::landslideRunout::digest
(
    const mpm::PointData& points,
    const std::vector<mpm::WallSettings>& walls
) const
{
    // How long a slide is followed and how it is judged may change, and the
    // numbers of threads and ranks do not matter
    dictionary relevant(properties_);
    relevant.remove("slide");
    relevant.remove("verdict");
    relevant.subDictOrAdd("numerics").remove("threads");
    relevant.subDict("numerics").remove("maxImbalance");

    OStringStream os;
    os.precision(std::numeric_limits<scalar>::max_digits10);
    relevant.write(os, false);

    forAll(soils_, soili)
    {
        if (soils_.set(soili))
        {
            const mpm::Material& m = soils_[soili].material();

            os  << m.constitutiveModel << ' ' << m.E << ' ' << m.nu << ' '
                << m.dilationAngle << ' ' << m.tensionCutOff << ' '
                << m.tensileStrength << nl;
        }
    }

    SHA1 sha;
    sha.append(os.str());

    append(sha, points.position);
    append(sha, points.volume);
    append(sha, points.rho);
    append(sha, points.zone);
    append(sha, points.cohesionIntercept);
    append(sha, points.frictionAngle);
    append(sha, points.porePressure);
    append(sha, points.velocity);
    append(sha, points.sigma);
    append(sha, points.equivalentPlasticStrain);

    for (const mpm::WallSettings& wall : walls)
    {
        append(sha, wall.vertices);
        append(sha, wall.triangles);
    }

    // A word must not begin with a digit
    return "sha1_" + sha.digest().str();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::landslideRunout::needsNoMesh
(
    const Time& time,
    const dictionary& options
)
{
    return readProperties(time, options).subDict("points").found("file");
}


std::optional<Foam::scalar>
Foam::landslideRunout::writtenFactorOfSafety() const
{
    // Of an hour, the first method's
    std::optional<scalar> result;

    if (Pstream::master() || !Pstream::parRun())
    {
        const fileName folder
        (
            time_.globalPath()/functionObject::outputPrefix/stabilityName_
        );

        for (const fileName& start : readDir(folder, fileName::DIRECTORY))
        {
            const auto found =
                factorOfSafetyTable::firstValue
                (
                    folder/start/"factorOfSafety.dat",
                    time_.value()
                );

            if (found)
            {
                result = found;
            }
        }
    }

    scalar value = result.value_or(-1);
    Pstream::scatter(value);

    return value > 0 ? std::optional<scalar>(value) : std::nullopt;
}


Foam::slidePoints Foam::landslideRunout::points() const
{
    slidePoints result(properties_.subDict("points"), frame_, soils_);

    if (result.fromFile())
    {
        result.read(time_.globalPath(), rhoWater_);
        return result;
    }

    const soilZones zones(*meshPtr_, soilPropertiesName_);

    result.seed(*meshPtr_, zones.cellSoil());
    result.setWater
    (
        *meshPtr_,
        zones.cellSoil(),
        cellValues(*meshPtr_, psiName_),
        cellValues(*meshPtr_, thetaName_),
        rhoWater_
    );

    return result;
}

// ************************************************************************* //
