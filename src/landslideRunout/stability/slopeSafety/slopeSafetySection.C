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
#include "cellValues.H"
#include "fieldToPointMapping.H"
#include "fvMesh.H"
#include "groundSection.H"
#include "IOdictionary.H"
#include "pondedDepth.H"
#include "rasterProfile.H"
#include "readChecked.H"
#include "slopeSection.H"
#include "soilMechanics.H"
#include "soilZones.H"
#include "Time.H"
#include "wordRes.H"

// * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * * //

namespace Foam
{

// A line in the form of the library without OpenFOAM
static slopeStability::polyline toPolyline
(
    const UList<vector2D>& line,
    const char* name
)
{
    std::vector<slopeStability::point> points;
    for (const vector2D& p : line)
    {
        points.emplace_back(p.x(), p.y());
    }

    return slopeStability::polyline(std::move(points), name);
}


// The soil of nodes that may not slide: that of the node above, else of the
// next column, so that interpolation reaches the boundary between them
static void fill
(
    std::vector<slopeStability::soilState>& states,
    const UList<label>& soil,
    const label nLevels
)
{
    const label nColumns = soil.size()/nLevels;
    boolList known(nColumns, false);

    for (label i = 0; i < nColumns; ++i)
    {
        for (label j = nLevels - 1; j >= 0; --j)
        {
            const label k = i*nLevels + j;
            if (soil[k] >= 0)
            {
                known[i] = true;
            }
            else if (known[i])
            {
                states[k] = states[k + 1];
            }
        }

        // From the highest soil upward
        for (label j = 1; j < nLevels; ++j)
        {
            const label k = i*nLevels + j;
            if (known[i] && states[k].unitWeight <= 0)
            {
                states[k] = states[k - 1];
            }
        }
    }

    const auto copyColumn = [&](const label to, const label from)
    {
        if (!known[to] && known[from])
        {
            std::copy_n
            (
                states.begin() + from*nLevels,
                nLevels,
                states.begin() + to*nLevels
            );
            known[to] = true;
        }
    };
    for (label i = 1; i < nColumns; ++i)
    {
        copyColumn(i, i - 1);
    }
    for (label i = nColumns - 2; i >= 0; --i)
    {
        copyColumn(i, i + 1);
    }
}


// The line above which soil that may slide reaches up to the ground, half way
// between nodes
static slopeStability::polyline firmBase
(
    const std::vector<slopeStability::point>& nodes,
    const UList<label>& soil,
    const label nLevels
)
{
    std::vector<slopeStability::point> line;

    for (label start = 0; start < soil.size(); start += nLevels)
    {
        label j = nLevels;
        while (j > 0 && soil[start + j - 1] >= 0)
        {
            --j;
        }

        const slopeStability::point& upper = nodes[start + min(j, nLevels - 1)];
        const slopeStability::point& lower = nodes[start + max(j - 1, 0)];
        line.push_back(0.5*(upper + lower));
    }

    return slopeStability::polyline(std::move(line), "base");
}


// Depth of the standing water: that of the ground's faces in their middle
static slopeStability::polyline pondLine(const groundSection& outline)
{
    const List<vector2D>& pond = outline.pond();

    std::vector<slopeStability::point> line;
    line.emplace_back(outline.ground().first().x(), max(0, pond.first().y()));
    for (const vector2D& p : pond)
    {
        line.emplace_back(p.x(), max(0, p.y()));
    }
    line.emplace_back(outline.ground().last().x(), max(0, pond.last().y()));

    return slopeStability::polyline(std::move(line), "pond");
}


// Density of water [kg/m3]
static scalar readRhoWater(const dictionary& soilProperties)
{
    return readCheckedOrDefault
    (
        soilProperties,
        "rhoWater",
        1000,
        [](const scalar rho){ return rho > 0; },
        "> 0 kg/m3"
    );
}

} // End namespace Foam


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::labelHashSet Foam::slopeSafety::groundPatches() const
{
    wordRe name("ground");

    IOobject io
    (
        "overlandProperties",
        mesh_.time().constant(),
        mesh_.time(),
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    if (dict_.found("groundPatch"))
    {
        name = dict_.get<wordRe>("groundPatch");
    }
    else if (io.typeHeaderOk<IOdictionary>(true))
    {
        IOdictionary(io).readIfPresent("groundPatch", name);
    }

    const labelHashSet patches
    (
        mesh_.boundaryMesh().patchSet(wordRes(one(), name), false)
    );

    if (patches.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "groundPatch " << name << " is no patch of the mesh."
            << " Valid names: " << flatOutput(mesh_.boundaryMesh().names())
            << exit(FatalIOError);
    }

    return patches;
}


Foam::PtrList<Foam::soilMechanics> Foam::slopeSafety::soils
(
    const soilZones& zones
) const
{
    PtrList<soilMechanics> result(zones.size());

    forAll(result, soili)
    {
        const dictionary& soilDict = zones.soilDict(soili);

        if (soilMechanics::given(soilDict))
        {
            result.set(soili, new soilMechanics(zones.names()[soili], soilDict));
        }
    }

    return result;
}


Foam::boolList Foam::slopeSafety::mobile
(
    const soilZones& zones,
    const PtrList<soilMechanics>& soils
) const
{
    boolList result(zones.size(), false);
    wordList names;

    forAll(soils, soili)
    {
        if (soils.set(soili))
        {
            result[soili] = true;
            names.append(zones.names()[soili]);
        }
    }

    if (dict_.found("zones"))
    {
        result = false;

        for (const word& zone : dict_.get<wordList>("zones"))
        {
            if (!names.found(zone))
            {
                FatalIOErrorInFunction(dict_)
                    << "zones: " << zone << " is no soil with an entry"
                    << " mechanical. Valid names: " << flatOutput(names)
                    << exit(FatalIOError);
            }
            result[zones.names().find(zone)] = true;
        }
    }

    if (!result.found(true))
    {
        FatalIOErrorInFunction(dict_)
            << "No soil that may slide: none has an entry mechanical. Soils: "
            << flatOutput(zones.names())
            << exit(FatalIOError);
    }

    return result;
}


const Foam::fieldToPointMapping& Foam::slopeSafety::mapping
(
    const pointField& places,
    const labelList& cellSoil
)
{
    const bool changed =
        !mapping_
     || mesh_.changing()
     || places != places_
     || cellSoil != cellSoil_;

    if (returnReduce(changed, orOp<bool>()))
    {
        places_ = places;
        cellSoil_ = cellSoil;

        // Ends and rounding put nodes a little outside of the mesh
        mapping_.reset
        (
            new fieldToPointMapping
            (
                mesh_,
                places_,
                outsidePolicy(outsidePolicy::NEAREST),
                cellSoil_
            )
        );
    }

    return *mapping_;
}


std::vector<slopeStability::soilState> Foam::slopeSafety::sample
(
    const soilZones& zones,
    const UList<vector2D>& nodes,
    labelList& soil
)
{
    pointField places(nodes.size());
    forAll(places, i)
    {
        places[i] = section_->toSpace(nodes[i]);
    }

    const PtrList<soilMechanics> soilProperties(soils(zones));
    const boolList mayMove(mobile(zones, soilProperties));

    const fieldToPointMapping& toPlaces = mapping(places, zones.cellSoil());
    const scalarField psi
    (
        toPlaces.map<scalar>
        (
            cellValues(mesh_, dict_.getOrDefault<word>("psi", "psi"))
        )
    );
    const scalarField theta
    (
        toPlaces.map<scalar>
        (
            cellValues(mesh_, dict_.getOrDefault<word>("theta", "theta"))
        )
    );
    soil = toPlaces.mapCellLabels(zones.cellSoil(), -1);

    const scalar rhoWater = readRhoWater(zones.soilDict(0).topDict());
    const scalar gammaWater = rhoWater*mag(g_);

    std::vector<slopeStability::soilState> states
    (
        nodes.size(),
        slopeStability::soilState{0, 0, 0}
    );
    forAll(soil, i)
    {
        if (soil[i] < 0 || !mayMove[soil[i]])
        {
            soil[i] = -1;
            continue;
        }

        const soilMechanics& mechanics = soilProperties[soil[i]];
        const scalar water = mechanics.limited(theta[i]);

        states[i].unitWeight = mag(g_)*mechanics.bulkDensity(water, rhoWater);
        states[i].cohesionIntercept = mechanics.cohesionIntercept
        (
            mechanics.porePressure(water, gammaWater*psi[i])
        );
        states[i].tanPhi = mechanics.tanPhi();
    }

    return states;
}


std::shared_ptr<slopeStability::slopeSection>
Foam::slopeSafety::makeSection()
{
    using namespace slopeStability;

    const groundSection outline
    (
        mesh_,
        *section_,
        groundPatches(),
        pondedDepth(mesh_, dict_.getOrDefault<word>("h", "h"))
    );
    const polyline ground(toPolyline(outline.ground(), "ground"));
    const polyline base(toPolyline(outline.base(), "base"));

    checkLimits(ground.xMin(), ground.xMax());

    // The columns, each with a height where the ground runs into the base, too
    const scalar length = ground.xMax() - ground.xMin();
    const scalar thinnest = 1e-6*length;
    const dictionary& sampling = dict_.subOrEmptyDict("sampling");
    const scalar spacing = readCheckedOrDefault
    (
        sampling,
        "spacing",
        length/200,
        [](const scalar x){ return x > 0; },
        "> 0 m"
    );
    const label nLevels = readCheckedOrDefault
    (
        sampling,
        "nLevels",
        81,
        [](const scalar n){ return n >= 2 && n == label(n); },
        "a whole number >= 2"
    );

    const std::vector<double> x(rasterProfile::columns(ground, base, spacing));
    const polyline top(rasterProfile::resampled(ground, x));
    std::vector<slopeStability::point> bottomPoints
    (
        rasterProfile::resampled(base, x).points()
    );
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        double& y = bottomPoints[i].y();
        y = min(y, top.points()[i].y() - thinnest);
    }
    const polyline bottom(std::move(bottomPoints), "base");

    // The soil at their nodes
    const std::vector<slopeStability::point> nodes
    (
        rasterProfile::nodes(top, bottom, nLevels)
    );
    const word soilName
    (
        dict_.getOrDefault<word>("soilProperties", "soilProperties")
    );
    const soilZones zones(mesh_, soilName);
    labelList soil;
    List<vector2D> places(nodes.size());
    forAll(places, i)
    {
        places[i] = vector2D(nodes[i].x(), nodes[i].y());
    }
    std::vector<soilState> states(sample(zones, places, soil));
    fill(states, soil, nLevels);

    const auto result = std::make_shared<slopeStability::slopeSection>
    (
        ground,
        soil.found(-1) ? firmBase(nodes, soil, nLevels) : base,
        std::make_shared<rasterProfile>(top, bottom, std::move(states))
    );

    result->setPond
    (
        pondLine(outline),
        readRhoWater(zones.soilDict(0).topDict())*mag(g_)
    );

    return result;
}

// ************************************************************************* //
