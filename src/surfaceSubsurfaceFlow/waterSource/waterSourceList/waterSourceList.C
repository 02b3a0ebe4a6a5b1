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

#include "waterSourceList.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::waterSourceList::waterSourceList
(
    const dictionary& dict,
    const groundSurface& ground,
    const subsurfaceFlow& soil
)
:
    PtrList<waterSource>()
{
    Info<< "Sources and sinks of water" << nl;

    for (const entry& e : dict)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << e.keyword() << "' of " << dict.name()
                << " is not a dictionary. Valid entries: one sub-dictionary a"
                << " source" << nl << exit(FatalIOError);
        }

        append(waterSource::New(e.dict(), ground, soil));
        last().writeInfo(Info);
    }

    Info<< endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::waterSourceList::beginStep
(
    const scalar t1,
    const scalar t2,
    const scalar stretch
)
{
    for (waterSource& source : *this)
    {
        source.beginStep(t1, t2, stretch);
    }
}


void Foam::waterSourceList::assemble(coupledMatrix& matrix, const label start)
{
    for (waterSource& source : *this)
    {
        source.assemble(matrix, start);
    }
}


Foam::scalar Foam::waterSourceList::inflow() const
{
    scalar sum = 0;
    for (const waterSource& source : *this)
    {
        sum += source.inflow();
    }
    return sum;
}


Foam::scalar Foam::waterSourceList::outflow() const
{
    scalar sum = 0;
    for (const waterSource& source : *this)
    {
        sum += source.outflow();
    }
    return sum;
}


Foam::scalar Foam::waterSourceList::driestHead() const
{
    scalar driest = 0;
    for (const waterSource& source : *this)
    {
        driest = min(driest, source.driestHead());
    }
    return driest;
}


Foam::scalar Foam::waterSourceList::nextBreakPoint(const scalar t) const
{
    scalar next = VGREAT;
    for (const waterSource& source : *this)
    {
        next = min(next, source.nextBreakPoint(t));
    }
    return next;
}

// ************************************************************************* //
