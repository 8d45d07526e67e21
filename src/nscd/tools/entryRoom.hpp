// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// How much room grains and walls leave at a place, as all ranks together know it.
// Tested by tests/unit/nscd/tools/grainEntryTest.cpp, tests/parallel/grainEntryTest.cpp
#pragma once

#include "nscd/scene/exchange.hpp"
#include "nscd/search/pairSearch.hpp"
#include "nscd/search/wallSearch.hpp"
#include "nscd/tools/entryRegion.hpp"

#include <functional>
#include <memory>

namespace nscd
{

/// The space that grains enter.
struct EntrySpace
{
    GrainShape shape;
    PeriodicBox box;
    std::shared_ptr<Exchange> exchange = std::make_shared<Exchange>();
    /// The rank that a grain with its center there belongs to, as far as this rank knows; -1: it knows none. A place that no rank knows is
    /// no place for a grain.
    std::function<int(const Vec3&)> rankOf = [](const Vec3&) { return 0; };
};

/// A place for the center of a grain.
struct EntryPlace
{
    Vec3 position;      ///< in the periodic box [m]
    double clearance;   ///< radius of the largest ball there that overlaps no grain [m], or the largest that was asked for
    int rank;           ///< that the grain is to belong to; -1: the place is outside
};

/// Room between walls, which all ranks have alike.
class RoomOfWalls
{
public:
    /// The walls must live as long as this, and may move meanwhile.
    RoomOfWalls(const Walls& walls, double largestDiameter);

    /// Whether a ball overlaps no wall and is behind none.
    bool isFree(const Vec3& x, double radius);

private:
    const Walls& walls_;
    WallSearch search_;
    std::vector<int> planes_, near_;
};

/// Room between the grains of all ranks where they are now.
class RoomOfGrains
{
public:
    /// Looks at grains near the region alone, up to `largestRadius` [m] of those that enter; `space` and `region` must live as long as this.
    RoomOfGrains(const Grains& own, const EntrySpace& space, const EntryRegion& region, double largestRadius);

    /// Places drawn in the region, each moved into the periodic box. The same on all ranks; collective.
    /// Cost: one reduction of two numbers for each place
    std::vector<EntryPlace> look(const std::vector<EntryTry>& tries);

private:
    double clearance(const Vec3& x);

    const EntrySpace& space_;
    const EntryRegion& region_;
    double largestRadius_;
    std::vector<double> radius_;   ///< of the grains near the bounds
    std::vector<Vec3> position_;
    PairSearch search_;
};

} // namespace nscd
