// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Assembly of the momentum equation and the velocity predictor.

#include "coupling/fluid/momentumEquation.H"

#include "fvcDdt.H"
#include "fvcDiv.H"
#include "fvcGrad.H"
#include "fvmDdt.H"
#include "fvmDiv.H"
#include "fvmSup.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

// Stress and options, per volume of the mixture.
tmp<fvVectorMatrix> stressAndOptions(volVectorField& U, const GrainSources& sources, const fvVectorMatrix& minusDivTau, fv::options& options)
{
    if (!sources.isModelB)
    {
        tmp<fvVectorMatrix> both(minusDivTau - options(U));
        both.ref() *= sources.fluidFraction();
        return both;
    }
    tmp<fvVectorMatrix> given(options(U));
    given.ref() *= sources.fluidFraction();
    return minusDivTau - given;
}

} // End anonymous namespace


tmp<fvVectorMatrix> averagedMomentum
(
    FluidFields& fields,
    const GrainSources& sources,
    const fvVectorMatrix& minusDivTau,
    const surfaceScalarField& convecting,
    fv::options& options
)
{
    volVectorField& U = fields.U;
    const volScalarField& fluidFraction = sources.fluidFraction;

    tmp<volScalarField> storage(fvc::div(convecting));
    if (!sources.isStatic) storage.ref() += fvc::ddt(fluidFraction);

    return fvm::ddt(fluidFraction, U) + fvm::div(convecting, U, "div(phi,U)") - fvm::Sp(storage, U)
      + stressAndOptions(U, sources, minusDivTau, options);
}


tmp<fvVectorMatrix> plainMomentum
(
    FluidFields& fields, const FluidTurbulence& turbulence, const surfaceScalarField& convecting, fv::options& options
)
{
    volVectorField& U = fields.U;
    tmp<fvVectorMatrix> momentum
    (
        fvm::ddt(U) + fvm::div(convecting, U, "div(phi,U)") + turbulence.minusDivTau(U, U) == options(U)
    );
    if (fields.bodyAcceleration.valid()) momentum.ref() -= fields.bodyAcceleration();
    if (fields.volumeSource.valid()) momentum.ref() -= fvm::Sp(fields.volumeSource(), U);
    return momentum;
}


void predictVelocity
(
    FluidFields& fields,
    const GrainSources& sources,
    const GrainFaceTerms& terms,
    const fvVectorMatrix& momentum,
    const dimensionedScalar& rho
)
{
    const volScalarField& fluidFraction = sources.fluidFraction;
    const volVectorField pressureForce("pressureForce", fields.balancedGradient/rho);

    fvVectorMatrix predictor
    (
        terms.response.valid()
      ? momentum == fluidFraction*(terms.force - terms.response->chi*pressureForce)
      : momentum == fluidFraction*(terms.force - pressureForce)
    );
    predictor.diag() += sources.drag.primitiveField()*fluidFraction.mesh().V();
    predictor.solve();
}


void predictPlainVelocity(FluidFields& fields, const fvVectorMatrix& momentum, const dimensionedScalar& rho)
{
    solve(momentum == -fvc::grad(fields.pRgh)/rho);
}

} // End namespace nscdCoupling
} // End namespace Foam
