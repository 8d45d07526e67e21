// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading motions.
#include "input/scene/motionReader.hpp"

#include "input/scene/functionReader.hpp"

namespace input
{

namespace
{

Vec3 readAxis(const CheckedEntries& given, int emptyAxis)
{
    const Vec3 axis = given.vec("axis", unit::one);
    if (!(axis.norm() > 0.0)) given.reject("axis", "has no length", "a vector, as (0 0 1)");
    checkNormalToPlane(given, "axis", axis, emptyAxis);
    return axis;
}

/// The keyword of the two that is given, the speed or its integral.
std::string oneOf(const CheckedEntries& given, const std::string& speed, const std::string& place)
{
    const bool hasSpeed = given.found(speed);
    if (!given.found(place)) return speed;
    if (hasSpeed) given.reject(place, "stands beside " + speed, "one of the two");
    return place;
}

/// `torquePoint` becomes the origin.
nscd::WallMotion readRotation(const CheckedEntries& given, int emptyAxis, Vec3& torquePoint)
{
    torquePoint = given.vec("origin", unit::length);
    const Vec3 axis = readAxis(given, emptyAxis);
    const std::string keyword = oneOf(given, "omega", "angle");
    const nscd::ScalarOfTime value = readScalarFunction(given, keyword);
    return nscd::rotationBy(torquePoint, axis, keyword == "angle" ? value : nscd::integralOf(value));
}

nscd::WallMotion readTranslation(const CheckedEntries& given, int emptyAxis)
{
    const std::string keyword = oneOf(given, "velocity", "displacement");
    const nscd::VectorOfTime value = readVectorFunction(given, keyword, emptyAxis);
    return nscd::translationBy(keyword == "displacement" ? value : nscd::integralOf(value));
}

nscd::WallMotion readOscillation(const CheckedEntries& given, int emptyAxis)
{
    const Vec3 amplitude = given.vec("amplitude", unit::length);
    checkInPlane(given, "amplitude", amplitude, emptyAxis);
    const double frequency = given.number("frequency", between(0, highestFrequency, unit::rate));
    return nscd::oscillation(amplitude, frequency, given.number("phase", anyNumber(), 0.0));
}

/// An infinite plane must remain one that its periodic images continue.
void checkTurningPlanes(const CheckedEntries& motion, const nscd::PeriodicBox& box, const nscd::Walls& walls, int patch)
{
    const Vec3 axis = motion.vec("axis", unit::one).normalized();
    for (const nscd::WallRegion& region : walls.regions)
    {
        if (region.patch != patch || !region.edges.empty()) continue;
        for (int k = 0; k < 3; ++k)
        {
            const bool staysAcross = axis.cross(region.normal).norm() < 1e-12 || axis.cross(Vec3(Vec3::Unit(k))).norm() < 1e-12;
            if (box.isPeriodic(k) && !staysAcross) motion.reject("axis", "turns a plane towards a periodic axis", "the plane's normal or the periodic axis");
        }
    }
}

nscd::WallMotion readMotion(const Dictionary& dict, const Surroundings& around, const nscd::Walls& walls, int patch, Vec3& torquePoint)
{
    const CheckedEntries given(dict);
    const int emptyAxis = around.shape.emptyAxis;
    const std::string type = given.choice("type", {"rotation", "translation", "oscillation"});
    nscd::WallMotion motion;
    if (type == "rotation") motion = readRotation(given, emptyAxis, torquePoint);
    else if (type == "translation") motion = readTranslation(given, emptyAxis);
    else motion = readOscillation(given, emptyAxis);
    given.finish();
    if (type == "rotation") checkTurningPlanes(given, around.box, walls, patch);
    return motion;
}

} // namespace

void readWallMotion(const CheckedEntries& wall, const Surroundings& around, nscd::Walls& walls, int patch)
{
    Vec3 torquePoint = Vec3::Zero();
    if (wall.found("motion")) walls.setMotion(patch, readMotion(wall.sub("motion"), around, walls, patch, torquePoint));
    walls.setSurfaceMotion(patch, readSurfaceMotion(wall, around.shape.emptyAxis));
    walls.patches[patch].torquePoint = wall.vec("torquePoint", unit::length, torquePoint);
}

nscd::SurfaceMotion readSurfaceMotion(const CheckedEntries& wall, int emptyAxis)
{
    const std::string keyword = oneOf(wall, "surfaceVelocity", "surfaceRotation");
    if (!wall.found(keyword)) return nullptr;
    if (keyword == "surfaceVelocity")
    {
        const nscd::VectorOfTime velocity = readVectorFunction(wall, keyword, emptyAxis);
        return [velocity](double time) { return nscd::Twist{velocity(time), Vec3::Zero(), Vec3::Zero()}; };
    }
    const CheckedEntries given(wall.sub(keyword));
    const Vec3 origin = given.vec("origin", unit::length);
    const Vec3 axis = readAxis(given, emptyAxis).normalized();
    const nscd::ScalarOfTime omega = readScalarFunction(given, "omega");
    given.finish();
    return [=](double time) { return nscd::Twist{Vec3::Zero(), omega(time)*axis, origin}; };
}

} // namespace input
