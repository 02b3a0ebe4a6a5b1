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

#include "coupledFlowControls.H"
#include "readChecked.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static label readCoupling(const dictionary& controls)
{
    const word coupling
    (
        controls.lookupOrDefault<word>("coupling", "simultaneous")
    );

    if (coupling == "simultaneous")
    {
        return 0;
    }

    if (coupling != "sequential")
    {
        FatalIOErrorInFunction(controls)
            << "Unknown coupling " << coupling
            << "; valid are simultaneous and sequential"
            << exit(FatalIOError);
    }

    return readCheckedOrDefault
    (
        controls,
        "nCouplingIterations",
        1,
        [](const scalar n) { return n >= 1 && n == std::floor(n); },
        "a whole number >= 1"
    );
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupledFlowControls::coupledFlowControls(const dictionary& dict)
:
    maxIterations
    (
        readCheckedOrDefault
        (
            dict,
            "maxIterations",
            60,
            [](const scalar n) { return n >= 1; },
            ">= 1"
        )
    ),
    tolerance
    (
        readCheckedOrDefault
        (
            dict,
            "tolerance",
            1e-10,
            [](const scalar e) { return e > 0 && e < 1; },
            "0 < tolerance < 1"
        )
    ),
    nNonOrthogonalCorrectors
    (
        readCheckedOrDefault
        (
            dict,
            "nNonOrthogonalCorrectors",
            3,
            [](const scalar n) { return n >= 0; },
            ">= 0"
        )
    ),
    nonOrthogonalTolerance
    (
        readCheckedOrDefault
        (
            dict,
            "nonOrthogonalTolerance",
            1e-5,
            [](const scalar share) { return share >= 0; },
            ">= 0"
        )
    ),
    nCouplings(readCoupling(dict))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::coupledFlowControls::keys()
{
    return
    {
        "maxIterations", "tolerance", "nNonOrthogonalCorrectors",
        "nonOrthogonalTolerance", "coupling", "nCouplingIterations"
    };
}

// ************************************************************************* //
