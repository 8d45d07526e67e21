// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Uniform grids over the outlined wall regions.
#include "nscd/search/wallSearch.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nscd
{

namespace
{

/// Up to this many outlined regions a plain loop is faster than a grid.
constexpr std::size_t fewRegions = 16;

double height(const WallRegion& region, const Vec3& x) { return region.normal.dot(x - region.point); }

} // namespace

WallSearch::WallSearch(const Walls& walls, double cellSize)
:
    walls_(walls),
    cellSize_(cellSize),
    extents_(walls.patches.size()),
    hasPlane_(walls.patches.size(), 0)
{
    std::vector<int> atRest;
    std::vector<std::vector<int>> moving(walls.patches.size());
    for (std::size_t k = 0; k < walls.regions.size(); ++k)
    {
        const WallRegion& region = walls.regions[k];
        bounds_.push_back(region.edges.empty() ? Eigen::AlignedBox3d() : bounds(region));
        (walls.patches[region.patch].motion ? moving[region.patch] : atRest).push_back(static_cast<int>(k));
        if (region.edges.empty()) hasPlane_[region.patch] = 1;
        else extents_[region.patch].extend(bounds_.back());
    }
    addGroup(-1, atRest);
    for (std::size_t patch = 0; patch < moving.size(); ++patch) addGroup(static_cast<int>(patch), moving[patch]);
}

void WallSearch::addGroup(int patch, const std::vector<int>& regions)
{
    if (regions.empty()) return;
    groups_.emplace_back();
    Group& group = groups_.back();
    group.patch = patch;
    std::vector<int> gridded;
    for (int region : regions)
    {
        group.outlined.extend(bounds_[region]);
        (walls_.regions[region].edges.empty() ? group.direct : gridded).push_back(region);
    }
    if (gridded.size() > fewRegions) fillGrid(group, gridded);
    else group.direct.insert(group.direct.end(), gridded.begin(), gridded.end());
}

int WallSearch::Group::clampedIndex(double x, int axis) const
{
    const double index = std::floor((x - extent.min()[axis])/width);
    return static_cast<int>(std::min<double>(count[axis] - 1, std::max(0.0, index)));
}

/// Calls visit(cell, its middle) for the cells that a box touches.
template<class Visit>
void WallSearch::Group::forEachCell(const Eigen::AlignedBox3d& box, const Visit& visit) const
{
    int low[3], high[3];
    for (int k = 0; k < 3; ++k)
    {
        low[k] = clampedIndex(box.min()[k], k);
        high[k] = clampedIndex(box.max()[k], k);
    }
    for (int z = low[2]; z <= high[2]; ++z)
    for (int y = low[1]; y <= high[1]; ++y)
    for (int x = low[0]; x <= high[0]; ++x)
    {
        visit((static_cast<std::size_t>(z)*count[1] + y)*count[0] + x, extent.min() + width*Vec3(x + 0.5, y + 0.5, z + 0.5));
    }
}

void WallSearch::fillGrid(Group& group, const std::vector<int>& regions) const
{
    for (int region : regions) group.extent.extend(bounds_[region]);
    // Memory bound: about a million cells however large the walls are.
    group.width = std::max(cellSize_, std::cbrt((group.extent.sizes().array() + cellSize_).prod()/1e6));
    for (int k = 0; k < 3; ++k) group.count[k] = static_cast<int>(group.extent.sizes()[k]/group.width) + 1;

    const auto forEachEntry = [&](const auto& visit)
    {
        for (int region : regions)
        {
            const WallRegion& wall = walls_.regions[region];
            group.forEachCell(bounds_[region], [&](std::size_t cell, const Vec3& middle)
            {
                if (std::abs(height(wall, middle)) <= 0.87*group.width) visit(cell, region);
            });
        }
    };
    group.start.assign(static_cast<std::size_t>(group.count[0])*group.count[1]*group.count[2] + 1, 0);
    forEachEntry([&](std::size_t cell, int) { ++group.start[cell + 1]; });
    std::partial_sum(group.start.begin(), group.start.end(), group.start.begin());
    group.members.resize(group.start.back());
    std::vector<std::size_t> next(group.start.begin(), group.start.end() - 1);
    forEachEntry([&](std::size_t cell, int region) { group.members[next[cell]++] = region; });
}

namespace
{

/// Takes out those from `first` on that are not nearer than `distance`.
void removeFar(const Walls& walls, const Vec3& center, double distance, std::vector<int>& regions, std::size_t first)
{
    const auto isFar = [&](int region)
    {
        const WallRegion& wall = walls.regions[region];
        return !wall.edges.empty() && std::abs(nearestPoint(wall, center).distance) >= distance;
    };
    regions.erase(std::remove_if(regions.begin() + static_cast<std::ptrdiff_t>(first), regions.end(), isFar), regions.end());
}

} // namespace

void WallSearch::addDirect(const Group& group, const Vec3& center, double distance, std::vector<int>& regions) const
{
    const std::size_t before = regions.size();
    for (int region : group.direct)
    {
        if (std::abs(height(walls_.regions[region], center)) <= distance) regions.push_back(region);
    }
    removeFar(walls_, center, distance, regions, before);
}

void WallSearch::addOfMany(const Group& group, const Vec3& center, double distance, std::vector<int>& regions) const
{
    const Vec3 reach = Vec3::Constant(distance);
    const Eigen::AlignedBox3d around(Vec3(center - reach), Vec3(center + reach));
    if (group.start.empty() || !group.extent.intersects(around)) return;
    const std::size_t before = regions.size();
    group.forEachCell(around, [&](std::size_t cell, const Vec3&)
    {
        for (std::size_t m = group.start[cell]; m < group.start[cell + 1]; ++m)
        {
            if (std::abs(height(walls_.regions[group.members[m]], center)) <= distance) regions.push_back(group.members[m]);
        }
    });
    const auto first = regions.begin() + static_cast<std::ptrdiff_t>(before);
    std::sort(first, regions.end());
    regions.erase(std::unique(first, regions.end()), regions.end());
    removeFar(walls_, center, distance, regions, before);
}

/// Calls visit(group, the center in its frame, what is added to its distance).
template<class Visit>
void WallSearch::forEachGroup(const Vec3& center, const std::vector<double>& patchReach, const Visit& visit) const
{
    for (const Group& group : groups_)
    {
        if (group.patch < 0)
        {
            visit(group, center, 0.0);
            continue;
        }
        const WallPose& pose = walls_.patches[group.patch].pose;
        visit(group, Vec3(pose.linear().transpose()*(center - pose.translation())), patchReach.empty() ? 0.0 : patchReach[group.patch]);
    }
}

void WallSearch::find(const Vec3& center, double distance, std::vector<int>& regions, const std::vector<double>& patchReach) const
{
    const auto before = static_cast<std::ptrdiff_t>(regions.size());
    forEachGroup(center, patchReach, [&](const Group& group, const Vec3& x, double added)
    {
        addDirect(group, x, distance + added, regions);
        addOfMany(group, x, distance + added, regions);
    });
    std::sort(regions.begin() + before, regions.end());
}

void WallSearch::findNear
(
    const Vec3& center, double distance, double ofMany, std::vector<int>& regions, const std::vector<double>& patchReach
) const
{
    const auto before = static_cast<std::ptrdiff_t>(regions.size());
    forEachGroup(center, patchReach, [&](const Group& group, const Vec3& x, double added)
    {
        addDirect(group, x, distance + added, regions);
        addOfMany(group, x, ofMany, regions);
    });
    std::sort(regions.begin() + before, regions.end());
}

void WallSearch::findInBox(int number, const Eigen::AlignedBox3d& box, std::vector<int>& regions) const
{
    const Group& group = groups_[number];
    if (!group.outlined.intersects(box)) return;
    const auto addIfNear = [&](int region)
    {
        if (bounds_[region].intersects(box)) regions.push_back(region);
    };
    for (int region : group.direct) addIfNear(region);
    if (group.start.empty()) return;
    group.forEachCell(box, [&](std::size_t cell, const Vec3&)
    {
        for (std::size_t m = group.start[cell]; m < group.start[cell + 1]; ++m) addIfNear(group.members[m]);
    });
}

} // namespace nscd
