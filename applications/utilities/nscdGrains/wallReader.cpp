// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading walls.
#include "wallReader.hpp"
#include "materialReader.hpp"
#include "motionReader.hpp"

#include "nscd/scene/stlFile.hpp"

#include <algorithm>

namespace nscdGrains
{

namespace
{

constexpr double flatness = 1e-6;  // of a polygon, relative to its size

/// Adds the regions of a wall to its patch.
using AddWall = void (*)(const CheckedEntries&, SceneSettings&, int patch);

void checkPlaneDirection(const CheckedEntries& given, const Vec3& normal, const SceneSettings& scene)
{
    if (!(normal.norm() > 0.0)) given.reject("normal", "has no length", "a vector towards the grains, as (0 0 1)");
    if (scene.isPlanar() && normal.z() != 0.0) given.reject("normal", "points out of the plane of discs", "a vector (x y 0)");
    for (int k = 0; k < 3; ++k)
    {
        if (scene.box.isPeriodic(k) && normal[k] != 0.0) given.reject("normal", "points along a periodic axis", "a plane that its images continue");
    }
}

nscd::WallSides readSides(const CheckedEntries& given, const char* usual)
{
    return given.choice("sides", {"one", "both"}, usual) == "one" ? nscd::WallSides::one : nscd::WallSides::both;
}

void addPlane(const CheckedEntries& given, SceneSettings& scene, int patch)
{
    const Vec3 point = given.vec("point");
    const Vec3 normal = given.vec("normal");
    checkPlaneDirection(given, normal, scene);
    scene.walls.addPlane(patch, point, normal, readSides(given, "one"));
}

/// In 2D a wall runs from one vertex to another; grains are to its left. Across the plane it is as long, so that no disc feels its edges there.
std::vector<Vec3> uprightPolygon(Vec3 start, Vec3 end)
{
    start.z() = end.z() = 0.0;
    const Vec3 half = 0.5*(end - start).norm()*Vec3::UnitZ();
    return {start - half, start + half, end + half, end - half};
}

void checkVertices(const CheckedEntries& given, const std::vector<Vec3>& vertices)
{
    double size = 0.0;
    Vec3 area = Vec3::Zero();
    for (std::size_t k = 0; k < vertices.size(); ++k)
    {
        const Vec3& next = vertices[(k + 1) % vertices.size()];
        if (vertices[k] == next) given.reject("vertices", "holds the same vertex twice in a row", "vertices that differ");
        size = std::max(size, (vertices[k] - vertices[0]).norm());
        area += 0.5*(vertices[k] - vertices[0]).cross(next - vertices[0]);
    }
    if (!(area.norm() > flatness*size*size)) given.reject("vertices", "has no area", "vertices counter-clockwise seen from the grains");
    for (const Vec3& vertex : vertices)
    {
        const double height = area.normalized().dot(vertex - vertices[0]);
        if (std::abs(height) > flatness*size) given.reject("vertices", "does not lie in one plane", "a flat polygon, or several");
    }
}

void addPolygon(const CheckedEntries& given, SceneSettings& scene, int patch)
{
    std::vector<Vec3> vertices = given.vecList("vertices");
    if (scene.isPlanar())
    {
        if (vertices.size() != 2)
        {
            given.reject("vertices", "is no wall in the plane of discs", "two vertices with grains to the left, as ((0 0 0) (1 0 0))");
        }
        vertices = uprightPolygon(vertices[0], vertices[1]);
    }
    if (vertices.size() < 3) given.reject("vertices", "has too few vertices", "three or more, counter-clockwise seen from the grains");
    checkVertices(given, vertices);
    scene.walls.addPolygon(patch, vertices);
}

const Words sideNames = {"xMin", "xMax", "yMin", "yMax", "zMin", "zMax"};

/// The sides of a box that can be walls: those across periodic axes and the plane of discs cannot.
Words usableSides(const SceneSettings& scene)
{
    Words sides;
    for (int k = 0; k < 3; ++k)
    {
        if (scene.box.isPeriodic(k) || (k == 2 && scene.isPlanar())) continue;
        sides.insert(sides.end(), {sideNames[2*k], sideNames[2*k + 1]});
    }
    return sides;
}

void addBoxSides(const CheckedEntries& given, SceneSettings& scene, int patch)
{
    const std::array<Vec3, 2> corners = given.twoVecs("box");
    const Words usable = usableSides(scene);
    const Words sides = given.choices("sides", usable, usable);
    for (int k = 0; k < 3; ++k)
    {
        const bool isFree = std::find(usable.begin(), usable.end(), sideNames[2*k]) == usable.end();
        if (!isFree && !(corners[1][k] > corners[0][k])) given.reject("box", "is empty", "(lower corner) (upper corner)");
        for (int side = 0; side < 2; ++side)
        {
            if (std::find(sides.begin(), sides.end(), sideNames[2*k + side]) == sides.end()) continue;
            scene.walls.addPlane(patch, corners[side], side == 0 ? Vec3(Vec3::Unit(k)) : Vec3(-Vec3::Unit(k)));
        }
    }
}

/// In 2D a surface that goes through the plane of discs; what faces along it is not felt.
void addSurface(const CheckedEntries& given, SceneSettings& scene, int patch)
{
    const std::string path = scene.pathOf(given.text("file"));
    const double scale = given.number("scale", above(0), 1.0);
    const nscd::WallSides sides = readSides(given, "both");
    checkIsFile(path, given.place("file"));
    try
    {
        const std::size_t leftOut = scene.walls.addTriangles(patch, nscd::readStl(path, scale), sides);
        const std::string& name = scene.walls.patches[patch].name;
        if (leftOut > 0) scene.notes.push_back(textOf("wall ", name, ": ", leftOut, " triangles without area are left out"));
    }
    catch (const std::invalid_argument& error)
    {
        given.reject("file", std::string("cannot be used: ") + error.what(), "an STL file, ASCII or binary");
    }
}

struct WallType
{
    const char* name;
    AddWall add;
};

/// Every kind of wall: a function that reads its keywords and adds its regions, and a row. Others go here.
const WallType wallTypes[] =
{
    {"plane", addPlane},
    {"polygon", addPolygon},
    {"box", addBoxSides},
    {"stl", addSurface}
};

const WallType& readType(const CheckedEntries& given)
{
    Words names;
    for (const WallType& type : wallTypes) names.push_back(type.name);
    const std::string name = given.choice("type", names);
    return *std::find_if(std::begin(wallTypes), std::end(wallTypes), [&](const WallType& type) { return name == type.name; });
}

void readWall(const CheckedEntries& list, const std::string& name, bool isPlane, SceneSettings& scene)
{
    const CheckedEntries given(list.sub(name));
    const auto isNamed = [&](const nscd::WallPatch& patch) { return patch.name == name; };
    if (std::any_of(scene.walls.patches.begin(), scene.walls.patches.end(), isNamed)) list.reject(name, "is the name of another wall");
    if (name.find_first_of(",\"\n") != std::string::npos) list.reject(name, "is no name for a column of walls.csv", "a name without commas and quotes");
    const AddWall add = isPlane ? addPlane : readType(given).add;
    const bool mayInherit = !given.found("material") && scene.wallMaterial >= 0;
    const int material = mayInherit ? scene.wallMaterial : readMaterial(given, "material", scene.materials);
    const int patch = scene.walls.addPatch(name, material);
    add(given, scene, patch);
    readWallMotion(given, scene, patch);
    given.finish();
}

} // namespace

void readWalls(const CheckedEntries& top, SceneSettings& scene)
{
    if (top.found("wallMaterial")) scene.wallMaterial = readMaterial(top, "wallMaterial", scene.materials);
    else if (scene.materials.table.size() == 1) scene.wallMaterial = 0;

    for (const char* const list : {"planes", "walls"})
    {
        const Dictionary dict = top.subOrEmpty(list);
        const CheckedEntries given(dict);
        for (const Entry& entry : dict.entries) readWall(given, entry.keyword, list == std::string("planes"), scene);
    }
    nscd::moveWalls(scene.walls, 0.0);
}

} // namespace nscdGrains
