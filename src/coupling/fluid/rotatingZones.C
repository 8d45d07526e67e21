// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// OpenFOAM's MRF zones, with the fluid fraction.

#include "coupling/fluid/rotatingZones.H"
#include "coupling/base/rotatingZonesFile.H"

#include "linear.H"

namespace Foam
{
namespace nscdCoupling
{

RotatingZones::RotatingZones(const fvMesh& mesh)
:
    zones_(hasRotatingZones(mesh) ? new IOMRFZoneList(mesh) : nullptr)
{}


void RotatingZones::turnWalls(volVectorField& U) const
{
    if (any()) zones_->correctBoundaryVelocity(U);
}


tmp<surfaceScalarField> RotatingZones::relativeFlux(tmp<surfaceScalarField> phi, const volScalarField& fluidFraction) const
{
    if (!any()) return phi;
    tmp<surfaceScalarField> relative(new surfaceScalarField("relativeFlux", phi));
    zones_->makeRelative(linearInterpolate(fluidFraction)(), relative.ref());
    return relative;
}


void RotatingZones::addCoriolis(const volScalarField& fluidFraction, fvVectorMatrix& momentum) const
{
    if (any()) zones_->addAcceleration(fluidFraction, momentum);
}

} // End namespace nscdCoupling
} // End namespace Foam
