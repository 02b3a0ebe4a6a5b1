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
#include "fieldToPointMapping.H"
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


void Foam::slidePoints::checkCellSize(const vector& place) const
{
    const scalar n = cmptMax(cmptMag(place))/spacing();

    if (n >= labelMax/2)
    {
        FatalIOErrorInFunction(dict_)
            << "cellSize " << cellSize_ << " m is too small: from the origin to"
            << " the points, as far as " << place << ", are " << n
            << " of their distances"
            << exit(FatalIOError);
    }
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
    dict_
    (
        checkKeys
        (
            dict,
            {
                "cellSize", "perCell", "zones", "xLimits", "yLimits",
                "zLimits", "file"
            }
        )
    ),
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
    forAll(soils_, soili)
    {
        if (soils_.set(soili))
        {
            soils_[soili].checkCellSize(cellSize_);
        }
    }
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

    for (const vector& v : velocity_)
    {
        points.velocity.push_back(toMpm(v));
    }
    for (const symmTensor& s : sigma_)
    {
        points.sigma.push_back
        ({{
            s.xx(), s.yy(), s.zz(), s.xy(), s.yz(), s.xz()
        }});
    }
    points.equivalentPlasticStrain.assign
    (
        plasticStrain_.begin(),
        plasticStrain_.end()
    );

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
    forAll(soils_, soili)
    {
        if (soils_.set(soili))
        {
            names.append(soils_[soili].name());
        }
    }
    checkKeys(soilsDict, wordList(), names);

    PtrList<soilMechanics> others(soils_.size());

    forAll(soils_, soili)
    {
        if (!soils_.set(soili))
        {
            continue;
        }

        const soilMechanics& soil = soils_[soili];

        if (const dictionary* dictPtr = soilsDict.findDict(soil.name()))
        {
            others.set(soili, new soilMechanics(soil, *dictPtr));
        }
    }

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
