// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Counting sort of bodies into cells.
#include "nscd/search/cellGrid.hpp"

#include <cmath>
#include <limits>
#include <numeric>

namespace nscd
{

namespace
{

/// A scene of few bodies far apart has wider cells instead of many empty ones.
constexpr double cellsPerBody = 4.0;

} // namespace

void CellGrid::setCells(const Eigen::AlignedBox3d& extent, const PeriodicBox& box)
{
    double width = 2.0*maxSize;
    for (;;)
    {
        double cells = 1.0;
        for (int k = 0; k < 3; ++k)
        {
            const double length = box.isPeriodic(k) ? box.length[k] : extent.sizes()[k];
            lower[k] = box.isPeriodic(k) ? box.lower[k] : extent.min()[k];
            const double along = std::max(1.0, std::floor(length/width));
            cells *= along;
            count[k] = static_cast<int>(std::min(along, 2e6));
            cellSize[k] = std::max(length/along, std::numeric_limits<double>::min());
            if (!box.isPeriodic(k)) cellSize[k] = std::max(cellSize[k], width);
            inverseSize[k] = 1.0/cellSize[k];
        }
        if (cells <= cellsPerBody*bodies.size() + 64.0) return;
        width *= 1.26;
    }
}

void CellGrid::fill(const std::vector<Vec3>& position, const std::vector<double>& sizes, const PeriodicBox& box)
{
    Eigen::AlignedBox3d extent;
    maxSize = 0.0;
    for (int i : bodies)
    {
        extent.extend(position[i]);
        maxSize = std::max(maxSize, sizes[i]);
    }
    setCells(extent, box);

    placeOf.resize(bodies.size());
    cellStart.assign(static_cast<std::size_t>(count[0])*count[1]*count[2] + 2, 0);
    for (std::size_t m = 0; m < bodies.size(); ++m)
    {
        const Vec3& p = position[bodies[m]];
        const Cell cell = cellOf(p[0], p[1], p[2]);
        placeOf[m] = row(cell[1], cell[2]) + cell[0];
        ++cellStart[placeOf[m] + 2];
    }
    // Shifted by one: filling moves each start on to where its cell ends, which is where the next one starts.
    std::partial_sum(cellStart.begin(), cellStart.end(), cellStart.begin());
    body.resize(bodies.size());
    size.resize(bodies.size() + padding);
    for (std::vector<double>& along : x) along.resize(bodies.size() + padding);
    for (std::size_t m = 0; m < bodies.size(); ++m)
    {
        const int i = bodies[m], place = cellStart[placeOf[m] + 1]++;
        placeOf[m] = place;
        body[place] = i;
        size[place] = sizes[i];
        for (int k = 0; k < 3; ++k) x[k][place] = position[i][k];
    }
}

} // namespace nscd
