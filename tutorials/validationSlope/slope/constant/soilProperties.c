/*--------------------------------*- C++ -*----------------------------------*\
  slideFoam | from rain to runout
  Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
\*---------------------------------------------------------------------------*/
FoamFile
{
    version     2.0;
    format      ascii;
    class       dictionary;
    object      soilProperties.c;
}
// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

// State c, failed in the paper

#include "soilProperties"

soils
{
    slope
    {
        mechanical
        {
            cohesion        0;              // Pa
            frictionAngle   20;             // deg
        }
    }
}

// ************************************************************************* //
