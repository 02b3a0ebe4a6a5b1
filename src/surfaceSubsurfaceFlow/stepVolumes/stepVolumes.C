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

#include "stepVolumes.H"
#include "faMesh.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Operation>
void Foam::stepVolumes::forAllPlaces(const Operation& operation) const
{
    const coupledLduMesh::addressing& couplings = lduMesh_.couplings();

    forAll(couplings.first, k)
    {
        operation(k, couplings.first[k], couplings.second[k]);
    }
    forAll(unknowns_, i)
    {
        operation(meshStart_ + i, unknowns_[i], -1);
    }
}


Foam::List<Foam::scalarField> Foam::stepVolumes::acrossPlaces
(
    const scalarField& values
) const
{
    List<scalarField> here(interfacePlaces_.size());

    forAll(here, i)
    {
        here[i] = scalarField(values, interfacePlaces_[i]);
    }

    return lduMesh_.across(here);
}


void Foam::stepVolumes::agree(scalarField& values) const
{
    const List<scalarField> there(acrossPlaces(values));

    forAll(interfacePlaces_, i)
    {
        forAll(interfacePlaces_[i], j)
        {
            scalar& here = values[interfacePlaces_[i][j]];
            here = min(here, there[i][j]);
        }
    }
}


void Foam::stepVolumes::setMaxChanges
(
    const scalarField& content,
    const scalarField& room
)
{
    // Multiple of what flowed: at the foot of an unsaturated front changes reach
    // this sum
    const scalar withRoom = 16;

    const auto share = [&](const label i)
    {
        return room[i] < content[i] ? max(room[i], 0)/content[i] : 1;
    };

    forAllPlaces
    (
        [&](const label place, const label first, const label second)
        {
            const scalar roomy =
                second < 0 ? share(first) : min(share(first), share(second));

            maxChange_[place] =
                withRoom*sqr(roomy)*mag(history_[place]);
        }
    );

    agree(maxChange_);
}


Foam::tmp<Foam::scalarField> Foam::stepVolumes::limiters
(
    const scalar carry,
    const scalarField& content,
    const scalarField& room
) const
{
    // Share of the content or room that may be used up
    const scalar share = 0.5;

    scalarField in(content.size(), Zero);
    scalarField out(content.size(), Zero);

    forAllPlaces
    (
        [&](const label place, const label first, const label second)
        {
            const scalar volume = carry*history_[place];
            (volume > 0 ? out : in)[first] += mag(volume);
            if (second >= 0)
            {
                (volume > 0 ? in : out)[second] += mag(volume);
            }
        }
    );

    // From here on the limiters of what comes in and goes out
    forAll(in, i)
    {
        const scalar gain = in[i] - out[i];
        const scalar loss = share*content[i];
        const scalar space = share*room[i];

        const scalar inLimit = gain > space ? (out[i] + space)/in[i] : 1;
        out[i] = -gain > loss ? (in[i] + loss)/out[i] : 1;
        in[i] = inLimit;
    }

    auto tresult = tmp<scalarField>::New(history_.size(), 1);
    scalarField& result = tresult.ref();

    forAllPlaces
    (
        [&](const label place, const label first, const label second)
        {
            const bool outward = history_[place] > 0;

            result[place] = (outward ? out : in)[first];
            if (second >= 0)
            {
                result[place] =
                    min(result[place], (outward ? in : out)[second]);
            }
        }
    );

    agree(result);

    for (const label place : prescribed_)
    {
        result[place] = 0;
    }

    return tresult;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stepVolumes::stepVolumes
(
    const coupledLduMesh& lduMesh,
    const fvMesh& mesh,
    const faMesh* aMesh,
    const label nCells
)
:
    lduMesh_(lduMesh),
    meshStart_(lduMesh.couplings().first.size()),
    groundStarts_(aMesh ? aMesh->boundary().size() : 0),
    nInternalFaces_(mesh.nInternalFaces()),
    unknowns_(),
    interfacePlaces_(lduMesh.rawInterfaces().size()),
    prescribed_(),
    length_(0),
    lastLength_(0),
    carried_(),
    maxChange_(),
    rate_(),
    volume_(),
    history_()
{
    forAll(interfacePlaces_, i)
    {
        interfacePlaces_[i].setSize(lduMesh.interfaceCells(i).size());
    }

    const auto addSlot = [&]
    (
        const coupledLduMesh::interfaceSlot& slot,
        const label firstPlace,
        const label size
    )
    {
        for (label i = 0; slot.index >= 0 && i < size; ++i)
        {
            interfacePlaces_[slot.index][slot.start + i] = firstPlace + i;
        }
    };

    DynamicList<label> unknowns;

    if (nCells)
    {
        for (const polyPatch& patch : mesh.boundaryMesh())
        {
            addSlot
            (
                lduMesh.meshSlot(patch.index()),
                meshStart_ + unknowns.size(),
                patch.size()
            );
            unknowns.append(patch.faceCells());
        }
    }

    forAll(groundStarts_, patchi)
    {
        const labelUList& faces = aMesh->boundary()[patchi].edgeFaces();

        groundStarts_[patchi] = meshStart_ + unknowns.size();
        addSlot
        (
            lduMesh.groundSlot(patchi),
            groundStarts_[patchi],
            faces.size()
        );
        for (const label facei : faces)
        {
            unknowns.append(nCells + facei);
        }
    }

    unknowns_.transfer(unknowns);

    const label nPlaces = meshStart_ + unknowns_.size();
    carried_.setSize(nPlaces, Zero);
    maxChange_.setSize(nPlaces, Zero);
    rate_.setSize(nPlaces, Zero);
    volume_.setSize(nPlaces, Zero);
    history_.setSize(nPlaces, Zero);
    prescribed_.resize(nPlaces);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::stepVolumes::begin
(
    const scalar length,
    const scalar carry,
    const scalar ratio,
    const scalarField& content,
    const scalarField& room
)
{
    length_ = length;
    lastLength_ = length/ratio;

    if (carry > 0)
    {
        carried_ = carry*limiters(carry, content, room);
        setMaxChanges(content, room);
    }
    else
    {
        carried_ = Zero;
    }
}


void Foam::stepVolumes::end()
{
    const scalar within = 4;

    forAll(history_, place)
    {
        const scalar size = length_*mag(rate_[place]);
        const scalar along = rate_[place] < 0 ? -1 : 1;

        history_[place] =
            along*min(max(along*volume_[place], size/within), within*size);
    }
}


void Foam::stepVolumes::matchHistory()
{
    const scalar roundOff = 1e-9;

    const List<scalarField> there(acrossPlaces(history_));

    forAll(interfacePlaces_, i)
    {
        forAll(interfacePlaces_[i], j)
        {
            scalar& here = history_[interfacePlaces_[i][j]];

            if (mag(here + there[i][j]) > roundOff*mag(here - there[i][j]))
            {
                here = 0;
            }
        }
    }
}

// ************************************************************************* //
