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

#include "transpiration.H"
#include "planSurface.H"
#include "readChecked.H"
#include "DynamicList.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace waterSources
{
    defineTypeNameAndDebug(transpiration, 0);
    addToRunTimeSelectionTable(waterSource, transpiration, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::waterSources::transpiration::distribute(const dictionary& dict)
{
    const word patchName(dict.getOrDefault<word>("groundPatch", "ground"));
    const label patchi = mesh_.boundaryMesh().findPatchID(patchName);

    if (patchi < 0)
    {
        FatalIOErrorInFunction(dict)
            << "The mesh has no patch '" << patchName << "' (entry groundPatch)"
            << nl << "    Valid names: " << mesh_.boundaryMesh().names() << nl
            << exit(FatalIOError);
    }

    const dictionary uniform(IStringStream("rootDensity constant 1;")());
    const autoPtr<Function1<scalar>> density
    (
        Function1<scalar>::New
        (
            "rootDensity",
            dict.found("rootDensity") ? dict : uniform
        )
    );

    const polyPatch& patch = mesh_.boundaryMesh()[patchi];
    const planSurface surface(patch, ground_.up());
    const scalarField depth
    (
        surface.elevation(mesh_.points()) - (mesh_.points() & ground_.up())
    );

    DynamicList<label> cells;
    DynamicList<scalar> parts;

    forAll(mesh_.cells(), celli)
    {
        scalar top = GREAT;
        scalar bottom = -GREAT;
        for (const label pointi : mesh_.cellPoints()[celli])
        {
            top = min(top, depth[pointi]);
            bottom = max(bottom, depth[pointi]);
        }

        const scalar from = max(top, scalar(0));
        const scalar to = min(bottom, rootDepth_);

        if (from < to)
        {
            const scalar roots = density->integrate(from, to);

            if (!std::isfinite(roots) || roots < 0)
            {
                FatalIOErrorInFunction(dict)
                    << "rootDensity amounts to " << roots << " between "
                    << from << " and " << to << " m of depth; it must be >= 0"
                    << exit(FatalIOError);
            }

            cells.append(celli);
            parts.append(roots*mesh_.V()[celli]/(bottom - top));
        }
    }

    cells_.transfer(cells);
    area_.transfer(parts);

    const scalar sum = gSum(area_);

    if (sum <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "No cell of the mesh holds roots: rootDepth " << rootDepth_
            << " m below patch " << patchName << nl << exit(FatalIOError);
    }

    area_ *= gSum(scalarField(patch.faceAreas() & ground_.up()))/sum;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::waterSources::transpiration::add
(
    coupledMatrix& matrix,
    const label
)
{
    forAll(cells_, i)
    {
        const label celli = cells_[i];
        const soilTable::state& s = soil_.cellState(celli);

        const share taken =
            share{stress_.value(s.head), stress_.slope(s.head)*s.dHead}
           *supply(soil_.table(celli), s);

        addInflow
        (
            matrix,
            celli,
            -demand_*area_[i]*taken.value,
            -demand_*area_[i]*taken.derivative
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::waterSources::transpiration::transpiration
(
    const dictionary& dict,
    const groundSurface& ground,
    const subsurfaceFlow& soil
)
:
    waterSource(dict, ground, soil),
    rate_("rate", dict),
    rootDepth_
    (
        readChecked
        (
            dict,
            "rootDepth",
            [](const scalar x) { return x > 0; },
            "rootDepth > 0 [m]"
        )
    ),
    stress_(dict),
    cells_(),
    area_(),
    demand_(0)
{
    checkKeys
    (
        dict,
        {
            "type", "rate", "groundPatch", "rootDensity", "rootDepth",
            "stressHeads"
        },
        {"rate", "rateCoeffs", "rootDensity", "rootDensityCoeffs"}
    );

    distribute(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::waterSources::transpiration::beginStep
(
    const scalar t1,
    const scalar t2,
    const scalar stretch
)
{
    demand_ = stretch*rate_.amount(t1, t2);
}


void Foam::waterSources::transpiration::writeInfo(Ostream& os) const
{
    os  << "    " << name_ << ": transpiration by roots in "
        << returnReduce(cells_.size(), sumOp<label>()) << " cells down to "
        << rootDepth_ << " m, plan area " << gSum(area_)
        << " m2, stress heads " << stress_.heads() << " m" << nl;
}

// ************************************************************************* //
