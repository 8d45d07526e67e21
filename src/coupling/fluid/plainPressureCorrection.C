// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Pressure correction of a fluid without grains: OpenFOAM's own PISO step, with p_rgh in Pa.

#include "coupling/fluid/pressureCorrection.H"

#include "adjustPhi.H"
#include "constrainHbyA.H"
#include "constrainPressure.H"
#include "fvcDdt.H"
#include "fvcDiv.H"
#include "fvcFlux.H"
#include "fvcGrad.H"
#include "fvcMeshPhi.H"
#include "fvmLaplacian.H"

namespace Foam
{
namespace nscdCoupling
{

// What pimpleFoam has and the grains' equations leave out: the ddtCorr flux (it is unstable at jumps of alpha), and the
// Gauss gradient in the cells.
void PressureCorrection::correctPlain
(
    FluidFields& fields, const fvVectorMatrix& momentum, const dimensionedScalar& rho
)
{
    volVectorField& U = fields.U;
    volScalarField& pRgh = fields.pRgh;

    const volScalarField rAU("rAU", 1/momentum.A());
    const volVectorField HbyA(constrainHbyA(rAU*momentum.H(), U, pRgh));
    const bool moves = mesh_.moving();
    const tmp<surfaceScalarField> past(moves ? fvc::ddtCorr(U, fields.faceVelocity()) : fvc::ddtCorr(U, fields.phi));
    surfaceScalarField freeFlux("phiHbyA", fvc::flux(HbyA) + fvc::interpolate(rAU)*past);
    if (pRgh.needReference())
    {
        fvc::makeRelative(freeFlux, U);
        adjustPhi(freeFlux, U, pRgh);
        fvc::makeAbsolute(freeFlux, U);
    }

    const surfaceScalarField mobility(fvc::interpolate(rAU));
    constrainPressure(pRgh, U, freeFlux, (mobility/rho)());
    fields.phi = freeFlux - solvePressure(fields, freeFlux, mobility, rho);
    pRgh.relax();

    fields.balancedGradient = fvc::grad(pRgh);
    U = HbyA - rAU/rho*fields.balancedGradient;
    U.correctBoundaryConditions();
}

} // End namespace nscdCoupling
} // End namespace Foam
