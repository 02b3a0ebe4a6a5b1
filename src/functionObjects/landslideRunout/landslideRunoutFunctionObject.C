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

#include "landslideRunoutFunctionObject.H"
#include "addToRunTimeSelectionTable.H"
#include "errorsAreFatal.H"
#include "fvMesh.H"
#include "Time.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(landslideRunoutFunctionObject, 0);
    addToRunTimeSelectionTable
    (
        functionObject,
        landslideRunoutFunctionObject,
        dictionary
    );
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::optional<Foam::scalar>
Foam::functionObjects::landslideRunoutFunctionObject::factorOfSafety() const
{
    const word& source = runout_->stabilityName();
    const wordList results(objectResultEntries(source));

    if
    (
        results.found("factorOfSafety")
     && results.found("factorOfSafetyTime")
     && getObjectResult<scalar>(source, "factorOfSafetyTime") == time_.value()
    )
    {
        return getObjectResult<scalar>(source, "factorOfSafety");
    }

    return runout_->writtenFactorOfSafety();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::landslideRunoutFunctionObject::
landslideRunoutFunctionObject
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    runout_(nullptr),
    atOutputTimes_(true)
{
    const errorsAreFatal scope;

    read(dict);

    // A solver calls execute() after its first step only
    if (!postProcess && dict.getOrDefault("executeAtStart", true))
    {
        runout_->execute(factorOfSafety());
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::landslideRunoutFunctionObject::read
(
    const dictionary& dict
)
{
    fvMeshFunctionObject::read(dict);

    runout_.reset(new landslideRunout(name(), time_, &mesh_, dict));

    // An executeControl alone leaves writeControl at its default, every step,
    // and OpenFOAM executes before it writes
    const word control(dict.getOrDefault<word>("executeControl", "writeTime"));
    atOutputTimes_ =
        !postProcess && (control == "writeTime" || control == "outputTime");

    return true;
}


bool Foam::functionObjects::landslideRunoutFunctionObject::execute()
{
    if (!atOutputTimes_ || time_.writeTime())
    {
        runout_->execute(factorOfSafety());
    }

    return true;
}


bool Foam::functionObjects::landslideRunoutFunctionObject::write()
{
    return true;
}

// ************************************************************************* //
