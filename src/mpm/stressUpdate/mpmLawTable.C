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

#include "mpmLawTable.H"
#include "mpmNames.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

mpm::LawTable::Model modelOf(const mpm::Material& material)
{
    typedef mpm::LawTable::Model Model;

    return
        material.constitutiveModel == "linearElastic" ? Model::linearElastic
      : material.constitutiveModel == "neoHookean" ? Model::neoHookean
      : material.constitutiveModel == "DruckerPrager" ? Model::DruckerPrager
      : Model::MohrCoulomb;
}


mpm::DruckerPragerFit fitOf(const mpm::Material& material)
{
    typedef mpm::DruckerPragerFit Fit;

    return
        material.druckerPragerFit == "inner" ? Fit::inner
      : material.druckerPragerFit == "middle" ? Fit::middle
      : material.druckerPragerFit == "outer" ? Fit::outer
      : Fit::planeStrain;
}


mpm::Softening softeningOf
(
    const mpm::Material& material,
    const double frictionAngle,
    const double cellSize
)
{
    const mpm::SofteningSettings& settings = material.softening;
    const auto tangent = [](const double degrees)
    {
        return std::tan(std::acos(-1.0)/180*degrees);
    };

    // Plastic strains of a cell, or nonlocal ones, that are those of the band
    const double perBand =
        settings.nonlocal() ? 1 : cellSize/settings.length;
    mpm::Softening softening;
    softening.peakStrain = settings.peakStrain/perBand;
    softening.perStrain =
        perBand/(settings.residualStrain - settings.peakStrain);
    softening.residualCohesion = settings.residualCohesion;
    softening.tanPhi = tangent(frictionAngle);
    softening.residualTanPhi =
        tangent(std::min(frictionAngle, settings.residualFrictionAngle));
    softening.tanPsi = tangent(material.dilationAngle);
    softening.residualTanPsi = tangent(settings.residualDilationAngle);
    return softening;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

mpm::LawTable::LawTable
(
    const std::vector<Material>& materials,
    const double cellSize
)
:
    materials_(materials),
    cellSize_(cellSize)
{
    for (const Material& material : materials_)
    {
        material.validate(cellSize);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int mpm::LawTable::find(const int zone, const double frictionAngle)
{
    const std::pair<int, double> key(zone, frictionAngle);
    const auto found = index_.find(key);
    if (found != index_.end())
    {
        return found->second;
    }

    const Material& material = materials_[zone];
    Law law;
    law.zone = zone;
    law.frictionAngle = frictionAngle;
    law.model = modelOf(material);
    law.elastic =
        law.model == Model::linearElastic || law.model == Model::neoHookean;
    law.tensileStrength =
        material.tensionCutOff ? material.tensileStrength : unlimited;
    law.stiffness = material.constrainedModulus();

    if (!law.elastic)
    {
        require
        (
            material.dilationAngle <= frictionAngle,
            "material " + material.name + ": dilationAngle",
            material.dilationAngle,
            "0 .. frictionAngle of the points, "
          + std::to_string(frictionAngle) + " deg"
        );
    }

    // An elastic law is one without friction whose cohesion is unlimited
    law.soil = mohrCoulomb
    (
        material.E,
        material.nu,
        law.elastic ? 0 : frictionAngle,
        law.elastic ? 0 : material.dilationAngle
    );
    law.lanes = lanesOf(law.soil);

    law.fit = fitOf(material);
    law.cone.moduli = law.soil.moduli;
    law.cone.setAngles
    (
        law.fit, law.soil.sinPhi, law.soil.cosPhi, law.soil.sinPsi
    );
    law.coneLanes.moduli = law.lanes.moduli;
    law.coneLanes.setAngles
    (
        law.fit, law.lanes.sinPhi, law.lanes.cosPhi, law.lanes.sinPsi
    );

    law.softens = !law.elastic && material.softening.length > 0;
    law.nonlocal = law.softens && material.softening.nonlocal();
    law.softening =
        law.softens
      ? softeningOf(material, frictionAngle, cellSize_)
      : Softening();
    law.relaxationTime = material.viscosity/law.soil.moduli.mu;

    laws_.push_back(law);
    index_[key] = int(laws_.size()) - 1;
    return index_[key];
}


bool mpm::LawTable::tensionCutOff() const
{
    return std::any_of
    (
        materials_.begin(),
        materials_.end(),
        [](const Material& m) { return m.tensionCutOff; }
    );
}


bool mpm::LawTable::common() const
{
    return std::all_of
    (
        materials_.begin(),
        materials_.end(),
        [](const Material& m)
        {
            const Model model = modelOf(m);
            return
                model == Model::linearElastic
             || (
                    model == Model::MohrCoulomb
                 && m.softening.length == 0
                 && m.viscosity == 0
                );
        }
    );
}


bool mpm::LawTable::dilates() const
{
    return std::any_of
    (
        materials_.begin(),
        materials_.end(),
        [](const Material& m) { return m.dilationAngle > 0; }
    );
}


bool mpm::LawTable::nonlocal() const
{
    return std::any_of
    (
        materials_.begin(),
        materials_.end(),
        [](const Material& m) { return m.softening.nonlocal(); }
    );
}


bool mpm::LawTable::needsDeformation() const
{
    return std::any_of
    (
        materials_.begin(),
        materials_.end(),
        [](const Material& m) { return modelOf(m) == Model::neoHookean; }
    );
}


// ************************************************************************* //
