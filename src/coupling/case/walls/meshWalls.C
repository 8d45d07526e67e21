// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Collecting the walls of a case.
#include "coupling/base/vectorConversion.H"
#include "coupling/case/walls/coplanarRegions.H"
#include "coupling/case/walls/gatheredPatch.H"
#include "coupling/case/walls/meshWalls.H"

#include "nscd/scene/stlFile.hpp"

#include "Time.H"

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

/// A file's name alone is one in constant/triSurface; other paths start at the case.
fileName pathOf(const fileName& file, const Time& time)
{
    if (file.isAbsolute()) return file;
    return file.find('/') == std::string::npos ? time.globalPath()/time.constant()/"triSurface"/file : time.globalPath()/file;
}

void addSurface(nscd::Walls& walls, int patch, const FreeWall& wall, const Time& time)
{
    try
    {
        const std::vector<nscd::Triangle> triangles = nscd::readStl(pathOf(wall.file, time), wall.scale);
        const std::size_t leftOut = walls.addTriangles(patch, triangles, wall.sides);
        if (leftOut > 0) Info<< "wall " << wall.name << ": " << label(leftOut) << " triangles without area are left out" << nl;
    }
    catch (const std::invalid_argument& error)
    {
        fail({wall.filePlace, "cannot be used: " + string(error.what()), wall.file, "an STL file, ASCII or binary"});
    }
}

void addFreeWall(nscd::Walls& walls, const FreeWall& wall, const Time& time)
{
    for (const nscd::WallPatch& patch : walls.patches)
    {
        if (patch.name == wall.name) fail({wall.place, "has the name of another wall", wall.name});
    }
    const int patch = walls.addPatch(wall.name, wall.material);
    if (wall.isPlane) walls.addPlane(patch, toVec3(wall.point), toVec3(wall.normal), wall.sides);
    else addSurface(walls, patch, wall, time);
    walls.setMotion(patch, wall.motion);
    walls.setSurfaceMotion(patch, wall.surfaceMotion);
    walls.patches[patch].torquePoint = toVec3(wall.torquePoint);
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
        walls.setSurfaceMotion(wallPatch, roles.surfaceMotion[patchi]);
        walls.patches[wallPatch].torquePoint = toVec3(roles.torquePoint[patchi]);
    }
    for (const PlaneWall& plane : properties.planes)
    {
        walls.addPlane(walls.addPatch(plane.name, plane.material), toVec3(plane.point), toVec3(plane.normal));
    }
    for (const FreeWall& wall : properties.walls) addFreeWall(walls, wall, mesh.time());
    nscd::moveWalls(walls, mesh.time().value());
    return walls;
}

} // namespace nscdCoupling
} // namespace Foam
