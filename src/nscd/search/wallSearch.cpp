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
        (walls.patches[region.patch].motion ? moving[region.patch] : atRest).push_back(static_cast<int>(k));
        if (region.edges.empty()) hasPlane_[region.patch] = 1;
        else extents_[region.patch].extend(bounds(region));
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
    for (int region : regions) (walls_.regions[region].edges.empty() ? group.direct : gridded).push_back(region);
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
    for (int region : regions) group.extent.extend(bounds(walls_.regions[region]));
    // Memory bound: about a million cells however large the walls are.
    group.width = std::max(cellSize_, std::cbrt((group.extent.sizes().array() + cellSize_).prod()/1e6));
    for (int k = 0; k < 3; ++k) group.count[k] = static_cast<int>(group.extent.sizes()[k]/group.width) + 1;

    const auto forEachEntry = [&](const auto& visit)
    {
        for (int region : regions)
        {
            const WallRegion& wall = walls_.regions[region];
            group.forEachCell(bounds(wall), [&](std::size_t cell, const Vec3& middle)
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

void WallSearch::findIn(const Group& group, const Vec3& center, double distance, std::vector<int>& regions) const
{
    const auto addIfPlaneIsNear = [&](int region)
    {
        if (std::abs(height(walls_.regions[region], center)) <= distance) regions.push_back(region);
    };
    const std::size_t before = regions.size();
    for (int region : group.direct) addIfPlaneIsNear(region);
    const Vec3 reach = Vec3::Constant(distance);
    const Eigen::AlignedBox3d around(Vec3(center - reach), Vec3(center + reach));
    if (!group.start.empty() && group.extent.intersects(around))
    {
        group.forEachCell(around, [&](std::size_t cell, const Vec3&)
        {
            for (std::size_t m = group.start[cell]; m < group.start[cell + 1]; ++m) addIfPlaneIsNear(group.members[m]);
        });
        std::sort(regions.begin() + before, regions.end());
        regions.erase(std::unique(regions.begin() + before, regions.end()), regions.end());
    }
    const auto isFar = [&](int region)
    {
        const WallRegion& wall = walls_.regions[region];
        return !wall.edges.empty() && std::abs(nearestPoint(wall, center).distance) >= distance;
    };
    regions.erase(std::remove_if(regions.begin() + before, regions.end(), isFar), regions.end());
}

void WallSearch::find(const Vec3& center, double distance, std::vector<int>& regions, const std::vector<double>& patchReach) const
{
    const std::size_t before = regions.size();
    for (const Group& group : groups_)
    {
        if (group.patch < 0)
        {
            findIn(group, center, distance, regions);
            continue;
        }
        const WallPose& pose = walls_.patches[group.patch].pose;
        const double added = patchReach.empty() ? 0.0 : patchReach[group.patch];
        findIn(group, pose.linear().transpose()*(center - pose.translation()), distance + added, regions);
    }
    std::sort(regions.begin() + before, regions.end());
}

} // namespace nscd
