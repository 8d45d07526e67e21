// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Placing grains, and checking them before the first step.
#include "clumpReader.hpp"
#include "grainFiles.hpp"
#include "grainSources.hpp"
#include "materialReader.hpp"

#include "nscd/search/overlaps.hpp"

#include <algorithm>
#include <set>

namespace nscdGrains
{

namespace
{

/// Grains of one source, behind those of the others.
class Placement
{
public:
    Placement(const SceneSettings& scene, const GrainSource& source, nscd::Grains& grains)
    :
        scene_(scene),
        source_(source),
        grains_(grains)
    {}

    void addLattice() { nscd::addLattice(grains_, source_.lattice, scene_.materials.density[source_.material], source_.material); }

    void addPositions()
    {
        const std::vector<Vec3> positions = readPositionsFile(scene_.pathOf(source_.file), source_.filePlace);
        grains_.reserve(grains_.size() + positions.size());
        for (const Vec3& position : positions) add(position, source_.diameter, source_.material);
    }

    void addTable()
    {
        const std::string path = scene_.pathOf(source_.file);
        const std::vector<TableRow> rows = readGrainTable(path, source_.filePlace);
        grains_.reserve(grains_.size() + rows.size());
        for (const TableRow& row : rows)
        {
            add(row.position, row.diameter, row.material.empty() ? source_.material : materialOf(row, path));
        }
    }

private:
    void add(const Vec3& position, double diameter, int material)
    {
        grains_.add(position, 0.5*diameter, scene_.materials.density[material], material, static_cast<std::int64_t>(grains_.size()));
    }

    int materialOf(const TableRow& row, const std::string& path) const
    {
        const MaterialTable& materials = scene_.materials;
        const int material = materials.table.find(row.material);
        if (material >= 0 && materials.density[material] > 0) return material;
        const Place place = {path, row.line, source_.file};
        fail({place, "names a material that is unknown or has no density", row.material, "", materials.grainMaterials()});
    }

    const SceneSettings& scene_;
    const GrainSource& source_;
    nscd::Grains& grains_;
};

void placeSource(const SceneSettings& scene, const GrainSource& source, nscd::Grains& grains)
{
    const std::size_t first = grains.size();
    Placement placement(scene, source, grains);
    if (source.type == "lattice") placement.addLattice();
    if (source.type == "positionsFile") placement.addPositions();
    if (source.type == "table") placement.addTable();
    for (std::size_t i = first; i < grains.size(); ++i)
    {
        if (scene.isPlanar()) grains.position[i].z() = 0.0;
        grains.position[i] = scene.box.wrap(grains.position[i]);
        grains.velocity[i] = source.velocity;
        grains.omega[i] = source.omega;
        grains.isFixed[i] = source.isFixed;
    }
    if (!source.clump.members.empty()) replaceByClumps(scene, source, first, grains);
}

/// An overlap in words, as "grains 3 and 7 overlap by 0.2".
std::string describe(const nscd::Overlap& overlap, const nscd::Grains& grains, const nscd::Walls& walls)
{
    const std::string at = textOf(" at (", grains.position[overlap.grain].transpose(), ")");
    const std::int64_t id = grains.id[overlap.grain];
    if (overlap.partner < 0)
    {
        const std::string& wall = walls.patches[walls.regions[-1 - overlap.partner].patch].name;
        return textOf("grain ", id, " and the wall ", wall, " overlap by ", overlap.share, at);
    }
    const std::int64_t other = grains.id[overlap.partner];
    if (overlap.isCoincident) return textOf("grains ", id, " and ", other, " have the same center", at);
    return textOf("grains ", id, " and ", other, " overlap by ", overlap.share, at);
}

} // namespace

void checkPeriods(const SceneSettings& scene, const nscd::Grains& grains)
{
    double diameter = 0.0;
    for (const double radius : grains.radius) diameter = std::max(diameter, 2*radius);
    for (int k = 0; k < 3; ++k)
    {
        if (!scene.box.isPeriodic(k) || scene.box.length[k] > diameter) continue;
        const std::string value = textOf(scene.box.length[k], " along ", "xyz"[k]);
        fail({scene.periodicPlace, "makes a period shorter than a grain", value, textOf("more than the largest diameter, ", diameter), {}});
    }
}

namespace
{

void checkOverlaps(const SceneSettings& scene, const nscd::Grains& grains)
{
    std::vector<nscd::Overlap> overlaps = nscd::grainOverlaps(grains, scene.box, scene.maxInitialOverlap);
    const std::vector<nscd::Overlap> withWalls = nscd::wallOverlaps(grains, scene.walls, scene.maxInitialOverlap);
    overlaps.insert(overlaps.end(), withWalls.begin(), withWalls.end());
    if (overlaps.empty()) return;
    const std::size_t shown = std::min<std::size_t>(5, overlaps.size());
    const auto isWorse = [](const nscd::Overlap& a, const nscd::Overlap& b) { return a.share > b.share; };
    std::partial_sort(overlaps.begin(), overlaps.begin() + static_cast<std::ptrdiff_t>(shown), overlaps.end(), isWorse);
    std::string list;
    for (std::size_t k = 0; k < shown; ++k) list += (k ? "; " : "") + describe(overlaps[k], grains, scene.walls);
    if (overlaps.size() > shown) list += "; ...";
    const std::string allowed = textOf("overlaps up to ", scene.maxInitialOverlap, " of the smaller diameter, distinct centers");
    fail({scene.overlapPlace, textOf("is exceeded by ", overlaps.size(), " pairs"), list, allowed, {}});
}

} // namespace

nscd::Grains placeGrains(const SceneSettings& scene)
{
    nscd::Grains grains;
    grains.shape = scene.shape;
    for (const GrainSource& source : scene.sources) placeSource(scene, source, grains);
    return grains;
}

void checkGrains(const SceneSettings& scene, const nscd::Grains& grains)
{
    const std::set<int> used(grains.material.begin(), grains.material.end());
    checkPairs(scene, std::vector<int>(used.begin(), used.end()));
    checkPeriods(scene, grains);
    checkOverlaps(scene, grains);
}

} // namespace nscdGrains
