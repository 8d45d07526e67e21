// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Conservative smoothing of cell fields over a length, by one implicit diffusion step.
#include "coupling/mapping/diffusionSmoother.H"

#include "cyclicAMIFvPatch.H"
#include "cyclicPolyPatch.H"
#include "processorFvPatch.H"
#include "gaussLaplacianScheme.H"
#include "surfaceFields.H"
#include "zeroGradientFvPatchFields.H"

#include <cmath>

namespace Foam
{
namespace nscdCoupling
{
namespace
{

dictionary tightSolver()
{
    dictionary controls;
    controls.add("solver", word("PCG"));
    controls.add("preconditioner", word("DIC"));
    controls.add("tolerance", 1e-13);
    controls.add("relTol", 0);
    controls.add("maxIter", 1000);
    return controls;
}

wordList borderTypes(const fvMesh& mesh)
{
    wordList types(mesh.boundary().size(), zeroGradientFvPatchScalarField::typeName);
    forAll(types, patchI)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchI];
        if (polyPatch::constraintType(patch.type()))
        {
            types[patchI] = patch.type();
        }
    }
    return types;
}

/// Grains reach no cells beyond a patch between halves of a mesh that slide past each other, and neither does what they are smoothed to.
void closeSliding(surfaceScalarField& faces)
{
    forAll(faces.boundaryField(), patchI)
    {
        if (isA<cyclicAMIFvPatch>(faces.mesh().boundary()[patchI])) faces.boundaryFieldRef()[patchI] = 0;
    }
}

} // namespace

DiffusionSmoother::DiffusionSmoother(const fvMesh& mesh, const scalar length)
:
    mesh_(mesh),
    isOn_(length > 0),
    area_(sqr(length)/(16*std::log(2.0))),
    controls_(tightSolver())
{
    if (!isOn_)
    {
        return;
    }
    solution_.reset
    (
        new volScalarField
        (
            IOobject("smoothed", mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE, false),
            mesh,
            dimensionedScalar("zero", dimless, Zero),
            borderTypes(mesh)
        )
    );
    surfaceScalarField minusDiffusion("minusDiffusion", dimensionedScalar("diffusion", dimArea, -area_)*mesh.magSf());
    closeSliding(minusDiffusion);
    matrix_ = autoPtr<fvScalarMatrix>
    (
        fv::gaussLaplacianScheme<scalar, scalar>::fvmLaplacianUncorrected
        (
            minusDiffusion, mesh.nonOrthDeltaCoeffs(), solution_()
        ).ptr()
    );
    matrix_->diag() += mesh.V();
    addCoupledDiagonal();
}

void DiffusionSmoother::addCoupledDiagonal()
{
    forAll(mesh_.boundary(), patchI)
    {
        const labelUList& cells = mesh_.boundary()[patchI].faceCells();
        const scalarField& coefficients = matrix_->internalCoeffs()[patchI];
        forAll(coefficients, k)
        {
            matrix_->diag()[cells[k]] += coefficients[k];
        }
    }
}

scalarField DiffusionSmoother::netInflow(const scalarField& cells) const
{
    scalarField inflow(cells.size(), Zero);
    const auto exchange = [&](const label from, const label to, const scalar conductance)
    {
        const scalar flux = conductance*(cells[from] - cells[to]);
        inflow[from] -= flux;
        inflow[to] += flux;
    };
    const scalarField& upper = matrix_->upper();
    forAll(upper, faceI)
    {
        exchange(mesh_.owner()[faceI], mesh_.neighbour()[faceI], -upper[faceI]);
    }
    forAll(mesh_.boundaryMesh(), patchI)
    {
        const cyclicPolyPatch* cyclic = isA<cyclicPolyPatch>(mesh_.boundaryMesh()[patchI]);
        if (!cyclic || !cyclic->owner())
        {
            continue;
        }
        const scalarField& conductance = matrix_->boundaryCoeffs()[patchI];
        forAll(conductance, k)
        {
            exchange(cyclic->faceCells()[k], cyclic->neighbPatch().faceCells()[k], conductance[k]);
        }
    }
    addInflowFromRanks(cells, inflow);
    return inflow;
}

// Both ranks work out the flux, each from its own conductance: they agree to round-off, and so does what is lost and gained.
void DiffusionSmoother::addInflowFromRanks(const scalarField& cells, scalarField& inflow) const
{
    if (!Pstream::parRun())
    {
        return;
    }
    volScalarField& values = const_cast<volScalarField&>(solution_());
    values.primitiveFieldRef() = cells;
    values.correctBoundaryConditions();
    forAll(mesh_.boundary(), patchI)
    {
        if (!isA<processorFvPatch>(mesh_.boundary()[patchI]))
        {
            continue;
        }
        const labelUList& faceCells = mesh_.boundary()[patchI].faceCells();
        const scalarField& conductance = matrix_->boundaryCoeffs()[patchI];
        const scalarField behind(values.boundaryField()[patchI].patchNeighbourField());
        forAll(faceCells, k)
        {
            inflow[faceCells[k]] += conductance[k]*(behind[k] - cells[faceCells[k]]);
        }
    }
}

SmoothingReport DiffusionSmoother::smooth(scalarField& cells) const
{
    if (!isOn_)
    {
        return {};
    }
    fvScalarMatrix& matrix = const_cast<fvScalarMatrix&>(matrix_());
    scalarField change(cells.size(), Zero);
    const solverPerformance performance = lduMatrix::solver::New
    (
        solution_().name(),
        matrix,
        matrix.boundaryCoeffs(),
        matrix.internalCoeffs(),
        solution_().boundaryField().scalarInterfaces(),
        controls_
    )->solve(change, netInflow(cells));
    const scalarField& volumes = mesh_.V();
    vector2D sums(sum(volumes*change), sum(volumes));
    reduce(sums, sumOp<vector2D>());
    cells += change - sums.x()/sums.y();
    return {performance.nIterations(), performance.finalResidual(), performance.converged()};
}

SmoothingReport DiffusionSmoother::smooth(vectorField& cells) const
{
    SmoothingReport total;
    if (!isOn_)
    {
        return total;
    }
    for (direction axis = 0; axis < vector::nComponents; ++axis)
    {
        scalarField component(cells.component(axis));
        const SmoothingReport report = smooth(component);
        cells.replace(axis, component);
        total.iterations += report.iterations;
        total.residual = max(total.residual, report.residual);
        total.isConverged = total.isConverged && report.isConverged;
    }
    return total;
}

} // namespace nscdCoupling
} // namespace Foam
