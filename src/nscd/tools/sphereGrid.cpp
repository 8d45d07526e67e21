// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Cells of spheres, as lists.
#include "nscd/tools/sphereGrid.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

SphereGrid::SphereGrid(const Eigen::AlignedBox3d& bounds, const PeriodicBox& box, double largestRadius, std::size_t number)
:
    extent_(bounds),
    box_(box),
    largest_(largestRadius),
    number_(number)
{
    for (int k = 0; k < 3; ++k)
    {
        extent_.min()[k] = box.isPeriodic(k) ? box.lower[k] : bounds.min()[k] - 2.0*largestRadius;
        extent_.max()[k] = box.isPeriodic(k) ? box.lower[k] + box.length[k] : bounds.max()[k] + 2.0*largestRadius;
    }
}

SphereGrid::Level& SphereGrid::levelOf(double radius)
{
    const std::size_t octave = static_cast<std::size_t>(std::max(0.0, std::floor(std::log2(largest_/radius))));
    if (levels_.size() <= octave) levels_.resize(octave + 1);
    Level& level = levels_[octave];
    if (level.largest > 0.0) return level;
    level.largest = std::ldexp(largest_, -static_cast<int>(octave))*(1.0 + 1e-9);
    const Vec3 sizes = extent_.sizes();
    const double most = 2.0*number_ + 1000.0;
    const double width = std::max(2.0*level.largest, std::cbrt(sizes.prod()/most));
    for (int k = 0; k < 3; ++k)
    {
        level.count[k] = std::max(1, static_cast<int>(std::min(sizes[k]/width, most)));
        level.inverseSize[k] = level.count[k]/sizes[k];
    }
    level.first.assign(static_cast<std::size_t>(level.count[0])*level.count[1]*level.count[2], -1);
    return level;
}

void SphereGrid::add(const Vec3& center, double radius)
{
    const Vec3 x = box_.wrap(center);
    if (!extent_.contains(x) && extent_.exteriorDistance(x) > radius) return;
    Level& level = levelOf(radius);
    std::array<int, 3> cell;
    for (int k = 0; k < 3; ++k)
    {
        cell[k] = std::clamp(static_cast<int>(std::floor((x[k] - extent_.min()[k])*level.inverseSize[k])), 0, level.count[k] - 1);
    }
    int& first = level.first[(static_cast<std::size_t>(cell[2])*level.count[1] + cell[1])*level.count[0] + cell[0]];
    level.spheres.push_back({x, radius, first});
    first = static_cast<int>(level.spheres.size()) - 1;
}

bool SphereGrid::isFree(const Vec3& center, double radius) const
{
    return std::all_of(levels_.begin(), levels_.end(), [&](const Level& level) { return level.spheres.empty() || isFreeOf(level, center, radius); });
}

/// First and last cell along each axis; those of a periodic one may lie beyond the ends, by one period at most.
SphereGrid::Cells SphereGrid::cellsAround(const Level& level, const Vec3& x, double reach) const
{
    Cells cells;
    for (int k = 0; k < 3; ++k)
    {
        const int last = level.count[k] - 1;
        const double from = std::floor((x[k] - reach - extent_.min()[k])*level.inverseSize[k]);
        const double to = std::floor((x[k] + reach - extent_.min()[k])*level.inverseSize[k]);
        if (!box_.isPeriodic(k)) cells[k] = {static_cast<int>(std::clamp<double>(from, 0, last)), static_cast<int>(std::clamp<double>(to, 0, last))};
        else if (to - from >= last) cells[k] = {0, last};
        else cells[k] = {static_cast<int>(from), static_cast<int>(to)};
    }
    return cells;
}

bool SphereGrid::isFreeOf(const Level& level, const Vec3& center, double radius) const
{
    const Vec3 x = box_.wrap(center);
    const Cells cells = cellsAround(level, x, radius + level.largest);
    for (int k = cells[2][0]; k <= cells[2][1]; ++k)
    {
        for (int j = cells[1][0]; j <= cells[1][1]; ++j)
        {
            const int row = (wrapped(k, 2, level)*level.count[1] + wrapped(j, 1, level))*level.count[0];
            for (int i = cells[0][0]; i <= cells[0][1]; ++i)
            {
                if (!isFreeOfCell(level, row + wrapped(i, 0, level), x, radius)) return false;
            }
        }
    }
    return true;
}

bool SphereGrid::isFreeOfCell(const Level& level, int cell, const Vec3& x, double radius) const
{
    for (int at = level.first[cell]; at >= 0; at = level.spheres[at].next)
    {
        const Sphere& other = level.spheres[at];
        const double reach = radius + other.radius;
        if (box_.nearestImage(x - other.center).squaredNorm() < reach*reach) return false;
    }
    return true;
}

} // namespace nscd
