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

#include "coupledSolver.H"
#include "StringStream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dictionary Foam::coupledSolver::controls
(
    const char* defaults,
    const dictionary& dict
)
{
    IStringStream is(defaults);
    dictionary result(is);

    const word name(result.lookup("solver"));
    result.merge(dict);
    result.set("solver", name);

    return result;
}


Foam::label Foam::coupledSolver::solveCurrent
(
    coupledMatrix& matrix,
    scalarField& step,
    const label maxIterations,
    const scalar part
)
{
    usage& solver = solvers_[current_];

    dictionary controls(solver.controls);
    if (part < 1)
    {
        for (const word& tolerance : {"tolerance", "relTol"})
        {
            controls.set(tolerance, part*controls.get<scalar>(tolerance));
        }
    }
    if (maxIterations < controls.lookupOrDefault<label>("maxIter", labelMax))
    {
        controls.set("maxIter", maxIterations);
    }

    const label n = matrix.solve(step, controls);

    ++solver.solutions;
    solver.iterations += n;

    return n;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupledSolver::coupledSolver(const dictionary& dict)
:
    automatic_(dict.lookupOrDefault<word>("solver", "auto") == "auto"),
    solvers_(automatic_ ? 2 : 1),
    current_(0),
    wait_(0),
    since_(0)
{
    if (automatic_)
    {
        solvers_[0].name = "PBiCGStab-DILU";
        solvers_[0].controls = controls
        (
            "solver PBiCGStab; preconditioner DILU; tolerance 1e-14;"
            " relTol 1e-5; maxIter 1000;",
            dict
        );

        // A loose solution on the coarsest level makes PBiCGStab stall, and
        // sweeps before the coarse levels do so in parallel
        solvers_[1].name = "PBiCGStab-GAMG";
        solvers_[1].controls = controls
        (
            "solver PBiCGStab; tolerance 1e-14; relTol 1e-5; maxIter 200;"
            " preconditioner { preconditioner GAMG; smoother GaussSeidel;"
            " agglomerator algebraicPair; nCellsInCoarsestLevel 50;"
            " mergeLevels 1; cacheAgglomeration false; nVcycles 1;"
            " nPreSweeps 0; nPostSweeps 2; directSolveCoarsest true;"
            " tolerance 1e-20; relTol 0; }",
            dict
        );
    }
    else
    {
        solvers_[0].name = dict.get<word>("solver");
        solvers_[0].controls = controls
        (
            "solver auto; preconditioner DILU; tolerance 1e-14; relTol 1e-5;"
            " maxIter 1000;",
            dict
        );
        solvers_[0].controls.set("solver", solvers_[0].name);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::coupledSolver::solve
(
    coupledMatrix& matrix,
    scalarField& step
)
{
    // An iteration with GAMG costs about five with DILU, and 15 to 20 do
    const label manyIterations = 80;
    const label fewIterations = 6;

    // Below this number of unknowns GAMG's levels cost more than they save
    const label largeSystem = 2000;

    step = Zero;

    if
    (
        !automatic_
     || returnReduce(step.size(), sumOp<label>()) < largeSystem
    )
    {
        return solveCurrent(matrix, step, labelMax);
    }

    label n = 0;

    if (current_ == 0)
    {
        n = solveCurrent(matrix, step, manyIterations);

        if (n < manyIterations)
        {
            wait_ = 0;
            return n;
        }

        current_ = 1;
        since_ = 0;
        wait_ = 2*wait_ + 1;
    }

    const label nCoarse = solveCurrent(matrix, step, labelMax);

    if (++since_ > wait_ && nCoarse <= fewIterations)
    {
        current_ = 0;
    }

    return n + nCoarse;
}


Foam::label Foam::coupledSolver::solveClosely
(
    coupledMatrix& matrix,
    scalarField& step
)
{
    const scalar part = 1e-4;

    step = Zero;

    return solveCurrent(matrix, step, labelMax, part);
}

// ************************************************************************* //
