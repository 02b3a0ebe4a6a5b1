/*---------------------------------------------------------------------------*\
  slideFoam | from rain to runout
  Copyright (C) 2026 the slideFoam authors
-------------------------------------------------------------------------------
License
    This file is part of slideFoam.

    slideFoam is free software: you can redistribute it and/or modify it
    under the terms of the GNU General Public License as published by
    the Free Software Foundation, either version 3 of the License, or
    (at your option) any later version.

    slideFoam is distributed in the hope that it will be useful, but WITHOUT
    ANY WARRANTY; without even the implied warranty of MERCHANTABILITY or
    FITNESS FOR A PARTICULAR PURPOSE.  See the GNU General Public License
    for more details.

    You should have received a copy of the GNU General Public License
    along with slideFoam.  If not, see <http://www.gnu.org/licenses/>.

\*---------------------------------------------------------------------------*/

#include "slidePoints.H"
#include "fieldToPointMapping.H"
#include "meshPointLocator.H"
#include "mpmChecked.H"
#include "pointTable.H"
#include "readChecked.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::slidePoints::readPerEdge
(
    const dictionary& dict,
    const label dimension
)
{
    // More than four points a direction are a waste: cells should be smaller
    const label maxPerEdge = 4;

    const label perCell = dict.get<label>("perCell");

    DynamicList<label> valid;
    for (label n = 1; n <= maxPerEdge; ++n)
    {
        valid.append(dimension == 2 ? n*n : n*n*n);

        if (valid.last() == perCell)
        {
            return n;
        }
    }

    FatalIOErrorInFunction(dict)
        << "perCell " << perCell << " is not one of: " << flatOutput(valid)
        << exit(FatalIOError);

    return 0;
}


Foam::Pair<Foam::vector> Foam::slidePoints::limits(const fvMesh& mesh) const
{
    Pair<vector> corners(frame_.limits(mesh.bounds()));

    const FixedList<word, 3> keys({"xLimits", "yLimits", "zLimits"});

    for (direction cmpt = 0; cmpt < frame_.dimension(); ++cmpt)
    {
        if (dict_.found(keys[cmpt]))
        {
            const auto given(dict_.get<Pair<scalar>>(keys[cmpt]));

            if (given.first() >= given.second())
            {
                FatalIOErrorInFunction(dict_)
                    << keys[cmpt] << ' ' << given
                    << ": the first limit must be below the second"
                    << exit(FatalIOError);
            }

            corners.first()[cmpt] = given.first();
            corners.second()[cmpt] = given.second();
        }
    }

    return corners;
}


Foam::pointField Foam::slidePoints::lattice(const Pair<vector>& corners) const
{
    // Point i is at (i + 0.5)*spacing, so cells begin at multiples of cellSize
    const scalar h = spacing();
    Vector<label> first(Zero);
    Vector<label> last(Zero);

    for (direction cmpt = 0; cmpt < frame_.dimension(); ++cmpt)
    {
        first[cmpt] = std::ceil(corners.first()[cmpt]/h - 0.5);
        last[cmpt] = std::floor(corners.second()[cmpt]/h - 0.5);
    }

    // A section has no third direction
    const scalar z = (frame_.dimension() == 3 ? h : 0);

    DynamicList<point> points;

    for (label k = first.z(); k <= last.z(); ++k)
    {
        for (label j = first.y(); j <= last.y(); ++j)
        {
            for (label i = first.x(); i <= last.x(); ++i)
            {
                points.append(point((i + 0.5)*h, (j + 0.5)*h, (k + 0.5)*z));
            }
        }
    }

    return pointField(std::move(points));
}


Foam::boolList Foam::slidePoints::participating() const
{
    boolList result(soils_.size(), false);
    wordList names(soils_.size());

    forAll(soils_, soili)
    {
        if (soils_.set(soili))
        {
            names[soili] = soils_[soili].name();
            result[soili] = true;
        }
    }

    if (!dict_.found("zones"))
    {
        return result;
    }

    result = false;
    const wordList zones(dict_.get<wordList>("zones"));

    for (const word& zone : zones)
    {
        const label soili = names.find(zone);

        if (soili == -1)
        {
            FatalIOErrorInFunction(dict_)
                << "zones: " << zone << " is no soil with a mechanical entry."
                << " Valid names: " << flatOutput(names)
                << exit(FatalIOError);
        }

        result[soili] = true;
    }

    return result;
}


void Foam::slidePoints::setSize(const label n)
{
    position_.setSize(n, Zero);
    volume_.setSize(n, pow(spacing(), frame_.dimension()));
    soil_.setSize(n, Zero);
    theta_.setSize(n, Zero);
    rho_.setSize(n, Zero);
    porePressure_.setSize(n, Zero);
    cohesionIntercept_.setSize(n, Zero);
    frictionAngle_.setSize(n, Zero);
}


void Foam::slidePoints::setStrength(const label pointi)
{
    const soilMechanics& soil = soils_[soil_[pointi]];

    cohesionIntercept_[pointi] = soil.cohesionIntercept(porePressure_[pointi]);
    frictionAngle_[pointi] = soil.frictionAngle();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slidePoints::slidePoints
(
    const dictionary& dict,
    const slideFrame& frame,
    const PtrList<soilMechanics>& soils
)
:
    dict_(dict),
    frame_(frame),
    soils_(soils),
    cellSize_
    (
        readChecked
        (
            dict,
            "cellSize",
            [](const scalar x){ return x > 0; },
            "> 0 m"
        )
    ),
    perEdge_(readPerEdge(dict, frame.dimension()))
{
    checkKeys
    (
        dict,
        {
            "cellSize", "perCell", "zones", "xLimits", "yLimits", "zLimits",
            "file"
        }
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::slidePoints::fromFile() const
{
    return dict_.found("file");
}


Foam::scalar Foam::slidePoints::relief() const
{
    // Top of each column of the lattice
    const scalar h = spacing();
    const direction up = frame_.vertical();
    const direction side = (frame_.dimension() == 2 ? vector::Z : vector::Y);

    HashTable<scalar, labelPair, labelPair::Hash<>> tops;

    for (const point& p : position_)
    {
        const labelPair column
        (
            std::floor(p.x()/h),
            frame_.dimension() == 2 ? 0 : label(std::floor(p[side]/h))
        );

        scalar& top = tops(column, -GREAT);
        top = max(top, p[up]);
    }

    scalar lowest = GREAT;
    scalar highest = -GREAT;

    forAllConstIters(tops, it)
    {
        lowest = min(lowest, it.val());
        highest = max(highest, it.val());
    }

    if (highest - lowest > h)
    {
        return highest - lowest;
    }

    // Level ground: the height of the body
    lowest = GREAT;
    for (const point& p : position_)
    {
        lowest = min(lowest, p[up]);
    }

    return highest - lowest + h;
}


void Foam::slidePoints::seed(const fvMesh& mesh, const labelUList& cellSoil)
{
    const boolList takesPart(participating());
    const pointField candidates(lattice(limits(mesh)));
    const meshPointLocator locator(mesh, frame_.toSpace(candidates)());

    labelList soils(candidates.size(), -1);

    forAll(soils, i)
    {
        const label celli = locator.cells()[i];

        if (celli != -1 && takesPart[cellSoil[celli]])
        {
            soils[i] = cellSoil[celli];
        }
    }

    Pstream::listCombineGather(soils, maxEqOp<label>());
    Pstream::listCombineScatter(soils);

    label n = 0;
    for (const label soili : soils)
    {
        n += (soili >= 0);
    }
    setSize(n);

    if (!size())
    {
        FatalIOErrorInFunction(dict_)
            << "No cell of a soil that takes part is at a point of the lattice"
            << " with spacing " << spacing() << " m" << nl
            << "    in the " << meshPointLocator::boundsMessage(mesh).c_str()
            << ". Look at section, limits, cellSize and zones"
            << exit(FatalIOError);
    }

    n = 0;
    forAll(soils, i)
    {
        if (soils[i] >= 0)
        {
            position_[n] = candidates[i];
            soil_[n] = soils[i];
            ++n;
        }
    }
}


void Foam::slidePoints::setWater
(
    const fvMesh& mesh,
    const labelUList& cellSoil,
    const UList<scalar>& psi,
    const UList<scalar>& theta,
    const scalar rhoWater
)
{
    const pointField places(frame_.toSpace(position_));

    // Points of a file need not lie in the mesh; seeded ones do
    const fieldToPointMapping mapping
    (
        mesh,
        places,
        outsidePolicy(outsidePolicy::ERROR),
        cellSoil
    );

    const scalarField psiPoints(mapping.map<scalar>(psi));
    theta_ = mapping.map<scalar>(theta);

    const scalar gammaWater = rhoWater*mag(frame_.gravity());

    forAll(position_, i)
    {
        const soilMechanics& soil = soils_[soil_[i]];

        // A straight line through cell values may leave the soil's limits
        // where the curve bends
        theta_[i] = soil.limited(theta_[i]);
        rho_[i] = soil.bulkDensity(theta_[i], rhoWater);
        porePressure_[i] =
            soil.porePressure(theta_[i], gammaWater*psiPoints[i]);
        setStrength(i);
    }
}


mpm::PointData Foam::slidePoints::data() const
{
    // The engine counts the soils that take part only
    labelList materialOf(soils_.size(), -1);
    label nMaterials = 0;
    forAll(soils_, soili)
    {
        if (soils_.set(soili))
        {
            materialOf[soili] = nMaterials++;
        }
    }

    mpm::PointData points;

    forAll(position_, i)
    {
        points.position.push_back(toMpm(position_[i]));
        points.volume.push_back(volume_[i]);
        points.rho.push_back(rho_[i]);
        points.zone.push_back(materialOf[soil_[i]]);
        points.cohesionIntercept.push_back(cohesionIntercept_[i]);
        points.frictionAngle.push_back(frictionAngle_[i]);
        points.porePressure.push_back(porePressure_[i]);
    }

    return points;
}


std::vector<mpm::Material> Foam::slidePoints::materials() const
{
    std::vector<mpm::Material> result;

    forAll(soils_, soili)
    {
        if (soils_.set(soili))
        {
            result.push_back(soils_[soili].material());
        }
    }

    return result;
}


void Foam::slidePoints::strengthOf
(
    const dictionary& soilsDict,
    std::vector<double>& cohesionIntercept,
    std::vector<double>& frictionAngle
) const
{
    wordList names;
    PtrList<soilMechanics> others(soils_.size());

    forAll(soils_, soili)
    {
        if (!soils_.set(soili))
        {
            continue;
        }

        const soilMechanics& soil = soils_[soili];

        names.append(soil.name());

        if (const dictionary* dictPtr = soilsDict.findDict(soil.name()))
        {
            others.set(soili, new soilMechanics(soil, *dictPtr));
        }
    }
    checkKeys(soilsDict, names);

    cohesionIntercept.assign
    (
        cohesionIntercept_.begin(),
        cohesionIntercept_.end()
    );
    frictionAngle.assign(frictionAngle_.begin(), frictionAngle_.end());

    forAll(position_, i)
    {
        if (others.set(soil_[i]))
        {
            const soilMechanics& other = others[soil_[i]];

            cohesionIntercept[i] = other.cohesionIntercept(porePressure_[i]);
            frictionAngle[i] = other.frictionAngle();
        }
    }
}


Foam::pointTable Foam::slidePoints::table() const
{
    pointTable table(frame_.toSpace(position_)());

    table.add("zone", soil_);
    table.add("volume", volume_);
    table.add("theta", theta_);
    table.add("rho", rho_);
    table.add("porePressure", porePressure_);
    table.add("cohesionIntercept", cohesionIntercept_);
    table.add("frictionAngle", frictionAngle_);

    return table;
}

// ************************************************************************* //
