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

#include "canvas.H"

#include <stdexcept>

#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

runoutPicture::canvas::canvas
(
    const int width,
    const int height,
    const colour& background
)
:
    width_(width),
    height_(height),
    pixels_(std::size_t(width)*height, background)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void runoutPicture::canvas::blend
(
    const int i,
    const int j,
    const colour& c,
    const double opacity
)
{
    if (i < 0 || j < 0 || i >= width_ || j >= height_)
    {
        return;
    }

    colour& own = pixels_[at(i, j)];

    for (int k = 0; k < 3; ++k)
    {
        own[k] = static_cast<unsigned char>
        (
            std::lround((1 - opacity)*own[k] + opacity*c[k])
        );
    }
}


void runoutPicture::canvas::fillRectangle
(
    const position& low,
    const position& high,
    const colour& c
)
{
    const int iMax = std::min(width_, int(std::lround(high[0])));
    const int jMax = std::min(height_, int(std::lround(high[1])));

    for (int j = std::max(0, int(std::lround(low[1]))); j < jMax; ++j)
    {
        for (int i = std::max(0, int(std::lround(low[0]))); i < iMax; ++i)
        {
            pixels_[at(i, j)] = c;
        }
    }
}


void runoutPicture::canvas::drawFrame
(
    const rectangle& frame,
    const double lineWidth,
    const colour& c
)
{
    const double t = lineWidth;
    const double x0 = frame.left;
    const double x1 = frame.left + frame.width;
    const double y0 = frame.bottom;
    const double y1 = frame.bottom + frame.height;

    fillRectangle({x0 - t, y0 - t}, {x1 + t, y0}, c);
    fillRectangle({x0 - t, y1}, {x1 + t, y1 + t}, c);
    fillRectangle({x0 - t, y0}, {x0, y1}, c);
    fillRectangle({x1, y0}, {x1 + t, y1}, c);
}


void runoutPicture::canvas::fillDisc
(
    const position& centre,
    const double radius,
    const colour& c
)
{
    const int iMin = std::max(0, int(centre[0] - radius - 0.5));
    const int jMin = std::max(0, int(centre[1] - radius - 0.5));
    const int iMax = std::min(width_ - 1, int(centre[0] + radius + 0.5));
    const int jMax = std::min(height_ - 1, int(centre[1] + radius + 0.5));

    for (int j = jMin; j <= jMax; ++j)
    {
        for (int i = iMin; i <= iMax; ++i)
        {
            const double dx = i + 0.5 - centre[0];
            const double dy = j + 0.5 - centre[1];

            if (dx*dx + dy*dy <= radius*radius)
            {
                pixels_[at(i, j)] = c;
            }
        }
    }
}


void runoutPicture::canvas::drawLine
(
    const position& from,
    const position& to,
    const double lineWidth,
    const colour& c
)
{
    const double dx = to[0] - from[0];
    const double dy = to[1] - from[1];
    const double length = std::hypot(dx, dy);
    const double r = 0.5*lineWidth;

    fillDisc(from, r, c);
    fillDisc(to, r, c);

    if (length > 0)
    {
        const double nx = -r*dy/length;
        const double ny = r*dx/length;
        const auto plain = [&c](double, double, double) { return c; };

        const position a{from[0] + nx, from[1] + ny};
        const position b{from[0] - nx, from[1] - ny};
        const position d{to[0] + nx, to[1] + ny};
        const position e{to[0] - nx, to[1] - ny};

        fillTriangle({a, b, d}, plain);
        fillTriangle({d, b, e}, plain);
    }
}


void runoutPicture::canvas::averageFrom
(
    const canvas& finer,
    const int factor,
    const int i0,
    const int j0
)
{
    const double share = 1.0/(factor*factor);

    for (int j = 0; j < finer.height_/factor; ++j)
    {
        for (int i = 0; i < finer.width_/factor; ++i)
        {
            std::array<int, 3> sum{0, 0, 0};

            for (int n = 0; n < factor; ++n)
            {
                for (int m = 0; m < factor; ++m)
                {
                    const colour& c = finer.pixel(factor*i + m, factor*j + n);

                    for (int k = 0; k < 3; ++k)
                    {
                        sum[k] += c[k];
                    }
                }
            }

            colour mean;
            for (int k = 0; k < 3; ++k)
            {
                mean[k] = static_cast<unsigned char>
                (
                    std::lround(share*sum[k])
                );
            }

            blend(i0 + i, j0 + j, mean);
        }
    }
}


void runoutPicture::canvas::writePNG(const std::string& fileName) const
{
    vtkNew<vtkImageData> image;
    image->SetDimensions(width_, height_, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);

    auto* target = static_cast<unsigned char*>(image->GetScalarPointer());
    for (const colour& c : pixels_)
    {
        target = std::copy(c.begin(), c.end(), target);
    }

    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(fileName.c_str());
    writer->Write();

    if (writer->GetErrorCode() != vtkErrorCode::NoError)
    {
        throw std::runtime_error
        (
            "Cannot write the picture " + fileName
          + ": is its folder there and writable?"
        );
    }
}


// ************************************************************************* //
