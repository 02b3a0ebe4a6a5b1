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

#include "linearReconstruction.H"
#include "CPCCellToCellStencil.H"
#include "processorPolyPatch.H"
#include "symmTensor.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::linearReconstruction::checkPatches(const polyMesh& mesh)
{
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (pp.coupled() && pp.type() != processorPolyPatch::typeName)
        {
            FatalErrorInFunction
                << "Patch " << pp.name() << " has type " << pp.type()
                << ": fields can't be mapped to points across periodic"
                << " patches. Valid coupled types: "
                << processorPolyPatch::typeName
                << exit(FatalError);
        }
    }
}


void Foam::linearReconstruction::makeStencils
(
    const polyMesh& mesh,
    const labelUList& groups
)
{
    const CPCCellToCellStencil stencil(mesh);
    const globalIndex& numbering = stencil.globalNumbering();

    // A number below the offset of its processor's boundary faces is a cell
    labelList nCells(Pstream::nProcs(), Zero);
    nCells[Pstream::myProcNo()] = mesh.nCells();
    Pstream::listCombineGather(nCells, plusEqOp<label>());
    Pstream::listCombineScatter(nCells);

    neighbours_.setSize(cells_.size());

    forAll(cells_, i)
    {
        const label self = numbering.toGlobal(cells_[i]);
        DynamicList<label> cellNumbers(stencil[cells_[i]].size());

        for (const label number : stencil[cells_[i]])
        {
            const label proci = numbering.whichProcID(number);

            if
            (
                number != self
             && numbering.toLocal(proci, number) < nCells[proci]
            )
            {
                cellNumbers.append(number);
            }
        }

        neighbours_[i].transfer(cellNumbers);
    }

    List<Map<label>> compactMap;
    map_.reset(new mapDistribute(numbering, neighbours_, compactMap));

    if (groups.size())
    {
        const labelList allGroups(distributed(groups));

        forAll(cells_, i)
        {
            inplaceSubsetList
            (
                neighbours_[i],
                [&](const label j)
                {
                    return allGroups[j] == groups[cells_[i]];
                }
            );
        }
    }
}


void Foam::linearReconstruction::makeCoefficients(const polyMesh& mesh)
{
    const pointField allCentres(distributed(mesh.cellCentres()));

    coefficients_.setSize(cells_.size());

    forAll(cells_, i)
    {
        const point& centre = mesh.cellCentres()[cells_[i]];
        vectorList& coefficients = coefficients_[i];

        // Weighted by the inverse square of the distance: with unit vectors a
        // flat cell's two directions count alike
        symmTensor normal(Zero);
        coefficients.setSize(neighbours_[i].size());

        forAll(coefficients, j)
        {
            const vector d(allCentres[neighbours_[i][j]] - centre);

            coefficients[j] = d/magSqr(d);
            normal += sqr(d)/magSqr(d);
        }

        const symmTensor inverse(pseudoInverse(normal));

        for (vector& c : coefficients)
        {
            c = inverse & c;
        }
    }
}


Foam::symmTensor Foam::linearReconstruction::pseudoInverse
(
    const symmTensor& t
)
{
    // Unit vectors that leave a plane by less than 1e-4 rad do not resolve
    // the direction across it; rounding alone gives some 1e-15
    const scalar singular = 1e-8;

    // Jacobi rotations: exact enough for clustered eigenvalues, of which
    // closed forms lose half of the digits
    const label maxSweeps = 50;

    tensor a(t);
    tensor vectors(tensor::I);

    for (label sweep = 0; sweep < maxSweeps; ++sweep)
    {
        if (mag(a.xy()) + mag(a.xz()) + mag(a.yz()) <= VSMALL + 1e-17*mag(a))
        {
            break;
        }

        for (direction p = 0; p < 2; ++p)
        {
            for (direction q = p + 1; q < 3; ++q)
            {
                const scalar apq = a(p, q);

                if (mag(apq) <= VSMALL)
                {
                    continue;
                }

                const scalar ratio = 0.5*(a(q, q) - a(p, p))/apq;
                const scalar tangent =
                    (ratio < 0 ? -1 : 1)/(mag(ratio) + hypot(ratio, 1.0));
                const scalar c = 1/hypot(tangent, 1.0);
                const scalar s = tangent*c;

                tensor rotation(tensor::I);
                rotation(p, p) = c;
                rotation(q, q) = c;
                rotation(p, q) = s;
                rotation(q, p) = -s;

                a = rotation.T() & a & rotation;
                vectors = vectors & rotation;
            }
        }
    }

    const scalar largest = max(max(a.xx(), a.yy()), a.zz());

    symmTensor inverse(Zero);

    for (direction i = 0; i < 3; ++i)
    {
        if (a(i, i) > singular*largest && largest > VSMALL)
        {
            inverse +=
                sqr(vector(vectors(0, i), vectors(1, i), vectors(2, i)))
               /a(i, i);
        }
    }

    return inverse;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::linearReconstruction::linearReconstruction
(
    const polyMesh& mesh,
    const labelUList& cells,
    const labelUList& groups
)
:
    cells_(cells),
    neighbours_(),
    map_(nullptr),
    coefficients_()
{
    if (groups.size() && groups.size() != mesh.nCells())
    {
        FatalErrorInFunction
            << "Groups are given for " << groups.size() << " cells of "
            << mesh.nCells()
            << exit(FatalError);
    }

    checkPatches(mesh);
    makeStencils(mesh, groups);
    makeCoefficients(mesh);
}

// ************************************************************************* //
