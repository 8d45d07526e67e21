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
    const ContactList& list, double range, const std::vector<double>& reachToMany, const WallSearch& search, const PeriodicBox& box
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
        const double reach = list.reach[body] + range, distance = list.radius[body] + reach;
        const std::vector<Vec3> places = placesOf(list.position[body], reach, box);
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

/// How a body is expected to go.
struct Track
{
    Vec3 start, path;
    double size;   ///< radius and slack [m]
};

/// Of own bodies.
Track trackOf(const ContactList& list, int body)
{
    return {list.positionAtBuild[body], list.path.empty() ? Vec3(Vec3::Zero()) : list.path[body], list.radius[body] + list.slack[body]};
}

Track trackOf(const GhostGrain& ghost) { return {ghost.position, ghost.path, ghost.radius + ghost.slack}; }

/// See mayMeet().
bool mayMeet(const Track& a, const Track& b, const std::array<signed char, 3>& image, const PeriodicBox& box, double range, double from)
{
    Vec3 x = a.start - b.start;
    for (int axis = 0; axis < 3; ++axis) x[axis] -= image[axis]*box.length[axis];
    const Vec3 way = a.path - b.path;
    const double approach = -x.dot(way), way2 = way.squaredNorm();
    const double share = approach <= from*way2 ? from : approach >= way2 ? 1.0 : approach/way2;
    const double near = a.size + b.size + 2.0*range;
    return (x + share*way).squaredNorm() < near*near;
}

/// What the search looks up: spheres around bodies, wrapped into the box, by `shift`.
struct SearchSpheres
{
    std::vector<Vec3> center;
    std::vector<double> size;
    std::vector<Vec3> shift;   ///< [m]; empty where nothing is periodic
};

/// Spheres around the middles of paths. Two bodies that may meet, |x + t w| <= radii + slacks + ranges at some t of [0, 1] with w the difference of
/// their paths, are no further apart than that + |w|/2 at the middle, and |w| <= |path_a - c| + |path_b - c| for any c: the mean here.
SearchSpheres searchSpheres(const ContactList& list, const std::vector<GhostGrain>& ghosts, const PeriodicBox& box, double range)
{
    const bool isPeriodic = box.any();
    const std::size_t number = list.owned() + ghosts.size();
    SearchSpheres spheres;
    spheres.center.reserve(number);
    spheres.size.reserve(number);
    spheres.shift.reserve(isPeriodic ? number : 0);
    const auto add = [&](const Track& track)
    {
        const Vec3 middle = track.start + 0.5*track.path;
        spheres.center.push_back(box.wrap(middle));
        spheres.size.push_back(track.size + range + 0.5*(track.path - list.meanPath).norm());
        if (isPeriodic) spheres.shift.push_back(spheres.center.back() - middle);
    };
    for (int body = 0; body < list.owned(); ++body) add(trackOf(list, body));
    for (const GhostGrain& ghost : ghosts) add(trackOf(ghost));
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
    return mayMeet(trackOf(list, pair.a), trackOf(list, pair.b), pair.image, box, range, from);
}

Candidates findCandidates
(
    ContactList& list, const std::vector<GhostGrain>& ghosts, int rank, const Scene& scene, const WallSearch& wallSearch,
    const std::vector<double>& reachToMany
)
{
    const double range = rangeOfLaws(scene.materials);
    const double largest = list.radius.empty() ? 0.0 : *std::max_element(list.radius.begin(), list.radius.end());
    const SearchSpheres spheres = searchSpheres(list, ghosts, scene.box, range);
    const std::vector<BodyPair>& pairs = list.search.find(spheres.center, spheres.size, scene.box, largest, mostPairs(spheres.center.size()));
    const std::vector<Candidate> walls = findWalls(list, range, reachToMany, wallSearch, scene.box);

    const bool arePathsKnown = !list.path.empty();
    const auto trackOfBody = [&](int body) { return body < list.owned() ? trackOf(list, body) : trackOf(ghosts[body - list.owned()]); };
    Candidates found;
    found.inner.reserve(pairs.size() + walls.size());
    auto wall = walls.begin();
    for (const BodyPair& pair : pairs)
    {
        for (; wall != walls.end() && wall->a < pair.a; ++wall) found.inner.push_back(*wall);
        if (pair.a >= list.owned() || (list.inverseMass[pair.a] == 0.0 && list.inverseMass[pair.b] == 0.0)) continue;
        const bool areMoved = !spheres.shift.empty();
        const Candidate candidate{pair.a, pair.b, -1, areMoved ? movedBy(pair.image, spheres.shift[pair.b] - spheres.shift[pair.a], scene.box) : pair.image};
        const bool isInner = pair.b < list.owned();
        if (!isInner && !isSolvedHere(rank, ghosts[pair.b - list.owned()].owner)) continue;
        if (arePathsKnown && !mayMeet(trackOfBody(pair.a), trackOfBody(pair.b), candidate.image, scene.box, range, 0.0)) continue;
        (isInner ? found.inner : found.interface).push_back(candidate);
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
