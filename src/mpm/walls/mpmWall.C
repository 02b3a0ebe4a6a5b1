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

#include "mpmWall.H"
#include "mpmNames.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim>
double mpm::Wall<Dim>::distanceToShape
(
    const Vector<Dim>& x,
    Vector<Dim>& normal
) const
{
    return
        terrain_ ? terrain_->distance(x, normal)
      : box_ ? box_->distance(x, normal)
      : levelSet_->distance(x, normal);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<int Dim>
mpm::Wall<Dim>::Wall
(
    const WallSettings& settings,
    const Vector<Dim>& up,
    const int record
)
:
    name_(settings.name),
    condition_
    (
        static_cast<Condition>
        (
            choose
            (
                "wall " + settings.name + ": condition",
                settings.condition,
                WallSettings::conditions()
            )
        )
    ),
    friction_(settings.friction),
    adhesion_(settings.adhesion),
    record_(record),
    point_(),
    normal_(),
    terrain_
    (
        settings.type == "terrain"
      ? std::make_shared<const Terrain<Dim>>
        (
            settings.name, settings.vertices, settings.triangles, up
        )
      : nullptr
    ),
    box_
    (
        settings.type == "box"
      ? std::make_shared<const Box<Dim>>(settings.lower, settings.upper)
      : nullptr
    ),
    levelSet_
    (
        settings.type == "levelSet"
      ? std::make_shared<const LevelSet<Dim>>
        (
            settings.name,
            settings.signedDistance,
            settings.lower,
            settings.upper,
            settings.spacing
        )
      : nullptr
    ),
    isPlane_(!terrain_ && !box_ && !levelSet_),
    isPlain_(record_ < 0 && !needsArea())
{
    double square = 0;
    for (int d = 0; d < Dim; ++d)
    {
        point_[d] = settings.point[d];
        square += settings.normal[d]*settings.normal[d];
    }
    for (int d = 0; isPlane_ && d < Dim; ++d)
    {
        normal_[d] = settings.normal[d]/std::sqrt(square);
    }
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::Wall<2>;
template class mpm::Wall<3>;


// ************************************************************************* //
