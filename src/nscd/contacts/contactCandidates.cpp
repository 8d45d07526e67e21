// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Pairs, walls, and who solves what lies between two ranks.
#include "nscd/contacts/contactCandidates.hpp"

#include "nscd/contacts/generalCandidates.hpp"
#include "nscd/search/wallSearch.hpp"

#include <algorithm>
#include <cmath>
#include <array>

namespace nscd
{

namespace
{

/// Candidates no further apart than each of these shares of the mean diameter are packed together, those first that will matter most of the
/// time: in a collapse 52 000 are loaded, of which 1 in 100 begins more than 0.01 apart; 70 000 are within the first share, 91 000 within the second.
constexpr std::array<double, 2> nearShares = {0.02, 0.1};

/// A list that grows with the square of the number of grains would take memory and time without end.
std::size_t mostPairs(std::size_t bodies) { return std::max<std::size_t>(1000000, 1000*bodies); }

/// All contacts between two ranks are solved by the same one, so that most bodies are moved by one rank at a time; by the
/// lower one where the sum of the two is even, so that each rank gets about half of its neighbors.
bool isSolvedHere(int here, int other) { return ((here + other) % 2 == 0) == (here < other); }

/// Walls near each body, as candidates that follow the body's pairs.
std::vector<Candidate> findWalls
(
    const ContactList& list, const std::vector<double>& reach, const std::vector<double>& reachToMany, const WallSearch& search, const PeriodicBox& box
)
{
    std::vector<Candidate> found;
    std::vector<double> patchReach;
    for (const WallReach& wall : list.wallReach) patchReach.push_back(wall.distance);
    std::vector<int> regions;
    for (int body = 0; body < list.owned(); ++body)
    {
        if (list.inverseMass[body] == 0.0) continue;
        regions.clear();
        const std::vector<Vec3> places = placesOf(list.position[body], reach[body], box);
        const double distance = list.radius[body] + reach[body];
        const bool seesOnlyNear = !reachToMany.empty() && std::isfinite(reachToMany[list.grainOf[body]]);
        for (const Vec3& place : places)
        {
            if (seesOnlyNear) search.findNear(place, distance, list.radius[body] + reachToMany[list.grainOf[body]], regions, patchReach);
            else search.find(place, distance, regions, patchReach);
        }
        if (places.size() > 1)
        {
            std::sort(regions.begin(), regions.end());
            regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
        }
        for (int region : regions) found.push_back({body, -1, region, {0, 0, 0}});
    }
    return found;
}

/// What the search looks up: spheres around bodies, wrapped into the box, by `shift` periods.
struct SearchSpheres
{
    std::vector<Vec3> center;
    std::vector<double> size;
    std::vector<Vec3> shift;   ///< empty: none
};

/// Spheres around the middles of paths. Two bodies that may meet, |x + t w| <= radii + slacks + ranges at some t of [0, 1] with w the difference of
/// their paths, are no further apart than that + |w|/2 at the middle, and |w| <= |path_a - c| + |path_b - c| for any c: the mean here. Ghosts are
/// bodies without a path, whose slack and range are their reach.
SearchSpheres spheresOnPaths(const ContactList& list, const std::vector<double>& reach, const PeriodicBox& box, double range)
{
    SearchSpheres spheres;
    const bool isPeriodic = box.isPeriodic(0) || box.isPeriodic(1) || box.isPeriodic(2);
    for (int body = 0; body < list.owned(); ++body)
    {
        const Vec3 middle = list.position[body] + 0.5*list.path[body];
        spheres.center.push_back(box.wrap(middle));
        spheres.size.push_back(list.radius[body] + range + list.slack[body] + 0.5*(list.path[body] - list.meanPath).norm());
        if (isPeriodic) spheres.shift.push_back(spheres.center.back() - middle);
    }
    for (std::size_t ghost = list.owned(); ghost < reach.size(); ++ghost)
    {
        spheres.center.push_back(list.position[ghost]);
        spheres.size.push_back(list.radius[ghost] + reach[ghost] + 0.5*list.meanPath.norm());
        if (isPeriodic) spheres.shift.push_back(Vec3::Zero());
    }
    return spheres;
}

SearchSpheres spheresAtBodies(const ContactList& list, const std::vector<double>& reach)
{
    SearchSpheres spheres{list.position, std::vector<double>(reach.size()), {}};
    for (std::size_t body = 0; body < reach.size(); ++body) spheres.size[body] = list.radius[body] + reach[body];
    return spheres;
}

} // namespace

std::vector<Vec3> placesOf(const Vec3& x, double reach, const PeriodicBox& box)
{
    std::vector<Vec3> places = {x};
    for (int axis = 0; axis < 3; ++axis)
    {
        if (!box.isPeriodic(axis)) continue;
        const double shift = x[axis] - reach < box.lower[axis] ? box.length[axis]
                           : x[axis] + reach >= box.lower[axis] + box.length[axis] ? -box.length[axis] : 0.0;
        if (shift == 0.0) continue;
        for (std::size_t k = 0, before = places.size(); k < before; ++k) places.push_back(places[k] + shift*Vec3::Unit(axis));
    }
    return places;
}

std::array<signed char, 3> movedBy(std::array<signed char, 3> image, const Vec3& shift, const PeriodicBox& box)
{
    for (int axis = 0; axis < 3; ++axis)
    {
        if (box.isPeriodic(axis)) image[axis] = static_cast<signed char>(image[axis] + std::lround(shift[axis]/box.length[axis]));
    }
    return image;
}

bool mayMeet(const ContactList& list, const Candidate& pair, const PeriodicBox& box, double range, double from)
{
    Vec3 x = list.positionAtBuild[pair.a] - list.positionAtBuild[pair.b];
    for (int axis = 0; axis < 3; ++axis) x[axis] -= pair.image[axis]*box.length[axis];
    Vec3 way = Vec3::Zero();
    if (!list.path.empty()) way = list.path[pair.a] - list.path[pair.b];
    const double approach = -x.dot(way), way2 = way.squaredNorm();
    const double share = approach <= from*way2 ? from : approach >= way2 ? 1.0 : approach/way2;
    const double near = list.radius[pair.a] + list.radius[pair.b] + list.slack[pair.a] + list.slack[pair.b] + 2.0*range;
    return (x + share*way).squaredNorm() < near*near;
}

Candidates findCandidates
(
    ContactList& list, const std::vector<double>& reach, const std::vector<GhostGrain>& ghosts, int rank, const Scene& scene,
    const WallSearch& wallSearch, const std::vector<double>& reachToMany
)
{
    const double range = rangeOfLaws(scene.materials);
    const double largest = list.radius.empty() ? 0.0 : *std::max_element(list.radius.begin(), list.radius.end());
    const bool arePathsKnown = !list.path.empty();
    const SearchSpheres spheres = arePathsKnown ? spheresOnPaths(list, reach, scene.box, range) : spheresAtBodies(list, reach);
    const std::vector<BodyPair>& pairs = list.search.find(spheres.center, spheres.size, scene.box, largest, mostPairs(spheres.center.size()));
    const std::vector<Candidate> walls = findWalls(list, reach, reachToMany, wallSearch, scene.box);

    Candidates found;
    found.inner.reserve(pairs.size() + walls.size());
    auto wall = walls.begin();
    for (const BodyPair& pair : pairs)
    {
        for (; wall != walls.end() && wall->a < pair.a; ++wall) found.inner.push_back(*wall);
        if (pair.a >= list.owned() || (list.inverseMass[pair.a] == 0.0 && list.inverseMass[pair.b] == 0.0)) continue;
        const bool areMoved = !spheres.shift.empty();
        const Candidate candidate{pair.a, pair.b, -1, areMoved ? movedBy(pair.image, spheres.shift[pair.b] - spheres.shift[pair.a], scene.box) : pair.image};
        if (pair.b < list.owned())
        {
            if (!arePathsKnown || mayMeet(list, candidate, scene.box, range, 0.0)) found.inner.push_back(candidate);
        }
        else if (isSolvedHere(rank, ghosts[pair.b - list.owned()].owner)) found.interface.push_back(candidate);
    }
    found.inner.insert(found.inner.end(), wall, walls.end());
    if (!list.general.empty()) removeWithinBodies(found.inner, list.general);
    return found;
}

Batches batchNearAndFar(const ContactList& list, const Scene& scene, const std::vector<Candidate>& candidates, double diameter)
{
    const auto isWithin = [&](const Candidate& c, double near)
    {
        if (c.wall >= 0) return nearestPoint(scene.walls, c.wall, list.position[c.a]).distance < list.radius[c.a] + near;
        Vec3 dx = list.position[c.a] - list.position[c.b];
        for (int axis = 0; axis < 3; ++axis) dx[axis] -= c.image[axis]*scene.box.length[axis];
        const double reach = list.radius[c.a] + list.radius[c.b] + near;
        return dx.squaredNorm() < reach*reach;
    };
    std::array<std::vector<std::uint32_t>, nearShares.size() + 1> groups;
    for (std::uint32_t k = 0; k < candidates.size(); ++k)
    {
        std::size_t group = 0;
        while (group < nearShares.size() && !isWithin(candidates[k], nearShares[group]*diameter)) ++group;
        groups[group].push_back(k);
    }
    std::vector<std::uint32_t> order;
    order.reserve(candidates.size());
    for (const auto& group : groups) order.insert(order.end(), group.begin(), group.end());
    return batchContacts(candidates, order, list.staticBody());
}

} // namespace nscd
