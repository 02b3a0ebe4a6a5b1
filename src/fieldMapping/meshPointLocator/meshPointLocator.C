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

#include "meshPointLocator.H"
#include "emptyPolyPatch.H"
#include "indexedOctree.H"
#include "PstreamReduceOps.H"
#include "StringStream.H"
#include "treeDataCell.H"
#include "treeDataFace.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

// Mesh coordinates are read from files with as few as 6 digits: a point made
// from the same number may then lie 1e-6 of a cell beyond the face
const Foam::scalar Foam::meshPointLocator::tolerance = 1e-6;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// The cells' boxes are looked up in a tree whose own box must not be flat
static treeBoundBox treeBounds(const boundBox& bounds)
{
    const scalar margin = 1e-4*max(bounds.mag(), SMALL);

    return treeBoundBox
    (
        bounds.min() - vector::uniform(margin),
        bounds.max() + vector::uniform(margin)
    );
}


// Depth, size of leaves and duplicity of search trees, as polyMesh has them
static const label treeLevels = 8;
static const scalar treeLeafSize = 10;
static const scalar treeDuplicity = 5;

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::meshPointLocator::better(const candidate& a, const candidate& b)
{
    // Distances that differ by rounding only are equal
    const scalar equal = 1e-9;

    if (a[0] != b[0])
    {
        return a[0] < b[0];
    }
    if (mag(a[1] - b[1]) > equal*max(a[1], b[1]))
    {
        return a[1] < b[1];
    }
    if (mag(a[2] - b[2]) > equal*max(mag(a[2]), mag(b[2])))
    {
        return a[2] < b[2];
    }
    return a[3] < b[3];
}


void Foam::meshPointLocator::centreUnresolved()
{
    const Vector<label> resolved(mesh_.geometricD());
    const point middle(mesh_.bounds().centre());

    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if (resolved[cmpt] == -1)
        {
            for (point& p : positions_)
            {
                p[cmpt] = middle[cmpt];
            }
        }
    }
}


Foam::scalar Foam::meshPointLocator::violation
(
    const point& p,
    const label celli
) const
{
    const vectorField& centres = mesh_.faceCentres();
    const vectorField& areas = mesh_.faceAreas();

    scalar worst = 0;

    for (const label facei : mesh_.cells()[celli])
    {
        const scalar sign = (mesh_.faceOwner()[facei] == celli ? 1 : -1);

        worst = max
        (
            worst,
            sign*((p - centres[facei]) & areas[facei])
           /max(mag(areas[facei]), VSMALL)
        );
    }

    return worst/cbrt(max(mesh_.cellVolumes()[celli], VSMALL));
}


Foam::meshPointLocator::candidate Foam::meshPointLocator::bestCell
(
    const indexedOctree<treeDataCell>& tree,
    const point& p,
    label& celli
) const
{
    // Any direction that is none of the mesh's own tells centres apart
    const vector ranking(1, 0.61803, 0.38197);

    candidate best({scalar(NONE), GREAT, 0, scalar(Pstream::myProcNo())});
    celli = -1;

    // Larger than the tolerance of any cell
    const scalar margin = tolerance*tree.bb().mag();

    const labelList found
    (
        tree.findBox
        (
            treeBoundBox
            (
                p - vector::uniform(margin),
                p + vector::uniform(margin)
            )
        )
    );

    for (const label shapei : found)
    {
        const label i = tree.shapes().cellLabels()[shapei];
        const point& centre = mesh_.cellCentres()[i];

        candidate c
        ({
            scalar(INSIDE),
            magSqr(p - centre),
            (centre & ranking),
            scalar(Pstream::myProcNo())
        });

        if (!mesh_.pointInCell(p, i, polyMesh::CELL_TETS))
        {
            c[0] = (violation(p, i) <= tolerance ? WITHIN_TOLERANCE : NONE);
        }

        if (c[0] != NONE && better(c, best))
        {
            best = c;
            celli = i;
        }
    }

    return best;
}


Foam::labelList Foam::meshPointLocator::nearCells() const
{
    boundBox query(positions_, false);
    query.inflate(tolerance);
    query.min() -= vector::uniform(SMALL);
    query.max() += vector::uniform(SMALL);

    DynamicList<label> cells;

    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        boundBox box(cellBounds(mesh_, celli));
        box.inflate(tolerance);

        if (box.overlaps(query))
        {
            cells.append(celli);
        }
    }

    return labelList(std::move(cells));
}


void Foam::meshPointLocator::locate()
{
    List<candidate> best
    (
        positions_.size(),
        candidate({scalar(NONE), GREAT, 0, scalar(Pstream::myProcNo())})
    );

    // Decomposition into tetrahedra is agreed on by all processors: make it
    // even if this one has no cells
    (void)mesh_.tetBasePtIs();

    const labelList near(nearCells());

    if (near.size())
    {
        const boundBox bounds(mesh_.points(), false);
        const treeBoundBox box(treeBounds(bounds));

        const indexedOctree<treeDataCell> tree
        (
            treeDataCell(true, mesh_, near, polyMesh::CELL_TETS),
            box,
            treeLevels,
            treeLeafSize,
            treeDuplicity
        );

        forAll(positions_, i)
        {
            if (box.contains(positions_[i]))
            {
                best[i] = bestCell(tree, positions_[i], cells_[i]);
            }
        }
    }

    List<candidate> global(best);
    Pstream::listCombineGather
    (
        global,
        [](candidate& x, const candidate& y)
        {
            if (better(y, x))
            {
                x = y;
            }
        }
    );
    Pstream::listCombineScatter(global);

    forAll(positions_, i)
    {
        if (global[i][0] == NONE)
        {
            outside_.set(i);
        }
        if (label(global[i][3]) != Pstream::myProcNo())
        {
            cells_[i] = -1;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::meshPointLocator::meshPointLocator
(
    const polyMesh& mesh,
    const pointField& points
)
:
    mesh_(mesh),
    positions_(points),
    cells_(points.size(), -1),
    outside_(points.size())
{
    centreUnresolved();
    locate();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boundBox Foam::meshPointLocator::cellBounds
(
    const polyMesh& mesh,
    const label celli
)
{
    boundBox bounds;

    for (const label facei : mesh.cells()[celli])
    {
        for (const label pointi : mesh.faces()[facei])
        {
            bounds.add(mesh.points()[pointi]);
        }
    }

    return bounds;
}


void Foam::meshPointLocator::moveOutsideToNearest()
{
    // The outer boundary of the whole mesh
    DynamicList<label> faces(mesh_.nBoundaryFaces());

    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (!pp.coupled() && !isA<emptyPolyPatch>(pp))
        {
            forAll(pp, facei)
            {
                faces.append(pp.start() + facei);
            }
        }
    }

    const labelList outsideLabels(outside_.toc());
    scalarField distSqr(outsideLabels.size(), GREAT);
    pointField nearest(outsideLabels.size(), Zero);
    labelList nearestCell(outsideLabels.size(), -1);

    if (faces.size())
    {
        const indexedOctree<treeDataFace> tree
        (
            treeDataFace(true, mesh_, faces),
            treeBounds(boundBox(mesh_.points(), false)),
            treeLevels,
            treeLeafSize,
            treeDuplicity
        );

        forAll(outsideLabels, i)
        {
            const point& p = positions_[outsideLabels[i]];
            const pointIndexHit hit(tree.findNearest(p, GREAT));

            if (hit.hit())
            {
                nearest[i] = hit.hitPoint();
                distSqr[i] = magSqr(p - nearest[i]);
                nearestCell[i] = mesh_.faceOwner()[faces[hit.index()]];
            }
        }
    }

    scalarField globalDistSqr(distSqr);
    Pstream::listCombineGather(globalDistSqr, minEqOp<scalar>());
    Pstream::listCombineScatter(globalDistSqr);

    labelList winner(outsideLabels.size(), Pstream::nProcs());
    forAll(winner, i)
    {
        if (nearestCell[i] != -1 && distSqr[i] == globalDistSqr[i])
        {
            winner[i] = Pstream::myProcNo();
        }
    }
    Pstream::listCombineGather(winner, minEqOp<label>());
    Pstream::listCombineScatter(winner);

    forAll(outsideLabels, i)
    {
        if (winner[i] == Pstream::myProcNo())
        {
            const label pointi = outsideLabels[i];

            cells_[pointi] = nearestCell[i];
            positions_[pointi] = nearest[i];
        }
    }
}


Foam::string Foam::meshPointLocator::boundsMessage(const polyMesh& mesh)
{
    OStringStream os;
    os  << "mesh " << mesh.name() << " with bounds " << mesh.bounds().min()
        << ' ' << mesh.bounds().max();

    return os.str();
}

// ************************************************************************* //
