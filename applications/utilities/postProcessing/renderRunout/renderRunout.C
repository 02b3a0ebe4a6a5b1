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

Application
    renderRunout

Description
    Draws material points and sections or plan views of meshes as PNG, by the
    CPU and without a display.

Usage
    \b renderRunout -output <file.png> [options] [-panel <title> [options]] ...

    With -help the list of all options. Examples:

    Plastic strain on the deformed slope, two states below each other:
    \verbatim
    renderRunout -output states.png -array equivalentPlasticStrain \
        -map strain -range 0 1 -label "plastic strain" \
        -line "-46 20 -16 20 0 0 24 0" \
        -panel "a: stable" -points a.vtp -panel "c: failed" -points c.vtp
    \endverbatim

    Pressure head in a section with the water table:
    \verbatim
    renderRunout -output psi.png -mesh VTK/case_0/internal.vtu -array psi \
        -isoline 0 -label "pressure head (m)"
    \endverbatim

    Water depth in plan:
    \verbatim
    renderRunout -output depth.png -mesh h_ground.vtp -array h -map blues \
        -hideBelow 0.001 -contours 10 -label "water depth (m)" \
        -mark 506 0 A
    \endverbatim

\*---------------------------------------------------------------------------*/

#include "commandLine.H"
#include "picture.H"

#include <iostream>

#include <vtkObject.h>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    using namespace runoutPicture;

    // Its errors come as exceptions with the file's name
    vtkObject::GlobalWarningDisplayOff();

    try
    {
        commandLine options(argc, argv);

        if (options.wantsHelp())
        {
            std::cout << options.help();
            return argc > 1 ? 0 : 1;
        }

        const pictureSettings settings(options.read());
        const canvas result(picture(settings).draw());

        result.writePNG(settings.output);
        std::cout
            << "Wrote " << settings.output << " (" << result.width() << " x "
            << result.height() << " pixels)\n";
    }
    catch (const std::exception& error)
    {
        std::cerr << "renderRunout: error: " << error.what() << '\n';
        return 1;
    }

    return 0;
}


// ************************************************************************* //
