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

#include "textPainter.H"

#include <stdexcept>

#include <vtkAutoInit.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

VTK_MODULE_INIT(vtkRenderingFreeType)

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

runoutPicture::textPainter::stencil runoutPicture::textPainter::render
(
    const std::string& text,
    const style& look
)
{
    // Pixels and points are the same at this resolution
    const int dotsPerInch = 72;

    vtkNew<vtkTextProperty> property;
    property->SetFontFamilyToArial();
    property->SetFontSize(look.size);
    property->SetBold(look.bold);
    property->SetColor(1, 1, 1);

    vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
    if (!renderer)
    {
        throw std::runtime_error("VTK was built without a text renderer");
    }
    renderer->SetScaleToPowerOfTwo(false);

    vtkNew<vtkImageData> image;
    int size[2];
    if
    (
       !renderer->RenderString
        (
            property, vtkStdString(text), image, size, dotsPerInch
        )
    )
    {
        throw std::runtime_error("Cannot render the text '" + text + "'");
    }

    int extent[6];
    image->GetExtent(extent);
    const int nx = std::min(size[0], extent[1] - extent[0] + 1);
    const int ny = std::min(size[1], extent[3] - extent[2] + 1);

    stencil result;
    result.width = look.upright ? ny : nx;
    result.height = look.upright ? nx : ny;
    result.coverage.resize(std::size_t(nx)*ny);

    for (int j = 0; j < ny; ++j)
    {
        for (int i = 0; i < nx; ++i)
        {
            const double alpha = image->GetScalarComponentAsDouble
            (
                extent[0] + i, extent[2] + j, extent[4], 3
            );

            // Upright: a quarter turn to the left
            const int column = look.upright ? ny - 1 - j : i;
            const int row = look.upright ? i : j;

            result.coverage[std::size_t(row)*result.width + column] =
                alpha/255;
        }
    }

    return result;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int runoutPicture::textPainter::width
(
    const std::string& text,
    const style& look
)
{
    if (text.empty())
    {
        return 0;
    }

    const stencil s(render(text, look));
    return look.upright ? s.height : s.width;
}


void runoutPicture::textPainter::draw
(
    canvas& target,
    const std::string& text,
    const position& where,
    const style& look,
    const anchor at
)
{
    if (text.empty())
    {
        return;
    }

    const stencil s(render(text, look));

    const double along =
        at == anchor::left ? 0 : at == anchor::centre ? 0.5 : 1;

    const int i0 = std::lround
    (
        where[0] - s.width*(look.upright ? 0.5 : along)
    );
    const int j0 = std::lround
    (
        where[1] - s.height*(look.upright ? along : 0.5)
    );

    const auto paint = [&](const int di, const int dj, const colour& ink)
    {
        for (int j = 0; j < s.height; ++j)
        {
            for (int i = 0; i < s.width; ++i)
            {
                const double c = s.coverage[std::size_t(j)*s.width + i];
                if (c > 0)
                {
                    target.blend(i0 + i + di, j0 + j + dj, ink, c);
                }
            }
        }
    };

    if (look.halo)
    {
        const int r = std::max(1, look.size/12);
        const colour white{255, 255, 255};

        for (int dj = -r; dj <= r; ++dj)
        {
            for (int di = -r; di <= r; ++di)
            {
                paint(di, dj, white);
            }
        }
    }

    paint(0, 0, look.ink);
}


// ************************************************************************* //
