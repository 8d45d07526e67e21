// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Sampling of the fluid at the grains.
#include "coupling/step/fluidAtGrains.H"

#include "coupling/case/walls/patchRoles.H"

#include "fvcCurl.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// On a 2D mesh the fluid pushes discs along the mesh's plane and spins them about its normal. What round-off says else would
/// grow where discs are packed: a row of them buckles out of a plane that nothing holds it in.
void keepInPlane(FluidAtGrains& at, int emptyAxis)
{
    if (emptyAxis < 0) return;
    for (std::vector<Vec3>* field : {&at.velocity, &at.pressureGradient, &at.divTau})
    {
        for (Vec3& value : *field) value[emptyAxis] = 0;
    }
    for (Vec3& spin : at.spin) spin = spin[emptyAxis]*Vec3::Unit(emptyAxis);
}

} // namespace


void sampleFluid
(
    const FluidSolver& fluid, const volScalarField* alpha, const GrainMapping& mapping, const GrainsAtHome& atHome,
    const ActiveForces& active, FluidAtGrains& at
)
{
    std::vector<ScalarSample> scalars;
    std::vector<VectorSample> vectors;
    tmp<volScalarField> nu;
    tmp<volVectorField> divTau, spin;

    vectors.push_back({fluid.U().primitiveField(), at.velocity});
    if (active.drag)
    {
        nu = fluid.nu();
        scalars.push_back({nu().primitiveField(), at.viscosity});
        if (alpha) scalars.push_back({alpha->primitiveField(), at.fluidFraction});
    }
    if (active.pressureGradient) vectors.push_back({fluid.balancedPressureGradient().primitiveField(), at.pressureGradient});
    if (active.viscous)
    {
        divTau = fluid.divTau();
        vectors.push_back({divTau().primitiveField(), at.divTau});
    }
    if (active.spinDrag)
    {
        spin = 0.5*fvc::curl(fluid.U());
        vectors.push_back({spin().primitiveField(), at.spin});
    }
    mapping.sample(scalars, vectors);

    GrainValues sampled;
    for (const ScalarSample& field : scalars) sampled.scalars.push_back(&field.grains);
    for (const VectorSample& field : vectors) sampled.vectors.push_back(&field.grains);
    atHome.toOwners(sampled);
    keepInPlane(at, emptyAxis(fluid.U().mesh()));
    if (active.drag && !alpha) at.fluidFraction.assign(at.velocity.size(), 1.0);
    for (scalar& viscosity : at.viscosity) viscosity *= fluid.rho().value();
}

} // namespace nscdCoupling
} // namespace Foam
