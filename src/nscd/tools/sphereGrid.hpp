// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Spheres of any sizes that are added one after the other, and whether another one touches any of them.
// Tested by tests/unit/nscd/tools/fillingTest.cpp
#pragma once

#include "nscd/base/periodicBox.hpp"

#include <array>
#include <vector>

namespace nscd
{

/// A grid of cells for each octave of sizes; along a periodic axis it takes the whole period.
class SphereGrid
{
public:
    /// Around a region's bounds, for spheres up to a radius [m], about so many of them.
    SphereGrid(const Eigen::AlignedBox3d& bounds, const PeriodicBox& box, double largestRadius, std::size_t number);

    /// Those that no sphere with its center in the bounds may touch are left out.
    void add(const Vec3& center, double radius);

    bool isFree(const Vec3& center, double radius) const;

private:
    struct Sphere
    {
        Vec3 center;
        double radius;
        int next;          ///< in its cell; -1: the last one
    };

    /// Of the spheres with radii up to `largest`, and more than half of it.
    struct Level
    {
        double largest = 0.0;
        std::array<int, 3> count;
        Vec3 inverseSize;
        std::vector<int> first;
        std::vector<Sphere> spheres;
    };

    using Cells = std::array<std::array<int, 2>, 3>;

    Level& levelOf(double radius);
    Cells cellsAround(const Level& level, const Vec3& x, double reach) const;
    bool isFreeOf(const Level& level, const Vec3& center, double radius) const;
    bool isFreeOfCell(const Level& level, int cell, const Vec3& center, double radius) const;
    int wrapped(int cell, int axis, const Level& level) const { return box_.isPeriodic(axis) ? (cell + level.count[axis]) % level.count[axis] : cell; }

    Eigen::AlignedBox3d extent_;
    PeriodicBox box_;
    double largest_;
    std::size_t number_;
    std::vector<Level> levels_;
};

} // namespace nscd
