// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Checking scenes and settings.
#include "nscd/scene/sceneCheck.hpp"

#include "nscd/base/invalidValue.hpp"

#include <cmath>

namespace nscd
{

namespace
{

bool isPositive(double value) { return value > 0.0 && std::isfinite(value); }

void checkPositive(const char* name, double value)
{
    if (!isPositive(value)) throw invalidValue(name, value, "a finite value > 0");
}

void checkNotNegative(const char* name, double value)
{
    if (!(value >= 0.0) || !std::isfinite(value)) throw invalidValue(name, value, "a finite value >= 0");
}

void checkShape(const GrainShape& shape)
{
    if (shape.dimensions != 2 && shape.dimensions != 3) throw invalidValue("dimensions of grains", shape.dimensions, "2 or 3");
    if (shape.dimensions == 2) checkPositive("thickness of discs [m]", shape.thickness);
    if (shape.emptyAxis < -1 || shape.emptyAxis > 2) throw invalidValue("empty axis", shape.emptyAxis, "-1 (none), 0, 1, 2");
}

void checkGrain(const Grains& grains, std::size_t i, int nMaterials)
{
    const auto refuse = [&](const char* name, const auto& value, const char* allowed)
    {
        throw invalidValue(std::string(name) + " of grain " + std::to_string(grains.id[i]), value, allowed);
    };
    if (!grains.position[i].allFinite()) refuse("position", grains.position[i].transpose(), "finite coordinates [m]");
    if (!grains.velocity[i].allFinite()) refuse("velocity", grains.velocity[i].transpose(), "finite components [m/s]");
    if (!grains.omega[i].allFinite()) refuse("omega", grains.omega[i].transpose(), "finite components [rad/s]");
    if (!(grains.orientation[i].norm() > 0.0)) refuse("orientation", grains.orientation[i].coeffs().transpose(), "a quaternion that is not zero");
    if (!isPositive(grains.radius[i])) refuse("radius", grains.radius[i], "a finite value > 0 m");
    if (!isPositive(grains.mass[i])) refuse("mass", grains.mass[i], "a finite value > 0 kg");
    const int material = grains.material[i];
    if (material < 0 || material >= nMaterials) refuse("material", material, "the index of a material added before");
}

void checkPair(const Materials& materials, int a, int b)
{
    if (materials.isPairSet(a, b)) return;
    throw invalidValue("pair of materials " + materials.names()[a] + "-" + materials.names()[b], "not set", "setPair() for all that can meet");
}

/// Those of walls that have a shape; walls without may lack a material, and so may all where there are no grains.
std::vector<int> wallMaterials(const Walls& walls, const Materials& materials)
{
    std::vector<char> hasShape(walls.patches.size(), 0);
    for (const WallRegion& region : walls.regions) hasShape[region.patch] = 1;
    std::vector<int> used;
    for (std::size_t k = 0; k < walls.patches.size(); ++k)
    {
        const WallPatch& patch = walls.patches[k];
        if (!hasShape[k]) continue;
        if (patch.material >= 0 && patch.material < materials.size()) used.push_back(patch.material);
        else throw invalidValue("material of wall " + patch.name, patch.material, "the index of a material added before");
    }
    return used;
}

/// Pairs of the materials of grains among themselves and with walls.
void checkPairs(const Grains& grains, const Materials& materials, const Walls& walls)
{
    if (grains.size() == 0) return;
    const std::vector<int> onWalls = wallMaterials(walls, materials);
    std::vector<char> isUsed(materials.size(), 0);
    for (const int material : grains.material) isUsed[material] = 1;
    for (int a = 0; a < materials.size(); ++a)
    {
        if (!isUsed[a]) continue;
        for (int b = 0; b < materials.size(); ++b)
        {
            if (isUsed[b]) checkPair(materials, a, b);
        }
        for (const int b : onWalls) checkPair(materials, a, b);
    }
}

} // namespace

void checkGrains(const Grains& grains, const Materials& materials, const Walls& walls)
{
    checkShape(grains.shape);
    const std::size_t lengths[] =
    {
        grains.velocity.size(), grains.omega.size(), grains.orientation.size(), grains.radius.size(), grains.mass.size(),
        grains.material.size(), grains.id.size(), grains.isFixed.size()
    };
    for (const std::size_t length : lengths)
    {
        if (length != grains.size()) throw invalidValue("length of an array of grains", length, "that of all, " + std::to_string(grains.size()));
    }
    for (std::size_t i = 0; i < grains.size(); ++i) checkGrain(grains, i, materials.size());
    checkPairs(grains, materials, walls);
}

void checkWalls(const Walls& walls)
{
    const int nPatches = static_cast<int>(walls.patches.size());
    for (const WallRegion& region : walls.regions)
    {
        if (region.patch < 0 || region.patch >= nPatches) throw invalidValue("patch of a wall region", region.patch, "an index of addPatch()");
        const std::string& name = walls.patches[region.patch].name;
        if (!region.point.allFinite()) throw invalidValue("point of wall " + name, region.point.transpose(), "finite coordinates [m]");
        if (!(std::abs(region.normal.norm() - 1.0) < 1e-6)) throw invalidValue("normal of wall " + name, region.normal.transpose(), "a unit vector");
        for (const WallEdge& edge : region.edges)
        {
            if (edge.start.allFinite() && edge.end.allFinite()) continue;
            throw invalidValue("vertex of wall " + name, "not finite", "finite coordinates [m]");
        }
    }
}

void checkBox(const PeriodicBox& box)
{
    if (!box.lower.allFinite()) throw invalidValue("lower end of a period", box.lower.transpose(), "finite coordinates [m]");
    for (int k = 0; k < 3; ++k) checkNotNegative("period [m]", box.length[k]);
}

void checkSettings(const ContactSettings& settings)
{
    checkPositive("tolerance", settings.tolerance);
    checkPositive("displacementTolerance", settings.displacementTolerance);
    checkPositive("forceTolerance", settings.forceTolerance);
    checkPositive("overlapTolerance", settings.overlapTolerance);
    checkNotNegative("deadBand", settings.deadBand);
    checkNotNegative("skin", settings.skin);
    if (settings.maxSweeps < 1) throw invalidValue("maxSweeps", settings.maxSweeps, ">= 1");
    if (settings.polishSweeps < 0) throw invalidValue("polishSweeps", settings.polishSweeps, ">= 0");
}

} // namespace nscd
