// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Locating grains without weights.
#include "coupling/step/grainLocations.H"

namespace Foam
{
namespace nscdCoupling
{

GrainLocations::GrainLocations(const fvMesh& mesh)
:
    mappingMesh_(makeMappingMesh(mesh)),
    locator_(mappingMesh_, mesh)
{}

const std::vector<label>& GrainLocations::update(const ::nscd::Grains& grains)
{
    cells_.resize(grains.nOwned, -1);
    label nearby = -1;
    for (std::size_t i = 0; i < grains.nOwned; ++i) cells_[i] = locator_.find(grains.position[i], cells_[i], nearby);
    return cells_;
}

} // namespace nscdCoupling
} // namespace Foam
