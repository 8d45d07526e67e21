// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Building the list of candidates: sort bodies, find pairs and walls, pack them into blocks of independent lanes.
#include "contactList.hpp"

#include "contactBatching.hpp"
#include "mortonOrder.hpp"
#include "pairSearch.hpp"
#include "wallSearch.hpp"

#include <algorithm>
#include <numeric>

namespace nscd
{

namespace
{

double meanDiameter(const Grains& grains)
{
    if (grains.size() == 0) return 1.0;
    return 2.0*std::accumulate(grains.radius.begin(), grains.radius.end(), 0.0)/grains.size();
}

void sortBodies(ContactList& list, const Grains& grains, const std::vector<double>& reach)
{
    list.grainOf = mortonOrder(grains.position, meanDiameter(grains));
    list.bodyOf.resize(grains.size());
    for (std::size_t body = 0; body < grains.size(); ++body)
    {
        const int i = list.grainOf[body];
        list.bodyOf[i] = static_cast<int>(body);
        list.position.push_back(grains.position[i]);
        list.radius.push_back(grains.radius[i]);
        list.reach.push_back(reach[i]);
    }
    list.positionAtBuild = list.position;
    list.bodies.assign(grains.size() + 1, Body{});
}

/// Walls near each body, as candidates that follow the body's pairs.
std::vector<Candidate> findWalls(const ContactList& list, const Scene& scene)
{
    std::vector<Candidate> found;
    if (scene.walls.regions.empty() || list.grainOf.empty()) return found;
    const double largest = *std::max_element(list.radius.begin(), list.radius.end());
    const WallSearch search(scene.walls, 4.0*largest);
    std::vector<int> regions;
    for (int body = 0; body < list.staticBody(); ++body)
    {
        if (scene.grains.isFixed[list.grainOf[body]]) continue;
        regions.clear();
        search.find(list.position[body], list.radius[body] + list.reach[body], regions);
        for (int region : regions) found.push_back({body, list.staticBody(), region, {0, 0, 0}});
    }
    return found;
}

std::vector<Candidate> findCandidates(const ContactList& list, const Scene& scene)
{
    std::vector<double> size(list.radius.size());
    for (std::size_t body = 0; body < size.size(); ++body) size[body] = list.radius[body] + list.reach[body];
    const double largest = size.empty() ? 0.0 : *std::max_element(list.radius.begin(), list.radius.end());

    const std::vector<BodyPair> pairs = findPairs(list.position, size, scene.box, largest);
    const std::vector<Candidate> walls = findWalls(list, scene);

    std::vector<Candidate> all;
    all.reserve(pairs.size() + walls.size());
    auto wall = walls.begin();
    for (const BodyPair& pair : pairs)
    {
        for (; wall != walls.end() && wall->a < pair.a; ++wall) all.push_back(*wall);
        const bool isHeld = scene.grains.isFixed[list.grainOf[pair.a]] && scene.grains.isFixed[list.grainOf[pair.b]];
        if (!isHeld) all.push_back({pair.a, pair.b, -1, pair.image});
    }
    all.insert(all.end(), wall, walls.end());
    return all;
}

const ContactPair& coefficients(const ContactList& list, const Scene& scene, const Candidate& candidate)
{
    const int materialA = scene.grains.material[list.grainOf[candidate.a]];
    const int materialB = candidate.wall >= 0
        ? scene.walls.patches[scene.walls.regions[candidate.wall].patch].material
        : scene.grains.material[list.grainOf[candidate.b]];
    return scene.materials.pair(materialA, materialB);
}

/// Writes the candidates into their slots; slots[k] is where candidate k goes.
void fillSlots(ContactList& list, const Scene& scene, const std::vector<Candidate>& candidates, const Batches& batches)
{
    const std::size_t slots = batches.blocks*blockLanes;
    ContactBlock empty{};
    std::fill(empty.a, empty.a + blockLanes, list.staticBody());
    std::fill(empty.b, empty.b + blockLanes, list.staticBody());
    list.blocks.assign(batches.blocks, empty);
    list.gap.assign(slots, 0.0);
    list.wall.assign(slots, -1);
    list.image.assign(slots, {0, 0, 0});
    if (scene.materials.anyRestitution()) list.restitution.assign(slots, 0.0);
    list.candidates = candidates.size();

    for (std::size_t k = 0; k < candidates.size(); ++k)
    {
        const Candidate& candidate = candidates[k];
        const std::size_t slot = batches.slotOf[k];
        ContactBlock& block = list.blocks[slot/blockLanes];
        block.a[slot % blockLanes] = candidate.a;
        block.b[slot % blockLanes] = candidate.b;
        const ContactPair& pair = coefficients(list, scene, candidate);
        block.friction[slot % blockLanes] = pair.friction;
        if (!list.restitution.empty()) list.restitution[slot] = pair.restitution;
        list.wall[slot] = candidate.wall;
        list.image[slot] = candidate.image;
    }
}

/// Groups the slots of outlined walls by body, for bodies near more than one.
void groupWallSlots(ContactList& list, const Scene& scene, const std::vector<Candidate>& candidates, const Batches& batches)
{
    list.wallSlotStart.assign(1, 0);
    std::size_t k = 0;
    while (k < candidates.size())
    {
        const int body = candidates[k].a;
        const std::size_t before = list.wallSlots.size();
        for (; k < candidates.size() && candidates[k].a == body; ++k)
        {
            const int wall = candidates[k].wall;
            if (wall >= 0 && !scene.walls.regions[wall].edges.empty()) list.wallSlots.push_back(static_cast<int>(batches.slotOf[k]));
        }
        if (list.wallSlots.size() == before + 1) list.wallSlots.pop_back();
        if (list.wallSlots.size() > before) list.wallSlotStart.push_back(static_cast<int>(list.wallSlots.size()));
    }
}

} // namespace

Vec3 impulse(const ContactList& list, std::size_t slot)
{
    const ContactBlock& block = list.blocks[slot/blockLanes];
    const std::size_t lane = slot % blockLanes;
    return Vec3(block.r[0][lane], block.r[1][lane], block.r[2][lane]);
}

void setImpulse(ContactList& list, std::size_t slot, const Vec3& r)
{
    ContactBlock& block = list.blocks[slot/blockLanes];
    for (int k = 0; k < 3; ++k) block.r[k][slot % blockLanes] = r[k];
}

Vec3 normal(const ContactList& list, std::size_t slot)
{
    const ContactBlock& block = list.blocks[slot/blockLanes];
    const std::size_t lane = slot % blockLanes;
    return Vec3(block.n[0][lane], block.n[1][lane], block.n[2][lane]);
}

namespace
{

/// Candidates this share of the mean diameter apart or nearer are packed together, as those that will matter most of the time.
constexpr double nearShare = 0.1;

/// Packs near candidates into blocks of their own, so that blocks of far ones can be left out of sweeps.
Batches batchNearAndFar(const ContactList& list, const Scene& scene, const std::vector<Candidate>& candidates)
{
    const double near = nearShare*meanDiameter(scene.grains);
    std::vector<std::size_t> order(candidates.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_partition(order.begin(), order.end(), [&](std::size_t k)
    {
        const Candidate& c = candidates[k];
        if (c.wall >= 0) return nearestPoint(scene.walls.regions[c.wall], list.position[c.a]).distance < list.radius[c.a] + near;
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

} // namespace

ContactList buildContactList(const Scene& scene, const std::vector<double>& reach)
{
    ContactList list;
    sortBodies(list, scene.grains, reach);
    const std::vector<Candidate> candidates = findCandidates(list, scene);
    const Batches batches = batchNearAndFar(list, scene, candidates);
    fillSlots(list, scene, candidates, batches);
    groupWallSlots(list, scene, candidates, batches);
    return list;
}

std::vector<SlotImpulse> loadedSlots(const ContactList& list)
{
    std::vector<SlotImpulse> loaded;
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (!list.isUsed(slot)) continue;
        const Vec3 r = impulse(list, slot);
        if (r == Vec3::Zero()) continue;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const int wall = list.wall[slot];
        const int b = wall >= 0 ? -1 - wall : list.grainOf[block.b[slot % blockLanes]];
        loaded.push_back({slot, {list.grainOf[block.a[slot % blockLanes]], b, r}});
    }
    return loaded;
}

std::vector<PairImpulse> collectImpulses(const ContactList& list)
{
    std::vector<PairImpulse> impulses;
    for (const SlotImpulse& entry : loadedSlots(list)) impulses.push_back(entry.pair);
    return impulses;
}

namespace
{

/// The same impulse seen from the grain of lower index.
PairImpulse fromLowerGrain(const PairImpulse& entry)
{
    return entry.b >= 0 && entry.b < entry.a ? PairImpulse{entry.b, entry.a, -entry.impulse} : entry;
}

/// Impulses grouped by their first grain.
struct ImpulsesByGrain
{
    std::vector<int> start;
    std::vector<PairImpulse> entries;
};

ImpulsesByGrain groupByGrain(const std::vector<PairImpulse>& impulses, std::size_t grains)
{
    ImpulsesByGrain table;
    table.start.assign(grains + 1, 0);
    table.entries.resize(impulses.size());
    for (const PairImpulse& entry : impulses) ++table.start[fromLowerGrain(entry).a + 1];
    std::partial_sum(table.start.begin(), table.start.end(), table.start.begin());
    std::vector<int> next(table.start.begin(), table.start.end() - 1);
    for (const PairImpulse& entry : impulses)
    {
        const PairImpulse ordered = fromLowerGrain(entry);
        table.entries[next[ordered.a]++] = ordered;
    }
    return table;
}

} // namespace

void assignImpulses(ContactList& list, const std::vector<PairImpulse>& impulses)
{
    if (impulses.empty()) return;
    ImpulsesByGrain table = groupByGrain(impulses, list.grainOf.size());
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (!list.isUsed(slot)) continue;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const int grainA = list.grainOf[block.a[slot % blockLanes]];
        const int grainB = list.wall[slot] >= 0 ? -1 - list.wall[slot] : list.grainOf[block.b[slot % blockLanes]];
        const bool isSwapped = grainB >= 0 && grainB < grainA;
        const int first = isSwapped ? grainB : grainA;
        const int second = isSwapped ? grainA : grainB;
        const Vec3 n = (isSwapped ? -1.0 : 1.0)*normal(list, slot);

        PairImpulse* best = nullptr;
        for (int k = table.start[first]; k < table.start[first + 1]; ++k)
        {
            PairImpulse& entry = table.entries[k];
            if (entry.b != second || !(entry.impulse.dot(n) > 0.0)) continue;
            if (!best || entry.impulse.dot(n) > best->impulse.dot(n)) best = &entry;
        }
        if (!best) continue;
        setImpulse(list, slot, isSwapped ? Vec3(-best->impulse) : best->impulse);
        best->impulse.setZero();
    }
}

} // namespace nscd
