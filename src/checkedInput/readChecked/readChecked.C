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

#include "readChecked.H"
#include "ListOps.H"

#include <cmath>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::readChecked
(
    const dictionary& dict,
    const word& key,
    const std::function<bool(scalar)>& valid,
    const string& range
)
{
    const scalar value = dict.get<scalar>(key);

    if (!std::isfinite(value) || !valid(value))
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' of " << dict.name() << " is " << value
            << ", outside its range: " << range.c_str() << nl
            << exit(FatalIOError);
    }

    return value;
}


Foam::scalar Foam::readCheckedOrDefault
(
    const dictionary& dict,
    const word& key,
    const scalar defaultValue,
    const std::function<bool(scalar)>& valid,
    const string& range
)
{
    if (!dict.found(key))
    {
        return defaultValue;
    }

    return readChecked(dict, key, valid, range);
}


void Foam::warnUnlessUsual
(
    const dictionary& dict,
    const word& key,
    const scalar value,
    const Pair<scalar>& usual,
    const string& range
)
{
    if (value < usual.first() || value > usual.second())
    {
        IOWarningInFunction(dict)
            << "Entry '" << key << "' of " << dict.name() << " is " << value
            << "; soils have " << range.c_str() << ". Is the unit right?"
            << endl;
    }
}


const Foam::dictionary& Foam::checkKeys
(
    const dictionary& dict,
    const wordList& values,
    const wordList& dictionaries
)
{
    for (const entry& e : dict)
    {
        if (e.keyword().isPattern())
        {
            continue;
        }

        const bool isValue = values.found(e.keyword());
        const bool isDictionary = dictionaries.found(e.keyword());

        if (!isValue && !isDictionary)
        {
            // A key may be allowed as both
            wordHashSet valid(values);
            valid.insert(dictionaries);

            FatalIOErrorInFunction(dict)
                << "Unknown key " << e.keyword() << ", line "
                << e.startLineNumber() << " of " << dict.name() << nl
                << "    Valid keys: " << flatOutput(valid.sortedToc())
                << exit(FatalIOError);
        }

        if (e.isDict() ? !isDictionary : !isValue)
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << e.keyword() << "' of " << dict.name() << " is "
                << (
                       e.isDict()
                     ? "a dictionary, and has to be a value"
                     : "a value, and has to be a dictionary"
                   )
                << exit(FatalIOError);
        }
    }

    return dict;
}

// ************************************************************************* //
