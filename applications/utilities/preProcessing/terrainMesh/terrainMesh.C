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

Application
    terrainMesh

Group
    grpPreProcessingUtilities

Description
    Turns a flat layered mesh into one that follows a terrain.

    Takes a plan mesh that was extruded downwards in horizontal layers (of any
    thickness: only their number counts), moves its points vertically to the
    ground, the interfaces between layers and the base, and puts every cell
    into the cellZone of its stratum. Plan coordinates and patches stay as
    they are, so the lateral patches remain vertical.

Usage
    \b terrainMesh [OPTION]

      - \par -dict \<file\>
        Use a dictionary other than system/terrainMeshDict

    \verbatim
    surfaces
    {
        ground  { type raster; file "constant/terrain/ground.asc"; }
        rock    { type raster; file "constant/terrain/ground.asc"; offset -2; }
        base    { type uniform; elevation 100; }
    }

    layers
    {
        ground      ground;
        base        base;
        depths      (0 0.2 0.5 1 2);
        expansion   1.3;
    }

    // From the top downwards: a cell belongs to the first zone whose bottom
    // lies below it; the last one has no bottom
    zones
    {
        soil    { bottom rock; }
        rock    {}
    }
    \endverbatim

See also
    Foam::terrainSurface
    Foam::terrainLayers

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "polyMesh.H"
#include "cellZone.H"
#include "IOdictionary.H"
#include "uniformDimensionedFields.H"
#include "readChecked.H"
#include "terrainLayers.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The surfaces by name
void readSurfaces
(
    const dictionary& dict,
    const fileName& casePath,
    HashPtrTable<terrainSurface>& surfaces
)
{
    for (const entry& e : dict)
    {
        surfaces.set
        (
            e.keyword(),
            terrainSurface::New(e.keyword(), e.dict(), casePath)
        );
    }
}


//- Elevations of the flat mesh's interfaces, from the top downwards
scalarList flatInterfaces(const pointField& points)
{
    scalarList z(points.component(vector::Z));
    sort(z);

    // Levels of one extrusion agree to round-off
    const scalar tolerance = 1e-6*(z.last() - z.first());

    DynamicList<scalar> levels;
    forAllReverse(z, i)
    {
        if (levels.empty() || levels.last() - z[i] > tolerance)
        {
            levels.append(z[i]);
        }
    }

    return scalarList(std::move(levels));
}


//- The interface that a point of the flat mesh lies on
label nearestInterface(const scalarList& interfaces, const scalar z)
{
    label nearest = 0;
    forAll(interfaces, i)
    {
        if (mag(interfaces[i] - z) < mag(interfaces[nearest] - z))
        {
            nearest = i;
        }
    }
    return nearest;
}


//- For each point its interface; a mesh that is not flat is an error
labelList pointInterfaces
(
    const pointField& points,
    const scalarList& interfaces
)
{
    labelList pointInterface(points.size());
    labelList count(interfaces.size(), 0);

    forAll(points, pointi)
    {
        const label i = nearestInterface(interfaces, points[pointi].z());
        pointInterface[pointi] = i;
        ++count[i];
    }

    // The smallest plan mesh is one triangle
    if (min(count) != max(count) || min(count) < 3)
    {
        FatalErrorInFunction
            << "The mesh is not an extruded flat one: its " << points.size()
            << " points lie at " << interfaces.size() << " elevations, "
            << min(count) << " to " << max(count) << " points at each."
            << " A mesh that terrainMesh has moved must be made anew first"
            << exit(FatalError);
    }

    return pointInterface;
}


//- Height above the surface, averaged over a cell's points. The height of its
//  centre would not do: between the points of a coarse mesh a curved surface
//  lies above or below the facet that stands for it
scalar meanHeight
(
    const terrainSurface& surface,
    const pointField& points,
    const labelList& cellPoints
)
{
    scalar sum = 0;
    for (const label pointi : cellPoints)
    {
        const point& p = points[pointi];
        sum += p.z() - surface.elevation(p.x(), p.y());
    }
    return sum/cellPoints.size();
}


//- For each zone its cells, by their mean height above the zones' bottoms
List<DynamicList<label>> cellsOfZones
(
    const polyMesh& mesh,
    const dictionary& dict,
    const HashPtrTable<terrainSurface>& surfaces
)
{
    const wordList names(dict.toc());
    List<const terrainSurface*> bottoms(names.size(), nullptr);

    forAll(names, zonei)
    {
        const dictionary& zoneDict =
            checkKeys(dict.subDict(names[zonei]), {"bottom"});
        const bool last = (zonei == names.size() - 1);

        if (last == zoneDict.found("bottom"))
        {
            FatalIOErrorInFunction(zoneDict)
                << "Every zone needs a 'bottom' but the last, lowest one,"
                << " which has none; zones from the top: " << names
                << exit(FatalIOError);
        }
        if (!last)
        {
            const word bottom(zoneDict.get<word>("bottom"));
            if (!surfaces.found(bottom))
            {
                FatalIOErrorInFunction(zoneDict)
                    << "No surface '" << bottom << "' for 'bottom';"
                    << " the surfaces are "
                    << flatOutput(surfaces.sortedToc())
                    << exit(FatalIOError);
            }
            bottoms[zonei] = surfaces[bottom];
        }
    }

    List<DynamicList<label>> cells(names.size());

    forAll(mesh.cells(), celli)
    {
        const labelList cellPoints(mesh.cells()[celli].labels(mesh.faces()));

        label zonei = 0;
        while
        (
            bottoms[zonei]
         && meanHeight(*bottoms[zonei], mesh.points(), cellPoints) < 0
        )
        {
            ++zonei;
        }
        cells[zonei].append(celli);
    }

    return cells;
}


//- Replace the mesh's cellZones
void setZones
(
    polyMesh& mesh,
    const dictionary& dict,
    const List<DynamicList<label>>& cells
)
{
    const wordList names(dict.toc());

    mesh.cellZones().clear();
    mesh.cellZones().setSize(names.size());

    forAll(names, zonei)
    {
        scalar volume = 0;
        for (const label celli : cells[zonei])
        {
            volume += mesh.cellVolumes()[celli];
        }

        Info<< "    zone " << names[zonei] << ": " << cells[zonei].size()
            << " cells, " << volume << " m3" << nl;

        if (cells[zonei].empty())
        {
            FatalIOErrorInFunction(dict)
                << "No cell lies in zone " << names[zonei]
                << ": the layers or the plan mesh are too coarse for it"
                << exit(FatalIOError);
        }

        mesh.cellZones().set
        (
            zonei,
            new cellZone
            (
                names[zonei],
                cells[zonei],
                zonei,
                mesh.cellZones()
            )
        );
    }

    mesh.cellZones().writeOpt() = IOobject::AUTO_WRITE;
}


//- A cell turned inside out is an error
void checkVolumes(const polyMesh& mesh)
{
    const label worst = findMin(mesh.cellVolumes());

    if (mesh.cellVolumes()[worst] <= 0)
    {
        FatalErrorInFunction
            << "Cell " << worst << " at " << mesh.cellCentres()[worst]
            << " has the volume " << mesh.cellVolumes()[worst]
            << " m3: interfaces cross, or the flat mesh was not extruded"
            << " along z"
            << exit(FatalError);
    }
}

} // End unnamed namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Move the points of a flat layered mesh to a terrain and its strata"
    );
    argList::noParallel();
    argList::addOption("dict", "file", "Alternative terrainMeshDict");

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createPolyMesh.H"

    const uniformDimensionedVectorField g
    (
        IOobject
        (
            "g",
            runTime.constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    );

    if ((-g.value().z()) < (1 - SMALL)*mag(g.value()))
    {
        FatalErrorInFunction
            << "A terrain is a surface z(x, y), so gravity must point along"
            << " -z, but constant/g is " << g.value()
            << exit(FatalError);
    }

    const IOdictionary dict
    (
        IOobject::selectIO
        (
            IOobject
            (
                "terrainMeshDict",
                runTime.system(),
                mesh,
                IOobject::MUST_READ,
                IOobject::NO_WRITE
            ),
            args.opt<fileName>("dict", "")
        )
    );

    checkKeys(dict, wordList(), {"FoamFile", "surfaces", "layers", "zones"});

    HashPtrTable<terrainSurface> surfaces;
    readSurfaces(dict.subDict("surfaces"), runTime.path(), surfaces);

    const scalarList interfaces(flatInterfaces(mesh.points()));
    const labelList pointInterface(pointInterfaces(mesh.points(), interfaces));
    const terrainLayers layers
    (
        dict.subDict("layers"),
        surfaces,
        interfaces.size() - 1
    );

    pointField points(mesh.points());
    forAll(points, pointi)
    {
        point& p = points[pointi];
        p.z() = layers.elevation(pointInterface[pointi], p.x(), p.y());
    }

    mesh.movePoints(points);
    checkVolumes(mesh);

    Info<< nl << "Moved " << points.size() << " points on "
        << interfaces.size() << " interfaces; elevations "
        << min(points.component(vector::Z)()) << " .. "
        << max(points.component(vector::Z)()) << " m" << nl;

    setZones
    (
        mesh,
        dict.subDict("zones"),
        cellsOfZones(mesh, dict.subDict("zones"), surfaces)
    );

    mesh.setInstance(runTime.constant());
    if (!mesh.write())
    {
        FatalErrorInFunction
            << "Failed writing the mesh in " << mesh.pointsInstance()
            << exit(FatalError);
    }

    Info<< nl << "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
