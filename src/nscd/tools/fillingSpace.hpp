// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The room that a region leaves to grains: within its sides, off the walls, in a box that may be periodic.
// Tested by tests/unit/nscd/tools/fillingTest.cpp
#pragma once

#include "nscd/search/wallSearch.hpp"
#include "nscd/tools/regions.hpp"

namespace nscd
{

/// Where a scene is.
struct FillingPlace
{
    const Walls& walls;        ///< where they are
    PeriodicBox box;
    GrainShape shape;
    double midPlane = 0.0;     ///< coordinate of discs along the empty axis [m]
    std::size_t number = 0;    ///< of the source among those that fill: its random numbers are its own
};

/// Obstacles are the region's sides, then the walls' regions, then the triangles of the region's surface. The box is shifted along its periodic
/// axes so that the region's bounds lie in its middle; sides across an axis along which the region takes the whole period are none.
class FillingSpace
{
public:
    /// `largestDiameter` [m] tunes the search for walls.
    FillingSpace(const Region& region, const FillingPlace& place, double largestDiameter);

    FillingSpace(const FillingSpace&) = delete;
    FillingSpace& operator=(const FillingSpace&) = delete;

    const PeriodicBox& box() const { return box_; }
    const Region& region() const { return region_; }
    int emptyAxis() const { return emptyAxis_; }

    /// Appends the obstacles nearer to a point than a distance [m], and those that it lies behind.
    void findNear(const Vec3& x, double distance, std::vector<int>& obstacles) const;
    SideProximity to(int obstacle, const Vec3& x) const;
    /// Whether no obstacle is nearer than a distance [m].
    bool isClear(const Vec3& x, double distance) const;

private:
    Vec3 inScene(const Vec3& x) const;
    bool isAcross(const Vec3& normal, int axis) const { return axis >= 0 && std::abs(normal[axis]) > 1.0 - 1e-9; }

    Region region_;
    Walls walls_;
    PeriodicBox sceneBox_, box_;
    int emptyAxis_;
    double midPlane_;
    std::vector<int> planes_;
    WallSearch search_;
    mutable std::vector<int> near_;
};

} // namespace nscd
