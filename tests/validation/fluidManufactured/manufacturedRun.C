// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Sources of a manufactured solution, step by step, and what is left between it and the fluid.

#include "manufacturedRun.H"
#include "mappingTools.H"

#include "fixedValueFvPatchFields.H"

#include <cmath>

namespace Foam
{
namespace nscdCoupling
{
namespace testing
{

ManufacturedRun::ManufacturedRun(const Manufactured& solution, const label n)
:
    solution_(solution),
    flow_(settings(solution, n))
{
    if (solution.hasWalls) prescribeOnPatches(flow_.sources());
    setFraction();
    flow_.fluid();
    flow_.setVelocity([this](const point& x) { return velocity(x); });
}


void ManufacturedRun::advance(const label nSteps)
{
    flow_.steps(nSteps, [this] { setSources(); });
}


Errors ManufacturedRun::errors()
{
    const volScalarField& pRgh = flow_.fluid().pRgh();
    const scalarField& V = flow_.mesh().V();
    scalar mean = 0;
    forAll(pRgh, i) mean += V[i]*(pRgh[i] - at(flow_.mesh().C()[i]).p)/gSum(V);
    return Errors
    {
        l2Error(flow_.fluid().U(), [this](const point& x) { return velocity(x); }),
        l2Error(pRgh, [&](const point& x) { return at(x).p + mean; })
    };
}


Errors ManufacturedRun::sizes()
{
    const fvMesh& mesh = flow_.mesh();
    scalar mean = 0, u = 0, p = 0;
    forAll(mesh.V(), i) mean += at(mesh.C()[i]).p/mesh.nCells();
    forAll(mesh.V(), i)
    {
        u += magSqr(velocity(mesh.C()[i]))/mesh.nCells();
        p += sqr(at(mesh.C()[i]).p - mean)/mesh.nCells();
    }
    return Errors{std::sqrt(u), std::sqrt(p)};
}


FluidCaseSettings ManufacturedRun::settings(const Manufactured& solution, const label n)
{
    const scalar size = solution.hasWalls ? 2 : 2*constant::mathematical::pi;
    FluidCaseSettings settings = planeCase(n, n, size, size);
    if (solution.hasWalls)
    {
        settings.box.min = point(-1, -1, 0);
        settings.box.max = point(1, 1, size/n);
        for (label side = 0; side < 4; ++side)
        {
            settings.borderU[side] = "type fixedValue; value uniform (0 0 0);";
            settings.borderP[side] = "type fixedFluxPressure; value uniform 0;";
        }
    }
    else settings.box.patchTypes = {"cyclic", "cyclic", "cyclic", "cyclic", "empty", "empty"};
    settings.rho = solution.fluid.rho;
    settings.nu = solution.fluid.mu/solution.fluid.rho;
    settings.box.deltaT = solution.deltaT > 0 ? solution.deltaT : size/n/4;
    settings.ddt = solution.ddt;
    settings.convection = solution.convection;
    settings.pimple = solution.pimple;
    settings.tolerance = solution.tolerance;
    if (solution.distortion > 0)
    {
        shake(settings.box, solution.distortion*size/n, true);
        settings.gradient = "leastSquares";
        settings.interpolation = "skewCorrected linear";
    }
    return settings;
}


// Fluid fraction and source of a manufactured solution are known at the walls, not only in the cells beside them.
void ManufacturedRun::prescribeOnPatches(GrainSources& sources)
{
    for (label side = 0; side < 4; ++side)
    {
        const fvPatch& patch = sources.fluidFraction.mesh().boundary()[side];
        sources.fluidFraction.boundaryFieldRef().set(side, new fixedValueFvPatchScalarField(patch, sources.fluidFraction));
        sources.acceleration.boundaryFieldRef().set
        (
            side, new fixedValueFvPatchVectorField(patch, sources.acceleration)
        );
    }
}


ManufacturedPoint ManufacturedRun::at(const point& x) const
{
    return solution_.at(solution_.fluid, x.x(), x.y(), flow_.time().value());
}


vector ManufacturedRun::velocity(const point& x) const
{
    const ManufacturedPoint m = at(x);
    return vector(m.U[0], m.U[1], 0)/m.fluidFraction;
}


void ManufacturedRun::setFraction()
{
    setCells(flow_.sources().fluidFraction, [this](const point& x) { return at(x).fluidFraction; });
}


void ManufacturedRun::setSources()
{
    const ManufacturedFluid& fluid = solution_.fluid;
    GrainSources& sources = flow_.sources();
    setFraction();
    setCells(sources.drag, [&](const point&) { return fluid.beta/fluid.rho; });
    setCells
    (
        sources.acceleration,
        [&](const point& x)
        {
            const ManufacturedPoint m = at(x);
            const double* s = solution_.isStressFormD ? m.sourceD : m.sourceS;
            return vector(s[0], s[1], 0)/fluid.rho;
        }
    );
    if (!solution_.isUnsteadyFraction) return;

    // The wave of grains moves at 1/2 along x; drag towards them is in the source.
    sources.hasResponse = true;
    setCells(sources.carried, [this](const point& x) { return vector(0.5*(1 - at(x).fluidFraction), 0, 0); });
}

} // End namespace testing
} // End namespace nscdCoupling
} // End namespace Foam
