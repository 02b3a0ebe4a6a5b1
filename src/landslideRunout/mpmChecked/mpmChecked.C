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


Foam::IOdictionary Foam::readDictionary(const IOobject& io)
{
    // Overflow is trapped while numbers are read, before the reader can say
    // which it was
    const sigFpe::ignore untrapped;

    return IOdictionary(io);
}

// ************************************************************************* //
