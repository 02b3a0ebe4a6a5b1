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

#include "boundaryNodes.H"
#include "StringStream.H"
#include "Time.H"
#include "volFields.H"

#include <limits>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::boundaryNodes::add(const dictionary& dict)
{
    for (const entry& e : dict)
    {
        word type;

        if (e.isDict())
        {
            e.dict().readIfPresent("type", type);
            add(e.dict());
        }
        else if (!e.stream().empty() && e.stream().first().isWord())
        {
            type = e.stream().first().wordToken();
        }

        if (type == "table" || type == "tableFile" || type == "csvFile")
        {
            tables_.append
            (
                tableNodes(*Function1<scalar>::New(e.keyword(), dict))
            );
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::boundaryNodes::boundaryNodes(const volScalarField& field)
{
    const Time& time = field.time();

    for (const fvPatchScalarField& patch : field.boundaryField())
    {
        // A condition keeps its functions to itself, but writes them
        OStringStream os;
        os.precision(std::numeric_limits<scalar>::max_digits10);
        patch.write(os);
        IStringStream is(os.str());
        add(dictionary(is));

        const instantList samples
        (
            Time::findTimes
            (
                time.globalPath()/time.constant()/"boundaryData"
               /patch.patch().name()
            )
        );

        scalarList times(samples.size());
        forAll(samples, i)
        {
            times[i] = samples[i].value();
        }
        tables_.append(tableNodes(times));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::boundaryNodes::next(const scalar t) const
{
    scalar result = VGREAT;

    for (const tableNodes& table : tables_)
    {
        result = min(result, table.next(t));
    }

    return result;
}

// ************************************************************************* //
