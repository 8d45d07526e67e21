// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Interpolation of the grains' terms, and what of them a patch lets through.

#include "coupling/fluid/grainFaceTerms.H"

#include "fixedFluxPressureFvPatchScalarField.H"
#include "fvcMeshPhi.H"
#include "linear.H"
#include "reverseLinear.H"
#include "surfaceInterpolate.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

Border borderOf(const fvPatchScalarField& pRgh)
{
    if (pRgh.coupled()) return Border::coupled;
    if (isA<fixedFluxPressureFvPatchScalarField>(pRgh)) return Border::balanced;
    return pRgh.fixesValue() ? Border::open : Border::given;
}

template<class Type>
void clear(GeometricField<Type, fvsPatchField, surfaceMesh>& faces, const List<Border>& borders, const Border which)
{
    forAll(borders, patchi)
    {
        if (borders[patchi] == which) faces.boundaryFieldRef()[patchi] = Zero;
    }
}

// No force acts beyond a patch whose flux is given.
tmp<surfaceScalarField> forceOnFaces(tmp<surfaceScalarField> faces, const List<Border>& borders)
{
    clear(faces.ref(), borders, Border::given);
    return faces;
}

// Grains cross only coupled and open patches.
tmp<surfaceScalarField> motionOnFaces(tmp<surfaceScalarField> faces, const List<Border>& borders)
{
    clear(faces.ref(), borders, Border::given);
    clear(faces.ref(), borders, Border::balanced);
    return faces;
}

tmp<surfaceScalarField> fluxOf(const volVectorField& cells)
{
    return cells.mesh().Sf() & fvc::interpolate(cells, "flux(HbyA)");
}

// The mean over the way from one cell's center to the other's, of what is the same in all of a cell: each counts with its part of the
// way, so the pressure that balances it is right at both centers, and the sum over the cells is the same before and after
// FaceReconstruction.
template<class Type>
tmp<GeometricField<Type, fvsPatchField, surfaceMesh>> meanOnTheWay(const GeometricField<Type, fvPatchField, volMesh>& cells)
{
    return reverseLinear<Type>(cells.mesh()).interpolate(cells);
}

// By the scheme that the case chose for vectors, moved from linear weights to those above.
tmp<surfaceScalarField> fluxOnTheWay(const volVectorField& cells)
{
    return fluxOf(cells) + (cells.mesh().Sf() & (meanOnTheWay(cells) - linearInterpolate(cells)));
}

// A wall that moves takes what is before it along, grains as well as fluid: together they fill the volume that it leaves.
void carryAlongWalls(const GrainSources& sources, const FluidFields& fields, const List<Border>& borders, surfaceScalarField& carried)
{
    const tmp<surfaceScalarField> swept(fvc::meshPhi(fields.U));
    forAll(borders, patchi)
    {
        if (borders[patchi] == Border::coupled || borders[patchi] == Border::open) continue;
        const fvPatchScalarField& fluidFraction = sources.fluidFraction.boundaryField()[patchi];
        carried.boundaryFieldRef()[patchi] = (1 - fluidFraction)*swept().boundaryField()[patchi];
    }
}

tmp<surfaceScalarField> weightedMean(const volScalarField& cells, const autoPtr<ResponseTerms>& response)
{
    if (!response.valid()) return meanOnTheWay(cells);
    return response->chiFace*meanOnTheWay<scalar>(cells/response->chi);
}

tmp<surfaceScalarField> weightedFlux(const volVectorField& cells, const autoPtr<ResponseTerms>& response)
{
    if (!response.valid()) return fluxOnTheWay(cells);
    return response->chiFace*fluxOnTheWay(cells/response->chi);
}

// Volume flux of the grains in the fluid as it is now, in cells. On faces only what the fluid changes is added: the mean of Y G is not
// the product of two means, and a raft of grains one cell high would hover on the difference (src/coupling/method.md).
tmp<volVectorField> presentFlux(const GrainSources& sources, const FluidFields& fields, const dimensionedScalar& rho)
{
    return sources.carried + sources.slip*fields.U - sources.mobility*fields.balancedGradient/rho;
}

tmp<volVectorField> explicitForce(const GrainSources& sources, const FluidFields& fields)
{
    tmp<volVectorField> force(sources.acceleration/sources.fluidFraction);
    if (fields.bodyAcceleration.valid()) force.ref() += fields.bodyAcceleration();
    return force;
}

} // End anonymous namespace


List<Border> bordersOf(const FluidFields& fields)
{
    const auto& patches = fields.pRgh.boundaryField();
    List<Border> borders(patches.size());
    forAll(patches, patchi) borders[patchi] = borderOf(patches[patchi]);
    return borders;
}


ResponseTerms::ResponseTerms
(
    const GrainSources& sources, const FluidFields& fields, const dimensionedScalar& rho, const List<Border>& borders
)
:
    chi("chi", 1 + sources.pressure/sources.fluidFraction),
    chiFace("chiFace", 1/meanOnTheWay<scalar>(1/chi)),
    slip("slipFace", motionOnFaces(linearInterpolate(sources.slip/sources.fluidFraction), borders)),
    carried("carriedFlux", motionOnFaces(fluxOf(presentFlux(sources, fields, rho)), borders)),
    mobility("mobilityFace", motionOnFaces(linearInterpolate(sources.mobility), borders))
{
    carried += mobility*fluxOf(fields.balancedGradient/rho) - slip*fluxOf(sources.fluidFraction*fields.U);
    if (fields.U.mesh().moving()) carryAlongWalls(sources, fields, borders, carried);
}


GrainFaceTerms::GrainFaceTerms
(
    const GrainSources& sources, const FluidFields& fields, const dimensionedScalar& rho, const List<Border>& borders
)
:
    response(sources.hasResponse ? new ResponseTerms(sources, fields, rho, borders) : nullptr),
    resistance("resistance", sources.drag/sqr(sources.fluidFraction)),
    resistanceFace("resistanceFace", forceOnFaces(weightedMean(resistance, response), borders)),
    force("explicitForce", explicitForce(sources, fields)),
    forceFlux("forceFlux", forceOnFaces(weightedFlux(force, response), borders))
{}

} // End namespace nscdCoupling
} // End namespace Foam
