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

#include "slideFrame.H"
#include "readChecked.H"
#include "IOstreams.H"
#include "transform.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slideFrame::slideFrame(const dictionary& dict, const vector& g)
:
    dimension_(dict.get<label>("dimension")),
    g_(g),
    section_(nullptr)
{
    if (dimension_ != 2 && dimension_ != 3)
    {
        FatalIOErrorInFunction(dict)
            << "dimension " << dimension_ << " is not one of: 2 3"
            << exit(FatalIOError);
    }

    if (dimension_ == 2)
    {
        section_.reset
        (
            new mappingSection
            (
                checkKeys(dict.subDict("section"), {"origin", "direction"}),
                g
            )
        );
        return;
    }

    // Three-dimensional runs have z up; gravity may be written with 6 digits
    const scalar aligned = 1 - 1e-6;

    if (-g.z() < max(aligned*mag(g), VSMALL))
    {
        FatalIOErrorInFunction(dict)
            << "dimension 3 needs gravity along -z, but constant/g is " << g
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::direction Foam::slideFrame::vertical() const
{
    return dimension_ == 2 ? vector::Y : vector::Z;
}


Foam::vector Foam::slideFrame::gravity() const
{
    return dimension_ == 2 ? vector(0, -mag(g_), 0) : g_;
}


Foam::Pair<Foam::vector> Foam::slideFrame::limits
(
    const boundBox& bounds
) const
{
    if (dimension_ == 3)
    {
        return Pair<vector>(bounds.min(), bounds.max());
    }

    const Pair<vector2D> xy(section_->limits(bounds));

    return Pair<vector>
    (
        vector(xy.first().x(), xy.first().y(), 0),
        vector(xy.second().x(), xy.second().y(), 0)
    );
}


bool Foam::slideFrame::cuts(const boundBox& box) const
{
    const vector& n = section_->normal();
    const scalar distance = (box.centre() - section_->origin()) & n;

    return mag(distance) <= 0.5*(cmptMag(box.span()) & cmptMag(n)) + SMALL;
}


Foam::tensor Foam::slideFrame::axes() const
{
    return
        dimension_ == 3
      ? tensor::I
      : tensor(section_->xAxis(), section_->yAxis(), section_->normal());
}


Foam::point Foam::slideFrame::toSpace(const point& p) const
{
    return dimension_ == 3 ? p : section_->toSpace(vector2D(p.x(), p.y()));
}


Foam::tmp<Foam::pointField> Foam::slideFrame::toSpace
(
    const UList<point>& points
) const
{
    auto tresult = tmp<pointField>::New(points.size());
    auto& result = tresult.ref();

    forAll(points, i)
    {
        result[i] = toSpace(points[i]);
    }

    return tresult;
}


Foam::vector Foam::slideFrame::directionToSpace(const vector& v) const
{
    return v & axes();
}


Foam::symmTensor Foam::slideFrame::stressToSpace(const symmTensor& s) const
{
    return transform(axes().T(), s);
}


Foam::point Foam::slideFrame::readPoint
(
    const dictionary& dict,
    const word& key
) const
{
    if (dimension_ == 3)
    {
        return dict.get<point>(key);
    }

    const vector2D xy(dict.get<vector2D>(key));

    return point(xy.x(), xy.y(), 0);
}


Foam::pointField Foam::slideFrame::readPoints
(
    const dictionary& dict,
    const word& key
) const
{
    if (dimension_ == 3)
    {
        return dict.get<pointField>(key);
    }

    const List<vector2D> xy(dict.get<List<vector2D>>(key));
    pointField points(xy.size());

    forAll(xy, i)
    {
        points[i] = point(xy[i].x(), xy[i].y(), 0);
    }

    return points;
}

// ************************************************************************* //
