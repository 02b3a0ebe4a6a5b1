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

#include "soilVariation.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::volScalarField> Foam::soilVariation::readField
(
    const fvMesh& mesh,
    const word& name,
    const dimensionSet& dimensions
)
{
    auto tfield =
        tmp<volScalarField>::New
        (
            IOobject
            (
                name,
                mesh.time().findInstance
                (
                    mesh.dbDir(),
                    name,
                    IOobject::MUST_READ
                ),
                mesh,
                IOobject::MUST_READ,
                IOobject::NO_WRITE,
                false
            ),
            mesh
        );

    if (tfield().dimensions() != dimensions)
    {
        FatalErrorInFunction
            << "The field " << name << " of the soils has the dimensions "
            << tfield().dimensions() << " in " << tfield().objectPath()
            << "; they must be " << dimensions << exit(FatalError);
    }

    Info<< "    " << name << " of the cells from "
        << tfield().instance()/tfield().name() << ": "
        << gMin(tfield().primitiveField()) << " to "
        << gMax(tfield().primitiveField()) << nl;

    return tfield;
}


void Foam::soilVariation::refuse
(
    const volScalarField& field,
    const label celli,
    const string& range
)
{
    FatalErrorInFunction
        << "The field " << field.name() << " is " << field[celli]
        << " in cell " << celli << " at " << field.mesh().C()[celli]
        << ", outside its range: " << range.c_str() << nl
        << "    File " << field.objectPath() << exit(FatalError);
}


void Foam::soilVariation::setConductivity
(
    const fvMesh& mesh,
    const labelList& cellSoil,
    const PtrList<soilHydraulics>& soils,
    const boolList& uses
)
{
    const tmp<volScalarField> tKs(readField(mesh, "Ks", dimVelocity));

    conductivity_.resize(mesh.nCells(), 1);

    forAll(conductivity_, celli)
    {
        if (uses[cellSoil[celli]])
        {
            if (tKs()[celli] <= 0)
            {
                refuse(tKs(), celli, "Ks > 0 [m/s]");
            }

            conductivity_[celli] = tKs()[celli]/soils[cellSoil[celli]].Ks();
        }
    }
}


void Foam::soilVariation::setWaterContents
(
    const fvMesh& mesh,
    const labelList& cellSoil,
    const PtrList<soilHydraulics>& soils,
    const boolList& usesThetaS,
    const boolList& usesThetaR
)
{
    tmp<volScalarField> tthetaS;
    tmp<volScalarField> tthetaR;

    if (usesThetaS.found(true))
    {
        tthetaS = readField(mesh, "thetaS", dimless);
    }
    if (usesThetaR.found(true))
    {
        tthetaR = readField(mesh, "thetaR", dimless);
    }

    factor_.resize(mesh.nCells(), 1);
    offset_.resize(mesh.nCells(), 0);

    forAll(factor_, celli)
    {
        const label soili = cellSoil[celli];
        const waterRetentionModel& curve = soils[soili].retention();

        const scalar thetaS =
            usesThetaS[soili] ? tthetaS()[celli] : curve.thetaS();
        const scalar thetaR =
            usesThetaR[soili] ? tthetaR()[celli] : curve.thetaR();

        if (usesThetaS[soili] && (thetaS <= 0 || thetaS > 1))
        {
            refuse(tthetaS(), celli, "0 < thetaS <= 1");
        }
        if (thetaR < 0 || thetaR >= thetaS)
        {
            refuse
            (
                usesThetaR[soili] ? tthetaR() : tthetaS(),
                celli,
                "0 <= thetaR < thetaS, with thetaR " + Foam::name(thetaR)
              + " and thetaS " + Foam::name(thetaS)
            );
        }

        factor_[celli] = (thetaS - thetaR)/(curve.thetaS() - curve.thetaR());
        offset_[celli] = thetaR - factor_[celli]*curve.thetaR();
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::soilVariation::soilVariation
(
    const fvMesh& mesh,
    const soilZones& zones,
    const PtrList<soilHydraulics>& soils
)
:
    conductivity_(),
    offset_(),
    factor_()
{
    const wordList names({"Ks", "thetaS", "thetaR"});
    List<boolList> uses(names.size(), boolList(soils.size(), false));

    forAll(soils, soili)
    {
        const dictionary& dict = zones.soilDict(soili).subDict("hydraulic");

        for (const word& fieldName : fieldNames(dict))
        {
            const label i = names.find(fieldName);

            if (i < 0)
            {
                FatalIOErrorInFunction(dict)
                    << "Entry 'fields' of " << dict.name() << " holds "
                    << fieldName << ". Valid names: " << names << nl
                    << exit(FatalIOError);
            }

            uses[i][soili] = true;
        }
    }

    if (uses[0].found(true))
    {
        setConductivity(mesh, zones.cellSoil(), soils, uses[0]);
    }
    if (uses[1].found(true) || uses[2].found(true))
    {
        setWaterContents(mesh, zones.cellSoil(), soils, uses[1], uses[2]);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::soilVariation::fieldNames(const dictionary& dict)
{
    return dict.getOrDefault<wordList>("fields", wordList());
}

// ************************************************************************* //
