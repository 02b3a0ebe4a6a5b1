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
#include "engineCases.H"

#include <doctest/doctest.h>

#include <map>

using namespace engineCases;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Points with random velocities and without stress, off the axis
mpm::PointData moving(const int dimension)
{
    mpm::PointData data = cloud(dimension, 300);
    for (mpm::Point3& x : data.position)
    {
        x[0] += 1.5;
    }
    data.sigma.clear();
    return data;
}


//- Stress after one step, tensors of six
std::vector<double> stressOf
(
    const int dimension,
    const mpm::Settings& s,
    const mpm::PointData& data
)
{
    auto run = mpm::Run::New(dimension, s, data, {elastic()}, {});
    run->step(1e-3);
    return run->field("sigma");
}


double trace(const std::vector<double>& sigma, const std::size_t i)
{
    return sigma[6*i] + sigma[6*i + 1] + sigma[6*i + 2];
}


//- The mean by its definition: a value at each node, then at each point
std::vector<double> average
(
    const int dimension,
    const mpm::Settings& s,
    const mpm::PointData& data,
    const std::vector<double>& values
)
{
    typedef std::array<long, 3> Place;
    const bool cell = s.antiLocking == "cell";

    // f(place, weight)
    const auto forPlaces = [&](const std::size_t i, const auto& f)
    {
        const int corners = cell ? 1 : 1 << dimension;
        for (int c = 0; c < corners; ++c)
        {
            Place at{{0, 0, 0}};
            double w = 1;
            for (int d = 0; d < dimension; ++d)
            {
                const double x =
                    (data.position[i][d] - s.origin[d])/s.cellSize;
                const int upper = (c >> d) & 1;
                at[d] = std::lround(std::floor(x)) + upper;
                w *= cell ? 1 : 1 - std::fabs(x - double(at[d]));
            }
            f(at, w);
        }
    };

    std::map<Place, std::array<double, 2>> sums;
    for (std::size_t i = 0; i < data.size(); ++i)
    {
        const double volume =
            data.volume[i]*(s.axisymmetric() ? data.position[i][0] : 1);
        forPlaces
        (
            i,
            [&](const Place& at, const double w)
            {
                sums[at][0] += w*volume*values[i];
                sums[at][1] += w*volume;
            }
        );
    }
    std::vector<double> result(data.size(), 0);
    for (std::size_t i = 0; i < data.size(); ++i)
    {
        forPlaces
        (
            i,
            [&](const Place& at, const double w)
            {
                result[i] += w*sums[at][0]/sums[at][1];
            }
        );
    }
    return result;
}


void checkAverage(const int dimension, mpm::Settings s)
{
    CAPTURE(dimension);
    CAPTURE(s.symmetry);
    CAPTURE(s.shapeFunction);
    CAPTURE(s.stressUpdate);
    const mpm::PointData data = moving(dimension);

    s.antiLocking = "none";
    const std::vector<double> own = stressOf(dimension, s, data);
    std::vector<double> traces;
    double scale = 0;
    for (std::size_t i = 0; i < data.size(); ++i)
    {
        traces.push_back(trace(own, i));
        scale = std::max(scale, std::fabs(traces.back()));
    }
    CHECK(scale > 0);

    for (const char* antiLocking : {"node", "cell"})
    {
        CAPTURE(antiLocking);
        s.antiLocking = antiLocking;
        const std::vector<double> sigma = stressOf(dimension, s, data);
        const std::vector<double> mean = average(dimension, s, data, traces);

        // Plane strain takes the change in two directions only: the stress
        // across the section is part of the mean one
        double ofMean = 0, ofDeviator = 0, change = 0;
        const bool planeStrain = dimension == 2 && !s.axisymmetric();
        for (std::size_t i = 0; i < data.size(); ++i)
        {
            ofMean = std::max(ofMean, std::fabs(trace(sigma, i) - mean[i]));
            change = std::max(change, std::fabs(trace(sigma, i) - traces[i]));
            for (int c = 0; c < 6; ++c)
            {
                if (c >= 3)
                {
                    ofDeviator = std::max
                    (
                        ofDeviator, std::fabs(sigma[6*i + c] - own[6*i + c])
                    );
                }
                else if (c != 2 || !planeStrain)
                {
                    ofDeviator = std::max
                    (
                        ofDeviator,
                        std::fabs
                        (
                            (sigma[6*i + c] - sigma[6*i])
                          - (own[6*i + c] - own[6*i])
                        )
                    );
                }
            }
        }
        CHECK(change > 0.1*scale);
        CHECK(ofMean < 1e-12*scale);
        CHECK(ofDeviator < 1e-12*scale);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("antiLocking averages the volumetric strain and nothing else")
{
    const auto named = []
    (
        mpm::Settings s,
        const char* shape,
        const char* update
    )
    {
        s.shapeFunction = shape;
        s.stressUpdate = update;
        s.transferScheme = "FLIP";
        return s;
    };
    for (const int dimension : {2, 3})
    {
        mpm::Settings s = settings(dimension, 0.25, 0);
        s.origin = {{0.03, -0.07, dimension == 3 ? 0.011 : 0}};
        checkAverage(dimension, s);
        checkAverage(dimension, named(s, "linear", "USF"));
        checkAverage(dimension, named(s, "cpGIMP", "MUSL"));
        checkAverage(dimension, named(s, "cubicBSpline", "USL"));
    }

    mpm::Settings s = settings(2, 0.25, 0);
    s.symmetry = "axisymmetric";
    checkAverage(2, s);
    checkAverage(2, named(s, "uGIMP", "USF"));
}


// ************************************************************************* //
