// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Sums over patches.
#include "coupling/case/log/inflow.H"

#include "nscd/base/formattedText.hpp"

#include "surfaceFields.H"

namespace Foam
{
namespace nscdCoupling
{

using ::nscd::formatted;

namespace
{

string describe(const word& name, scalar flow, scalar area, scalar areaOfFluid)
{
    return formatted
    (
        "%s: %.4g m/s superficial, %.4g m/s interstitial (alpha.fluid %.4g), %.4g m3/s",
        name.c_str(), flow/area, flow/areaOfFluid, areaOfFluid/area, flow
    );
}

} // namespace


stringList describeInflow(const volVectorField& U, const volScalarField& fluidFraction)
{
    // Values that follow time or the void fraction are those of the last write until somebody asks for them.
    volVectorField now("inflow", U);
    now.correctBoundaryConditions();
    stringList lines;
    for (const fvPatch& patch : U.mesh().boundary())
    {
        if (patch.coupled()) continue;
        const fvPatchScalarField& alpha = fluidFraction.boundaryField()[patch.index()];
        const scalar flow = -gSum(alpha*(now.boundaryField()[patch.index()] & patch.Sf()));
        const scalar area = gSum(patch.magSf()), areaOfFluid = gSum(alpha*patch.magSf());
        if (flow > SMALL*area) lines.append(describe(patch.name(), flow, area, areaOfFluid));
    }
    return lines;
}

} // namespace nscdCoupling
} // namespace Foam
