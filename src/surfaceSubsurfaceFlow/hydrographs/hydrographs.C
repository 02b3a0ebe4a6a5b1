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

#include "hydrographs.H"
#include "readChecked.H"
#include "planPolyline.H"
#include "processorFaPatch.H"
#include "restartState.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::hydrographs::gauge::add(const label place, const label count)
{
    if (count)
    {
        places.append(place);
        counts.append(count);
    }
}


void Foam::hydrographs::addOutlets()
{
    const overlandFlow& overland = water_.overland();
    const faBoundaryMesh& patches = overland.aMesh().boundary();

    forAll(patches, patchi)
    {
        if (overland.isOutlet(patchi))
        {
            gauge outlet;
            outlet.name = patches[patchi].name();

            forAll(patches[patchi].edgeFaces(), i)
            {
                outlet.add(water_.stepVolume().groundEdge(patchi, i), 1);
            }

            gauges_.append(outlet);
        }
    }
}


void Foam::hydrographs::addLines(const dictionary& dict)
{
    const overlandFlow& overland = water_.overland();
    const groundPlan plan
    (
        overland.aMesh().mesh(),
        overland.aMesh().faceLabels(),
        overland.up()
    );

    for (const entry& e : dict)
    {
        const word& name = e.keyword();

        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << name << " is no dictionary: a line has points"
                << exit(FatalIOError);
        }

        checkKeys(e.dict(), {"points"});

        for (const gauge& other : gauges_)
        {
            if (other.name == name)
            {
                FatalIOErrorInFunction(dict)
                    << name << " is the name of an outlet; give the line"
                    << " another one" << exit(FatalIOError);
            }
        }

        gauge line;
        line.name = name;
        setPlaces(line, planPolyline(e.dict(), plan));

        if (!returnReduce(line.places.size(), sumOp<label>()))
        {
            FatalIOErrorInFunction(e.dict())
                << "points: the line passes between no two face centres of"
                << " the ground, so that nothing can cross it"
                << exit(FatalIOError);
        }

        gauges_.append(line);
    }
}


void Foam::hydrographs::setPlaces
(
    gauge& line,
    const planPolyline& points
) const
{
    // An outlet's water goes this share of the way beyond the rim, for lines
    // that lie on it
    const scalar beyond = 1e-3;

    const overlandFlow& overland = water_.overland();
    const planGeometry& geometry = overland.geometry();
    const faMesh& aMesh = overland.aMesh();
    const stepVolumes& volumes = water_.stepVolume();

    const auto centre = [&](const label facei)
    {
        return geometry.plan
        (
            aMesh.mesh().faceCentres()[aMesh.faceLabels()[facei]]
        );
    };

    forAll(geometry.edges(), edgei)
    {
        line.add
        (
            water_.addressing().edgeCoupling(edgei),
            points.crossings
            (
                centre(aMesh.owner()[edgei]),
                centre(aMesh.neighbour()[edgei])
            )
        );
    }

    forAll(aMesh.boundary(), patchi)
    {
        const faPatch& patch = aMesh.boundary()[patchi];
        const auto* processor = isA<processorFaPatch>(patch);

        // What passes between processors counts on one of them
        if (processor ? !processor->master() : !overland.isOutlet(patchi))
        {
            continue;
        }

        forAll(patch.edgeFaces(), i)
        {
            const vector2D from(centre(patch.edgeFaces()[i]));
            const vector2D& delta = geometry.patchEdges()[patchi][i].delta;

            line.add
            (
                volumes.groundEdge(patchi, i),
                points.crossings
                (
                    from,
                    from + (processor ? 1 : 1 + beyond)*delta
                )
            );
        }
    }
}


Foam::wordList Foam::hydrographs::columns() const
{
    DynamicList<word> names;
    names.append("time");
    names.append("dt");

    for (const gauge& g : gauges_)
    {
        names.append(g.name + ".discharge");
        names.append(g.name + ".volume");
    }

    return wordList(names);
}


void Foam::hydrographs::keep()
{
    dictionary sums;
    for (const gauge& g : gauges_)
    {
        restartState::set(sums, g.name, g.volume);
    }

    state_.set("hydrographs", sums);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::hydrographs::hydrographs(const coupledFlow& water, dictionary& state)
:
    water_(water),
    state_(state),
    gauges_(),
    table_()
{
    if (!water.hasOverland())
    {
        return;
    }

    addOutlets();

    const dictionary& properties = water.overland().properties();
    if (properties.found("hydrographs"))
    {
        addLines(properties.subDict("hydrographs"));
    }

    if (gauges_.size())
    {
        const dictionary kept(state.subOrEmptyDict("hydrographs"));

        for (gauge& g : gauges_)
        {
            kept.readIfPresent(g.name, g.volume);
        }

        keep();
        table_.reset
        (
            new stepTable(water.mesh().time(), "hydrographs", columns())
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::hydrographs::update()
{
    if (!table_)
    {
        return;
    }

    scalarList moved(gauges_.size(), Zero);

    forAll(gauges_, i)
    {
        const gauge& g = gauges_[i];

        forAll(g.places, k)
        {
            moved[i] += g.counts[k]*water_.stepVolume().volume(g.places[k]);
        }
    }

    Pstream::listCombineGather(moved, plusEqOp<scalar>());
    Pstream::listCombineScatter(moved);

    const Time& runTime = water_.mesh().time();

    DynamicList<stepTable::field> row;
    row.append(runTime.value());
    row.append(runTime.deltaTValue());

    forAll(gauges_, i)
    {
        gauges_[i].volume += moved[i];
        row.append(moved[i]/runTime.deltaTValue());
        row.append(gauges_[i].volume);
    }

    table_->write(row);
    keep();
}

// ************************************************************************* //
