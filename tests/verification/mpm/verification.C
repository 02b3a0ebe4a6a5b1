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

#include "verification.H"

#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

std::string number(const double value)
{
    std::ostringstream text;
    text << std::setprecision(5) << value;
    return text.str();
}

} // End anonymous namespace


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void verification::Checks::line(const bool passed, const std::string& text)
{
    failures_ += !passed;
    std::cout
        << (passed ? "PASS " : "FAIL ") << case_ << ": " << text << std::endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void verification::Checks::less
(
    const std::string& name,
    const double value,
    const double bound,
    const std::string& reason
)
{
    const bool passed = std::fabs(value) <= bound;
    line
    (
        passed,
        name + " " + number(value) + (passed ? " <= " : " is not <= ")
      + number(bound) + " (" + reason + ")"
    );
}


void verification::Checks::within
(
    const std::string& name,
    const double value,
    const double low,
    const double high,
    const std::string& reason
)
{
    const bool passed = low <= value && value <= high;
    line
    (
        passed,
        name + " " + number(value) + (passed ? " in [" : " is not in [")
      + number(low) + ", " + number(high) + "] (" + reason + ")"
    );
}


void verification::Checks::report
(
    const std::string& name,
    const double value
) const
{
    std::cout
        << "     " << case_ << ": " << name << " " << number(value)
        << std::endl;
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

mpm::PointData verification::seed
(
    const int dimension,
    const double cellSize,
    const int perCell,
    const mpm::Point3& lower,
    const mpm::Point3& upper,
    const std::function<bool(const mpm::Point3&)>& inside,
    const double rho
)
{
    const double spacing = cellSize/perCell;
    mpm::Point3 volumeEdges{{spacing, spacing, dimension == 3 ? spacing : 1}};
    long first[3] = {0, 0, 0};
    long last[3] = {0, 0, 0};
    for (int d = 0; d < dimension; ++d)
    {
        first[d] = std::lround(std::floor(lower[d]/spacing));
        last[d] = std::lround(std::ceil(upper[d]/spacing)) - 1;
    }

    mpm::PointData points;
    for (long k = first[2]; k <= last[2]; ++k)
    {
        for (long j = first[1]; j <= last[1]; ++j)
        {
            for (long i = first[0]; i <= last[0]; ++i)
            {
                const mpm::Point3 x
                {{
                    (i + 0.5)*spacing,
                    (j + 0.5)*spacing,
                    dimension == 3 ? (k + 0.5)*spacing : 0
                }};
                if (inside(x))
                {
                    points.position.push_back(x);
                    points.volume.push_back
                    (
                        volumeEdges[0]*volumeEdges[1]*volumeEdges[2]
                    );
                    points.rho.push_back(rho);
                    points.zone.push_back(0);
                }
            }
        }
    }
    return points;
}


mpm::WallSettings verification::plane
(
    const std::string& name,
    const std::string& condition,
    const mpm::Point3& point,
    const mpm::Point3& normal,
    const double friction
)
{
    mpm::WallSettings wall;
    wall.name = name;
    wall.type = "plane";
    wall.condition = condition;
    wall.point = point;
    wall.normal = normal;
    wall.friction = friction;
    return wall;
}


double verification::reducedStrength
(
    mpm::Run& run,
    const std::string& start,
    const double F,
    const double endTime,
    const std::function<double(const mpm::Run&)>& measure
)
{
    std::istringstream is(start);
    run.restore(is);

    std::vector<double> cohesion = run.field("cohesionIntercept");
    std::vector<double> angle = run.field("frictionAngle");
    for (std::size_t i = 0; i < angle.size(); ++i)
    {
        cohesion[i] /= F;
        angle[i] = std::atan(std::tan(degree*angle[i])/F)/degree;
    }
    run.setField("cohesionIntercept", cohesion);
    run.setField("frictionAngle", angle);

    run.advance(endTime);
    return measure(run);
}


double verification::safetyFactor
(
    const std::function<double(double)>& measureOfF,
    const double criterion,
    double lower,
    double upper,
    const int bisections
)
{
    double below = measureOfF(lower);
    double above = measureOfF(upper);
    for (int i = 0; i < bisections; ++i)
    {
        const double middle = 0.5*(lower + upper);
        const double measure = measureOfF(middle);
        (measure < criterion ? lower : upper) = middle;
        (measure < criterion ? below : above) = measure;
    }
    const double share =
        std::log(criterion/below)/std::log(above/below);
    return lower + (upper - lower)*std::fmin(std::fmax(share, 0.0), 1.0);
}


std::string verification::saved(const mpm::Run& run)
{
    std::ostringstream os;
    run.save(os);
    return os.str();
}


double verification::order(const double coarseError, const double fineError)
{
    return std::log2(std::fabs(coarseError/fineError));
}

// ************************************************************************* //
