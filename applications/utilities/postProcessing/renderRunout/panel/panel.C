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

#include "panel.H"
#include "isolines.H"

#include <limits>
#include <tuple>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using runoutPicture::colour;

//- Colours of lines
constexpr colour black{30, 30, 30};
constexpr colour brown{120, 92, 60};
constexpr colour water{20, 84, 160};
constexpr colour meshGrey{120, 120, 120};

//- Points larger than their spacing by this leave no gaps between them in a
//  square arrangement, whose diagonal is sqrt(2) times the spacing
const double pointOverlap = 1.42;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

runoutPicture::plotWindow runoutPicture::panel::windowOfData() const
{
    const double large = std::numeric_limits<double>::max();
    plotWindow w{large, -large, large, -large};

    const auto include = [&w](const std::vector<position>& nodes)
    {
        for (const position& x : nodes)
        {
            w.xMin = std::min(w.xMin, x[0]);
            w.xMax = std::max(w.xMax, x[0]);
            w.yMin = std::min(w.yMin, x[1]);
            w.yMax = std::max(w.yMax, x[1]);
        }
    };

    if (mesh_)
    {
        include(mesh_->nodes);
    }
    if (points_)
    {
        include(points_->nodes);
    }

    // Room around, and a width and height above zero whatever the data
    const double room = 0.02*std::max(w.xMax - w.xMin, w.yMax - w.yMin);
    const double least = std::max(room, 1e-9);

    return
    {
        w.xMin - least, w.xMax + least, w.yMin - least, w.yMax + 2*least
    };
}


runoutPicture::position runoutPicture::panel::toPixels
(
    const position& x,
    const canvas& target
) const
{
    return inFrame(x, target.width(), target.height());
}


void runoutPicture::panel::drawMesh
(
    canvas& target,
    const colourScale* scale
) const
{
    const bool coloured = scale && meshIsColoured();
    const bool flat = !mesh_->triangleValues.empty();

    for (std::size_t t = 0; t < mesh_->triangles.size(); ++t)
    {
        const auto& nodes = mesh_->triangles[t];
        const std::array<position, 3> corners
        {
            toPixels(mesh_->nodes[nodes[0]], target),
            toPixels(mesh_->nodes[nodes[1]], target),
            toPixels(mesh_->nodes[nodes[2]], target)
        };

        if (!coloured || flat)
        {
            const colour c =
                coloured
              ? scale->at(mesh_->triangleValues[t])
              : colourScale::bare;

            target.fillTriangle
            (
                corners,
                [&c](double, double, double) { return c; }
            );
            continue;
        }

        const double a = mesh_->nodeValues[nodes[0]];
        const double b = mesh_->nodeValues[nodes[1]];
        const double c = mesh_->nodeValues[nodes[2]];

        target.fillTriangle
        (
            corners,
            [&](const double wa, const double wb, const double wc)
            {
                return scale->at(wa*a + wb*b + wc*c);
            }
        );
    }
}


void runoutPicture::panel::drawPoints
(
    canvas& target,
    const colourScale* scale
) const
{
    const double diameter =
        settings_.pointSize
      ? *settings_.pointSize
      : pointOverlap*points_->spacing;

    // Never smaller than can be seen
    const double radius = std::max
    (
        1.5,
        0.5*diameter*target.width()/(window_.xMax - window_.xMin)
    );

    const bool coloured = scale && !points_->values.empty();

    for (std::size_t i = 0; i < points_->nodes.size(); ++i)
    {
        target.fillDisc
        (
            toPixels(points_->nodes[i], target),
            radius,
            coloured ? scale->at(points_->values[i]) : colourScale::bare
        );
    }
}


void runoutPicture::panel::drawIsolines
(
    canvas& target,
    const double lineWidth
) const
{
    const auto draw =
        [&](const std::vector<segment>& pieces, const colour& ink, double width)
        {
            for (const segment& piece : pieces)
            {
                target.drawLine
                (
                    toPixels(piece[0], target),
                    toPixels(piece[1], target),
                    width,
                    ink
                );
            }
        };

    if (settings_.contours > 0)
    {
        const auto [low, high] =
            std::minmax_element(mesh_->depth.begin(), mesh_->depth.end());

        for
        (
            double level = settings_.contours
               *std::ceil(*low/settings_.contours);
            level < *high;
            level += settings_.contours
        )
        {
            draw(isoline(*mesh_, mesh_->depth, level), brown, 0.6*lineWidth);
        }
    }

    if (!settings_.isolines.empty() && meshIsColoured())
    {
        const auto values = valuesAtNodes(*mesh_);

        for (const double level : settings_.isolines)
        {
            draw(isoline(*mesh_, values, level), black, lineWidth);
        }
    }
}


void runoutPicture::panel::drawPolyline
(
    canvas& target,
    const polyline& line,
    const double lineWidth,
    const colour& ink
) const
{
    for (std::size_t i = 1; i < line.size(); ++i)
    {
        target.drawLine
        (
            toPixels(line[i - 1], target),
            toPixels(line[i], target),
            lineWidth,
            ink
        );
    }
}


void runoutPicture::panel::drawDashed
(
    canvas& target,
    const polyline& line,
    const double lineWidth,
    const colour& ink
) const
{
    // Lengths in widths of the line
    const double dash = 6*lineWidth;
    const double gap = 4*lineWidth;
    double along = 0;

    for (std::size_t i = 1; i < line.size(); ++i)
    {
        const position a(toPixels(line[i - 1], target));
        const position b(toPixels(line[i], target));
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        double done = 0;

        while (done < length)
        {
            const double phase = std::fmod(along, dash + gap);
            const double left =
                (phase < dash ? dash : dash + gap) - phase;
            const double step = std::min(std::max(left, 1e-6), length - done);

            if (phase < dash)
            {
                const auto at = [&](const double s) -> position
                {
                    return
                    {
                        a[0] + s/length*(b[0] - a[0]),
                        a[1] + s/length*(b[1] - a[1])
                    };
                };
                target.drawLine(at(done), at(done + step), lineWidth, ink);
            }

            done += step;
            along += step;
        }
    }
}


void runoutPicture::panel::drawEdges
(
    canvas& target,
    const double lineWidth
) const
{
    const auto& [edges, width, ink] =
        settings_.edges
      ? std::make_tuple(&mesh_->edges, 0.4*lineWidth, meshGrey)
      : std::make_tuple(&mesh_->outline, 0.7*lineWidth, black);

    for (const auto& edge : *edges)
    {
        drawPolyline
        (
            target,
            {mesh_->nodes[edge[0]], mesh_->nodes[edge[1]]},
            width,
            ink
        );
    }
}


void runoutPicture::panel::drawLines
(
    canvas& target,
    const double lineWidth
) const
{
    for (const polyline& line : lines_)
    {
        drawPolyline(target, line, lineWidth, black);
    }
    for (const polyline& line : settings_.dashedLines)
    {
        drawDashed(target, line, lineWidth, water);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

runoutPicture::panel::panel(const panelSettings& settings)
:
    settings_(settings),
    lines_(settings.lines),
    window_{0, 1, 0, 1}
{
    const bool forPoints = !settings_.points.empty();

    if (!settings_.mesh.empty())
    {
        mesh_ = sceneReader
        (
            settings_.view,
            forPoints ? arrayChoice() : settings_.array
        ).mesh
        (
            settings_.mesh,
            settings_.slice,
            settings_.smooth,
            settings_.flat
        );
    }
    if (forPoints)
    {
        points_ = sceneReader(settings_.view, settings_.array)
            .points(settings_.points);
    }

    for (const std::string& file : settings_.lineFiles)
    {
        const auto more = readLines(file, settings_.view);
        lines_.insert(lines_.end(), more.begin(), more.end());
    }

    if (settings_.colours.label.empty())
    {
        settings_.colours.label = settings_.array.name;
    }

    if (settings_.window)
    {
        const auto& w = *settings_.window;
        window_ = {w[0], w[1], w[2], w[3]};
    }
    else
    {
        window_ = windowOfData();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::optional<std::array<double, 2>> runoutPicture::panel::range() const
{
    if (settings_.array.name.empty())
    {
        return {};
    }

    const std::vector<double>& values =
        points_ ? points_->values
      : mesh_->triangleValues.empty() ? mesh_->nodeValues
      : mesh_->triangleValues;

    std::optional<std::array<double, 2>> result;

    for (const double v : values)
    {
        if (std::isfinite(v))
        {
            result =
                result
              ? std::array<double, 2>
                {
                    std::min((*result)[0], v),
                    std::max((*result)[1], v)
                }
              : std::array<double, 2>{v, v};
        }
    }

    if (!result)
    {
        throw std::runtime_error
        (
            "Array " + settings_.array.name + " of "
          + (points_ ? settings_.points : settings_.mesh)
          + " has no finite value"
        );
    }

    return result;
}


void runoutPicture::panel::include(const plotWindow& other)
{
    window_.xMin = std::min(window_.xMin, other.xMin);
    window_.xMax = std::max(window_.xMax, other.xMax);
    window_.yMin = std::min(window_.yMin, other.yMin);
    window_.yMax = std::max(window_.yMax, other.yMax);
}


runoutPicture::position runoutPicture::panel::inFrame
(
    const position& x,
    const double width,
    const double height
) const
{
    return
    {
        width*(x[0] - window_.xMin)/(window_.xMax - window_.xMin),
        height*(x[1] - window_.yMin)/(window_.yMax - window_.yMin)
    };
}


void runoutPicture::panel::draw
(
    canvas& target,
    const colourScale* scale,
    const double lineWidth
) const
{
    if (mesh_)
    {
        drawMesh(target, scale);
        drawEdges(target, lineWidth);
    }
    if (points_)
    {
        drawPoints(target, scale);
    }
    if (mesh_)
    {
        drawIsolines(target, lineWidth);
    }
    drawLines(target, lineWidth);
}


// ************************************************************************* //
