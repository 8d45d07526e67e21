// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Finds the wall regions near each body.
#pragma once

#include "nscd/scene/walls.hpp"

#include <limits>
#include <vector>

namespace nscd
{

/// Regions in uniform grids: one for all patches at rest, one for each that moves, in which points are looked up by where they are
/// to the patch; so nothing is built anew when walls move. Planes, and groups of few regions, are tested directly.
class WallSearch
{
public:
    /// Keeps a reference to `walls`, whose patches' poses may change meanwhile, and nothing else of them.
    WallSearch(const Walls& walls, double cellSize);

    /// Appends the indices of regions nearer to `center` than `distance`, in increasing order. `patchReach` is added to the
    /// distance for regions of each patch that moves [m]; empty: nothing is.
    void find(const Vec3& center, double distance, std::vector<int>& regions, const std::vector<double>& patchReach = {}) const;
    /// The same, but of groups of many regions (below) those nearer than `ofMany`, to which nothing is added.
    void findNear(const Vec3& center, double distance, double ofMany, std::vector<int>& regions, const std::vector<double>& patchReach = {}) const;

    /// Regions move in groups: all patches at rest, and each that moves. The patch that moves; -1: those at rest.
    int groups() const { return static_cast<int>(groups_.size()); }
    int patchOf(int group) const { return groups_[group].patch; }
    /// Whether a group has so many outlined regions that they are in a grid.
    bool hasMany(int group) const { return !groups_[group].start.empty(); }
    /// Of that grid [m]; infinite without.
    double cellWidth(int group) const { return groups_[group].width; }
    /// Around the outlined regions of a group, in its frame; empty where it has none.
    const Eigen::AlignedBox3d& outlined(int group) const { return groups_[group].outlined; }
    /// Appends the outlined regions of a group whose bounds touch a box, both in the group's frame, some more than once.
    void findInBox(int group, const Eigen::AlignedBox3d& box, std::vector<int>& regions) const;

    double cellSize() const { return cellSize_; }

    /// Bounds of a patch's finite regions at its reference pose, and whether it has planes.
    const Eigen::AlignedBox3d& extent(int patch) const { return extents_[patch]; }
    bool hasPlane(int patch) const { return hasPlane_[patch]; }

private:
    /// Regions that move together. Cell c holds members[start[c]] .. members[start[c + 1] - 1].
    struct Group
    {
        int patch = -1;             ///< that moves; -1: all at rest
        std::vector<int> direct;
        Eigen::AlignedBox3d outlined, extent;
        double width = std::numeric_limits<double>::infinity();
        int count[3] = {0, 0, 0};
        std::vector<std::size_t> start;
        std::vector<int> members;

        int clampedIndex(double x, int axis) const;
        template<class Visit> void forEachCell(const Eigen::AlignedBox3d& box, const Visit& visit) const;
    };

    void addGroup(int patch, const std::vector<int>& regions);
    void fillGrid(Group& group, const std::vector<int>& regions) const;
    template<class Visit> void forEachGroup(const Vec3& center, const std::vector<double>& patchReach, const Visit& visit) const;
    void addDirect(const Group& group, const Vec3& center, double distance, std::vector<int>& regions) const;
    void addOfMany(const Group& group, const Vec3& center, double distance, std::vector<int>& regions) const;

    const Walls& walls_;
    double cellSize_;
    std::vector<Group> groups_;
    std::vector<Eigen::AlignedBox3d> extents_;
    std::vector<Eigen::AlignedBox3d> bounds_;   ///< of each region
    std::vector<char> hasPlane_;
};

} // namespace nscd
