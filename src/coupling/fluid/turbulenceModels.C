// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// OpenFOAM's turbulence models for a fluid of constant density that fills a fraction of space, compiled for us.

#include "coupling/fluid/turbulenceModels.H"

#include "TurbulenceModel.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMatrices.H"
#include "incompressibleTurbulenceModel.H"
#include "makeTurbulenceModel.H"

#include "LESModel.H"
#include "RASModel.H"
#include "laminarModel.H"

#include "Smagorinsky.H"
#include "Stokes.H"
#include "kEpsilon.H"
#include "kEqn.H"
#include "kOmegaSST.H"
#include "realizableKE.H"

namespace Foam
{

/// What OpenFOAM's models are built on here: the fluid fraction as their alpha, 1 as their rho. A class of our own, since
/// OpenFOAM's phaseIncompressible means that in v1912 and another thing (alpha 1, a rho that varies) from v2012 on.
template<class Transport>
class FluidFractionTurbulenceModel
:
    public TurbulenceModel<volScalarField, geometricOneField, incompressibleTurbulenceModel, Transport>
{
public:

    FluidFractionTurbulenceModel
    (
        const word&, const volScalarField& fluidFraction, const geometricOneField& one, const volVectorField& U,
        const surfaceScalarField& superficialFlux, const surfaceScalarField& interstitialFlux, const Transport& transport,
        const word& propertiesName
    )
    :
        TurbulenceModel<volScalarField, geometricOneField, incompressibleTurbulenceModel, Transport>
        (
            fluidFraction, one, U, superficialFlux, interstitialFlux, transport, propertiesName
        )
    {}

    // Stresses that OpenFOAM's own solvers ask for: FluidTurbulence makes ours. From v2012 on there is a second devReff.

    tmp<volSymmTensorField> devReff() const override
    {
        NotImplemented;
        return nullptr;
    }

    virtual tmp<volSymmTensorField> devReff(const volVectorField&) const
    {
        NotImplemented;
        return nullptr;
    }

    tmp<fvVectorMatrix> divDevReff(volVectorField&) const override
    {
        NotImplemented;
        return nullptr;
    }
};

} // namespace Foam

makeTurbulenceModelTypes
(
    volScalarField,
    geometricOneField,
    incompressibleTurbulenceModel,
    FluidFractionTurbulenceModel,
    singlePhaseTransportModel
);

makeBaseTurbulenceModel
(
    volScalarField,
    geometricOneField,
    incompressibleTurbulenceModel,
    FluidFractionTurbulenceModel,
    singlePhaseTransportModel
);

#define makeFluidModel(Family, Type)                                           \
    makeTemplatedTurbulenceModel                                               \
    (singlePhaseTransportModelFluidFractionTurbulenceModel, Family, Type)

makeFluidModel(laminar, Stokes)
makeFluidModel(RAS, kEpsilon)
makeFluidModel(RAS, realizableKE)
makeFluidModel(RAS, kOmegaSST)
makeFluidModel(LES, Smagorinsky)
makeFluidModel(LES, kEqn)

namespace Foam
{
namespace nscdCoupling
{

autoPtr<turbulenceModel> selectTurbulenceModel
(
    const volScalarField& fluidFraction, const volVectorField& U, const surfaceScalarField& superficialFlux,
    const surfaceScalarField& interstitialFlux, const singlePhaseTransportModel& transport
)
{
    using Models = TurbulenceModel<volScalarField, geometricOneField, incompressibleTurbulenceModel, singlePhaseTransportModel>;
    return autoPtr<turbulenceModel>
    (
        Models::New(fluidFraction, geometricOneField(), U, superficialFlux, interstitialFlux, transport).ptr()
    );
}

} // namespace nscdCoupling
} // namespace Foam
