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

#include "mpmNames.H"
#include "mpmSimulation.H"
#include "mpmSleep.H"

#include <algorithm>
#include <stdexcept>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim>
void mpm::Simulation<Dim>::refuseStressOfDeformation
(
    const std::vector<double>& sigma
) const
{
    const PointCloud<Dim>& cloud = state_.cloud;
    const int nComponents = Run::nComponents("sigma");
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        const LawTable::Law& law = state_.laws[cloud.law[i]];
        const auto first = sigma.begin() + i*nComponents;
        if
        (
            law.model == LawTable::Model::neoHookean
         && std::any_of
            (
                first,
                first + nComponents,
                [](const double s) { return s != 0; }
            )
        )
        {
            throw std::invalid_argument
            (
                "point " + std::to_string(cloud.id[i])
              + ": sigma is given, but that of material "
              + state_.laws.materials()[law.zone].name
              + " (neoHookean) follows from its deformation"
            );
        }
    }
}


template<int Dim>
void mpm::Simulation<Dim>::setFrictionAngle(const std::vector<double>& angles)
{
    PointCloud<Dim>& cloud = state_.cloud;

    // All angles are looked at before any point changes
    std::vector<std::int32_t> law(cloud.size());
    state_.communicator->agree
    (
        [&]()
        {
            for (std::size_t i = 0; i < cloud.size(); ++i)
            {
                const double angle = angles[cloud.id[i]];
                require
                (
                    angle >= 0 && angle < 90,
                    "point " + std::to_string(cloud.id[i])
                  + ": frictionAngle",
                    angle, "0 <= frictionAngle < 90 [deg]"
                );
                law[i] =
                    state_.laws.find(state_.laws[cloud.law[i]].zone, angle);
            }
        }
    );
    cloud.law.swap(law);
}


template<int Dim>
std::vector<double> mpm::Simulation<Dim>::ownField
(
    const std::string& name
) const
{
    const PointCloud<Dim>& cloud = state_.cloud;
    const std::size_t n = cloud.size();
    const int nComponents = Run::nComponents(name);
    std::vector<double> values(n*nComponents, 0.0);

    const auto scalars = [&](const auto& get)
    {
        for (std::size_t i = 0; i < n; ++i)
        {
            values[i] = double(get(i));
        }
    };
    const auto arrays = [&](const auto& source)
    {
        for (std::size_t i = 0; i < n; ++i)
        {
            std::copy
            (
                source[i].begin(),
                source[i].end(),
                values.begin() + i*nComponents
            );
        }
    };

    if (name == "position") arrays(cloud.x);
    else if (name == "velocity") arrays(cloud.v);
    else if (name == "displacement") arrays(cloud.displacement);
    else if (name == "sigma") arrays(cloud.sigma);
    else if (name == "mass") scalars([&](auto i) { return cloud.mass[i]; });
    else if (name == "volume") scalars([&](auto i) { return cloud.volume[i]; });
    else if (name == "cohesionIntercept")
    {
        scalars([&](auto i) { return cloud.cohesion[i]; });
    }
    else if (name == "porePressure")
    {
        scalars([&](auto i) { return cloud.porePressure[i]; });
    }
    else if (name == "equivalentPlasticStrain")
    {
        scalars([&](auto i) { return cloud.plasticStrain[i]; });
    }
    else if (name == "yielding")
    {
        scalars([&](auto i) { return cloud.yielding[i]; });
    }
    else if (name == "rho")
    {
        scalars([&](auto i) { return cloud.mass[i]/cloud.volume[i]; });
    }
    else if (name == "zone")
    {
        scalars([&](auto i) { return state_.laws[cloud.law[i]].zone; });
    }
    else
    {
        // The last of the names that nComponents knows
        scalars
        (
            [&](auto i) { return state_.laws[cloud.law[i]].frictionAngle; }
        );
    }

    return values;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim>
std::vector<double> mpm::Simulation<Dim>::field(const std::string& name) const
{
    const std::size_t nComponents = Run::nComponents(name);
    const std::vector<double> own(ownField(name));
    const std::vector<std::int32_t>& id = state_.cloud.id;

    Buffer mine;
    append(mine, id.data(), id.size());
    append(mine, own.data(), own.size());

    std::vector<double> values(master() ? nPoints_*nComponents : 0);
    for (const Buffer& buffer : state_.communicator->gather(mine))
    {
        const std::size_t n =
            buffer.size()/(sizeof(id[0]) + nComponents*sizeof(own[0]));
        std::size_t atId = 0;
        std::size_t at = n*sizeof(id[0]);
        for (std::size_t i = 0; i < n; ++i)
        {
            std::int32_t place = 0;
            take(buffer, atId, &place, 1);
            take(buffer, at, &values[place*nComponents], nComponents);
        }
    }
    return values;
}


template<int Dim>
void mpm::Simulation<Dim>::setField
(
    const std::string& name,
    const std::vector<double>& values
)
{
    static const std::vector<std::string> settable
    {
        "cohesionIntercept", "frictionAngle", "porePressure", "velocity",
        "sigma", "equivalentPlasticStrain", "displacement"
    };
    choose("field to set", name, settable);

    PointCloud<Dim>& cloud = state_.cloud;
    const std::size_t n = cloud.size();
    const int nComponents = Run::nComponents(name);
    requireSize(name, values.size(), nPoints_*nComponents);
    for (const double value : values)
    {
        require(std::isfinite(value), name, value, "finite");
    }

    wakeAll(state_);

    const auto scalars = [&](std::vector<double>& target)
    {
        for (std::size_t i = 0; i < n; ++i)
        {
            target[i] = values[cloud.id[i]];
        }
    };
    const auto arrays = [&](auto& target)
    {
        for (std::size_t i = 0; i < n; ++i)
        {
            std::copy_n
            (
                values.begin() + std::size_t(cloud.id[i])*nComponents,
                target[i].size(),
                target[i].begin()
            );
        }
    };

    if (name == "cohesionIntercept") scalars(cloud.cohesion);
    else if (name == "frictionAngle") setFrictionAngle(values);
    else if (name == "porePressure") scalars(cloud.porePressure);
    else if (name == "equivalentPlasticStrain")
    {
        scalars(cloud.plasticStrain);
        if (state_.laws.nonlocal())
        {
            cloud.keepSofteningStrain();
        }
    }
    else if (name == "sigma")
    {
        std::vector<double> own;
        for (std::size_t i = 0; i < n; ++i)
        {
            const auto first =
                values.begin() + std::size_t(cloud.id[i])*nComponents;
            own.insert(own.end(), first, first + nComponents);
        }
        state_.communicator->agree
        (
            [&]() { refuseStressOfDeformation(own); }
        );
        arrays(cloud.sigma);
        startAccount();
    }
    else if (name == "displacement") arrays(cloud.displacement);
    else
    {
        arrays(cloud.v);
        findSpeeds();
        startAccount();
    }
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template void mpm::Simulation<2>::refuseStressOfDeformation
(
    const std::vector<double>&
) const;
template void mpm::Simulation<3>::refuseStressOfDeformation
(
    const std::vector<double>&
) const;

template void mpm::Simulation<2>::setFrictionAngle(const std::vector<double>&);
template void mpm::Simulation<3>::setFrictionAngle(const std::vector<double>&);

#define instantiate(Dim)                                                       \
    template std::vector<double> mpm::Simulation<Dim>::ownField                \
    (                                                                          \
        const std::string&                                                     \
    ) const;                                                                   \
    template std::vector<double> mpm::Simulation<Dim>::field                   \
    (                                                                          \
        const std::string&                                                     \
    ) const;                                                                   \
    template void mpm::Simulation<Dim>::setField                               \
    (                                                                          \
        const std::string&,                                                    \
        const std::vector<double>&                                             \
    );

instantiate(2)
instantiate(3)

#undef instantiate


// ************************************************************************* //
