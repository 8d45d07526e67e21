// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Collecting the walls of a case.
#include "coupling/base/vectorConversion.H"
#include "coupling/case/walls/coplanarRegions.H"
#include "coupling/case/walls/gatheredPatch.H"
#include "coupling/case/walls/meshWalls.H"

#include "Time.H"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

std::vector<nscd::WallRegion> regionsOf
(
    const polyMesh& mesh, const pointField& points, const polyPatch& patch, int wallPatch, const labelUList& wholeFace
)
{
    if (!Pstream::parRun()) return coplanarRegions(primitivePatch(SubList<face>(mesh.faces(), patch.size(), patch.start()), points), wallPatch);
    const GatheredPatch whole = gatherPatch(mesh, points, patch, wholeFace);
    return coplanarRegions(primitivePatch(SubList<face>(whole.faces, whole.faces.size()), whole.points), wallPatch);
}

/// Adds the walls of grainProperties behind those of the mesh.
void append(nscd::Walls& walls, const GrainProperties& properties)
{
    const nscd::Walls& more = properties.walls;
    const std::size_t nPatches = walls.patches.size();
    for (std::size_t k = 0; k < more.patches.size(); ++k)
    {
        const auto hasItsName = [&](const nscd::WallPatch& patch) { return patch.name == more.patches[k].name; };
        const bool isTaken = std::any_of(walls.patches.begin(), walls.patches.end(), hasItsName);
        if (isTaken) fail({properties.wallPlaces[k], "is the name of another wall, a patch of the mesh"});
        walls.patches.push_back(more.patches[k]);
    }
    for (const nscd::WallRegion& region : more.regions)
    {
        walls.regions.push_back(region);
        walls.regions.back().patch += int(nPatches);
    }
    for (const std::string& note : properties.notes) Info<< note.c_str() << nl;
}

} // namespace


nscd::Walls makeMeshWalls(const GrainProperties& properties, const PatchRoles& roles, const polyMesh& mesh, const pointField& points)
{
    nscd::Walls walls;
    const labelList wholeFace = Pstream::parRun() ? facesOfWholeMesh(mesh) : labelList();
    for (const label patchi : roles.ofRole(PatchRole::wall))
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        const int wallPatch = walls.addPatch(patch.name(), roles.material[patchi]);
        const std::vector<nscd::WallRegion> regions = regionsOf(mesh, points, patch, wallPatch, wholeFace);
        walls.regions.insert(walls.regions.end(), regions.begin(), regions.end());
        walls.setSurfaceMotion(wallPatch, roles.surfaceMotion[patchi]);
        walls.patches[wallPatch].torquePoint = toVec3(roles.torquePoint[patchi]);
    }
    append(walls, properties);
    nscd::moveWalls(walls, mesh.time().value());
    return walls;
}


nscd::Walls makeMeshWalls(const GrainProperties& properties, const PatchRoles& roles, const polyMesh& mesh)
{
    return makeMeshWalls(properties, roles, mesh, mesh.points());
}

} // namespace nscdCoupling
} // namespace Foam
