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

#include "colourBar.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void runoutPicture::colourBar::drawTip
(
    canvas& target,
    const std::array<position, 3>& corners,
    const colour& c
)
{
    target.fillTriangle(corners, [&c](double, double, double) { return c; });
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

runoutPicture::colourBar::colourBar
(
    const colourScale& scale,
    const int fontSize
)
:
    scale_(scale),
    look_{fontSize}
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void runoutPicture::colourBar::drawUpright
(
    canvas& target,
    const rectangle& bar
) const
{
    const double x0 = bar.left;
    const double x1 = bar.left + bar.width;
    const double y0 = bar.bottom;
    const double y1 = bar.bottom + bar.height;

    for (int j = 0; j < bar.height; ++j)
    {
        target.fillRectangle
        (
            {x0, y0 + j},
            {x1, y0 + j + 1},
            scale_.atFraction((j + 0.5)/bar.height)
        );
    }
    target.drawFrame(bar, std::max(1, look_.size/16), frameInk);

    const double gap = em(0.12);
    const double middle = 0.5*(x0 + x1);
    if (scale_.above())
    {
        const double y = y1 + gap;
        drawTip
        (
            target,
            {position{x0, y}, position{x1, y}, position{middle, y + em(0.6)}},
            scale_.atFraction(1)
        );
    }
    if (scale_.below())
    {
        const double y = y0 - gap;
        drawTip
        (
            target,
            {position{x0, y}, position{x1, y}, position{middle, y - em(0.6)}},
            scale_.atFraction(0)
        );
    }

    int widest = 0;
    for (const axisTick& tick : scale_.ticks(std::max(2, bar.height/em(2.2))))
    {
        const double y = y0 + scale_.fraction(tick.value)*bar.height;

        target.fillRectangle({x1, y}, {x1 + em(0.25), y + 1}, frameInk);
        textPainter::draw(target, tick.text, {x1 + em(0.45), y}, look_);
        widest = std::max(widest, textPainter::width(tick.text, look_));
    }

    textPainter::style upright(look_);
    upright.upright = true;
    textPainter::draw
    (
        target,
        scale_.settings().label,
        {x1 + em(0.45) + widest + em(0.9), 0.5*(y0 + y1)},
        upright,
        textPainter::anchor::centre
    );
}


void runoutPicture::colourBar::drawLying
(
    canvas& target,
    const rectangle& bar
) const
{
    const double x0 = bar.left;
    const double x1 = bar.left + bar.width;
    const double y0 = bar.bottom;
    const double y1 = bar.bottom + bar.height;

    for (int i = 0; i < bar.width; ++i)
    {
        target.fillRectangle
        (
            {x0 + i, y0},
            {x0 + i + 1, y1},
            scale_.atFraction((i + 0.5)/bar.width)
        );
    }
    target.drawFrame(bar, std::max(1, look_.size/16), frameInk);

    const double gap = em(0.12);
    const double middle = 0.5*(y0 + y1);
    if (scale_.above())
    {
        const double x = x1 + gap;
        drawTip
        (
            target,
            {position{x, y0}, position{x, y1}, position{x + em(0.6), middle}},
            scale_.atFraction(1)
        );
    }
    if (scale_.below())
    {
        const double x = x0 - gap;
        drawTip
        (
            target,
            {position{x, y0}, position{x, y1}, position{x - em(0.6), middle}},
            scale_.atFraction(0)
        );
    }

    for (const axisTick& tick : scale_.ticks(std::max(2, bar.width/em(5))))
    {
        const double x = x0 + scale_.fraction(tick.value)*bar.width;

        target.fillRectangle({x, y0 - em(0.25)}, {x + 1, y0}, frameInk);
        textPainter::draw
        (
            target, tick.text, {x, y0 - em(0.9)}, look_,
            textPainter::anchor::centre
        );
    }

    textPainter::draw
    (
        target,
        scale_.settings().label,
        {0.5*(x0 + x1), y0 - em(2.1)},
        look_,
        textPainter::anchor::centre
    );
}


// ************************************************************************* //
