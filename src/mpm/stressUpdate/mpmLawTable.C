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

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

mpm::LawTable::Model modelOf(const mpm::Material& material)
{
    typedef mpm::LawTable::Model Model;

    return
        material.constitutiveModel == "linearElastic" ? Model::linearElastic
      : material.constitutiveModel == "neoHookean" ? Model::neoHookean
      : Model::MohrCoulomb;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

mpm::LawTable::LawTable(const std::vector<Material>& materials)
:
    materials_(materials)
{
    for (const Material& material : materials_)
    {
        material.validate();
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
    return !needsDeformation();
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
