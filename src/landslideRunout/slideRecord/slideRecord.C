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

#include "slideRecord.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "outputFolder.H"
#include "pointTable.H"
#include "slideFrame.H"
#include "vtpPointSetWriter.H"
#include "mpmRun.H"

#include <fstream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::pointTable Foam::slideRecord::table(const mpm::Run& run) const
{
    // Only the master has the values
    const label n = run.master() ? run.nPoints() : 0;

    const auto vectors =
        [&](const word& name)
        {
            const std::vector<double> values(run.field(name));
            vectorField result(n);
            forAll(result, i)
            {
                result[i] =
                    vector(values[3*i], values[3*i + 1], values[3*i + 2]);
            }
            return result;
        };

    const auto toSpace =
        [&](vectorField values)
        {
            for (vector& v : values)
            {
                v = frame_.directionToSpace(v);
            }
            return values;
        };

    pointTable table(frame_.toSpace(vectors("position"))());

    for (const word& name : wordList({"velocity", "displacement"}))
    {
        table.add(name, toSpace(vectors(name)));
    }

    // The engine's order is xx yy zz xy yz zx
    const std::vector<double> s(run.field("sigma"));
    symmTensorField sigma(n);
    forAll(sigma, i)
    {
        const double* c = &s[6*i];
        sigma[i] = frame_.stressToSpace
        (
            symmTensor(c[0], c[3], c[5], c[1], c[4], c[2])
        );
    }
    table.add("sigma", sigma);

    const wordList scalars
    ({
        "cohesionIntercept", "porePressure", "rho", "frictionAngle",
        "equivalentPlasticStrain", "zone"
    });

    for (const word& name : scalars)
    {
        const std::vector<double> values(run.field(name));
        scalarField field(n);
        std::copy(values.begin(), values.end(), field.begin());
        table.add(name, field);
    }

    return table;
}


Foam::vectorField Foam::slideRecord::impulses(const mpm::Run& run) const
{
    vectorField result(label(run.wallLoads().size()));

    forAll(result, i)
    {
        const mpm::Point3& j = run.wallLoads()[i].impulse;
        result[i] = frame_.directionToSpace(vector(j[0], j[1], j[2]));
    }

    return result;
}


Foam::word Foam::slideRecord::pointFile(const scalar time)
{
    return "points_" + timeTable::text(time) + ".vtp";
}


void Foam::slideRecord::writeSeries() const
{
    const fileName file(folder_/"points.pvd");
    const fileName unfinished(file + ".unfinished");

    {
        std::ofstream os(unfinished);

        os  << "<?xml version='1.0'?>\n"
            << "<VTKFile type='Collection' version='0.1'>\n<Collection>\n";

        for (const scalar time : pointTimes_)
        {
            os  << "<DataSet timestep='" << timeTable::text(time)
                << "' file='" << pointFile(time) << "'/>\n";
        }

        os  << "</Collection>\n</VTKFile>\n";
    }

    replaceByComplete(unfinished, file);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slideRecord::slideRecord
(
    const fileName& folder,
    const slideFrame& frame
)
:
    folder_(folder),
    frame_(frame),
    runout_
    (
        folder/"runout.dat",
        {
            "time", "kineticEnergy", "maxDisplacement", "front", "crest",
            "activePoints"
        }
    ),
    energy_
    (
        folder/"energy.dat",
        {
            "time", "kinetic", "elastic", "potential", "plastic", "friction",
            "impact", "transfers", "integration", "remainder"
        }
    ),
    pointTimes_(),
    loads_(),
    lastImpulse_(),
    lastTime_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::slideRecord::reaches(const scalar time) const
{
    return runout_.found(time) && isFile(folder_/pointFile(time));
}


void Foam::slideRecord::goOnFrom(const scalar time)
{
    if (!Pstream::master())
    {
        return;
    }

    runout_.removeAfter(time);
    energy_.removeAfter(time);
    if (energy_.empty())
    {
        rm(folder_/"energy.dat");
    }

    // The point files that are there, by the times in their names
    DynamicList<scalar> times;
    for (const fileName& name : readDir(folder_, fileName::FILE))
    {
        const auto underscore = name.find('_');

        if (name.ext() == "vtp" && underscore != std::string::npos)
        {
            times.append(std::stod(name.lessExt().substr(underscore + 1)));
        }
    }
    sort(times);

    for (const scalar t : times)
    {
        if (t <= timeTable::rounded(time))
        {
            pointTimes_.append(t);
        }
        else
        {
            rm(folder_/pointFile(t));
        }
    }
}


void Foam::slideRecord::startLoads(const mpm::Run& run)
{
    loads_.clear();
    loads_.setSize(run.wallLoads().size());

    forAll(loads_, i)
    {
        loads_.set
        (
            i,
            new timeTable
            (
                folder_/("force_" + run.wallLoads()[i].wall + ".dat"),
                {
                    "time", "Fx", "Fy", "Fz", "impulseX", "impulseY",
                    "impulseZ", "maxForce", "maxForceTime"
                }
            )
        );
        loads_[i].removeAfter(run.stepNumber() ? run.time() : -1);
    }

    lastImpulse_ = impulses(run);
    lastTime_ = run.time();
}


void Foam::slideRecord::add(const mpm::Diagnostics& d, const mpm::Run& run)
{
    const vectorField impulse(impulses(run));
    const scalar interval = d.time - lastTime_;

    forAll(loads_, i)
    {
        const mpm::WallLoad& load = run.wallLoads()[i];
        const vector change(impulse[i] - lastImpulse_[i]);
        DynamicList<string> row;

        for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
        {
            row.append
            (
                interval > 0 ? timeTable::text(change[cmpt]/interval) : string()
            );
        }
        for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
        {
            row.append(timeTable::text(impulse[i][cmpt]));
        }
        row.append(timeTable::text(load.maxForce));
        row.append(timeTable::text(load.maxForceTime));
        loads_[i].set(d.time, stringList(row));
    }

    lastImpulse_ = impulse;
    lastTime_ = d.time;


    runout_.set
    (
        d.time,
        {
            timeTable::text(d.kineticEnergy),
            timeTable::text(d.maxDisplacement),
            d.movedPoints ? timeTable::text(d.front) : string(),
            timeTable::text(d.crest),
            Foam::name(label(d.activePoints))
        }
    );

    if (d.energyAccount)
    {
        stringList energies;
        for
        (
            const scalar energy :
            {
                d.kineticEnergy + d.affineKineticEnergy, d.elasticEnergy,
                d.potentialEnergy, d.plasticEnergy, d.frictionEnergy,
                d.impactEnergy, d.transferEnergy, d.integrationEnergy,
                d.energyRemainder
            }
        )
        {
            energies.append(timeTable::text(energy));
        }
        energy_.set(d.time, energies);
    }
}


void Foam::slideRecord::write(const mpm::Run& run)
{
    const pointTable points(table(run));

    if (!run.master())
    {
        return;
    }

    runout_.write();
    if (!energy_.empty())
    {
        energy_.write();
    }
    forAll(loads_, i)
    {
        loads_[i].write();
    }

    pointSetWriters::vtpPointSetWriter().write
    (
        folder_/pointFile(run.time()),
        points,
        run.time()
    );

    const scalar time = timeTable::rounded(run.time());

    if (pointTimes_.empty() || pointTimes_.last() < time)
    {
        pointTimes_.append(time);
    }
    writeSeries();
}


void Foam::slideRecord::writeFinal(const mpm::Run& run) const
{
    const pointTable points(table(run));

    if (run.master())
    {
        pointSetWriters::vtpPointSetWriter().write
        (
            folder_/"final.vtp",
            points,
            run.time()
        );
    }
}

// ************************************************************************* //
