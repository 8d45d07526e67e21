// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Collecting the walls of a case.
#include "meshWalls.H"
#include "coplanarRegions.H"
#include "vectorConversion.H"

namespace Foam
{
namespace nscdCoupling
{

nscd::Walls makeMeshWalls(const GrainProperties& properties, const PatchRoles& roles, const polyMesh& mesh)
{
    nscd::Walls walls;
    for (const label patchi : roles.ofRole(PatchRole::wall))
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        const int wallPatch = walls.addPatch(patch.name(), roles.material[patchi]);
        const std::vector<nscd::WallRegion> regions = coplanarRegions(patch, wallPatch);
        walls.regions.insert(walls.regions.end(), regions.begin(), regions.end());
    }
    for (const PlaneWall& plane : properties.planes)
    {
        walls.addPlane(walls.addPatch(plane.name, plane.material), toVec3(plane.point), toVec3(plane.normal));
    }
    return walls;
}

} // namespace nscdCoupling
} // namespace Foam
