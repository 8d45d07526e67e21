// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A uniform grid over the outlined wall regions.
#include "wallSearch.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

/// Up to this many outlined regions a plain loop is faster than a grid.
constexpr std::size_t fewRegions = 16;

} // namespace

WallSearch::WallSearch(const Walls& walls, double cellSize)
:
    walls_(walls)
{
    for (std::size_t k = 0; k < walls.regions.size(); ++k)
    {
        (walls.regions[k].edges.empty() ? direct_ : gridded_).push_back(static_cast<int>(k));
    }
    if (gridded_.size() <= fewRegions)
    {
        direct_.insert(direct_.end(), gridded_.begin(), gridded_.end());
        std::sort(direct_.begin(), direct_.end());
        gridded_.clear();
        return;
    }
    fillGrid(cellSize);
}

int WallSearch::clampedIndex(double x, int axis) const
{
    const double index = std::floor((x - extent_.min()[axis])/width_);
    return static_cast<int>(std::min<double>(count_[axis] - 1, std::max(0.0, index)));
}

void WallSearch::fillGrid(double cellSize)
{
    for (int region : gridded_) extent_.extend(bounds(walls_.regions[region]));
    // Memory bound: about a million cells however large the walls are.
    width_ = std::max(cellSize, std::cbrt((extent_.sizes().array() + cellSize).prod()/1e6));
    for (int k = 0; k < 3; ++k) count_[k] = static_cast<int>(extent_.sizes()[k]/width_) + 1;
    cells_.resize(static_cast<std::size_t>(count_[0])*count_[1]*count_[2]);

    for (int region : gridded_)
    {
        const Eigen::AlignedBox3d box = bounds(walls_.regions[region]);
        int low[3], high[3];
        for (int k = 0; k < 3; ++k)
        {
            low[k] = clampedIndex(box.min()[k], k);
            high[k] = clampedIndex(box.max()[k], k);
        }
        const WallRegion& wall = walls_.regions[region];
        for (int z = low[2]; z <= high[2]; ++z)
        for (int y = low[1]; y <= high[1]; ++y)
        for (int x = low[0]; x <= high[0]; ++x)
        {
            const Vec3 middle = extent_.min() + width_*Vec3(x + 0.5, y + 0.5, z + 0.5);
            if (std::abs(wall.normal.dot(middle - wall.point)) > 0.87*width_) continue;
            cells_[(static_cast<std::size_t>(z)*count_[1] + y)*count_[0] + x].push_back(region);
        }
    }
}

bool WallSearch::isNear(int region, const Vec3& center, double distance) const
{
    const WallRegion& wall = walls_.regions[region];
    if (std::abs(wall.normal.dot(center - wall.point)) > distance) return false;
    return wall.edges.empty() || std::abs(nearestPoint(wall, center).distance) < distance;
}

void WallSearch::find(const Vec3& center, double distance, std::vector<int>& regions) const
{
    for (int region : direct_)
    {
        if (isNear(region, center, distance)) regions.push_back(region);
    }
    if (gridded_.empty()) return;

    const Vec3 reach = Vec3::Constant(distance);
    if (!extent_.intersects(Eigen::AlignedBox3d(Vec3(center - reach), Vec3(center + reach)))) return;
    const std::size_t before = regions.size();
    for (int z = clampedIndex(center[2] - distance, 2); z <= clampedIndex(center[2] + distance, 2); ++z)
    for (int y = clampedIndex(center[1] - distance, 1); y <= clampedIndex(center[1] + distance, 1); ++y)
    for (int x = clampedIndex(center[0] - distance, 0); x <= clampedIndex(center[0] + distance, 0); ++x)
    {
        for (int region : cells_[(static_cast<std::size_t>(z)*count_[1] + y)*count_[0] + x])
        {
            if (isNear(region, center, distance)) regions.push_back(region);
        }
    }
    std::sort(regions.begin() + before, regions.end());
    regions.erase(std::unique(regions.begin() + before, regions.end()), regions.end());
}

} // namespace nscd
