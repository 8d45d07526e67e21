// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A uniform grid over bodies, filled by counting sort.
#pragma once

#include "nscd/base/periodicBox.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace nscd
{

/// Bodies of about one size, cell by cell; cells that follow one another along x lie one behind the other. Keeps its memory when
/// it is filled anew.
struct CellGrid
{
    /// Members behind the last one that may be read.
    static constexpr int padding = 8;
    using Cell = std::array<int, 3>;

    Vec3 lower;
    Vec3 cellSize;
    Vec3 inverseSize;
    Cell count;
    double maxSize = 0.0;
    std::vector<int> bodies;       ///< in the order given
    std::vector<int> placeOf;      ///< member of each of them
    std::vector<int> cellStart;
    std::vector<int> body;         ///< of each member
    std::vector<double> x[3];      ///< of each member [m]
    std::vector<double> size;      ///< likewise [m]

    /// Sorts `bodies` into cells at least twice as wide as the largest size, and not many more cells than bodies.
    void fill(const std::vector<Vec3>& position, const std::vector<double>& sizes, const PeriodicBox& box);

    /// Cell of a point of the grid; what rounding puts beyond belongs to the last cell.
    Cell cellOf(double px, double py, double pz) const
    {
        const auto index = [this](double p, int k) { return static_cast<int>(std::min<double>(count[k] - 1, std::max(0.0, (p - lower[k])*inverseSize[k]))); };
        return {index(px, 0), index(py, 1), index(pz, 2)};
    }

    /// First cell of the row (y, z).
    int row(int y, int z) const { return (z*count[1] + y)*count[0]; }

private:
    void setCells(const Eigen::AlignedBox3d& extent, const PeriodicBox& box);
};

} // namespace nscd
