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

#include "slopeStabilityFunctionObject.H"
#include "addToRunTimeSelectionTable.H"
#include "errorsAreFatal.H"
#include "fvMesh.H"
#include "Time.H"

// * * * * * * * * * * * * * Static Data Members  * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(slopeStabilityFunctionObject, 0);
    addToRunTimeSelectionTable
    (
        functionObject,
        slopeStabilityFunctionObject,
        dictionary
    );
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::slopeStabilityFunctionObject::search()
{
    const std::optional<scalar> factorOfSafety
    (
        safety_->execute(time_.timeName(time_.startTime().value()))
    );

    if (factorOfSafety)
    {
        setResult("factorOfSafety", *factorOfSafety);
        setResult("factorOfSafetyTime", time_.value());
    }
}


// * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * * //

Foam::functionObjects::slopeStabilityFunctionObject::
slopeStabilityFunctionObject
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    safety_(nullptr),
    atOutputTimes_(true)
{
    const errorsAreFatal scope;

    read(dict);

    // A solver calls execute() after its first step only
    if (!postProcess && dict.getOrDefault("executeAtStart", true))
    {
        search();
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

bool Foam::functionObjects::slopeStabilityFunctionObject::read
(
    const dictionary& dict
)
{
    fvMeshFunctionObject::read(dict);

    safety_.reset(new slopeSafety(name(), mesh_, dict));

    // An executeControl alone leaves writeControl at its default, every step,
    // and OpenFOAM executes before it writes
    const word control(dict.getOrDefault<word>("executeControl", "writeTime"));
    atOutputTimes_ =
        !postProcess && (control == "writeTime" || control == "outputTime");

    return true;
}


bool Foam::functionObjects::slopeStabilityFunctionObject::execute()
{
    if (!atOutputTimes_ || time_.writeTime())
    {
        search();
    }

    return true;
}


bool Foam::functionObjects::slopeStabilityFunctionObject::write()
{
    return true;
}

// ************************************************************************* //
