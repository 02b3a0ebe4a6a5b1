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

#include "soilMechanics.H"
#include "localShearStrength.H"
#include "mpmChecked.H"
#include "readChecked.H"
#include "soilVariation.H"
#include "unitConversion.H"
#include "waterRetentionModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::string Foam::soilMechanics::frictionAngleRange
(
    "0 < frictionAngle < 90 deg"
);


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static bool positive(const scalar x)
{
    return x > 0;
}


static bool notNegative(const scalar x)
{
    return x >= 0;
}


static bool acute(const scalar degrees)
{
    return degrees > 0 && degrees < 90;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::soilMechanics::readSoftening(const dictionary& dict)
{
    checkKeys
    (
        dict,
        {
            "residualCohesion", "residualFrictionAngle",
            "residualDilationAngle", "peakStrain", "residualStrain", "length",
            "regularisation"
        }
    );

    mpm::SofteningSettings& softening = material_.softening;
    softening.residualCohesion = readChecked
    (
        dict,
        "residualCohesion",
        [this](const scalar x){ return x >= 0 && x <= cohesion_; },
        "0 to cohesion Pa"
    );
    softening.residualFrictionAngle = readChecked
    (
        dict,
        "residualFrictionAngle",
        [this](const scalar x){ return x > 0 && x <= frictionAngle_; },
        "0 < residualFrictionAngle <= frictionAngle deg"
    );
    softening.residualDilationAngle = readCheckedOrDefault
    (
        dict,
        "residualDilationAngle",
        0,
        [this](const scalar x)
        {
            return
                x >= 0
             && x <= material_.dilationAngle
             && x <= material_.softening.residualFrictionAngle;
        },
        "0 to dilationAngle and residualFrictionAngle deg"
    );
    softening.peakStrain =
        readCheckedOrDefault(dict, "peakStrain", 0, notNegative, ">= 0");
    softening.residualStrain = readChecked
    (
        dict,
        "residualStrain",
        [&softening](const scalar x){ return x > softening.peakStrain; },
        "> peakStrain"
    );
    softening.length = readChecked(dict, "length", positive, "> 0 m");
    softening.regularisation = dict.getOrDefault<word>
    (
        "regularisation",
        softening.regularisation
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::soilMechanics::soilMechanics
(
    const word& name,
    const dictionary& soilDict
)
:
    name_(name),
    rhoDry_(0),
    cohesion_(0),
    frictionAngle_(0),
    material_(),
    softening_(),
    thetaS_(-1),
    thetaR_(-1)
{
    const dictionary& dict = soilDict.subDict("mechanical");

    checkKeys
    (
        dict,
        {
            "rhoDry", "cohesion", "frictionAngle", "dilationAngle", "E", "nu",
            "constitutiveModel", "druckerPragerFit", "tensileStrength",
            "viscosity"
        },
        {"softening"}
    );

    rhoDry_ = readChecked(dict, "rhoDry", positive, "> 0 kg/m3");
    cohesion_ = readChecked(dict, "cohesion", notNegative, ">= 0 Pa");
    frictionAngle_ =
        readChecked(dict, "frictionAngle", acute, frictionAngleRange);

    material_.name = name;
    material_.E = readChecked(dict, "E", positive, "> 0 Pa");
    material_.nu = readChecked
    (
        dict,
        "nu",
        [](const scalar x){ return x >= 0 && x < 0.5; },
        "0 <= nu < 0.5"
    );
    warnUnlessUsual
    (
        dict, "rhoDry", rhoDry_, {100, 5000}, "100 to 5000 kg/m3"
    );
    warnUnlessUsual(dict, "E", material_.E, {1e4, 1e12}, "1e4 to 1e12 Pa");
    if (cohesion_ > 0)
    {
        warnUnlessUsual
        (
            dict, "cohesion", cohesion_, {50, 1e8}, "none or 50 to 1e8 Pa"
        );
    }

    material_.dilationAngle = readCheckedOrDefault
    (
        dict,
        "dilationAngle",
        0,
        [this](const scalar x){ return x >= 0 && x <= frictionAngle_; },
        "0 to frictionAngle deg"
    );
    material_.constitutiveModel =
        dict.getOrDefault<word>
        (
            "constitutiveModel",
            material_.constitutiveModel
        );

    material_.druckerPragerFit =
        dict.getOrDefault<word>
        (
            "druckerPragerFit",
            material_.druckerPragerFit
        );

    if (dict.found("tensileStrength"))
    {
        material_.tensionCutOff = true;
        material_.tensileStrength =
            readChecked(dict, "tensileStrength", notNegative, ">= 0 Pa");
    }
    material_.viscosity =
        readCheckedOrDefault(dict, "viscosity", 0, notNegative, ">= 0 Pa s");
    if (const dictionary* softeningPtr = dict.findDict("softening"))
    {
        readSoftening(*softeningPtr);
        softening_ = *softeningPtr;
    }

    mpmChecked
    (
        dict,
        "reading the soil " + name,
        [this](){ material_.validate(); }
    );

    if (const dictionary* hydraulicPtr = soilDict.findDict("hydraulic"))
    {
        for (const word& field : soilVariation::fieldNames(*hydraulicPtr))
        {
            if (field != "Ks")
            {
                FatalIOErrorInFunction(*hydraulicPtr)
                    << "Entry 'fields' of " << hydraulicPtr->name()
                    << " holds " << field << ": the strength of a soil needs"
                    << " one thetaS and thetaR for all of it" << nl
                    << exit(FatalIOError);
            }
        }

        const autoPtr<waterRetentionModel> retention
        (
            waterRetentionModel::New(hydraulicPtr->subDict("retention"))
        );

        thetaS_ = retention->thetaS();
        thetaR_ = retention->thetaR();
    }
}


Foam::soilMechanics::soilMechanics
(
    const soilMechanics& soil,
    const dictionary& dict
)
:
    soilMechanics(soil)
{
    checkKeys(dict, {"cohesion", "frictionAngle"});

    cohesion_ = readCheckedOrDefault
    (
        dict,
        "cohesion",
        cohesion_,
        notNegative,
        ">= 0 Pa"
    );
    frictionAngle_ = readCheckedOrDefault
    (
        dict,
        "frictionAngle",
        frictionAngle_,
        acute,
        frictionAngleRange
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::soilMechanics::checkCellSize(const scalar cellSize) const
{
    mpmChecked
    (
        softening_,
        "reading the soil " + name_,
        [this, cellSize](){ material_.validate(cellSize); }
    );
}


Foam::scalar Foam::soilMechanics::tanPhi() const
{
    return std::tan(degToRad(frictionAngle_));
}


Foam::scalar Foam::soilMechanics::limited(const scalar theta) const
{
    return max(thetaR_, min(thetaS_, theta));
}


Foam::scalar Foam::soilMechanics::porePressure
(
    const scalar theta,
    const scalar uw
) const
{
    return localShearStrength::porePressure
    (
        localShearStrength::effectiveStressParameter(theta, thetaS_, thetaR_),
        uw
    );
}


Foam::scalar Foam::soilMechanics::cohesionIntercept
(
    const scalar porePressure
) const
{
    return localShearStrength::cohesionIntercept
    (
        cohesion_,
        porePressure,
        tanPhi()
    );
}


Foam::scalar Foam::soilMechanics::bulkDensity
(
    const scalar theta,
    const scalar rhoWater
) const
{
    return localShearStrength::bulkDensity(rhoDry_, theta, rhoWater);
}

// ************************************************************************* //
