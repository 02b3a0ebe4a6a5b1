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

#include "outsidePolicy.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::outsidePolicy::type> Foam::outsidePolicy::names
({
    { type::ERROR, "error" },
    { type::NEAREST, "nearest" },
    { type::VALUE, "value" }
});


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::outsidePolicy::outsidePolicy(const dictionary& dict)
:
    type_(names.getOrDefault("outside", dict, type::ERROR)),
    source_(dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::outsidePolicy::stop(const string& message) const
{
    const string advice
    (
        "Move the points, or choose what they get: outside "
      + names[type::NEAREST] + " or " + names[type::VALUE]
    );

    if (source_.name().empty())
    {
        FatalErrorInFunction
            << message.c_str() << nl << "    " << advice.c_str()
            << exit(FatalError);
    }

    FatalIOErrorInFunction(source_)
        << message.c_str() << nl << "    " << advice.c_str()
        << exit(FatalIOError);
}

// ************************************************************************* //
