// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Assembly and solution of the energy equation, in K/s.
#include "coupling/fluid/fluidEnergy.H"
#include "coupling/fluid/rankPatches.H"

#include "EulerDdtScheme.H"
#include "fvcDiv.H"
#include "fvmDiv.H"
#include "fvmLaplacian.H"
#include "fvmSup.H"

namespace Foam
{
namespace nscdCoupling
{

FluidEnergy::FluidEnergy(const FluidSolver& fluid, const volScalarField& fluidFraction, const FluidHeat& properties)
:
    fluid_(fluid),
    fluidFraction_(fluidFraction),
    properties_(properties),
    T_(IOobject("T", fluid.U().time().timeName(), fluid.U().mesh(), IOobject::MUST_READ, IOobject::AUTO_WRITE), fluid.U().mesh()),
    conductance_(T_.size(), Zero),
    given_(T_.size(), Zero)
{
    fillRankPatches(T_);
}


tmp<fvScalarMatrix> FluidEnergy::equation()
{
    const fvMesh& mesh = T_.mesh();
    const dimensionedScalar laminar("k", dimViscosity, properties_.conductivity/perVolume());
    const volScalarField diffusivity("diffusivity", fluidFraction_*(laminar + fluid_.nut()/properties_.turbulentPrandtl));
    tmp<fvScalarMatrix> matrix
    (
        fv::EulerDdtScheme<scalar>(mesh).fvmDdt(fluidFraction_, T_)
      + fvm::div(fluid_.phi(), T_, "div(phi,T)") - fvm::Sp(fvc::div(fluid_.phi()), T_)
      - fvm::laplacian(diffusivity, T_, "laplacian(diffusivity,T)")
    );
    matrix.ref().diag() += conductance_*mesh.V().field()/perVolume();
    matrix.ref().source() += given_*mesh.V().field()/perVolume();
    return matrix;
}


FluidHeatStep FluidEnergy::solve()
{
    const fvMesh& mesh = T_.mesh();
    FluidHeatStep step;
    step.before = content();
    const tmp<fvScalarMatrix> matrix(equation());
    matrix.constCast().solve(mesh.solverDict(T_.name()));
    const scalarField carried(fluidFraction_.primitiveField() - mesh.time().deltaTValue()*fvc::div(fluid_.phi())().primitiveField());
    step.after = contentOf(carried, T_.primitiveField());
    step.inflow = inflowOf(matrix());
    return step;
}


scalar FluidEnergy::content() const { return contentOf(fluidFraction_.primitiveField(), T_.primitiveField()); }


scalar FluidEnergy::contentOf(const scalarField& fraction, const scalarField& temperature) const
{
    return perVolume()*gSum((T_.mesh().V().field()*fraction*temperature)());
}


// By the coefficients that the patches gave to the matrix: those of flow and of conduction together.
scalar FluidEnergy::inflowOf(const fvScalarMatrix& equation) const
{
    scalar sum = 0;
    forAll(T_.boundaryField(), patchi)
    {
        const fvPatchScalarField& patch = T_.boundaryField()[patchi];
        if (patch.coupled()) continue;
        const scalarField inside(patch.patchInternalField());
        sum += Foam::sum(equation.boundaryCoeffs()[patchi] - equation.internalCoeffs()[patchi]*inside);
    }
    reduce(sum, sumOp<scalar>());
    return sum*perVolume()*T_.time().deltaTValue();
}

} // namespace nscdCoupling
} // namespace Foam
