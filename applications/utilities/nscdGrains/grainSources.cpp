// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading the sources of grains.
#include "clumpReader.hpp"
#include "grainSources.hpp"
#include "materialReader.hpp"

#include <cmath>

namespace nscdGrains
{

namespace
{

/// Grains along each axis from `count (nx ny nz);`, or from `spacing`: as many as fit.
std::array<int, 3> readCount(const CheckedEntries& given, const Vec3& extent, bool isPlanar)
{
    const bool isCounted = given.found("count");
    if (isCounted && given.found("spacing")) given.reject("spacing", "stands beside count", "one of the two");
    if (!isCounted && !given.found("spacing")) fail({given.place("count"), "is missing", "", "count (10 10 20); or spacing 2.5e-3;", {}});
    const Vec3 perAxis = isCounted ? given.vec("count") : Vec3(extent/given.number("spacing", above(0)));
    std::array<int, 3> count;
    double total = 1.0;
    for (int k = 0; k < 3; ++k)
    {
        // A box that is a whole number of spacings long must not lose a layer to round-off.
        const double number = isPlanar && k == 2 ? 1.0 : std::floor(perAxis[k] + (isCounted ? 0.0 : 1e-9));
        const bool isUsed = !(isPlanar && k == 2);
        if (isCounted && isUsed && !(number >= 1 && number == perAxis[k])) given.reject("count", "is not three whole numbers >= 1", "as (10 10 20)");
        total *= std::max(1.0, number);
        if (total > 1e9) given.reject(isCounted ? "count" : "spacing", "makes too many grains", "at most 1e9 grains");
        count[k] = std::max(1, static_cast<int>(number));
    }
    return count;
}

nscd::GrainLattice readLattice(const CheckedEntries& given, bool isPlanar)
{
    nscd::GrainLattice lattice{};
    std::array<Vec3, 2> corners = given.twoVecs("box");
    if (isPlanar) corners[0].z() = corners[1].z() = 0.0;
    lattice.lower = corners[0];
    lattice.upper = corners[1];
    for (int k = 0; k < (isPlanar ? 2 : 3); ++k)
    {
        if (!(corners[1][k] > corners[0][k])) given.reject("box", "is empty", "(lower corner) (upper corner)");
    }
    lattice.diameter = given.number("diameter", above(0));
    lattice.count = readCount(given, corners[1] - corners[0], isPlanar);
    lattice.spread = given.number("spread", Range{0, 1, true, false}, 0.0);
    lattice.jitter = given.number("jitter", between(0, 1), 0.0);
    lattice.seed = static_cast<std::uint64_t>(given.integer("seed", 0, 1));
    return lattice;
}

void checkPlanarMotion(const CheckedEntries& given, const GrainSource& source)
{
    if (source.velocity.z() != 0.0) given.reject("velocity", "moves discs out of their plane", "a vector (x y 0)");
    if (source.omega.x() != 0.0 || source.omega.y() != 0.0) given.reject("omega", "turns discs out of their plane", "a vector (0 0 z)");
}

GrainSource readSource(const Dictionary& dict, const SceneSettings& scene, bool isFixedByDefault)
{
    const CheckedEntries given(dict);
    GrainSource source;
    source.place = dict.place;
    source.type = given.choice("type", {"positionsFile", "table", "lattice"});
    source.material = readGrainMaterial(given, scene.materials);
    source.velocity = given.vec("velocity", Vec3::Zero());
    source.omega = given.vec("omega", Vec3::Zero());
    source.isFixed = given.choice("motion", {"free", "fixed"}, isFixedByDefault ? "fixed" : "free") == "fixed";
    if (scene.isPlanar()) checkPlanarMotion(given, source);
    if (source.type == "lattice") source.lattice = readLattice(given, scene.isPlanar());
    else source.file = given.text("file");
    source.filePlace = given.place("file");
    if (source.type == "positionsFile") source.diameter = given.number("diameter", above(0));
    source.clump = readClump(given, scene);
    if (!source.clump.members.empty())
    {
        if (source.isFixed) given.reject("clump", "cannot be held", "motion free, or single grains that are fixed");
        if (source.lattice.spread > 0.0) given.reject("spread", "stands beside clump", "clumps of one size: several sources for several sizes");
    }
    given.finish();
    return source;
}

} // namespace

void readSources(const CheckedEntries& top, SceneSettings& scene)
{
    const bool isFixed = top.choice("motion", {"free", "fixed"}, "free") == "fixed";
    scene.maxInitialOverlap = top.number("maxInitialOverlap", atLeast(0), scene.maxInitialOverlap);
    scene.overlapPlace = top.place("maxInitialOverlap");

    const Dictionary& grains = top.sub("grains");
    const Entry* type = grains.find("type");
    if (type && !type->dict)
    {
        scene.sources.push_back(readSource(grains, scene, isFixed));
        return;
    }
    const CheckedEntries named(grains);
    for (const Entry& entry : grains.entries)
    {
        if (!entry.dict)
        {
            const std::string allowed = "grains { type lattice; ... }, or one dictionary for each source";
            fail({named.place(entry.keyword), "stands in grains without a type", "", allowed, {}});
        }
        scene.sources.push_back(readSource(*entry.dict, scene, isFixed));
    }
    if (scene.sources.empty()) fail({top.place("grains"), "names no source of grains", "", "grains { type lattice; ... }", {}});
}

} // namespace nscdGrains
