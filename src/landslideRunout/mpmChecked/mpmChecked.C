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

#include "mpmChecked.H"
#include "error.H"
#include "HashSet.H"
#include "ListOps.H"

#include "sigFpe.H"

#include <exception>
#include <stdexcept>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::mpmChecked
(
    const dictionary& dict,
    const string& activity,
    const std::function<void()>& call
)
{
    // The errors are raised outside of the handlers: they end the program by
    // themselves or throw exceptions of their own
    string message;
    bool badInput = false;

    try
    {
        call();
        return;
    }
    catch (const std::invalid_argument& e)
    {
        message = e.what();
        badInput = true;
    }
    catch (const std::exception& e)
    {
        message = e.what();
    }

    if (badInput)
    {
        FatalIOErrorInFunction(dict)
            << message.c_str()
            << exit(FatalIOError);
    }

    FatalErrorInFunction
        << "While " << activity.c_str() << ": " << message.c_str()
        << exit(FatalError);
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
            wordList valid(values);
            valid.append(dictionaries);

            FatalIOErrorInFunction(dict)
                << "Unknown key " << e.keyword() << " in " << dict.name() << nl
                << "    Valid keys: " << flatOutput(valid)
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


Foam::IOdictionary Foam::readDictionary(const IOobject& io)
{
    // Overflow is trapped while numbers are read, before the reader can say
    // which it was
    const sigFpe::ignore untrapped;

    return IOdictionary(io);
}

// ************************************************************************* //
