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

#include "sectionPointSource.H"
#include "addToRunTimeSelectionTable.H"
#include "meshPointLocator.H"
#include "readChecked.H"
#include "Time.H"
#include "uniformDimensionedFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace pointSources
{
    defineTypeNameAndDebug(sectionPointSource, 0);
    addToRunTimeSelectionTable(pointSource, sectionPointSource, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointSources::sectionPointSource::sectionPointSource
(
    const dictionary& dict
)
:
    dict_
    (
        checkKeys
        (
            dict,
            {"type", "spacing", "xLimits", "yLimits"},
            {"section"}
        )
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::vector2D> Foam::pointSources::sectionPointSource::lattice
(
    const Pair<vector2D>& corners,
    const scalar spacing
)
{
    // Point i is at (i + 0.5)*spacing
    const label firstX = std::ceil(corners.first().x()/spacing - 0.5);
    const label firstY = std::ceil(corners.first().y()/spacing - 0.5);
    const label lastX = std::floor(corners.second().x()/spacing - 0.5);
    const label lastY = std::floor(corners.second().y()/spacing - 0.5);

    DynamicList<vector2D> points
    (
        max(0, lastX - firstX + 1)*max(0, lastY - firstY + 1)
    );

    for (label j = firstY; j <= lastY; ++j)
    {
        for (label i = firstX; i <= lastX; ++i)
        {
            points.append(vector2D((i + 0.5)*spacing, (j + 0.5)*spacing));
        }
    }

    return List<vector2D>(std::move(points));
}


Foam::vector Foam::pointSources::sectionPointSource::gravity
(
    const polyMesh& mesh
)
{
    return uniformDimensionedVectorField
    (
        IOobject
        (
            "g",
            mesh.time().constant(),
            mesh.time(),
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    ).value();
}


Foam::pointField Foam::pointSources::sectionPointSource::points
(
    const polyMesh& mesh
) const
{
    const mappingSection section(dict_.subDict("section"), gravity(mesh));
    const scalar spacing
    (
        dict_.getCheck<scalar>("spacing", scalarMinMax::ge(SMALL))
    );

    Pair<vector2D> corners(section.limits(mesh.bounds()));

    scalarMinMax x(corners.first().x(), corners.second().x());
    scalarMinMax y(corners.first().y(), corners.second().y());

    if (dict_.found("xLimits"))
    {
        const auto given(dict_.get<Pair<scalar>>("xLimits"));
        x = scalarMinMax(given.first(), given.second());
    }
    if (dict_.found("yLimits"))
    {
        const auto given(dict_.get<Pair<scalar>>("yLimits"));
        y = scalarMinMax(given.first(), given.second());
    }

    const List<vector2D> candidates
    (
        lattice
        (
            Pair<vector2D>
            (
                vector2D(x.min(), y.min()),
                vector2D(x.max(), y.max())
            ),
            spacing
        )
    );

    pointField positions(candidates.size());
    forAll(candidates, i)
    {
        positions[i] = section.toSpace(candidates[i]);
    }

    const meshPointLocator locator(mesh, positions);

    DynamicList<point> inside(positions.size());
    forAll(positions, i)
    {
        if (!locator.outside().test(i))
        {
            inside.append(positions[i]);
        }
    }

    if (inside.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "No point of the section, spaced " << spacing
            << " m, lies in the "
            << meshPointLocator::boundsMessage(mesh).c_str()
            << exit(FatalIOError);
    }

    return pointField(std::move(inside));
}

// ************************************************************************* //
