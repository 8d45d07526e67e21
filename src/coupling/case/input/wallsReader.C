// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Walls beside the mesh: shapes, motions, belts.
#include "coupling/base/vectorConversion.H"
#include "coupling/case/input/functionReader.H"
#include "coupling/case/input/grainProperties.H"
#include "coupling/case/input/materialsReader.H"
#include "coupling/case/input/wallsReader.H"

#include "dimensionSets.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

vector readAxis(const CheckedDict& given)
{
    const vector axis = given.vec("axis", dimless);
    if (mag(axis) <= 0) given.reject("axis", "has no length", "a vector, as (0 0 1)");
    return axis;
}

/// The keyword of the two that is given, the speed or its integral.
word oneOf(const CheckedDict& given, const word& speed, const word& place)
{
    const bool hasSpeed = given.found(speed);
    if (hasSpeed && given.found(place)) given.reject(place, "is given beside " + speed, "one of the two");
    return given.found(place) ? place : speed;
}

nscd::WallMotion readRotation(const CheckedDict& given, vector& torquePoint)
{
    const vector origin = given.vec("origin", dimLength);
    const vector axis = readAxis(given);
    const word keyword = oneOf(given, "omega", "angle");
    const nscd::ScalarOfTime value = readScalarFunction(given, keyword);
    torquePoint = origin;
    return nscd::rotationBy(toVec3(origin), toVec3(axis), keyword == "angle" ? value : nscd::integralOf(value));
}

nscd::WallMotion readTranslation(const CheckedDict& given)
{
    const word keyword = oneOf(given, "velocity", "displacement");
    const nscd::VectorOfTime value = readVectorFunction(given, keyword);
    return nscd::translationBy(keyword == "displacement" ? value : nscd::integralOf(value));
}

nscd::WallMotion readOscillation(const CheckedDict& given)
{
    const vector amplitude = given.vec("amplitude", dimLength);
    const scalar frequency = given.number("frequency", atLeast(0), dimless/dimTime);
    const scalar phase = given.number("phase", anyNumber(), dimless, 0.0);
    return nscd::oscillation(toVec3(amplitude), frequency, phase);
}

/// `torquePoint` becomes the origin of a rotation.
nscd::WallMotion readMotion(const dictionary& dict, vector& torquePoint)
{
    const CheckedDict given(dict);
    const std::string type = given.choice("type", {"rotation", "translation", "oscillation"});
    nscd::WallMotion motion;
    if (type == "rotation") motion = readRotation(given, torquePoint);
    else if (type == "translation") motion = readTranslation(given);
    else motion = readOscillation(given);
    given.finish();
    return motion;
}

void readShape(const CheckedDict& given, FreeWall& wall)
{
    wall.isPlane = given.choice("type", {"stl", "plane"}) == "plane";
    wall.sides = given.choice("sides", {"one", "both"}, wall.isPlane ? "one" : "both") == "both"
        ? nscd::WallSides::both : nscd::WallSides::one;
    if (wall.isPlane)
    {
        wall.point = given.vec("point", dimLength);
        wall.normal = given.vec("normal", dimless);
        if (mag(wall.normal) <= 0) given.reject("normal", "has no length", "a vector towards the grains, as (0 0 1)");
        return;
    }
    wall.file = given.text("file");
    wall.filePlace = given.place("file");
    wall.scale = given.number("scale", above(0), dimless, 1.0);
}

FreeWall readWall(const CheckedDict& given, const word& name, const GrainProperties& properties)
{
    FreeWall wall;
    wall.name = name;
    readShape(given, wall);
    const bool mayInherit = properties.wallMaterial >= 0 && !given.found("material");
    wall.material = mayInherit ? properties.wallMaterial : readMaterial(given, "material", properties.materials);
    if (given.found("motion")) wall.motion = readMotion(given.sub("motion"), wall.torquePoint);
    wall.torquePoint = given.vec("torquePoint", dimLength, wall.torquePoint);
    wall.surfaceMotion = readSurfaceMotion(given);
    given.finish();
    return wall;
}

} // namespace


nscd::SurfaceMotion readSurfaceMotion(const CheckedDict& wall)
{
    const word keyword = oneOf(wall, "surfaceVelocity", "surfaceRotation");
    if (!wall.found(keyword)) return nullptr;
    if (keyword == "surfaceVelocity")
    {
        const nscd::VectorOfTime velocity = readVectorFunction(wall, keyword);
        return [velocity](double time) { return nscd::Twist{velocity(time), nscd::Vec3::Zero(), nscd::Vec3::Zero()}; };
    }
    const CheckedDict given(wall.sub(keyword));
    const nscd::Vec3 origin = toVec3(given.vec("origin", dimLength));
    const nscd::Vec3 axis = toVec3(readAxis(given)).normalized();
    const nscd::ScalarOfTime omega = readScalarFunction(given, "omega");
    given.finish();
    return [=](double time) { return nscd::Twist{nscd::Vec3::Zero(), omega(time)*axis, origin}; };
}


std::vector<FreeWall> readWalls(const CheckedDict& top, const GrainProperties& properties)
{
    std::vector<FreeWall> walls;
    if (!top.found("walls")) return walls;
    const dictionary& list = top.sub("walls");
    const CheckedDict given(list);
    for (const entry& wall : list)
    {
        walls.push_back(readWall(CheckedDict(given.sub(wall.keyword())), wall.keyword(), properties));
        walls.back().place = given.place(wall.keyword());
    }
    return walls;
}

} // namespace nscdCoupling
} // namespace Foam
