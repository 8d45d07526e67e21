// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Finds the wall regions near each body.
#pragma once

#include "walls.hpp"

#include <vector>

namespace nscd
{

/// Regions in a uniform grid; planes, and scenes of few regions, are tested directly.
class WallSearch
{
public:
    WallSearch(const Walls& walls, double cellSize);

    /// Appends the indices of regions nearer to `center` than `distance`, in increasing order.
    void find(const Vec3& center, double distance, std::vector<int>& regions) const;

private:
    bool isNear(int region, const Vec3& center, double distance) const;
    void fillGrid(double cellSize);
    int clampedIndex(double x, int axis) const;

    const Walls& walls_;
    std::vector<int> direct_;
    std::vector<int> gridded_;
    Eigen::AlignedBox3d extent_;
    double width_ = 1.0;
    int count_[3] = {0, 0, 0};
    std::vector<std::vector<int>> cells_;
};

} // namespace nscd
