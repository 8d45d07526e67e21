// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// OpenFOAM's turbulence models for a fluid of constant density that fills a fraction of space, compiled for us.

#include "PhaseIncompressibleTurbulenceModel.H"
#include "addToRunTimeSelectionTable.H"
#include "makeTurbulenceModel.H"
#include "singlePhaseTransportModel.H"

#include "LESModel.H"
#include "RASModel.H"
#include "laminarModel.H"

#include "Smagorinsky.H"
#include "Stokes.H"
#include "kEpsilon.H"
#include "kEqn.H"
#include "kOmegaSST.H"
#include "realizableKE.H"

makeTurbulenceModelTypes
(
    volScalarField,
    geometricOneField,
    incompressibleTurbulenceModel,
    PhaseIncompressibleTurbulenceModel,
    singlePhaseTransportModel
);

makeBaseTurbulenceModel
(
    volScalarField,
    geometricOneField,
    incompressibleTurbulenceModel,
    PhaseIncompressibleTurbulenceModel,
    singlePhaseTransportModel
);

#define makeFluidModel(Family, Type)                                           \
    makeTemplatedTurbulenceModel                                               \
    (singlePhaseTransportModelPhaseIncompressibleTurbulenceModel, Family, Type)

makeFluidModel(laminar, Stokes)
makeFluidModel(RAS, kEpsilon)
makeFluidModel(RAS, realizableKE)
makeFluidModel(RAS, kOmegaSST)
makeFluidModel(LES, Smagorinsky)
makeFluidModel(LES, kEqn)
