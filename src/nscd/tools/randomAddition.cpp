// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Random sequential addition.
#include "nscd/tools/randomAddition.hpp"

#include "nscd/tools/sphereGrid.hpp"

#include <algorithm>
#include <numeric>

namespace nscd
{

namespace
{

/// Of a place for one sphere.
constexpr int mostTries = 100000;

std::vector<std::size_t> largestFirst(const std::vector<double>& radius)
{
    std::vector<std::size_t> order(radius.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return radius[a] > radius[b]; });
    return order;
}

double largestOf(const std::vector<double>& radius) { return radius.empty() ? 0.0 : *std::max_element(radius.begin(), radius.end()); }

struct Room
{
    const FillingSpace& space;
    SphereGrid placed;
    SphereGrid others;

    /// Walls are looked up last: that takes longest.
    bool findPlace(const RandomNumbers& random, double radius, double growth, Vec3& center) const
    {
        for (int k = 0; k < mostTries; ++k)
        {
            center = randomPoint(space.region(), random);
            if (placed.isFree(center, radius) && isClear(center, radius, growth)) return true;
        }
        return false;
    }

    /// Beside others, pockets between them and walls are those that a grown sphere fits in.
    bool isClear(const Vec3& center, double radius, double growth) const
    {
        if (!others.isFree(center, growth*radius)) return false;
        return space.isClear(center, others.isFree(center, 3.0*growth*radius) ? radius : growth*radius);
    }
};

} // namespace

std::size_t addAtRandom(const FillingSpace& space, const Spheres& others, const RandomNumbers& random, Spheres& spheres, double growth)
{
    spheres.center.resize(spheres.radius.size());
    const auto gridFor = [&](double largest, std::size_t number) { return SphereGrid(space.region().bounds, space.box(), largest, number); };
    const double largest = largestOf(spheres.radius);
    Room room{space, gridFor(largest, spheres.size()), gridFor(std::max(growth*largest, largestOf(others.radius)), others.size())};
    for (std::size_t i = 0; i < others.size(); ++i) room.others.add(others.center[i], others.radius[i]);
    std::size_t placed = 0;
    for (const std::size_t i : largestFirst(spheres.radius))
    {
        if (!room.findPlace(random, spheres.radius[i], growth, spheres.center[i])) break;
        room.placed.add(spheres.center[i], spheres.radius[i]);
        ++placed;
    }
    return placed;
}

} // namespace nscd
