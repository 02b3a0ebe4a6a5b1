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
    checkWaterBalance

Description
    Both sides of the water balance from the fields of a finished case in which
    every step was written, without the solver's own sums: storages from psi
    and h, rain from the dictionary's rate over the plan area, outflow by
    Manning's formula from h at the outlet, infiltration from qExchange.

    Prints a line a time: time, rain, infiltration, surfaceOutflow,
    surfaceStorage, subsurfaceStorage [m3], separated by tabs.

    It knows the case it is written for: one outlet with a given slope, rain as
    a hyetograph, a horizontal plan in x and y, soil closed but for the ground.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "areaFields.H"
#include "faMesh.H"
#include "IOmanip.H"
#include "unsaturatedSoils.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Depth of rain [m] from the start to a time, of pairs (end rate)
static scalar rainDepth
(
    const List<Tuple2<scalar, scalar>>& intervals,
    const scalar t
)
{
    scalar depth = 0;
    scalar start = 0;

    for (const auto& interval : intervals)
    {
        depth +=
            interval.second()*max(min(t, interval.first()) - start, scalar(0));
        start = interval.first();
    }

    return depth;
}


//- Length of the outlet's edges in the plan, by the face they belong to
static scalarField outletLength
(
    const faMesh& aMesh,
    const faPatch& outlet
)
{
    scalarField length(aMesh.nFaces(), Zero);

    forAll(outlet, i)
    {
        vector edge(aMesh.edges()[outlet.start() + i].vec(aMesh.points()));
        edge.z() = 0;
        length[outlet.edgeFaces()[i]] += mag(edge);
    }

    return length;
}


int main(int argc, char *argv[])
{
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const faMesh aMesh(mesh);
    const unsaturatedSoils soils(mesh);

    const IOdictionary overland
    (
        IOobject
        (
            "overlandProperties",
            runTime.constant(),
            mesh,
            IOobject::MUST_READ
        )
    );
    const scalar manning = overland.get<scalar>("manning");
    const scalar slope =
        overland.subDict("outlets").subDict("outlet").get<scalar>("slope");
    const List<Tuple2<scalar, scalar>> rain
    (
        overland.subDict("rainfall").lookup("values")
    );

    // Plan areas of the ground faces
    scalarField planArea(aMesh.nFaces());
    forAll(planArea, facei)
    {
        planArea[facei] =
            mag(aMesh.faces()[facei].areaNormal(aMesh.points()).z());
    }

    const scalarField length
    (
        outletLength
        (
            aMesh,
            aMesh.boundary()[aMesh.boundary().findPatchID("outlet")]
        )
    );

    scalar infiltration = 0;
    scalar outflow = 0;
    scalar before = 0;

    Info<< setprecision(17);

    for (const instant& now : runTime.times())
    {
        if (now.name() == runTime.constant() || now.value() <= 0)
        {
            continue;
        }

        runTime.setTime(now, 0);
        const scalar dt = now.value() - before;
        before = now.value();

        const auto readFrom = [&](const word& name)
        {
            return IOobject
            (
                name,
                runTime.timeName(),
                aMesh.thisDb(),
                IOobject::MUST_READ,
                IOobject::NO_WRITE,
                false
            );
        };

        const volScalarField psi
        (
            IOobject
            (
                "psi",
                runTime.timeName(),
                mesh,
                IOobject::MUST_READ,
                IOobject::NO_WRITE,
                false
            ),
            mesh
        );
        const areaScalarField h(readFrom("h"), aMesh);
        const areaScalarField qExchange(readFrom("qExchange"), aMesh);

        scalar subsurface = 0;
        forAll(psi, celli)
        {
            subsurface +=
                soils.ofCell(celli).storage(psi[celli])*mesh.V()[celli];
        }

        scalar surface = 0;
        forAll(h, facei)
        {
            surface += h[facei]*planArea[facei];
            infiltration += dt*qExchange[facei]*planArea[facei];
            outflow +=
                dt*length[facei]*std::sqrt(slope)/manning
               *std::pow(h[facei], 5.0/3.0);
        }

        Info<< now.value() << token::TAB
            << rainDepth(rain, now.value())*sum(planArea) << token::TAB
            << infiltration << token::TAB
            << outflow << token::TAB
            << surface << token::TAB
            << subsurface << nl;
    }

    Info<< nl << "End" << nl << endl;

    return 0;
}

// ************************************************************************* //
