// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Collecting the walls of a case.
#include "meshWalls.H"
#include "coplanarRegions.H"
#include "gatheredPatch.H"
#include "vectorConversion.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

std::vector<nscd::WallRegion> regionsOf(const polyMesh& mesh, const polyPatch& patch, int wallPatch, const labelUList& wholeFace)
{
    if (!Pstream::parRun()) return coplanarRegions(patch, wallPatch);
    const GatheredPatch whole = gatherPatch(mesh, patch, wholeFace);
    return coplanarRegions(primitivePatch(SubList<face>(whole.faces, whole.faces.size()), whole.points), wallPatch);
}

} // namespace


nscd::Walls makeMeshWalls(const GrainProperties& properties, const PatchRoles& roles, const polyMesh& mesh)
{
    nscd::Walls walls;
    const labelList wholeFace = Pstream::parRun() ? facesOfWholeMesh(mesh) : labelList();
    for (const label patchi : roles.ofRole(PatchRole::wall))
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        const int wallPatch = walls.addPatch(patch.name(), roles.material[patchi]);
        const std::vector<nscd::WallRegion> regions = regionsOf(mesh, patch, wallPatch, wholeFace);
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
