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

#include "rainfall.H"
#include "uniformRain.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::rainfall> Foam::rainfall::New
(
    const word& entryName,
    const dictionary& dict,
    const groundPlan& plan
)
{
    if (!dict.isDict(entryName))
    {
        return autoPtr<rainfall>(new uniformRain(entryName, dict));
    }

    const dictionary& rainDict = dict.subDict(entryName);
    const word rainType(rainDict.get<word>("type"));

    auto ctor = dictionaryConstructorTablePtr_->cfind(rainType);

    if (ctor.good())
    {
        return autoPtr<rainfall>(ctor()(entryName, rainDict, plan));
    }

    if (!Function1<scalar>::dictionaryConstructorTablePtr_->found(rainType))
    {
        FatalIOErrorInFunction(rainDict)
            << "Unknown rain " << rainType << ". Rain that differs from place"
            << " to place: " << dictionaryConstructorTablePtr_->sortedToc()
            << ". Functions of time: "
            << Function1<scalar>::dictionaryConstructorTablePtr_->sortedToc()
            << exit(FatalIOError);
    }

    return autoPtr<rainfall>(new uniformRain(entryName, dict));
}

// ************************************************************************* //
