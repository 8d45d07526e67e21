// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// The mean-flow gradient: response of the flux to a unit gradient, and superposition.

#include "coupling/fluid/meanFlow.H"

#include "cyclicFvPatch.H"
#include "fvcDiv.H"
#include "fvmLaplacian.H"
#include "processorCyclicFvPatch.H"
#include "zeroGradientFvPatchFields.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

labelList periodicAxes(const fvMesh& mesh)
{
    labelList axes;
    for (label axis = 0; axis < 3; ++axis)
    {
        scalar across = 0;
        for (const fvPatch& patch : mesh.boundary())
        {
            if (!isA<cyclicFvPatch>(patch) && !isA<processorCyclicFvPatch>(patch)) continue;
            across += sum(mag(patch.Sf().component(axis)));
        }
        reduce(across, sumOp<scalar>());
        if (across > SMALL*gSum(mesh.magSf().primitiveField())) axes.append(axis);
    }
    return axes;
}

vector readTarget(const dictionary& dict, const labelList& axes)
{
    if (dict.empty()) return Zero;

    const vector target = dict.get<vector>("target");
    for (label axis = 0; axis < 3; ++axis)
    {
        if (mag(target[axis]) > 0 && !axes.found(axis))
        {
            FatalIOErrorInFunction(dict)
                << "target " << target << " asks for a mean flow along axis " << axis
                << ", which has no cyclic patches" << exit(FatalIOError);
        }
    }
    return target;
}

} // End anonymous namespace


bool MeanFlowGradient::writeData(Ostream& os) const
{
    const int precision = os.precision(17);
    const bool isWritten = UniformDimensionedField<vector>::writeData(os);
    os.precision(precision);
    return isWritten;
}


MeanFlow::MeanFlow(const fvMesh& mesh, const dictionary& dict)
:
    mesh_(mesh),
    isHeld_(!dict.empty()),
    target_(readTarget(dict, periodicAxes(mesh))),
    axes_(isHeld_ ? periodicAxes(mesh) : labelList()),
    gradient_
    (
        IOobject
        (
            "meanFlowGradient", mesh.time().timeName(), "uniform", mesh,
            IOobject::READ_IF_PRESENT, isHeld_ ? IOobject::AUTO_WRITE : IOobject::NO_WRITE
        ),
        dimensionedVector("meanFlowGradient", dimPressure/dimLength, Zero)
    ),
    potential_(axes_.size())
{
    forAll(axes_, i)
    {
        const word name("meanFlowPotential" + Foam::name(i));
        potential_.set
        (
            i,
            new volScalarField
            (
                IOobject(name, mesh.time().timeName(), mesh, IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE),
                mesh,
                dimensionedScalar(dimLength, Zero),
                zeroGradientFvPatchScalarField::typeName
            )
        );
        mesh.setFluxRequired(name);
    }
}


tmp<surfaceScalarField> MeanFlow::gradientFlux(const dimensionedScalar& rho) const
{
    return (gradient_/rho) & mesh_.Sf();
}


// sum over faces of flux times the distance between the cell centers it joins: integral of a divergence-free vector.
vector MeanFlow::mean(const surfaceScalarField& flux) const
{
    const surfaceVectorField delta(mesh_.delta());
    vector moment = sum(flux.primitiveField()*delta.primitiveField());
    forAll(mesh_.boundary(), patchi)
    {
        // Each coupled pair of faces is met from both sides.
        if (!mesh_.boundary()[patchi].coupled()) continue;
        moment += 0.5*sum(flux.boundaryField()[patchi]*delta.boundaryField()[patchi]);
    }
    reduce(moment, sumOp<vector>());
    return moment/gSum(mesh_.V());
}


tmp<surfaceScalarField> MeanFlow::unitResponse
(
    const label i, const surfaceScalarField& mobility, const label refCell
)
{
    vector unit = Zero;
    unit[axes_[i]] = 1;
    surfaceScalarField gradientFlux("unitGradientFlux", dimensionedVector("unit", dimless, unit) & mesh_.Sf());
    forAll(mesh_.boundary(), patchi)
    {
        if (!mesh_.boundary()[patchi].coupled()) gradientFlux.boundaryFieldRef()[patchi] = 0;
    }

    fvScalarMatrix equation
    (
        fvm::laplacian(mobility, potential_[i], "laplacian(rAU,p_rgh)") == -fvc::div(mobility*gradientFlux)
    );
    equation.setReference(refCell, 0);
    equation.solve(mesh_.solver("p_rghFinal"));
    gradientFlux += equation.flux()/mobility;
    return tmp<surfaceScalarField>(new surfaceScalarField(gradientFlux));
}


void MeanFlow::hold
(
    surfaceScalarField& mixtureFlux,
    surfaceScalarField& gradientFlux,
    volScalarField& pRgh,
    const surfaceScalarField& mobility,
    const dimensionedScalar& rho,
    const label refCell
)
{
    // Without a flux through the walls the identity keeps the response regular along directions that are not periodic.
    tensor response = tensor::I;
    PtrList<surfaceScalarField> responses(axes_.size());
    forAll(axes_, i)
    {
        responses.set(i, unitResponse(i, mobility, refCell));
        const vector flux = mean(mobility*responses[i]);
        for (const label axis : axes_) response(axis, axes_[i]) = flux[axis];
    }

    const vector excess = mean(mixtureFlux) - target_;
    vector change = Zero;
    for (const label axis : axes_) change[axis] = excess[axis];
    applyChange(inv(response) & change, responses, mixtureFlux, gradientFlux, pRgh, mobility, rho);
}


void MeanFlow::applyChange
(
    const vector& change,
    const PtrList<surfaceScalarField>& responses,
    surfaceScalarField& mixtureFlux,
    surfaceScalarField& gradientFlux,
    volScalarField& pRgh,
    const surfaceScalarField& mobility,
    const dimensionedScalar& rho
)
{
    forAll(axes_, i)
    {
        const dimensionedScalar step("step", dimAcceleration, change[axes_[i]]);
        gradientFlux += step*responses[i];
        mixtureFlux -= step*mobility*responses[i];
        pRgh += rho*step*potential_[i];
        gradient_.value()[axes_[i]] += rho.value()*step.value();
    }
}

} // End namespace nscdCoupling
} // End namespace Foam
