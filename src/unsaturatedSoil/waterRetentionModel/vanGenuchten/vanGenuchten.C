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

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    // Beyond this ln[(alpha s)^n] one is nothing beside (alpha s)^n
    const Foam::scalar dry = 40;
}

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


Foam::scalar Foam::waterRetentionModels::vanGenuchten::logPores
(
    const scalar h
) const
{
    const scalar lx = logX(h);

    if (lx > dry)
    {
        return std::log(m_) - lx;
    }

    // Where exp(-a) is the smaller part log1p keeps its digits, else expm1
    const scalar a = m_*logOnePlusExp(-lx);

    return
        a > 0.7 ? std::log1p(-std::exp(-a)) : std::log(-std::expm1(-a));
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
    logSc_(0),
    logSaturatedPores_(0)
{
    checkKeys
    (
        dict,
        {"type", "thetaS", "thetaR", "alpha", "m", "n", "airEntryHead"}
    );
    warnUnlessUsual(dict, "alpha", alpha_, {0.05, 100}, "0.05 to 100 1/m");

    if (saturationHead_ < 0)
    {
        logSc_ = -m_*logOnePlusExp(logX(saturationHead_));
        logSaturatedPores_ = logPores(saturationHead_);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::waterRetentionModels::vanGenuchten::logSe
(
    const scalar h
) const
{
    return
        h < saturationHead_ ? -m_*logOnePlusExp(logX(h)) - logSc_ : 0;
}


Foam::scalar Foam::waterRetentionModels::vanGenuchten::dlogSedh
(
    const scalar h
) const
{
    if (h >= saturationHead_)
    {
        return 0;
    }

    // d(lx)/dh = n/h; d/dt ln(1 + e^t) = 1/(1 + e^-t)
    return -m_*n_/h*std::exp(-logOnePlusExp(-logX(h)));
}


Foam::scalar Foam::waterRetentionModels::vanGenuchten::SeIntegral
(
    const scalar h
) const
{
    // Below this suction 1 - Se is under round-off (exp(-37) = 1e-16)
    const scalar full =
        max(-saturationHead_, std::exp(-37/n_)/alpha_);

    return -h <= full ? h : -(full + integrateSe(full, -h, n_));
}


Foam::scalar Foam::waterRetentionModels::vanGenuchten::logPoreIntegral
(
    const label,
    const scalar h
) const
{
    return
        h < saturationHead_ ? logPores(h) - logSaturatedPores_ : 0;
}


Foam::scalar Foam::waterRetentionModels::vanGenuchten::dlogPoreIntegraldh
(
    const label,
    const scalar h
) const
{
    if (h >= saturationHead_)
    {
        return 0;
    }

    const scalar lx = logX(h);

    if (lx > dry)
    {
        return -n_/h;
    }

    // d ln(1 - e^-a)/da = e^-a/(1 - e^-a)
    const scalar a = m_*logOnePlusExp(-lx);

    return
       -m_*n_/h*std::exp(-logOnePlusExp(lx))
       *std::exp(-a)/(-std::expm1(-a));
}

// ************************************************************************* //
