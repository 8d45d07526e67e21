// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading and placing clumps.
#include "clumpReader.hpp"

#include "grainFiles.hpp"

#include <cmath>
#include <map>
#include <random>

namespace nscdGrains
{

namespace
{

std::vector<nscd::Ball> readMembers(const CheckedEntries& given, const SceneSettings& scene)
{
    const bool isFile = given.found("file");
    if (isFile && given.found("members")) given.reject("members", "stands beside file", "one of the two");
    std::vector<nscd::Ball> members;
    if (isFile)
    {
        const std::string path = scene.pathOf(given.text("file"));
        for (const TableRow& row : readGrainTable(path, given.place("file")))
        {
            if (!row.material.empty()) fail({{path, row.line, ""}, "names a material", row.material, "x y z d: a clump has one, that of its source", {}});
            members.push_back({row.position, 0.5*row.diameter});
        }
    }
    else
    {
        const double diameter = given.number("diameter", above(0));
        for (const Vec3& center : given.vecList("members")) members.push_back({center, 0.5*diameter});
    }
    if (members.empty()) given.reject(isFile ? "file" : "members", "names no member", "at least one");
    return members;
}

/// Uniform over all orientations (Shoemake 1992), or over the turns in the plane; from the bits of the generator, the same on every machine.
nscd::Quaternion randomOrientation(std::mt19937_64& engine, bool isPlanar)
{
    const auto uniform = [&] { return static_cast<double>(engine() >> 11)*0x1p-53; };
    const double turn = 2.0*3.14159265358979323846;
    if (isPlanar) return nscd::Quaternion(Eigen::AngleAxisd(turn*uniform(), Vec3::UnitZ()));
    const double u = uniform(), a = turn*uniform(), b = turn*uniform(), p = std::sqrt(1.0 - u), q = std::sqrt(u);
    return nscd::Quaternion(p*std::sin(a), p*std::cos(a), q*std::sin(b), q*std::cos(b));
}

/// Drops the grains from `first` on.
void cutOff(nscd::Grains& grains, std::size_t first)
{
    grains.forEachArray([first](auto& values) { values.resize(first); });
    grains.nOwned = first;
}

} // namespace

ClumpSource readClump(const CheckedEntries& source, const SceneSettings& scene)
{
    ClumpSource clump;
    if (!source.found("clump")) return clump;
    const CheckedEntries given(source.sub("clump"));
    clump.members = readMembers(given, scene);
    try
    {
        nscd::makeClumpShape(clump.members, 1.0, scene.shape);
    }
    catch (const std::invalid_argument& error)
    {
        given.reject(given.found("file") ? "file" : "members", error.what());
    }
    clump.isRandom = given.choice("orientation", {"random", "asGiven"}, "random") == "random";
    clump.seed = static_cast<std::uint64_t>(given.integer("seed", 0, 1));
    given.finish();
    return clump;
}

void replaceByClumps(const SceneSettings& scene, const GrainSource& source, std::size_t first, nscd::Grains& grains)
{
    const std::vector<Vec3> positions(grains.position.begin() + static_cast<std::ptrdiff_t>(first), grains.position.end());
    const std::vector<int> materials(grains.material.begin() + static_cast<std::ptrdiff_t>(first), grains.material.end());
    cutOff(grains, first);
    std::mt19937_64 engine(source.clump.seed);
    std::map<int, int> shapeOfMaterial;
    for (std::size_t k = 0; k < positions.size(); ++k)
    {
        auto [shape, isNew] = shapeOfMaterial.try_emplace(materials[k], static_cast<int>(grains.clumps.shapes.size()));
        if (isNew)
        {
            const double density = scene.materials.density[materials[k]];
            grains.clumps.shapes.push_back(nscd::makeClumpShape(source.clump.members, density, scene.shape));
        }
        nscd::ClumpPlacement placement;
        placement.shape = shape->second;
        placement.position = positions[k];
        if (source.clump.isRandom) placement.orientation = randomOrientation(engine, scene.isPlanar());
        placement.velocity = source.velocity;
        placement.omega = source.omega;
        placement.material = materials[k];
        placement.firstId = static_cast<std::int64_t>(grains.size());
        nscd::addClump(grains, placement, scene.box);
    }
}

} // namespace nscdGrains
