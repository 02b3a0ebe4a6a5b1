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

#include <cfenv>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupledMatrix::scaleRows()
{
    rowScale_ = matrix_.diag();

    for (scalar& scale : rowScale_)
    {
        scale = 1/(mag(scale) > VSMALL ? scale : scalar(1));
    }

    const labelUList& l = lduMesh_.lduAddr().lowerAddr();
    const labelUList& u = lduMesh_.lduAddr().upperAddr();

    matrix_.diag() *= rowScale_;
    forAll(l, k)
    {
        matrix_.upper()[k] *= rowScale_[l[k]];
        matrix_.lower()[k] *= rowScale_[u[k]];
    }

    List<scalarField> here(boundaryCoeffs_.size());
    forAll(here, i)
    {
        here[i] = scalarField(rowScale_, lduMesh_.interfaceCells(i));
    }

    // The internal coefficients are those of the rows of the other side
    const List<scalarField> there(lduMesh_.across(here));
    forAll(here, i)
    {
        boundaryCoeffs_[i] *= here[i];
        internalCoeffs_[i] *= there[i];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupledMatrix::coupledMatrix
(
    const coupledLduMesh& lduMesh,
    stepVolumes& volumes
)
:
    lduMesh_(lduMesh),
    volumes_(volumes),
    residual_(lduMesh.lduAddr().size(), Zero),
    matrix_(lduMesh),
    boundaryCoeffs_(lduMesh.rawInterfaces().size()),
    internalCoeffs_(lduMesh.rawInterfaces().size()),
    rowScale_()
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


Foam::scalar Foam::coupledMatrix::imbalance(const label n) const
{
    return mag(gSum(scalarField(SubList<scalar>(residual_, n))));
}


void Foam::coupledMatrix::reset(const scalarField& residual)
{
    residual_ = residual;
    rowScale_.clear();
    volumes_.clear();
    dropDerivatives();
}


void Foam::coupledMatrix::dropDerivatives()
{
    matrix_.diag() = Zero;
    matrix_.upper() = Zero;
    matrix_.lower() = Zero;

    forAll(boundaryCoeffs_, i)
    {
        boundaryCoeffs_[i] = Zero;
        internalCoeffs_[i] = Zero;
    }
}


void Foam::coupledMatrix::hold(const label n)
{
    SubList<scalar>(residual_, n) = Zero;
    SubList<scalar>(matrix_.diag(), n) = 1;
}


Foam::label Foam::coupledMatrix::solve
(
    scalarField& step,
    const dictionary& controls
)
{
    // In a singular system the solver divides by zero: that shows in the step
    std::fenv_t environment;
    std::feholdexcept(&environment);

    if (rowScale_.empty())
    {
        scaleRows();
    }

    const scalarField source(-rowScale_*residual_);

    const label n = lduMatrix::solver::New
    (
        "water",
        matrix_,
        boundaryCoeffs_,
        internalCoeffs_,
        lduMesh_.interfaceFields(),
        controls
    )->solve(step, source).nIterations();

    std::fesetenv(&environment);

    return n;
}

// ************************************************************************* //
