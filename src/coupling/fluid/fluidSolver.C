// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// The fluid's part of a time step, told in the order it happens.

#include "coupling/fluid/fluidSolver.H"
#include "coupling/fluid/rankPatches.H"

#include "fvcMeshPhi.H"
#include "linear.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

UniformDimensionedField<vector> readGravity(const fvMesh& mesh)
{
    return UniformDimensionedField<vector>
    (
        IOobject("g", mesh.time().constant(), mesh, IOobject::READ_IF_PRESENT, IOobject::NO_WRITE),
        dimensionedVector("g", dimAcceleration, Zero)
    );
}

void refuseConsistent(const dictionary& pimple)
{
    if (pimple.getOrDefault("consistent", false))
    {
        FatalIOErrorInFunction(pimple)
            << "PIMPLE `consistent yes` (SIMPLEC) does not go with drag on the faces; remove it" << exit(FatalIOError);
    }
}

// The best that is known of a field at the end of this step.
template<class Field>
tmp<Field> latest(const Field& field, const pimpleControl& pimple)
{
    return pimple.firstIter() ? extrapolated(field) : tmp<Field>(field);
}

} // End anonymous namespace


FluidSolver::FluidSolver(fvMesh& mesh, GrainSources& sources, const dictionary& meanFlowDict)
:
    mesh_(mesh),
    sources_(sources),
    pimple_(mesh),
    fields_(mesh, sources.fluidFraction),
    zones_(mesh),
    turbulence_(sources.fluidFraction, fields_.U, fields_.phi),
    g_(readGravity(mesh)),
    hydrostatic_("hydrostatic", rho()*(g_ & mesh.C())),
    p_
    (
        IOobject("p", mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::AUTO_WRITE),
        fields_.pRgh + hydrostatic_
    ),
    options_(fv::options::New(mesh)),
    pressure_(mesh, pimple_, p_, fields_.pRgh, meanFlowDict)
{
    refuseConsistent(pimple_.dict());
    fillAllRankPatches(mesh);
}


void FluidSolver::solve()
{
    while (nextOuterLoop()) solveOuterLoop();
}


// Of nothing but what is written at a time, so that a run that goes on makes the same.
void FluidSolver::beforeMeshMoves()
{
    keepFaceVelocity(fields_, sources_.fluidFraction);
}


void FluidSolver::followMesh()
{
    hydrostatic_ = rho()*(g_ & mesh_.C());
    pressure_.followMesh();
    fields_.U.correctBoundaryConditions();
    fluxThroughMovedFaces(fields_);
}


tmp<surfaceScalarField> FluidSolver::convectingFlux(const surfaceScalarField& absolute) const
{
    if (!mesh_.moving()) return zones_.relativeFlux(absolute, sources_.fluidFraction);
    return absolute - linearInterpolate(sources_.fluidFraction)*fvc::meshPhi(fields_.U);
}


void FluidSolver::solveOuterLoop()
{
    updateVolumeSource();
    zones_.turnWalls(fields_.U);
    if (sources_.hasGrains || pressure_.meanFlow().isHeld()) solveWithGrains();
    else solvePlain();

    if (pimple_.turbCorr()) correctTurbulence();
    updateAbsolutePressure();
}


void FluidSolver::solveWithGrains()
{
    const List<Border> borders(bordersOf(fields_));
    const GrainFaceTerms terms(sources_, fields_, rho(), borders);

    // Of faces that have moved the flux of the step before says nothing.
    const tmp<surfaceScalarField> flux(mesh_.moving() ? tmp<surfaceScalarField>(fields_.phi) : latest(fields_.phi, pimple_));
    const tmp<surfaceScalarField> convecting(convectingFlux(flux()));
    const tmp<fvVectorMatrix> minusDivTau(turbulence_.minusDivTau(fields_.U, latest(fields_.U, pimple_)()));
    tmp<fvVectorMatrix> momentum(averagedMomentum(fields_, sources_, minusDivTau(), convecting(), options_));
    zones_.addCoriolis(sources_.fluidFraction, momentum.ref());
    momentum.ref().relax();
    options_.constrain(momentum.ref());

    if (pimple_.momentumPredictor())
    {
        predictVelocity(fields_, sources_, terms, momentum(), rho());
        options_.correct(fields_.U);
    }

    while (pimple_.correct())
    {
        pressure_.correctWithGrains(fields_, sources_.fluidFraction, terms, borders, momentum(), rho());
        options_.correct(fields_.U);
    }

    // With the operator that moved the fluid, so that fluid and grains share one stress to round-off.
    fields_.divTau = -rho()*(minusDivTau() & fields_.U);
    fields_.divTau.correctBoundaryConditions();
    forceOnGrains_ = whatGrainsGot(momentum());
}


vector FluidSolver::whatGrainsGot(const fvVectorMatrix& momentum) const
{
    const scalarField& volume = mesh_.V();
    // The share of the stress that acts on grains.
    scalarField solid(1 - sources_.fluidFraction.primitiveField());
    if (sources_.isModelB) solid = 0;
    const tmp<volVectorField> kept(momentum & fields_.U);
    vector force = sum(volume*(solid*fields_.divTau.primitiveField() - rho().value()*kept().primitiveField() - meanFlowGradient()));
    if (fields_.bodyAcceleration.valid())
    {
        force += rho().value()*sum((volume*sources_.fluidFraction.primitiveField()*fields_.bodyAcceleration->primitiveField())());
    }
    forAll(mesh_.boundary(), patchi)
    {
        if (mesh_.boundary()[patchi].coupled()) continue;
        force -= sum(fields_.pRgh.boundaryField()[patchi]*mesh_.Sf().boundaryField()[patchi]);
    }
    reduce(force, sumOp<vector>());
    return force;
}


void FluidSolver::solvePlain()
{
    const tmp<surfaceScalarField> convecting(convectingFlux(fields_.phi));
    tmp<fvVectorMatrix> momentum(plainMomentum(fields_, turbulence_, convecting(), options_));
    zones_.addCoriolis(sources_.fluidFraction, momentum.ref());
    momentum.ref().relax();
    options_.constrain(momentum.ref());

    if (pimple_.momentumPredictor())
    {
        predictPlainVelocity(fields_, momentum(), rho());
        options_.correct(fields_.U);
    }

    while (pimple_.correct())
    {
        pressure_.correctPlain(fields_, momentum(), rho());
        options_.correct(fields_.U);
    }
}


// Turbulence is convected as momentum is.
void FluidSolver::correctTurbulence()
{
    if (!zones_.any() && !mesh_.moving()) return turbulence_.correct();
    const surfaceScalarField absolute("absoluteFlux", fields_.phi);
    fields_.phi = convectingFlux(absolute);
    turbulence_.correct();
    fields_.phi = absolute;
}


void FluidSolver::updateVolumeSource()
{
    volScalarField& fraction = sources_.fluidFraction;
    if (!options_.appliesToField(fraction.name())) return;
    const tmp<fvScalarMatrix> added(options_(fraction));
    fields_.volumeSource.reset(new volScalarField("volumeSource", added() & fraction));
}


// The reference height is the origin, as OpenFOAM has it without constant/hRef.
void FluidSolver::updateAbsolutePressure()
{
    p_ = fields_.pRgh + hydrostatic_;
}


CourantNumber FluidSolver::courantNumber() const
{
    if (mesh_.moving()) return nscdCoupling::courantNumber(convectingFlux(fields_.phi), sources_.fluidFraction);
    return nscdCoupling::courantNumber(fields_.phi, sources_.fluidFraction);
}


FluidMomentum FluidSolver::momentum() const
{
    return fluidMomentum(fields_, sources_.fluidFraction, turbulence_);
}

} // End namespace nscdCoupling
} // End namespace Foam
