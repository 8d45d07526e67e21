// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Pressure correction for a fluid between grains: everything is balanced on the faces.

#include "coupling/fluid/pressureCorrection.H"

#include "adjustPhi.H"
#include "constrainHbyA.H"
#include "constrainPressure.H"
#include "findRefCell.H"
#include "fvcDiv.H"
#include "fvcMeshPhi.H"
#include "fvmLaplacian.H"
#include "linear.H"
#include "surfaceInterpolate.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

tmp<surfaceScalarField> fluxOf(const volVectorField& cells)
{
    return cells.mesh().Sf() & fvc::interpolate(cells, "flux(HbyA)");
}

// What the mixture of fluid and grains does when the fluid alone obeys the given law.
// Equation: mixture flux = (1 + c) phi + A - Y grad p
FluxLaw mixtureLaw(const FluxLaw& fluid, const ResponseTerms& grains)
{
    return FluxLaw
    {
        (1 + grains.slip)*fluid.free + grains.carried,
        (1 + grains.slip)*fluid.mobility + grains.mobility
    };
}

tmp<volScalarField> divergenceLessSource(const surfaceScalarField& flux, const FluidFields& fields)
{
    tmp<volScalarField> divergence(fvc::div(flux));
    if (fields.volumeSource.valid()) divergence.ref() -= fields.volumeSource();
    return divergence;
}

/// What flows through walls that move stays on its side of them.
void adjustThroughFaces(surfaceScalarField& flux, const volScalarField& fluidFraction, FluidFields& fields)
{
    if (!fields.U.mesh().moving())
    {
        adjustPhi(flux, fields.U, fields.pRgh);
        return;
    }
    const surfaceScalarField swept(linearInterpolate(fluidFraction)*fvc::meshPhi(fields.U));
    flux -= swept;
    adjustPhi(flux, fields.U, fields.pRgh);
    flux += swept;
}

/// A domain that is closed takes no more fluid than sinks remove.
void refuseNetSource(const volScalarField& source)
{
    const scalar net = gSum((source.mesh().V()*source.primitiveField())());
    const scalar gross = gSum((source.mesh().V()*mag(source.primitiveField()))());
    if (mag(net) <= 1e-9*gross) return;
    FatalErrorInFunction
        << "fvOptions add " << net << " m3/s of fluid to a domain that nothing leaves: the fluid is incompressible. "
        << "Give a patch a fixed p_rgh, or remove as much as is added" << exit(FatalError);
}

/// PIMPLE's entries with a reference of the pressure for cases that name none: 0 Pa in the first cell.
dictionary withReference(const dictionary& pimple, const word& p)
{
    dictionary dict(pimple);
    const word cell(p + "RefCell"), value(p + "RefValue");
    if (!dict.found(cell) && !dict.found(p + "RefPoint")) dict.add(cell, label(0));
    if (!dict.found(value)) dict.add(value, scalar(0));
    return dict;
}

} // End anonymous namespace


PressureCorrection::PressureCorrection
(
    fvMesh& mesh, pimpleControl& pimple,
    const volScalarField& p, const volScalarField& pRgh, const dictionary& meanFlowDict
)
:
    mesh_(mesh),
    pimple_(pimple),
    reconstruct_(mesh),
    meanFlow_(mesh, meanFlowDict)
{
    setRefCell(p, pRgh, withReference(pimple.dict(), p.name()), refCell_, refValue_);
}


// Boundary values of HbyA are those of U where U is prescribed; there the law gives back alpha U.Sf.
FluxLaw PressureCorrection::fluidLaw
(
    FluidFields& fields,
    const volScalarField& fluidFraction,
    const volScalarField& rAU,
    const volVectorField& HbyA,
    const GrainFaceTerms& terms
) const
{
    surfaceScalarField flux(fluxOf(fluidFraction*HbyA));
    if (fields.pRgh.needReference()) adjustThroughFaces(flux, fluidFraction, fields);

    const surfaceScalarField ra(linearInterpolate(sqr(fluidFraction)*rAU));
    const surfaceScalarField damping(1/(1 + ra*terms.resistanceFace));
    FluxLaw law{(flux + ra*terms.forceFlux)*damping, ra*damping};
    if (terms.response.valid()) law.mobility *= terms.response->chiFace;
    return law;
}


tmp<surfaceScalarField> PressureCorrection::solvePressure
(
    FluidFields& fields, const surfaceScalarField& freeFlux, const surfaceScalarField& mobility,
    const dimensionedScalar& rho
)
{
    volScalarField& pRgh = fields.pRgh;
    if (fields.volumeSource.valid() && pRgh.needReference()) refuseNetSource(fields.volumeSource());
    const tmp<volScalarField> excess(divergenceLessSource(freeFlux, fields));
    const surfaceScalarField coefficient("mobilityPerDensity", mobility/rho);
    tmp<surfaceScalarField> correction;
    while (pimple_.correctNonOrthogonal())
    {
        fvScalarMatrix equation
        (
            fvm::laplacian(coefficient, pRgh, "laplacian(rAU,p_rgh)") == excess()
        );
        equation.setReference(refCell_, refValue_);
        equation.solve(mesh_.solver(pRgh.select(pimple_.finalInnerIter())));
        if (pimple_.finalNonOrthogonalIter()) correction = equation.flux();
    }
    return correction;
}


tmp<surfaceScalarField> PressureCorrection::balanceMixture
(
    FluidFields& fields, const FluxLaw& mixture, const dimensionedScalar& rho
)
{
    if (!meanFlow_.isHeld())
    {
        const tmp<surfaceScalarField> correction(solvePressure(fields, mixture.free, mixture.mobility, rho));
        mixtureFlux_.reset(new surfaceScalarField(mixture.free - correction()));
        return correction/mixture.mobility;
    }

    const surfaceScalarField uniform(meanFlow_.gradientFlux(rho));
    tmp<surfaceScalarField> gradientFlux
    (
        uniform
      + solvePressure(fields, mixture.free - mixture.mobility*uniform, mixture.mobility, rho)/mixture.mobility
    );
    mixtureFlux_.reset(new surfaceScalarField(mixture.free - mixture.mobility*gradientFlux()));
    const label refCell = fields.pRgh.needReference() ? refCell_ : Pstream::master() ? 0 : -1;
    meanFlow_.hold(mixtureFlux_(), gradientFlux.ref(), fields.pRgh, mixture.mobility, rho, refCell);
    return gradientFlux;
}


void PressureCorrection::correctCells
(
    FluidFields& fields,
    const volScalarField& fluidFraction,
    const volScalarField& rAU,
    const volVectorField& HbyA,
    const GrainFaceTerms& terms,
    const surfaceScalarField& gradientFlux,
    const dimensionedScalar& rho
) const
{
    surfaceScalarField imbalanceFlux(terms.forceFlux - terms.resistanceFace*fields.phi);
    if (terms.response.valid()) imbalanceFlux -= terms.response->chiFace*gradientFlux;
    else imbalanceFlux -= gradientFlux;

    const volScalarField& r = terms.resistance;
    const volVectorField imbalance(reconstruct_(imbalanceFlux) + r*reconstruct_(fields.phi));
    fields.U = (HbyA + fluidFraction*rAU*imbalance)/(1 + sqr(fluidFraction)*rAU*r);
    fields.U.correctBoundaryConditions();

    fields.balancedGradient = rho*(terms.force - imbalance);
    if (terms.response.valid()) fields.balancedGradient /= terms.response->chi;
    fields.balancedGradient.correctBoundaryConditions();
}


void PressureCorrection::correctWithGrains
(
    FluidFields& fields,
    const volScalarField& fluidFraction,
    const GrainFaceTerms& terms,
    const List<Border>& borders,
    const fvVectorMatrix& momentum,
    const dimensionedScalar& rho
)
{
    const volScalarField rAU("rAU", 1/momentum.A());
    const volVectorField HbyA(constrainHbyA(rAU*momentum.H(), fields.U, fields.pRgh));

    const FluxLaw fluid(fluidLaw(fields, fluidFraction, rAU, HbyA, terms));
    constrainPressure(fields.pRgh, fluidFraction, fields.U, fluid.free, (fluid.mobility/rho)());

    const surfaceScalarField gradientFlux
    (
        balanceMixture(fields, terms.response.valid() ? mixtureLaw(fluid, terms.response()) : fluid, rho)
    );
    fields.phi = fluid.free - fluid.mobility*gradientFlux;
    fields.pRgh.relax();

    correctCells(fields, fluidFraction, rAU, HbyA, terms, gradientFlux, rho);
}


ContinuityError PressureCorrection::continuityError(const FluidFields& fields) const
{
    const volScalarField divergence(divergenceLessSource(mixtureFlux_.valid() ? mixtureFlux_() : fields.phi, fields));
    const scalar volume = gSum(mesh_.V());
    ContinuityError error;
    error.largest = gMax(mag(divergence.primitiveField())());
    error.meanAbs = gSum((mesh_.V()*mag(divergence.primitiveField()))())/volume;
    error.mean = gSum((mesh_.V()*divergence.primitiveField())())/volume;
    return error;
}

} // End namespace nscdCoupling
} // End namespace Foam
