// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Sums over cells and patches.

#include "coupling/fluid/fluidBalance.H"

#include "fvcSurfaceIntegrate.H"

namespace Foam
{
namespace nscdCoupling
{

CourantNumber courantNumber(const surfaceScalarField& phi, const volScalarField& fluidFraction)
{
    const fvMesh& mesh = phi.mesh();
    const scalarField outflow(0.5*fvc::surfaceSum(mag(phi))().primitiveField()/fluidFraction.primitiveField());
    const scalar deltaT = mesh.time().deltaTValue();
    return CourantNumber
    {
        deltaT*gSum(outflow)/gSum(mesh.V()),
        deltaT*gMax((outflow/mesh.V().field())())
    };
}


FluidMomentum fluidMomentum
(
    const FluidFields& fields, const volScalarField& fluidFraction, const FluidTurbulence& turbulence
)
{
    const fvMesh& mesh = fluidFraction.mesh();
    const scalar rho = turbulence.rho().value();
    const surfaceVectorField stress(turbulence.stressFlux(fields.U));

    FluidMomentum momentum;
    momentum.inside = rho*sum(mesh.V().field()*fluidFraction.primitiveField()*fields.U.primitiveField());
    forAll(mesh.boundary(), patchi)
    {
        if (mesh.boundary()[patchi].coupled()) continue;
        momentum.convected += rho*sum(fields.U.boundaryField()[patchi]*fields.phi.boundaryField()[patchi]);
        momentum.pressureForce -= sum(fields.pRgh.boundaryField()[patchi]*mesh.Sf().boundaryField()[patchi]);
        momentum.viscousForce += rho*sum(stress.boundaryField()[patchi]);
    }
    reduce(momentum.inside, sumOp<vector>());
    reduce(momentum.convected, sumOp<vector>());
    reduce(momentum.pressureForce, sumOp<vector>());
    reduce(momentum.viscousForce, sumOp<vector>());
    return momentum;
}

} // End namespace nscdCoupling
} // End namespace Foam
