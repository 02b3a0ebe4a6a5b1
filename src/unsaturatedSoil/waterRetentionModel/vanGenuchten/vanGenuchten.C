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

#include "vanGenuchten.H"
#include "readChecked.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace waterRetentionModels
{
    defineTypeNameAndDebug(vanGenuchten, 0);
    addToRunTimeSelectionTable(waterRetentionModel, vanGenuchten, dictionary);
}
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::waterRetentionModels::vanGenuchten::readM
(
    const dictionary& dict
)
{
    const bool hasM = dict.found("m");
    const bool hasN = dict.found("n");

    if (!hasM && !hasN)
    {
        FatalIOErrorInFunction(dict)
            << "Neither 'm' (0 < m < 1) nor 'n' (n > 1) is given in "
            << dict.name() << nl
            << exit(FatalIOError);
    }

    const scalar m =
        hasM
      ? readChecked
        (
            dict,
            "m",
            [](const scalar x) { return x > 0 && x < 1; },
            "0 < m < 1"
        )
      : 0;

    const scalar n =
        hasN
      ? readChecked
        (
            dict,
            "n",
            [](const scalar x) { return x > 1; },
            "n > 1"
        )
      : 1/(1 - m);

    const scalar mOfN = 1 - 1/n;

    // Published tables round m and n to three or four digits
    if (hasM && hasN && mag(m - mOfN) > 1e-3)
    {
        FatalIOErrorInFunction(dict)
            << "Entries 'm' " << m << " and 'n' " << n << " of "
            << dict.name() << " disagree: 1 - 1/n = " << mOfN
            << ". Give one of them" << nl
            << exit(FatalIOError);
    }

    return hasM ? m : mOfN;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::waterRetentionModels::vanGenuchten::vanGenuchten(const dictionary& dict)
:
    waterRetentionModel(dict),
    alpha_
    (
        readChecked
        (
            dict,
            "alpha",
            [](const scalar x) { return x > 0; },
            "alpha > 0 [1/m]"
        )
    ),
    m_(readM(dict)),
    n_(1/(1 - m_)),
    saturationHead_
    (
        -readCheckedOrDefault
        (
            dict,
            "airEntryHead",
            0,
            [](const scalar x) { return x >= 0; },
            "airEntryHead >= 0 [m of suction]"
        )
    ),
    logSc_(0)
{
    if (saturationHead_ < 0)
    {
        logSc_ = -m_*logOnePlusExp(logX(saturationHead_));
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::waterRetentionModels::vanGenuchten::Se(const scalar h) const
{
    return std::exp(logSaturation(h));
}


Foam::scalar Foam::waterRetentionModels::vanGenuchten::desaturation
(
    const scalar h
) const
{
    return -std::expm1(logSaturation(h));
}


Foam::scalar Foam::waterRetentionModels::vanGenuchten::dSedh
(
    const scalar h
) const
{
    if (h >= saturationHead_)
    {
        return 0;
    }

    // alpha m n (alpha s)^(n - 1) [1 + (alpha s)^n]^(-m - 1)/Sc
    const scalar lx = logX(h);

    return
        alpha_*m_*n_
       *std::exp((1 - 1/n_)*lx - (m_ + 1)*logOnePlusExp(lx) - logSc_);
}


Foam::scalar Foam::waterRetentionModels::vanGenuchten::headOfSe
(
    const scalar Se
) const
{
    if (Se >= 1)
    {
        return saturationHead_;
    }

    // ln(x) for x = (Sc Se)^(-1/m) - 1, written so that exp cannot overflow
    const scalar t = -(std::log(Se) + logSc_)/m_;
    const scalar lx = t + std::log(-std::expm1(-t));

    return -std::exp(lx/n_)/alpha_;
}


Foam::scalar Foam::waterRetentionModels::vanGenuchten::SeIntegral
(
    const scalar h
) const
{
    if (h >= saturationHead_)
    {
        return h;
    }

    // Eight-point Gauss nodes and weights on [-1, 1]
    static const scalar node[4] =
    {
        0.1834346424956498049394761, 0.5255324099163289858177390,
        0.7966664774136267395915539, 0.9602898564975362316835609
    };
    static const scalar weight[4] =
    {
        0.3626837833783619829651504, 0.3137066458778872873379622,
        0.2223810344533744705443560, 0.1012285362903762591525314
    };

    // Below this suction 1 - Se is under round-off (exp(-37) = 1e-16)
    const scalar full =
        max(-saturationHead_, std::exp(-37/n_)/alpha_);

    if (-h <= full)
    {
        return h;
    }

    // The integrand Se(s) s is analytic in ln(s) within pi/n of the real axis:
    // panels of a third of that lose nothing
    const scalar range = std::log(-h/full);
    const label nPanels = 1 + label(range*max(n_, scalar(2)));
    const scalar half = 0.5*range/nPanels;

    scalar sum = 0;

    for (label panel = 0; panel < nPanels; ++panel)
    {
        const scalar centre = std::log(full) + (2*panel + 1)*half;

        for (label i = 0; i < 4; ++i)
        {
            for (const scalar side : {-1.0, 1.0})
            {
                const scalar s = std::exp(centre + side*node[i]*half);

                sum += weight[i]*half*s*std::exp(logSe(-s));
            }
        }
    }

    return -(full + sum);
}


void Foam::waterRetentionModels::vanGenuchten::logSlopes
(
    const scalar h,
    scalar& logSaturationSlope,
    scalar& poreExponentSlope
) const
{
    // d(lx)/dh = n/h; d/dt ln(1 + e^t) = 1/(1 + e^-t)
    const scalar lx = logX(h);
    const scalar slope = -m_*n_/h;

    logSaturationSlope = slope*std::exp(-logOnePlusExp(-lx));
    poreExponentSlope = slope*std::exp(-logOnePlusExp(lx));
}

// ************************************************************************* //
