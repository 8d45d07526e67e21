// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading the sources of grains.
#include "input/scene/sourceReader.hpp"

#include "input/scene/clumpReader.hpp"
#include "input/scene/coarseReader.hpp"
#include "input/scene/entryReader.hpp"
#include "input/scene/fillingReader.hpp"
#include "input/scene/functionReader.hpp"
#include "input/scene/materialReader.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace input
{

namespace
{

/// Of this machine [B], as Linux tells it; elsewhere without end.
double memory()
{
    std::ifstream file("/proc/meminfo");
    std::string name;
    double kilobytes = 0.0;
    return file >> name >> kilobytes ? 1024.0*kilobytes : std::numeric_limits<double>::infinity();
}

/// A run takes 1.6 kB a grain and more; its ranks may be on as many machines like this one.
double mostGrains(int nRanks)
{
    return std::min(1e9, std::floor(nRanks*memory()/1000.0));
}

/// Grains along one axis, from `count` or as many as a spacing lets fit.
double countAlong(const CheckedEntries& given, double number, bool isCounted)
{
    // A box that is a whole number of spacings long must not lose a layer to round-off.
    const double whole = std::floor(number + (isCounted ? 0.0 : 1e-9));
    if (isCounted && !(whole >= 1 && whole == number)) given.reject("count", "is not three whole numbers >= 1", "as (10 10 20)");
    return std::max(1.0, whole);
}

/// Grains along each axis from `count (nx ny nz);`, or from `spacing`.
std::array<int, 3> readCount(const CheckedEntries& given, const Vec3& extent, const Surroundings& around)
{
    const bool isCounted = given.found("count");
    if (isCounted && given.found("spacing")) given.reject("spacing", "stands beside count", "one of the two");
    if (!isCounted && !given.found("spacing")) given.require("count", "count (10 10 20); or spacing 2.5e-3;");
    const Vec3 perAxis = isCounted ? given.vec("count", unit::one) : Vec3(extent/given.number("spacing", above(0, unit::length)));
    Vec3 count;
    for (int k = 0; k < 3; ++k) count[k] = around.isEmpty(k) ? 1.0 : countAlong(given, perAxis[k], isCounted);
    const double most = mostGrains(around.nRanks);
    if (!(count.prod() <= most))
    {
        given.reject(isCounted ? "count" : "spacing", "makes too many grains", textOf("at most ", most, " grains, for the memory of this machine"));
    }
    return {static_cast<int>(count[0]), static_cast<int>(count[1]), static_cast<int>(count[2])};
}

nscd::GrainLattice readLattice(const CheckedEntries& given, const Surroundings& around, double coarseGraining)
{
    nscd::GrainLattice lattice{};
    const std::array<Vec3, 2> corners = given.twoVecs("box", unit::length);
    lattice.lower = corners[0];
    lattice.upper = corners[1];
    for (int k = 0; k < 3; ++k)
    {
        if (around.isEmpty(k)) lattice.lower[k] = lattice.upper[k] = 0.0;
        else if (!(corners[1][k] > corners[0][k])) given.reject("box", "is empty", "(lower corner) (upper corner)");
    }
    lattice.diameter = coarseGraining*given.number("diameter", above(0, unit::length));
    lattice.count = readCount(given, lattice.upper - lattice.lower, around);
    lattice.spread = given.number("spread", Range{0, 1, true, false}, 0.0);
    lattice.jitter = given.number("jitter", between(0, 1), 0.0);
    lattice.seed = static_cast<std::uint64_t>(given.integer("seed", 0, 1));
    return lattice;
}

GrainSource readSource(const Dictionary& dict, const std::string& type, const Surroundings& around, const char* usualMotion, Scene& scene)
{
    const MaterialTable& materials = scene.materials;
    const CheckedEntries given(dict);
    GrainSource source;
    source.place = dict.place;
    given.found("type");
    source.type = type;
    source.coarseGraining = readCoarseGraining(given, around, scene);
    source.material = readMaterialOfGrains(given, materials);
    source.velocity = given.vec("velocity", unit::velocity, Vec3::Zero());
    source.omega = given.vec("omega", unit::rate, Vec3::Zero());
    checkInPlane(given, "velocity", source.velocity, around.shape.emptyAxis);
    checkNormalToPlane(given, "omega", source.omega, around.shape.emptyAxis);
    source.isFixed = given.choice("motion", {"free", "fixed"}, usualMotion) == std::string("fixed");
    if (source.type == "lattice") source.lattice = readLattice(given, around, source.coarseGraining);
    else if (source.type == "filling") readFilling(given, materials, around, mostGrains(around.nRanks), source);
    else source.file = given.text("file");
    source.filePlace = given.place("file");
    if (source.type == "positionsFile") source.diameter = source.coarseGraining*given.number("diameter", above(0, unit::length));
    if (source.type != "filling") source.clump = readClump(given, source, around);
    given.finish();
    return source;
}

/// Grains of another case: what they are made of, how they move and what holds them is as it was written.
GrainSource readWrittenTime(const Dictionary& dict, const std::string& usualMotion)
{
    const CheckedEntries given(dict);
    given.found("type");
    GrainSource source;
    source.place = dict.place;
    source.type = "time";
    source.isFixed = usualMotion == "fixed";
    source.file = given.text("case");
    source.filePlace = given.place("case");
    given.require("time", "time 0.5; or time latestTime;");
    const std::vector<Token>& time = given.tokens("time", "a number [s], or latestTime");
    if (time.size() != 1 || !(time[0].isNumber() || time[0].text == "latestTime")) given.reject("time", "is no time", "a number [s], or latestTime", {"latestTime"});
    source.time = time[0].text;
    source.timePlace = given.place("time");
    given.finish();
    return source;
}

/// A source at the start, or one during the run.
void addSource(const Dictionary& dict, const std::string& name, const Surroundings& around, const std::string& usualMotion, Scene& scene)
{
    const CheckedEntries given(dict);
    Words types = {"positionsFile", "table", "lattice", "filling", "entering"};
    if (around.grainsOfTime) types.push_back("time");
    const std::string type = given.choice("type", types);
    if (type == "time") scene.sources.push_back(readWrittenTime(dict, usualMotion));
    else if (type != "entering") scene.sources.push_back(readSource(dict, type, around, usualMotion.c_str(), scene));
    else if (usualMotion == "fixed") given.reject("type", "lets grains in that motion fixed would hold", "motion fixed; in the sources that are to be held");
    else readEntry(dict, name, around, scene);
}

} // namespace

void readSources(const CheckedEntries& top, const Surroundings& around, Scene& scene)
{
    const std::string motion = top.choice("motion", {"free", "fixed"}, "free");
    scene.fixedUntil = top.number("fixedUntil", atLeast(0), scene.fixedUntil);
    scene.maxInitialOverlap = top.number("maxInitialOverlap", atLeast(0), scene.maxInitialOverlap);
    scene.overlapPlace = top.place("maxInitialOverlap");

    const Dictionary& grains = top.sub("grains");
    const CheckedEntries named(grains);
    if (grains.find("type") && !named.isDictionary("type"))
    {
        addSource(grains, "grains", around, motion, scene);
        return;
    }
    for (const Entry& entry : grains.entries)
    {
        if (!entry.dict)
        {
            named.foundAsSpelt("type");
            const std::string allowed = "grains { type lattice; ... }, or one dictionary for each source";
            throw InputError({named.place(entry.keyword), "stands in grains without a type", "", allowed});
        }
        addSource(*entry.dict, entry.keyword, around, motion, scene);
    }
}

} // namespace input
