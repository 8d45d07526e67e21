// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// The stress of the averaged fluid and the update of its viscosity.

#include "coupling/fluid/fluidTurbulence.H"
#include "coupling/fluid/turbulenceModels.H"

#include "fvcDiv.H"
#include "fvcGrad.H"
#include "fvcSnGrad.H"
#include "fvmLaplacian.H"
#include "linear.H"

namespace Foam
{
namespace nscdCoupling
{

FluidTurbulence::FluidTurbulence
(
    const volScalarField& fluidFraction, const volVectorField& U, const surfaceScalarField& phi
)
:
    fluidFraction_(fluidFraction),
    phi_(phi),
    phiInterstitial_("phiInterstitial", phi/linearInterpolate(fluidFraction)),
    transport_(U, phi),
    rho_("rho", dimDensity, transport_),
    model_(selectTurbulenceModel(fluidFraction, U, phi, phiInterstitial_, transport_)),
    isLaminar_(IOdictionary(model_()).get<word>("simulationType") == "laminar")
{
    model_->validate();
}


FluidTurbulence::~FluidTurbulence() = default;


tmp<volScalarField> FluidTurbulence::nut() const { return model_->nut(); }


// The schemes are named as in pimpleFoam, so that its fvSchemes serve here too.
tmp<fvVectorMatrix> FluidTurbulence::minusDivTau(volVectorField& U, const volVectorField& known) const
{
    const volScalarField nuEff("nuEff", model_->nuEff());
    return
    (
      - fvc::div(nuEff*dev2(T(fvc::grad(known))), "div((nuEff*dev2(T(grad(U)))))")
      - fvm::laplacian(nuEff, U, "laplacian(nuEff,U)")
    );
}


tmp<surfaceVectorField> FluidTurbulence::stressFlux(const volVectorField& U) const
{
    const volScalarField nuEff("nuEff", model_->nuEff());
    return linearInterpolate(nuEff)*U.mesh().magSf()*fvc::snGrad(U)
      + (U.mesh().Sf() & linearInterpolate(nuEff*dev2(T(fvc::grad(U)))));
}


void FluidTurbulence::correct()
{
    transport_.correct();
    if (!isLaminar_) updateInterstitialFlux();
    model_->correct();
}


void FluidTurbulence::updateInterstitialFlux()
{
    phiInterstitial_ = phi_/linearInterpolate(fluidFraction_);
}

} // End namespace nscdCoupling
} // End namespace Foam
