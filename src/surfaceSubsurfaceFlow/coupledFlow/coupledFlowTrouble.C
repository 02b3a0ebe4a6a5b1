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

#include "coupledFlow.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::coupledFlow::place(const label unknown) const
{
    // 1e6 kPa [m]
    const scalar ovenDry = -1e5;

    OStringStream os;

    if (unknown >= start_)
    {
        const label i = unknown - start_;
        const label facei = ground_.faces()[i];

        os  << "ground face " << i << " at " << mesh_.faceCentres()[facei]
            << ", surface head " << water_->head()[i] << " m";
        if (soil_)
        {
            os  << ", soil " << soil_->soilName(mesh_.faceOwner()[facei]);
        }
    }
    else
    {
        os  << "cell " << unknown << " at " << mesh_.cellCentres()[unknown]
            << ", soil " << soil_->soilName(unknown) << ", pressure head "
            << soil_->cellState(unknown).head << " m";

        if (soil_->cellState(unknown).head < ovenDry)
        {
            os  << " (oven-dry: is more drawn from there than it holds?)";
        }
    }

    return os.str();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::coupledFlow::trouble() const
{
    const scalarField residual
    (
        performance_.converged
      ? unknowns_ - unknownsOld_
      : tmp<scalarField>(matrix_->residual())
    );

    // The unknown to name: one that fell too dry, else the largest residual, or
    // change if there is none
    label worst = performance_.dried ? soil_->driedCell() : -1;
    scalar largest = worst >= 0 ? mag(residual[worst]) : -1;

    if (!performance_.dried)
    {
        forAll(residual, i)
        {
            if (!(mag(residual[i]) <= largest))
            {
                largest = mag(residual[i]);
                worst = i;
            }
        }
    }

    // The processor that has it says so
    const scalar overall = returnReduce(largest, maxOp<scalar>());
    const label speaker = returnReduce
    (
        largest >= overall ? Pstream::myProcNo() : labelMax,
        minOp<label>()
    );

    stringList places(Pstream::nProcs());
    if (Pstream::myProcNo() == speaker && worst >= 0)
    {
        places[speaker] = place(worst);
    }
    Pstream::gatherList(places);
    Pstream::scatterList(places);

    OStringStream os;
    if (performance_.dried)
    {
        os  << "drier than the curves of its soil reach: ";
    }
    else if (!performance_.converged)
    {
        if (performance_.singular)
        {
            os  << "the linear system has no solution, ";
        }
        os  << "residual " << performance_.finalResidual
            << " m3, limit " << performance_.limit << " m3, sum "
            << performance_.imbalance << " m3, limit "
            << performance_.imbalanceLimit << " m3, the largest part, " << overall << " m3, in ";
    }
    os  << places[speaker].c_str();

    if (Pstream::parRun())
    {
        os  << " on processor " << speaker;
    }

    return os.str();
}


void Foam::coupledFlow::stop(const label nCuts) const
{
    OStringStream why;
    why << "which " << nCuts << " cuts brought to " << step_.length() << " s";
    stop(string(why.str()));
}


void Foam::coupledFlow::stop(const string& why) const
{
    OStringStream what;
    what<< "No solution of the step from t = " << step_.start << " s, "
        << why.c_str();
    stopRun(string(what.str()));
}


void Foam::coupledFlow::stopRun(const string& why) const
{
    FatalErrorInFunction
        << why.c_str() << ": " << trouble().c_str()
        << ". What was written before is complete." << exit(FatalError);
}

// ************************************************************************* //
