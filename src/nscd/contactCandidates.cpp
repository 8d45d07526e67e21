// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Pairs, walls, and who solves what lies between two ranks.
#include "contactCandidates.hpp"

#include "clumpCandidates.hpp"
#include "pairSearch.hpp"
#include "wallSearch.hpp"

#include <algorithm>
#include <numeric>

namespace nscd
{

namespace
{

/// Candidates this share of the mean diameter apart or nearer are packed together, as those that will matter most of the time.
constexpr double nearShare = 0.1;

/// All contacts between two ranks are solved by the same one, so that most bodies are moved by one rank at a time; by the
/// lower one where the sum of the two is even, so that each rank gets about half of its neighbors.
bool isSolvedHere(int here, int other) { return ((here + other) % 2 == 0) == (here < other); }

/// Walls near each body, as candidates that follow the body's pairs.
std::vector<Candidate> findWalls(const ContactList& list, const std::vector<double>& reach, const WallSearch& search)
{
    std::vector<Candidate> found;
    std::vector<double> patchReach;
    for (const WallReach& wall : list.wallReach) patchReach.push_back(wall.distance);
    std::vector<int> regions;
    for (int body = 0; body < list.owned(); ++body)
    {
        if (list.inverseMass[body] == 0.0) continue;
        regions.clear();
        search.find(list.position[body], list.radius[body] + reach[body], regions, patchReach);
        for (int region : regions) found.push_back({body, -1, region, {0, 0, 0}});
    }
    return found;
}

} // namespace

Candidates findCandidates
(
    const ContactList& list, const std::vector<double>& reach, const std::vector<GhostGrain>& ghosts, int rank, const Scene& scene,
    const WallSearch& wallSearch
)
{
    std::vector<double> size(reach.size());
    for (std::size_t body = 0; body < size.size(); ++body) size[body] = list.radius[body] + reach[body];
    const double largest = size.empty() ? 0.0 : *std::max_element(list.radius.begin(), list.radius.end());

    const std::vector<BodyPair> pairs = findPairs(list.position, size, scene.box, largest);
    const std::vector<Candidate> walls = findWalls(list, reach, wallSearch);

    Candidates found;
    found.inner.reserve(pairs.size() + walls.size());
    auto wall = walls.begin();
    for (const BodyPair& pair : pairs)
    {
        for (; wall != walls.end() && wall->a < pair.a; ++wall) found.inner.push_back(*wall);
        if (pair.a >= list.owned() || (list.inverseMass[pair.a] == 0.0 && list.inverseMass[pair.b] == 0.0)) continue;
        const Candidate candidate{pair.a, pair.b, -1, pair.image};
        if (pair.b < list.owned()) found.inner.push_back(candidate);
        else if (isSolvedHere(rank, ghosts[pair.b - list.owned()].owner)) found.interface.push_back(candidate);
    }
    found.inner.insert(found.inner.end(), wall, walls.end());
    if (!list.clumps.empty()) removeWithinClumps(found.inner, list.clumps);
    return found;
}

Batches batchNearAndFar(const ContactList& list, const Scene& scene, const std::vector<Candidate>& candidates, double diameter)
{
    const double near = nearShare*diameter;
    std::vector<std::size_t> order(candidates.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_partition(order.begin(), order.end(), [&](std::size_t k)
    {
        const Candidate& c = candidates[k];
        if (c.wall >= 0) return nearestPoint(scene.walls, c.wall, list.position[c.a]).distance < list.radius[c.a] + near;
        Vec3 dx = list.position[c.a] - list.position[c.b];
        for (int axis = 0; axis < 3; ++axis) dx[axis] -= c.image[axis]*scene.box.length[axis];
        return dx.norm() < list.radius[c.a] + list.radius[c.b] + near;
    });
    std::vector<Candidate> sorted;
    sorted.reserve(candidates.size());
    for (std::size_t k : order) sorted.push_back(candidates[k]);
    const Batches batches = batchContacts(sorted, list.staticBody());
    Batches result{batches.blocks, std::vector<std::size_t>(candidates.size())};
    for (std::size_t k = 0; k < order.size(); ++k) result.slotOf[order[k]] = batches.slotOf[k];
    return result;
}

} // namespace nscd
