// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading a scene, one function per dictionary.
#include "grainSources.hpp"
#include "materialReader.hpp"
#include "motionReader.hpp"
#include "wallReader.hpp"

#include "nscd/kernels/sweepKernels.hpp"
#include "nscd/solvers/contactSolver.hpp"

#include <filesystem>

namespace nscdGrains
{

namespace
{

void readShape(const CheckedEntries& top, SceneSettings& scene)
{
    const double dimensions = top.number("dimensions", anyNumber(), 3);
    if (dimensions != 2 && dimensions != 3) top.reject("dimensions", "is out of range", "2 (discs in the x-y plane) or 3 (spheres)");
    scene.shape.dimensions = static_cast<int>(dimensions);
    scene.shape.emptyAxis = scene.isPlanar() ? 2 : -1;
    scene.shape.thickness = top.number("thickness", above(0), 1.0);
    if (top.found("thickness") && !scene.isPlanar()) top.reject("thickness", "is for discs", "dimensions 2");

    const Vec3 usual = scene.isPlanar() ? Vec3(0, -9.81, 0) : Vec3(0, 0, -9.81);
    scene.gravity = top.vec("gravity", usual);
    if (scene.isPlanar() && scene.gravity.z() != 0.0) top.reject("gravity", "points out of the plane of discs", "a vector (x y 0)");
}

constexpr double maxSteps = 1e12;   // times must tell steps apart

RunSettings readRun(const CheckedEntries& top)
{
    RunSettings run;
    run.deltaT = top.number("deltaT", above(0));
    run.endTime = top.number("endTime", above(0));
    if (run.endTime < run.deltaT) top.reject("endTime", "is shorter than a step", textOf("at least deltaT, ", run.deltaT));
    if (run.endTime > maxSteps*run.deltaT) top.reject("endTime", "makes too many steps", textOf("at most ", maxSteps*run.deltaT, ", ", maxSteps, " steps"));
    run.writeInterval = top.number("writeInterval", above(0), run.endTime);
    run.purgeWrite = top.integer("purgeWrite", 0, run.purgeWrite);
    run.results = top.text("results", run.results);
    return run;
}

void readPeriodic(const CheckedEntries& top, SceneSettings& scene)
{
    const Dictionary dict = top.subOrEmpty("periodic");
    const CheckedEntries given(dict);
    scene.periodicPlace = top.place("periodic");
    const char* const axes[] = {"x", "y", "z"};
    for (int k = 0; k < 3; ++k)
    {
        if (!given.found(axes[k])) continue;
        if (k == 2 && scene.isPlanar()) given.reject("z", "is across the plane of discs", "x, y");
        const std::array<double, 2> ends = given.pair(axes[k]);
        if (!(ends[1] > ends[0])) given.reject(axes[k], "is empty", "(lower upper)");
        scene.box.lower[k] = ends[0];
        scene.box.length[k] = ends[1] - ends[0];
    }
    given.finish();
}

Words solverWords()
{
    Words words;
    for (const nscd::ContactSolverRow& row : nscd::contactSolvers()) words.push_back(row.name);
    return words;
}

nscd::ContactSettings readContactSettings(const CheckedEntries& top)
{
    const Dictionary dict = top.subOrEmpty("solver");
    const CheckedEntries given(dict);
    nscd::ContactSettings s;
    s.solver = given.choice("type", solverWords(), s.solver);
    s.tolerance = given.number("tolerance", above(0), s.tolerance);
    s.displacementTolerance = given.number("displacementTolerance", above(0), s.displacementTolerance);
    s.maxSweeps = static_cast<int>(given.integer("maxSweeps", 1, s.maxSweeps));
    s.deadBand = given.number("deadBand", atLeast(0), s.deadBand);
    s.overlapTolerance = given.number("overlapTolerance", above(0), s.overlapTolerance);
    s.skin = given.number("skin", atLeast(0), s.skin);
    s.accelerate = given.flag("accelerate", s.accelerate);
    s.sleep = given.flag("sleep", s.sleep);
    s.vectorPath = given.choice("vectorPath", {"auto", "portable", "AVX2", "AVX512"}, s.vectorPath);
    try
    {
        nscd::chooseKernels(s.vectorPath.c_str());
    }
    catch (const std::invalid_argument& error)
    {
        given.reject("vectorPath", "is not for this processor", "auto");
    }
    given.finish();
    return s;
}

} // namespace

std::string SceneSettings::pathOf(const std::string& path) const
{
    return std::filesystem::path(file).parent_path()/path;
}

SceneSettings parseScene(const std::string& text, const std::string& file)
{
    const Dictionary dict = parseDictionary(text, file);
    const CheckedEntries top(dict);
    SceneSettings scene;
    scene.file = file;
    readShape(top, scene);
    scene.run = readRun(top);
    scene.materials = readMaterials(top);
    readPeriodic(top, scene);
    readWalls(top, scene);
    readSources(top, scene);
    readDriven(top, scene);
    scene.contact = readContactSettings(top);
    top.finish();
    return scene;
}

SceneSettings readScene(const std::string& path)
{
    return parseScene(readText(path, {"command line", 0, "scene"}), path);
}

} // namespace nscdGrains
