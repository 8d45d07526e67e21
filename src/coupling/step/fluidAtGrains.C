// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Which fields are asked for, and the way of their values to the grains.
#include "coupling/step/fluidAtGrains.H"

#include "coupling/case/walls/patchRoles.H"

#include "fvcCurl.H"
#include "fvcGrad.H"
#include "mathematicalConstants.H"

#include <cmath>

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
    for (std::vector<Vec3>* field : {&at.velocity, &at.pressureGradient, &at.divTau, &at.convection})
    {
        for (Vec3& value : *field) value[emptyAxis] = 0;
    }
    for (Vec3& spin : at.spin) spin = spin[emptyAxis]*Vec3::Unit(emptyAxis);
}

/// The cell fields that are wanted, each with where its values go, and those of them that were made for it.
struct WantedFields
{
    std::vector<ScalarSample> scalars;
    std::vector<VectorSample> vectors;
    tmp<volScalarField> nu;
    tmp<volVectorField> spin;
    tmp<volVectorField> convection;

    WantedFields(const FluidSolver& fluid, const volScalarField* fluidFraction, unsigned wanted, FluidAtGrains& at)
    {
        vectors.push_back({fluid.U().primitiveField(), at.velocity});
        if (wanted & reads::pressureGradient) vectors.push_back({fluid.balancedPressureGradient().primitiveField(), at.pressureGradient});
        if (wanted & reads::divTau) vectors.push_back({fluid.divTau().primitiveField(), at.divTau});
        if (wanted & reads::spin)
        {
            spin = 0.5*fvc::curl(fluid.U());
            vectors.push_back({spin().primitiveField(), at.spin});
        }
        if (wanted & reads::convection)
        {
            convection = fluid.U() & fvc::grad(fluid.U());
            vectors.push_back({convection().primitiveField(), at.convection});
        }
        if (wanted & reads::viscosity)
        {
            nu = fluid.nu();
            scalars.push_back({nu().primitiveField(), at.viscosity});
        }
        if (wanted & reads::fluidFraction && fluidFraction) scalars.push_back({fluidFraction->primitiveField(), at.fluidFraction});
    }
};

/// Of parcels the diameters of real grains, from theirs: `factor` is that of the owned grains.
void makeReal(const std::vector<scalar>& factor, const GrainsAtHome& atHome, std::vector<scalar>& volumeOverDiameter)
{
    std::vector<scalar> atHomes = factor;
    atHome.toHomes({{&atHomes}, {}});
    for (std::size_t i = 0; i < atHomes.size(); ++i) volumeOverDiameter[i] *= atHomes[i];
}

/// Sum of V_i over sum of V_i/d_i, each laid down in the cells and sampled from there: Sauter's mean, with the weights of the solid fraction.
void sampleMeanDiameter
(
    const GrainMapping& mapping, const GrainsAtHome& atHome, const std::vector<scalar>* coarseGraining, std::vector<scalar>& mean
)
{
    const std::vector<scalar>& volumes = mapping.volumes();
    std::vector<scalar> volumeOverDiameter(volumes.size()), sampled;
    for (std::size_t i = 0; i < volumes.size(); ++i)
    {
        volumeOverDiameter[i] = volumes[i]/std::cbrt(6*volumes[i]/constant::mathematical::pi);
    }
    if (coarseGraining) makeReal(*coarseGraining, atHome, volumeOverDiameter);
    scalarField solids, surface;
    mapping.spread({{volumes, solids}, {volumeOverDiameter, surface}}, {});
    mapping.sample({{solids, mean}, {surface, sampled}}, {});
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = sampled[i] > 0 ? mean[i]/sampled[i] : 0;
}

} // namespace

void sampleFluid
(
    const FluidSolver& fluid, const volScalarField* fluidFraction, const GrainMapping& mapping, const GrainsAtHome& atHome,
    unsigned wanted, FluidAtGrains& at, const std::vector<scalar>* coarseGraining
)
{
    const WantedFields fields(fluid, fluidFraction, wanted, at);
    mapping.sample(fields.scalars, fields.vectors);

    GrainValues sampled;
    if (wanted & reads::own)
    {
        at.own = mapping.ownTrace();
        sampled = {{&at.own.fraction, &at.own.others}, {&at.own.flowDiagonal, &at.own.flowOffDiagonal}};
    }
    if (wanted & reads::meanDiameter)
    {
        sampleMeanDiameter(mapping, atHome, coarseGraining, at.meanDiameter);
        sampled.scalars.push_back(&at.meanDiameter);
    }
    for (const ScalarSample& field : fields.scalars) sampled.scalars.push_back(&field.grains);
    for (const VectorSample& field : fields.vectors) sampled.vectors.push_back(&field.grains);
    atHome.toOwners(sampled);
    keepInPlane(at, emptyAxis(fluid.U().mesh()));
    if (wanted & reads::fluidFraction && !fluidFraction) at.fluidFraction.assign(at.velocity.size(), 1.0);
    if (!(wanted & reads::viscosity)) return;
    for (scalar& viscosity : at.viscosity) viscosity *= fluid.rho().value();
}

} // namespace nscdCoupling
} // namespace Foam
