// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading motions, with the keywords of nscdDEMFoam's constant/grainProperties.
#include "functionReader.hpp"
#include "motionReader.hpp"

#include <algorithm>
#include <set>

namespace nscdGrains
{

namespace
{

Vec3 readAxis(const CheckedEntries& given, bool isPlanar)
{
    const Vec3 axis = given.vec("axis");
    if (!(axis.norm() > 0.0)) given.reject("axis", "has no length", "a vector, as (0 0 1)");
    if (isPlanar && axis.head<2>().norm() > 0.0) given.reject("axis", "turns out of the plane of discs", "a vector (0 0 z)");
    return axis;
}

/// The keyword of the two that is given, the speed or its integral.
std::string oneOf(const CheckedEntries& given, const std::string& speed, const std::string& place)
{
    if (!given.found(place)) return speed;
    if (given.found(speed)) given.reject(place, "stands beside " + speed, "one of the two");
    return place;
}

/// `torquePoint` becomes the origin.
nscd::WallMotion readRotation(const CheckedEntries& given, bool isPlanar, Vec3& torquePoint)
{
    torquePoint = given.vec("origin");
    const Vec3 axis = readAxis(given, isPlanar);
    const std::string keyword = oneOf(given, "omega", "angle");
    const nscd::ScalarOfTime value = readScalarFunction(given, keyword);
    return nscd::rotationBy(torquePoint, axis, keyword == "angle" ? value : nscd::integralOf(value));
}

nscd::WallMotion readTranslation(const CheckedEntries& given, bool isPlanar)
{
    const std::string keyword = oneOf(given, "velocity", "displacement");
    const nscd::VectorOfTime value = readVectorFunction(given, keyword, isPlanar);
    return nscd::translationBy(keyword == "displacement" ? value : nscd::integralOf(value));
}

nscd::WallMotion readOscillation(const CheckedEntries& given, bool isPlanar)
{
    const Vec3 amplitude = given.vec("amplitude");
    if (isPlanar && amplitude.z() != 0.0) given.reject("amplitude", "leaves the plane of discs", "a vector (x y 0)");
    const double frequency = given.number("frequency", atLeast(0));
    return nscd::oscillation(amplitude, frequency, given.number("phase", anyNumber(), 0.0));
}

/// An infinite plane must remain one that its periodic images continue.
void checkTurningPlanes(const CheckedEntries& motion, const SceneSettings& scene, int patch)
{
    const Vec3 axis = motion.vec("axis").normalized();
    for (const nscd::WallRegion& region : scene.walls.regions)
    {
        if (region.patch != patch || !region.edges.empty()) continue;
        for (int k = 0; k < 3; ++k)
        {
            const bool staysAcross = axis.cross(region.normal).norm() < 1e-12 || axis.cross(Vec3(Vec3::Unit(k))).norm() < 1e-12;
            if (scene.box.isPeriodic(k) && !staysAcross) motion.reject("axis", "turns a plane towards a periodic axis", "the plane's normal or the periodic axis");
        }
    }
}

nscd::WallMotion readMotion(const Dictionary& dict, const SceneSettings& scene, int patch, Vec3& torquePoint)
{
    const CheckedEntries given(dict);
    const std::string type = given.choice("type", {"rotation", "translation", "oscillation"});
    nscd::WallMotion motion;
    if (type == "rotation") motion = readRotation(given, scene.isPlanar(), torquePoint);
    else if (type == "translation") motion = readTranslation(given, scene.isPlanar());
    else motion = readOscillation(given, scene.isPlanar());
    given.finish();
    if (type == "rotation") checkTurningPlanes(given, scene, patch);
    return motion;
}

nscd::SurfaceMotion readSurfaceMotion(const CheckedEntries& wall, bool isPlanar)
{
    const std::string keyword = oneOf(wall, "surfaceVelocity", "surfaceRotation");
    if (!wall.found(keyword)) return nullptr;
    if (keyword == "surfaceVelocity")
    {
        const nscd::VectorOfTime velocity = readVectorFunction(wall, keyword, isPlanar);
        return [velocity](double time) { return nscd::Twist{velocity(time), Vec3::Zero(), Vec3::Zero()}; };
    }
    const CheckedEntries given(wall.sub(keyword));
    const Vec3 origin = given.vec("origin");
    const Vec3 axis = readAxis(given, isPlanar).normalized();
    const nscd::ScalarOfTime omega = readScalarFunction(given, "omega");
    given.finish();
    return [=](double time) { return nscd::Twist{Vec3::Zero(), omega(time)*axis, origin}; };
}

DrivenGroup readGroup(const CheckedEntries& list, const std::string& name, bool isPlanar)
{
    const CheckedEntries given(list.sub(name));
    DrivenGroup group;
    group.place = list.place(name);
    for (const long id : given.integers("ids", 0)) group.grains.ids.push_back(id);
    std::sort(group.grains.ids.begin(), group.grains.ids.end());
    const auto twice = std::adjacent_find(group.grains.ids.begin(), group.grains.ids.end());
    if (twice != group.grains.ids.end()) given.reject("ids", "names grain " + std::to_string(*twice) + " twice", "each grain once");
    group.grains.velocity = readVectorFunction(given, "velocity", isPlanar);
    if (given.found("omega")) group.grains.omega = readSpinFunction(given, "omega", isPlanar);
    given.finish();
    return group;
}

} // namespace

void readWallMotion(const CheckedEntries& wall, SceneSettings& scene, int patch)
{
    Vec3 torquePoint = Vec3::Zero();
    if (wall.found("motion")) scene.walls.setMotion(patch, readMotion(wall.sub("motion"), scene, patch, torquePoint));
    scene.walls.setSurfaceMotion(patch, readSurfaceMotion(wall, scene.isPlanar()));
    scene.walls.patches[patch].torquePoint = wall.vec("torquePoint", torquePoint);
}

void readDriven(const CheckedEntries& top, SceneSettings& scene)
{
    const Dictionary dict = top.subOrEmpty("driven");
    const CheckedEntries list(dict);
    std::set<std::int64_t> seen;
    for (const Entry& entry : dict.entries)
    {
        scene.driven.push_back(readGroup(list, entry.keyword, scene.isPlanar()));
        for (const std::int64_t id : scene.driven.back().grains.ids)
        {
            if (!seen.insert(id).second) list.reject(entry.keyword, "drives grain " + std::to_string(id) + ", which another group drives too");
        }
    }
}

void holdDriven(const SceneSettings& scene, nscd::Grains& grains)
{
    for (const DrivenGroup& group : scene.driven)
    {
        const std::size_t missing = group.grains.ids.size() - nscd::hold(group.grains, grains);
        if (missing == 0) continue;
        const std::string allowed = textOf("0 to ", grains.size() - 1, ", in the order of the sources");
        fail({group.place, "names grains by ids that are not there", textOf(missing, " of its ids"), allowed, {}});
    }
}

} // namespace nscdGrains
