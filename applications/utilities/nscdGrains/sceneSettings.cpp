// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading a scene, and placing its grains.
#include "sceneSettings.hpp"

#include "input/dictionary/textFile.hpp"
#include "input/scene/drivenReader.hpp"
#include "input/scene/materialReader.hpp"
#include "input/scene/sceneReader.hpp"
#include "input/start/placement.hpp"
#include "input/start/startChecks.hpp"

#include <algorithm>
#include <filesystem>

namespace nscdGrains
{

using input::CheckedEntries;
using input::InputError;
using input::textOf;

namespace
{

void readShape(const CheckedEntries& top, SceneSettings& scene)
{
    top.foundAsSpelt("dimensions");
    const double dimensions = top.number("dimensions", input::anyNumber(), 3);
    if (dimensions != 2 && dimensions != 3) top.reject("dimensions", "is out of range", "2 (discs in the x-y plane) or 3 (spheres)");
    scene.shape.dimensions = static_cast<int>(dimensions);
    scene.shape.emptyAxis = scene.isPlanar() ? 2 : -1;
    scene.shape.thickness = top.number("thickness", input::above(0, input::unit::length), 1.0);
    if (top.found("thickness") && !scene.isPlanar()) top.reject("thickness", "is for discs", "dimensions 2");

    const Vec3 usual = scene.isPlanar() ? Vec3(0, -9.81, 0) : Vec3(0, 0, -9.81);
    scene.gravity = top.vec("gravity", input::unit::acceleration, usual);
    if (scene.isPlanar() && scene.gravity.z() != 0.0) top.reject("gravity", "points out of the plane of the grains", "a vector (x y 0)");
}

constexpr double maxSteps = 1e12;   // times must tell steps apart

RunSettings readRun(const CheckedEntries& top)
{
    const input::Range duration = input::above(0, input::unit::time);
    RunSettings run;
    run.deltaT = top.number("deltaT", duration);
    run.endTime = top.number("endTime", duration);
    if (run.endTime < run.deltaT) top.reject("endTime", "is shorter than a step", textOf("at least deltaT, ", run.deltaT));
    if (run.endTime > maxSteps*run.deltaT) top.reject("endTime", "makes too many steps", textOf("at most ", maxSteps*run.deltaT, ", ", maxSteps, " steps"));
    run.writeInterval = top.number("writeInterval", duration, run.endTime);
    run.purgeWrite = top.integer("purgeWrite", 0, run.purgeWrite);
    run.results = top.text("results", run.results);
    return run;
}

void readPeriodic(const CheckedEntries& top, SceneSettings& scene)
{
    const input::Dictionary dict = top.subOrEmpty("periodic");
    const CheckedEntries given(dict);
    scene.periodicPlace = top.place("periodic");
    const char* const axes[] = {"x", "y", "z"};
    for (int k = 0; k < 3; ++k)
    {
        if (!given.found(axes[k])) continue;
        if (k == 2 && scene.isPlanar()) given.reject("z", "is across the plane of discs", "x, y");
        const std::array<double, 2> ends = given.pair(axes[k], input::unit::length);
        if (!(ends[1] > ends[0])) given.reject(axes[k], "is empty", "(lower upper)");
        scene.box.lower[k] = ends[0];
        scene.box.length[k] = ends[1] - ends[0];
    }
    given.finish();
}

void checkMaterialsAndPeriods(const SceneSettings& scene, const nscd::Grains& grains)
{
    input::checkPairs(scene.materials, input::usedMaterials(scene, grains), scene.walls);
    input::checkPeriods(scene.box, input::largestDiameter(scene, grains), scene.periodicPlace);
}

void checkOverlaps(const SceneSettings& scene, const nscd::Grains& grains, const nscd::Walls& walls, double maxShare)
{
    if (scene.letsFixedGo())
    {
        // Held ones may overlap, those that are free later may not.
        nscd::Grains later = grains;
        if (input::letGo(scene.driven, later)) return checkOverlaps(scene, later, walls, maxShare);
    }
    const std::vector<nscd::Overlap> overlaps = input::findOverlaps(grains, scene.box, walls, maxShare);
    input::refuseOverlaps(overlaps.size(), input::worstOverlaps(overlaps, grains, walls), scene, maxShare);
}

} // namespace

std::string SceneSettings::pathOf(const std::string& path) const
{
    return std::filesystem::path(file).parent_path()/path;
}

input::Surroundings SceneSettings::surroundings() const
{
    input::Surroundings around;
    around.shape = shape;
    around.box = box;
    around.pathOfGrains = around.pathOfSurface = [this](const std::string& path) { return pathOf(path); };
    return around;
}

SceneSettings parseScene(const std::string& text, const std::string& file)
{
    const input::Dictionary dict = input::parseDictionary(text, file);
    const CheckedEntries top(dict);
    SceneSettings scene;
    scene.file = file;
    readShape(top, scene);
    scene.run = readRun(top);
    readPeriodic(top, scene);
    input::readScene(top, scene.surroundings(), scene);
    if (!scene.hasAnySource()) throw InputError({top.place("grains"), "names no source of grains", "", "grains { type lattice; ... }"});
    nscd::moveWalls(scene.walls, 0.0);
    top.finish();
    return scene;
}

SceneSettings readScene(const std::string& path)
{
    return parseScene(input::readText(path, {"command line", 0, "scene"}), path);
}

nscd::Grains placeGrains(const SceneSettings& scene, const std::function<void(const std::string&)>& tell)
{
    nscd::Grains grains;
    input::PlacementTools tools;
    tools.tell = tell;
    input::placeGrains(scene, scene.surroundings(), tools, [&](nscd::Grains& all) { grains = std::move(all); });
    input::holdDriven(scene.driven, grains);
    return grains;
}

void checkGrains(const SceneSettings& scene, const nscd::Grains& grains)
{
    checkMaterialsAndPeriods(scene, grains);
    checkOverlaps(scene, grains, scene.walls, scene.maxInitialOverlap);
}

void checkGrainsOfRestart(const SceneSettings& scene, const nscd::Grains& grains, double time)
{
    checkMaterialsAndPeriods(scene, grains);
    nscd::Walls walls = scene.walls;
    nscd::moveWalls(walls, time);
    checkOverlaps(scene, grains, walls, input::maxOverlapOfRestart(scene));
}

} // namespace nscdGrains
