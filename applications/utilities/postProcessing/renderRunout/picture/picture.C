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

#include "picture.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using runoutPicture::colour;
using runoutPicture::textPainter;

constexpr colour white{255, 255, 255};

//- Pixels of the drawing in one of the picture, each way
const int fineness = 3;

//- A frame higher than this times its column is made narrower instead
const double maxAspect = 1.3;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void runoutPicture::picture::shareWindows()
{
    for (panel& p : panels_)
    {
        for (const panel& other : panels_)
        {
            if
            (
               !p.settings().window
             && !other.settings().window
             && p.settings().view == other.settings().view
            )
            {
                p.include(other.window());
            }
        }
    }
}


void runoutPicture::picture::makeScales()
{
    shared_ = panels_.size() > 1;
    std::optional<std::array<double, 2>> all;

    for (const panel& p : panels_)
    {
        const auto range = p.range();

        shared_ =
            shared_ && range
         && p.settings().colours == panels_.front().settings().colours;

        if (range)
        {
            all =
                all
              ? std::array<double, 2>
                {
                    std::min((*all)[0], (*range)[0]),
                    std::max((*all)[1], (*range)[1])
                }
              : *range;
        }
    }

    for (const panel& p : panels_)
    {
        const auto range = shared_ ? all : p.range();

        scales_.push_back
        (
            range
          ? std::make_unique<colourScale>
            (
                p.settings().colours, (*range)[0], (*range)[1]
            )
          : nullptr
        );
    }
}


void runoutPicture::picture::layOut()
{
    const int columns = std::min(settings_.columns, int(panels_.size()));
    const int columnWidth = (settings_.width - em(1))/columns;

    // Beside and below each frame: ticks, names, an own colour bar
    const int left = em(4.4);
    const int right = shared_ ? em(0.8) : em(6.2);
    const int below = em(3.4);

    // From above, turned round when the height is known
    int top = settings_.title.empty() ? em(0.6) : em(2.6);

    for (std::size_t first = 0; first < panels_.size(); first += columns)
    {
        const std::size_t end =
            std::min(panels_.size(), first + std::size_t(columns));
        int rowHeight = 0;

        for (std::size_t i = first; i < end; ++i)
        {
            const int titleHeight =
                panels_[i].settings().title.empty() ? em(0.4) : em(1.8);
            const double aspect = panels_[i].window().aspect();

            int width = columnWidth - left - right;
            int height = int(std::lround(width*aspect));

            if (height > maxAspect*columnWidth)
            {
                height = int(maxAspect*columnWidth);
                width = std::max(1, int(std::lround(height/aspect)));
            }
            height = std::max(1, height);

            frames_.push_back
            ({
                int(i - first)*columnWidth + left,
                top + titleHeight + height,
                width,
                height
            });
            rowHeight = std::max(rowHeight, titleHeight + height + below);
        }

        top += rowHeight;
    }

    height_ = top + (shared_ ? em(4.2) : em(0.2));

    for (rectangle& frame : frames_)
    {
        frame.bottom = height_ - frame.bottom;
    }
}


void runoutPicture::picture::drawAxes
(
    canvas& target,
    const std::size_t i
) const
{
    const rectangle& frame = frames_[i];
    const panel& p = panels_[i];
    const plotWindow& w = p.window();

    const double t = std::max(1, settings_.fontSize/16);
    const double length = em(0.3);

    target.drawFrame(frame, t, frameInk);

    // As many ticks as there is room for their text
    const int nx = std::max(2, frame.width/em(5));
    const int ny = std::max(1, frame.height/em(2.4));

    for (const axisTick& tick : linearTicks(w.xMin, w.xMax, nx))
    {
        const double x =
            frame.left + p.inFrame({tick.value, 0}, frame.width, 1)[0];
        target.fillRectangle
        (
            {x, frame.bottom - length}, {x + t, double(frame.bottom)}, frameInk
        );
        textPainter::draw
        (
            target, tick.text, {x, frame.bottom - length - 0.6*em(1)},
            plain(), textPainter::anchor::centre
        );
    }

    for (const axisTick& tick : linearTicks(w.yMin, w.yMax, ny))
    {
        const double y =
            frame.bottom + p.inFrame({0, tick.value}, 1, frame.height)[1];
        target.fillRectangle
        (
            {frame.left - length, y}, {double(frame.left), y + t}, frameInk
        );
        textPainter::draw
        (
            target, tick.text, {frame.left - length - 0.25*em(1), y},
            plain(), textPainter::anchor::right
        );
    }

    textPainter::draw
    (
        target,
        p.settings().view.rightName() + " (m)",
        {frame.left + 0.5*frame.width, double(frame.bottom - em(2.2))},
        plain(),
        textPainter::anchor::centre
    );

    textPainter::style upright(plain());
    upright.upright = true;
    textPainter::draw
    (
        target,
        p.settings().view.upName() + " (m)",
        {double(frame.left - em(3.4)), frame.bottom + 0.5*frame.height},
        upright,
        textPainter::anchor::centre
    );

    textPainter::style title(plain());
    title.bold = true;
    textPainter::draw
    (
        target,
        p.settings().title,
        {double(frame.left), double(frame.bottom + frame.height + em(0.9))},
        title
    );
}


void runoutPicture::picture::drawMarks
(
    canvas& target,
    const std::size_t i
) const
{
    const rectangle& frame = frames_[i];
    textPainter::style look(plain());
    look.bold = true;
    look.halo = true;

    for (const placedText& mark : panels_[i].settings().marks)
    {
        const position x =
            panels_[i].inFrame(mark.where, frame.width, frame.height);
        const position where{frame.left + x[0], frame.bottom + x[1]};

        target.fillDisc(where, 0.3*em(1), white);
        target.fillDisc(where, 0.2*em(1), look.ink);
        textPainter::draw
        (
            target, mark.text, {where[0] + em(0.45), where[1] + em(0.6)}, look
        );
    }
}


void runoutPicture::picture::drawPanel
(
    canvas& target,
    const std::size_t i
) const
{
    const rectangle& frame = frames_[i];

    canvas fine(fineness*frame.width, fineness*frame.height, white);
    panels_[i].draw
    (
        fine,
        scales_[i].get(),
        fineness*std::max(1.5, settings_.fontSize/10.0)
    );
    target.averageFrom(fine, fineness, frame.left, frame.bottom);

    drawAxes(target, i);
    drawMarks(target, i);

    if (scales_[i] && !shared_)
    {
        // Room for the tips beyond both ends
        const int tips = em(0.8);
        colourBar(*scales_[i], settings_.fontSize).drawUpright
        (
            target,
            {
                frame.left + frame.width + em(0.9),
                frame.bottom + tips,
                em(0.9),
                std::max(1, frame.height - 2*tips)
            }
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

runoutPicture::picture::picture(const pictureSettings& settings)
:
    settings_(settings),
    shared_(false),
    height_(0)
{
    for (const panelSettings& p : settings_.panels)
    {
        panels_.emplace_back(p);
    }

    shareWindows();
    makeScales();
    layOut();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

runoutPicture::canvas runoutPicture::picture::draw() const
{
    canvas target(settings_.width, height_, white);

    for (std::size_t i = 0; i < panels_.size(); ++i)
    {
        drawPanel(target, i);
    }

    if (shared_)
    {
        // Half of the width, in the middle
        colourBar(*scales_.front(), settings_.fontSize).drawLying
        (
            target,
            {settings_.width/4, em(3), settings_.width/2, em(0.8)}
        );
    }

    textPainter::style title{em(1.2), true};
    textPainter::draw
    (
        target,
        settings_.title,
        {0.5*settings_.width, double(height_ - em(1.4))},
        title,
        textPainter::anchor::centre
    );

    return target;
}


// ************************************************************************* //
