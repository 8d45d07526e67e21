// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A mesh that moves: in each step it goes first, then the fluid's fluxes, the walls and the grains' weights follow it.
// Tested by tests/foam/program/movingMeshTest.C
#include "coupling/step/coupledRun.H"

#include "coupling/case/start/movingMeshCheck.H"

#include "dynamicFvMesh.H"

namespace Foam
{
namespace nscdCoupling
{

void CoupledRun::moveMesh()
{
    if (!movesMesh()) return;
    const auto timer = timing_.time(StepPart::depositGrains);
    if (hasFluid()) immersion_->fluid->beforeMeshMoves();
    dynamic_cast<dynamicFvMesh&>(mesh_).update();
    checkMovedMesh(mesh_, scene_.box);
    scene_.movingPatches->follow(time_.value());
    if (locations_) locations_ = std::make_unique<GrainLocations>(mesh_);
    if (homes_ && !hasFluid()) homes_->followMesh(findHome());
    if (!hasFluid()) return;
    immersion_->fluid->followMesh();
    if (!immersion_->mapping) return;
    std::vector<label> cells = immersion_->mapping->cells();
    makeMapping();
    immersion_->mapping->lookFirstIn(std::move(cells));
    if (homes_) homes_->followMesh(findHome());
    if (hasGrains()) updateWeights(true);
}


FindHome CoupledRun::findHome() const
{
    if (!properties_.solvesFluid) return findHomeIn(mesh_);
    return [this](const Vec3& position, label guess) { return immersion_->mapping->find(position, guess); };
}


void CoupledRun::makeMapping()
{
    immersion_->mapping = std::make_unique<GrainMapping>(mesh_, voidFraction_, 0.5*largestDiameter_, scene_.space.shape.dimensions);
}

} // namespace nscdCoupling
} // namespace Foam
