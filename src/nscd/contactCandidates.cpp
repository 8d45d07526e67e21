// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Pairs, walls, and who solves what lies between two ranks.
#include "contactCandidates.hpp"

#include "clumpCandidates.hpp"
#include "wallSearch.hpp"

#include <algorithm>
#include <cmath>
#include <array>
#include <iterator>

namespace nscd
{

namespace
{

/// Candidates no further apart than each of these shares of the mean diameter are packed together, those first that will matter most of the
/// time: in a collapse 52 000 are loaded, of which 1 in 100 begins more than 0.01 apart; 70 000 are within the first share, 91 000 within the second.
constexpr std::array<double, 2> nearShares = {0.02, 0.1};

/// What a body may come off its path by when another hits it, in the difference of their paths: what a heavy one does to it at once. With 0.7 a quarter
/// more lists are built in a collapse.
constexpr double blow = 1.0;

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

/// Sets how far own bodies may be off their paths: by the margin, and by what a blow of those around may do. One whose reach does not allow
/// for that is expected nowhere.
void setSlack(ContactList& list, const std::vector<BodyPair>& pairs, double margin)
{
    list.slack = list.reach;
    if (list.path.empty()) return;
    std::vector<double> relative2(list.owned(), 0.0);
    for (const BodyPair& pair : pairs)
    {
        if (pair.a >= list.owned() || pair.b >= list.owned()) continue;
        const double way2 = (list.path[pair.a] - list.path[pair.b]).squaredNorm();
        relative2[pair.a] = std::max(relative2[pair.a], way2);
        relative2[pair.b] = std::max(relative2[pair.b], way2);
    }
    for (int body = 0; body < list.owned(); ++body)
    {
        const double slack = margin + blow*std::sqrt(relative2[body]);
        if (slack + list.path[body].norm() <= list.reach[body]) list.slack[body] = slack;
        else list.path[body].setZero();
    }
}

/// Whether two own bodies may touch on their ways, or attract each other within `range` each.
bool mayMeet(const ContactList& list, const BodyPair& pair, const PeriodicBox& box, double range)
{
    Vec3 x = list.position[pair.a] - list.position[pair.b];
    for (int axis = 0; axis < 3; ++axis) x[axis] -= pair.image[axis]*box.length[axis];
    const Vec3 way = list.path[pair.a] - list.path[pair.b];
    const double approach = -x.dot(way), way2 = way.squaredNorm();
    const double share = approach <= 0.0 ? 0.0 : approach >= way2 ? 1.0 : approach/way2;
    const double near = list.radius[pair.a] + list.radius[pair.b] + list.slack[pair.a] + list.slack[pair.b] + 2.0*range;
    return (x + share*way).squaredNorm() < near*near;
}

} // namespace

Candidates findCandidates
(
    ContactList& list, const std::vector<double>& reach, const std::vector<GhostGrain>& ghosts, int rank, const Scene& scene,
    const WallSearch& wallSearch, double margin
)
{
    std::vector<double> size(reach.size());
    for (std::size_t body = 0; body < size.size(); ++body) size[body] = list.radius[body] + reach[body];
    const double largest = size.empty() ? 0.0 : *std::max_element(list.radius.begin(), list.radius.end());

    const std::vector<BodyPair>& pairs = list.search.find(list.position, size, scene.box, largest);
    const std::vector<Candidate> walls = findWalls(list, reach, wallSearch);
    setSlack(list, pairs, margin);
    const double range = scene.materials.cohesionRange();

    Candidates found;
    found.inner.reserve(pairs.size() + walls.size());
    auto wall = walls.begin();
    for (const BodyPair& pair : pairs)
    {
        for (; wall != walls.end() && wall->a < pair.a; ++wall) found.inner.push_back(*wall);
        if (pair.a >= list.owned() || (list.inverseMass[pair.a] == 0.0 && list.inverseMass[pair.b] == 0.0)) continue;
        const Candidate candidate{pair.a, pair.b, -1, pair.image};
        if (pair.b < list.owned())
        {
            if (list.path.empty() || mayMeet(list, pair, scene.box, range)) found.inner.push_back(candidate);
        }
        else if (isSolvedHere(rank, ghosts[pair.b - list.owned()].owner)) found.interface.push_back(candidate);
    }
    found.inner.insert(found.inner.end(), wall, walls.end());
    if (!list.clumps.empty()) removeWithinClumps(found.inner, list.clumps);
    return found;
}

void takeIsolated(const ContactList& list, Candidates& candidates)
{
    std::vector<unsigned char> number(list.firstWallBody(), 0);  // of candidates, up to two
    for (const Candidate& c : candidates.inner)
    {
        number[c.a] += number[c.a] < 2;
        if (c.b >= 0) number[c.b] += number[c.b] < 2;
    }
    for (const Candidate& c : candidates.interface) number[list.ownBody(c.a)] = 2;
    for (int body : list.halo.shared()) number[body] = 2;
    for (int body = 0; body < list.owned(); ++body)
    {
        if (list.inverseMass[body] == 0.0) number[body] = 0;
    }

    const auto isCoupled = [&](const Candidate& c) { return number[c.a] > 1 || (c.b >= 0 && number[c.b] > 1); };
    std::vector<Candidate>& inner = candidates.inner;
    if (std::all_of(inner.begin(), inner.end(), isCoupled)) return;
    std::copy_if(inner.begin(), inner.end(), std::back_inserter(candidates.isolated), [&](const Candidate& c) { return !isCoupled(c); });
    inner.erase(std::remove_if(inner.begin(), inner.end(), [&](const Candidate& c) { return !isCoupled(c); }), inner.end());
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
