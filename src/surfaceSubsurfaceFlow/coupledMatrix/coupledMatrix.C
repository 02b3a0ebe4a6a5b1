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

#include "coupledMatrix.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupledMatrix::coupledMatrix(const coupledLduMesh& lduMesh)
:
    lduMesh_(lduMesh),
    residual_(lduMesh.lduAddr().size(), Zero),
    matrix_(lduMesh),
    boundaryCoeffs_(lduMesh.rawInterfaces().size()),
    internalCoeffs_(lduMesh.rawInterfaces().size())
{
    // Made here, so that all three exist: an asymmetric matrix
    matrix_.diag();
    matrix_.upper();
    matrix_.lower();

    forAll(boundaryCoeffs_, i)
    {
        const label size = lduMesh.interfaceCells(i).size();
        boundaryCoeffs_.set(i, new scalarField(size, Zero));
        internalCoeffs_.set(i, new scalarField(size, Zero));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupledMatrix::norm() const
{
    return gSumMag(residual_);
}


void Foam::coupledMatrix::reset(const scalarField& residual)
{
    residual_ = residual;
    matrix_.diag() = Zero;
    matrix_.upper() = Zero;
    matrix_.lower() = Zero;

    forAll(boundaryCoeffs_, i)
    {
        boundaryCoeffs_[i] = Zero;
        internalCoeffs_[i] = Zero;
    }
}


Foam::label Foam::coupledMatrix::solve
(
    scalarField& step,
    const dictionary& controls
)
{
    step = Zero;
    const scalarField source(-residual_);

    return lduMatrix::solver::New
    (
        "water",
        matrix_,
        boundaryCoeffs_,
        internalCoeffs_,
        lduMesh_.interfaceFields(),
        controls
    )->solve(step, source).nIterations();
}

// ************************************************************************* //
