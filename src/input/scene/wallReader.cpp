// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading walls.
#include "input/scene/wallReader.hpp"

#include "input/dictionary/textFile.hpp"
#include "input/dictionary/withoutTraps.hpp"
#include "input/scene/functionReader.hpp"
#include "input/scene/materialReader.hpp"
#include "input/scene/motionReader.hpp"

#include "nscd/scene/stlFile.hpp"

#include <algorithm>

namespace input
{

namespace
{

constexpr double flatness = 1e-6;  // of a polygon, relative to its size

/// Adds the regions of a wall to its patch.
using AddWall = void (*)(const CheckedEntries&, const Surroundings&, Scene&, int patch);

void checkPlaneDirection(const CheckedEntries& given, const Vec3& normal, const Surroundings& around)
{
    if (!(normal.norm() > 0.0)) given.reject("normal", "has no length", "a vector towards the grains, as (0 0 1)");
    checkInPlane(given, "normal", normal, around.shape.emptyAxis);
    for (int k = 0; k < 3; ++k)
    {
        if (around.box.isPeriodic(k) && normal[k] != 0.0) given.reject("normal", "points along a periodic axis", "a plane that its images continue");
    }
}

nscd::WallSides readSides(const CheckedEntries& given, const char* usual)
{
    return given.choice("sides", {"one", "both"}, usual) == "one" ? nscd::WallSides::one : nscd::WallSides::both;
}

void addPlane(const CheckedEntries& given, const Surroundings& around, Scene& scene, int patch)
{
    const Vec3 point = given.vec("point", unit::length);
    const Vec3 normal = given.vec("normal", unit::one);
    checkPlaneDirection(given, normal, around);
    scene.walls.addPlane(patch, point, normal, readSides(given, "one"));
}

/// In 2D a wall runs from one vertex to another; grains are to its left. Across the plane it is as long, so that no disc feels its edges there.
std::vector<Vec3> uprightPolygon(Vec3 start, Vec3 end, int emptyAxis)
{
    start[emptyAxis] = end[emptyAxis] = 0.0;
    const Vec3 half = 0.5*(end - start).norm()*Vec3::Unit(emptyAxis);
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

void addPolygon(const CheckedEntries& given, const Surroundings& around, Scene& scene, int patch)
{
    std::vector<Vec3> vertices = given.vecList("vertices", unit::length);
    const int emptyAxis = around.shape.emptyAxis;
    if (emptyAxis >= 0)
    {
        if (vertices.size() != 2)
        {
            given.reject("vertices", "is no wall in the plane of the grains", "two vertices with grains to the left, as ((0 0 0) (1 0 0))");
        }
        vertices = uprightPolygon(vertices[0], vertices[1], emptyAxis);
    }
    if (vertices.size() < 3) given.reject("vertices", "has too few vertices", "three or more, counter-clockwise seen from the grains");
    checkVertices(given, vertices);
    scene.walls.addPolygon(patch, vertices);
}

const Words sideNames = {"xMin", "xMax", "yMin", "yMax", "zMin", "zMax"};

/// The sides of a box that can be walls: those across periodic axes and the plane of the grains cannot.
Words usableSides(const Surroundings& around)
{
    Words sides;
    for (int k = 0; k < 3; ++k)
    {
        if (around.box.isPeriodic(k) || around.isEmpty(k)) continue;
        sides.insert(sides.end(), {sideNames[2*k], sideNames[2*k + 1]});
    }
    return sides;
}

void addBoxSides(const CheckedEntries& given, const Surroundings& around, Scene& scene, int patch)
{
    const std::array<Vec3, 2> corners = given.twoVecs("box", unit::length);
    const Words usable = usableSides(around);
    const Words sides = given.choices("sides", usable, usable);
    if (sides.empty() && given.found("sides")) given.reject("sides", "is empty: the box has no wall", "", usable);
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

/// Refuses coordinates whose squares and products no computer holds.
void checkSize(const CheckedEntries& given, const std::vector<nscd::Triangle>& triangles)
{
    for (const nscd::Triangle& triangle : triangles)
    {
        for (const Vec3& vertex : triangle)
        {
            if (vertex.allFinite() && vertex.cwiseAbs().maxCoeff() > largestNumber)
            {
                given.reject("file", "holds a vertex too far away, " + describe(vertex), textOf("coordinates up to ", largestNumber));
            }
        }
    }
}

/// In 2D a surface that goes through the plane of the grains; what faces along it is not felt.
void addSurface(const CheckedEntries& given, const Surroundings& around, Scene& scene, int patch)
{
    const std::string path = around.pathOfSurface(given.text("file"));
    const double scale = given.number("scale", above(0), 1.0);
    const nscd::WallSides sides = readSides(given, "both");
    checkIsFile(path, given.place("file"));
    try
    {
        const WithoutTraps traps;
        const std::vector<nscd::Triangle> triangles = nscd::readStl(path, scale);
        checkSize(given, triangles);
        const std::size_t leftOut = scene.walls.addTriangles(patch, triangles, sides);
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

void checkName(const CheckedEntries& list, const std::string& name, const nscd::Walls& walls)
{
    const auto isNamed = [&](const nscd::WallPatch& patch) { return patch.name == name; };
    if (std::any_of(walls.patches.begin(), walls.patches.end(), isNamed)) list.reject(name, "is the name of another wall");
    if (name.find_first_of(",\"\n") != std::string::npos) list.reject(name, "is no name for a column of walls.csv", "a name without commas and quotes");
}

void readWall(const CheckedEntries& list, const std::string& name, bool isPlane, const Surroundings& around, Scene& scene)
{
    const CheckedEntries given(list.sub(name));
    checkName(list, name, scene.walls);
    const AddWall add = isPlane ? addPlane : readType(given).add;
    const int patch = scene.walls.addPatch(name, readMaterialOfWall(given, scene));
    scene.wallPlaces.push_back(list.place(name));
    add(given, around, scene, patch);
    readWallMotion(given, around, scene.walls, patch);
    given.finish();
}

} // namespace

void readWalls(const CheckedEntries& top, const Surroundings& around, Scene& scene)
{
    for (const char* const list : {"planes", "walls"})
    {
        const Dictionary dict = top.subOrEmpty(list);
        const CheckedEntries given(dict);
        for (const Entry& entry : dict.entries) readWall(given, entry.keyword, list == std::string("planes"), around, scene);
    }
}

} // namespace input
