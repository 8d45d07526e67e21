// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Looking for room.
#include "nscd/tools/entryRoom.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

/// Stands for no rank where the least rank of all is asked for.
constexpr double noRank = 1e9;

} // namespace

RoomOfWalls::RoomOfWalls(const Walls& walls, double largestDiameter)
:
    walls_(walls),
    search_(walls, largestDiameter)
{
    for (std::size_t region = 0; region < walls.regions.size(); ++region)
    {
        if (walls.regions[region].edges.empty()) planes_.push_back(static_cast<int>(region));
    }
}

/// Nothing enters behind a plane, which the search for walls that are near does not tell; a bounded wall has two sides.
bool RoomOfWalls::isFree(const Vec3& x, double radius)
{
    const auto distance = [&](int region) { return nearestPoint(walls_, region, x).distance; };
    if (std::any_of(planes_.begin(), planes_.end(), [&](int region) { return distance(region) < radius; })) return false;
    near_.clear();
    search_.find(x, radius, near_);
    return std::none_of(near_.begin(), near_.end(), [&](int region) { return std::abs(distance(region)) < radius; });
}

RoomOfGrains::RoomOfGrains(const Grains& own, const EntrySpace& space, const EntryRegion& region, double largestRadius)
:
    space_(space),
    region_(region),
    largestRadius_(largestRadius)
{
    const Eigen::AlignedBox3d& bounds = region.bounds;
    for (std::size_t i = 0; i < own.nOwned; ++i)
    {
        const Vec3 offset = space.box.nearestImage(own.position[i] - bounds.center());
        const double reach = own.radius[i] + largestRadius;
        if (((offset.cwiseAbs() - 0.5*bounds.sizes()).array() > reach).any()) continue;
        position_.push_back(own.position[i]);
        radius_.push_back(own.radius[i]);
    }
    search_.fill(position_, radius_, space.box);
}

double RoomOfGrains::clearance(const Vec3& x)
{
    double least = largestRadius_;
    for (const BodyPair& pair : search_.around(x, largestRadius_, space_.box))
    {
        const double distance = space_.box.nearestImage(x - position_[pair.b]).norm();
        least = std::min(least, distance - radius_[pair.b]);
    }
    return least;
}

std::vector<EntryPlace> RoomOfGrains::look(const std::vector<EntryTry>& tries)
{
    std::vector<EntryPlace> looked;
    std::vector<double> least;   // of all ranks: clearance and rank, negative for the maximum
    for (const EntryTry& at : tries)
    {
        const Vec3 x = space_.box.wrap(at.position);
        const int rank = region_.holds(at) ? space_.rankOf(x) : -1;
        least.push_back(-clearance(x));
        least.push_back(rank < 0 ? -noRank : -rank);
        looked.push_back({x, 0.0, -1});
    }
    space_.exchange->max(least.data(), static_cast<int>(least.size()));
    for (std::size_t k = 0; k < looked.size(); ++k)
    {
        looked[k].clearance = -least[2*k];
        if (least[2*k + 1] > -noRank) looked[k].rank = static_cast<int>(-least[2*k + 1]);
    }
    return looked;
}

} // namespace nscd
