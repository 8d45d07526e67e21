// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Building the list of candidates: sort bodies, find ghosts, pairs and walls, pack them into blocks of independent lanes.
#include "nscd/contacts/contactList.hpp"

#include "nscd/base/mortonOrder.hpp"
#include "nscd/contacts/contactCandidates.hpp"
#include "nscd/contacts/generalCandidates.hpp"
#include "nscd/contacts/listBlocks.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

/// Empties a list and keeps its large arrays' memory: new pages cost more than what is written to them.
ContactList emptied(ContactList old)
{
    ContactList list;
    const auto keep = [](auto& to, auto& from)
    {
        to.swap(from);
        to.clear();
    };
    keep(list.grainOf, old.grainOf);
    keep(list.positionAtBuild, old.positionAtBuild);
    keep(list.reach, old.reach);
    keep(list.path, old.path);
    keep(list.slack, old.slack);
    keep(list.position, old.position);
    keep(list.radius, old.radius);
    keep(list.inverseMass, old.inverseMass);
    keep(list.id, old.id);
    keep(list.bodies, old.bodies);
    keep(list.blocks, old.blocks);
    keep(list.gap, old.gap);
    keep(list.wall, old.wall);
    keep(list.image, old.image);
    keep(list.awake, old.awake);
    std::swap(list.search, old.search);
    return list;
}

void reserveBodies(ContactList& list, std::size_t number)
{
    list.position.reserve(number);
    list.radius.reserve(number);
    list.inverseMass.reserve(number);
    list.id.reserve(number);
}

void addBody(ContactList& list, const Vec3& position, double radius, double inverseMass, std::int64_t id)
{
    list.position.push_back(position);
    list.radius.push_back(radius);
    list.inverseMass.push_back(inverseMass);
    list.id.push_back(id);
}

/// Slacks are what is left of reaches beside paths and the range of laws.
GrainPaths pathsOfGrains(const std::vector<double>& reach, const ExpectedMotion& expected, double range)
{
    GrainPaths paths;
    paths.range = range;
    paths.meanPath = expected.time*expected.meanVelocity;
    paths.path.reserve(expected.velocity.size());
    for (const Vec3& velocity : expected.velocity) paths.path.push_back(expected.time*velocity);
    paths.slack.reserve(reach.size());
    for (std::size_t i = 0; i < reach.size(); ++i) paths.slack.push_back(reach[i] - range - (paths.path.empty() ? 0.0 : paths.path[i].norm()));
    return paths;
}

/// Of grains that may be stopped: anywhere within their reaches.
GrainPaths anywhereOn(GrainPaths paths)
{
    for (std::size_t i = 0; i < paths.path.size(); ++i) paths.slack[i] += paths.path[i].norm();
    paths.path.clear();
    return paths;
}

void sortBodies(ContactList& list, const Grains& grains, double diameter)
{
    list.grainOf = mortonOrder(grains.position, diameter);
    reserveBodies(list, list.grainOf.size());
    for (int i : list.grainOf) addBody(list, grains.position[i], grains.radius[i], grains.isFixed[i] ? 0.0 : 1.0/grains.mass[i], grains.id[i]);
    list.positionAtBuild = list.position;
}

void setPaths(ContactList& list, const std::vector<double>& reach, const GrainPaths& paths, double time)
{
    list.pathTime = time;
    list.meanPath = paths.meanPath;
    list.reach.reserve(list.owned());
    list.slack.reserve(list.owned());
    list.path.reserve(paths.path.size());
    for (int i : list.grainOf)
    {
        list.reach.push_back(reach[i] - paths.range);
        list.slack.push_back(paths.slack[i]);
        if (!paths.path.empty()) list.path.push_back(paths.path[i]);
    }
}

void addGhosts(ContactList& list, const std::vector<GhostGrain>& ghosts)
{
    reserveBodies(list, list.owned() + ghosts.size());
    for (const GhostGrain& ghost : ghosts) addBody(list, ghost.position, ghost.radius, ghost.inverseMass, ghost.id);
}

void dropGhosts(ContactList& list)
{
    list.position.resize(list.owned());
    list.radius.resize(list.owned());
    list.inverseMass.resize(list.owned());
    list.id.resize(list.owned());
}

/// Keeps the ghosts that candidates name, and numbers them anew.
void keepNeeded(ContactList& list, const std::vector<GhostGrain>& ghosts, std::vector<Candidate>& interface)
{
    std::vector<int> number(ghosts.size(), -1);
    for (const Candidate& c : interface) number[c.b - list.owned()] = 0;
    for (std::size_t g = 0; g < ghosts.size(); ++g)
    {
        if (number[g] == 0) number[g] = list.owned() + static_cast<int>(list.ghosts.size());
        (number[g] < 0 ? list.solvedElsewhere : list.ghosts).push_back(ghosts[g]);
    }
    list.ghosts.shrink_to_fit();
    list.solvedElsewhere.shrink_to_fit();
    for (Candidate& c : interface) c.b = number[c.b - list.owned()];
}

/// Without members of general bodies, which move with these.
std::vector<int> interfaceBodies(const std::vector<Candidate>& interface, const GeneralBodies& general)
{
    std::vector<int> bodies;
    for (const Candidate& c : interface)
    {
        if (general.member(c.a) < 0) bodies.push_back(c.a);
    }
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    return bodies;
}

/// Connects to the ranks that own the ghosts, and adds copies of own bodies that several ranks move.
void joinHalo(ContactList& list, std::vector<Candidate>& interface, Exchange& exchange)
{
    std::vector<int> bodyOf(list.owned());
    for (int body = 0; body < list.owned(); ++body) bodyOf[list.grainOf[body]] = body;
    std::vector<int> shared = exchange.connect(list.ghosts);
    for (int& grain : shared) grain = bodyOf[grain];
    list.halo = Halo(exchange, list.owned(), list.ghosts.size(), std::move(shared), interfaceBodies(interface, list.general));
    if (!list.general.empty()) joinGeneralBodies(list, interface, exchange);

    const std::vector<int>& copied = list.halo.copied();
    for (int body : copied) addBody(list, list.position[body], list.radius[body], list.inverseMass[body], list.id[body]);
    for (Candidate& c : interface)
    {
        const auto copy = std::lower_bound(copied.begin(), copied.end(), c.a);
        if (copy != copied.end() && *copy == c.a) c.a = list.halo.firstCopy() + static_cast<int>(copy - copied.begin());
    }
}

/// Makes all bodies, and names those that candidates with walls meet.
void addWallBodies(ContactList& list, const Scene& scene, Candidates& candidates)
{
    int next = list.firstWallBody();
    for (Candidate& c : candidates.inner)
    {
        if (c.wall >= 0 && scene.walls.patches[scene.walls.regions[c.wall].patch].hasVelocity()) c.b = next++;
    }
    list.bodies.assign(next + 1, Body{});
    for (Candidate& c : candidates.inner)
    {
        if (c.b < 0) c.b = list.staticBody();
    }
}

void findMovingSlots(ContactList& list, const std::vector<Candidate>& candidates, const std::vector<std::uint32_t>& slotOf)
{
    list.movingSlots.resize(list.staticBody() - list.firstWallBody());
    if (list.movingSlots.empty()) return;
    for (std::size_t k = 0; k < candidates.size(); ++k)
    {
        const int body = candidates[k].b - list.firstWallBody();
        if (candidates[k].wall >= 0 && candidates[k].b < list.staticBody()) list.movingSlots[body] = slotOf[k];
    }
}

/// Groups the slots of outlined walls by body, for bodies near more than one.
void groupWallSlots(ContactList& list, const Scene& scene, const std::vector<Candidate>& candidates, const std::vector<std::uint32_t>& slotOf)
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
            if (wall >= 0 && !scene.walls.regions[wall].edges.empty()) list.wallSlots.push_back(static_cast<int>(slotOf[k]));
        }
        if (list.wallSlots.size() == before + 1) list.wallSlots.pop_back();
        if (list.wallSlots.size() > before) list.wallSlotStart.push_back(static_cast<int>(list.wallSlots.size()));
    }
}

/// Blocks without general bodies.
CandidateSlots packSingle(ContactList& list, const Scene& scene, const std::vector<int>& material, const Candidates& candidates, double diameter)
{
    Batches inner = batchNearAndFar(list, scene, candidates.inner, diameter), interface = batchNearAndFar(list, scene, candidates.interface, diameter);
    const std::size_t used = inner.blocks + interface.blocks, room = list.areStraysFollowed ? blocksForStrays(used) : 0;
    reserveBlocks(list, scene, used + room);
    appendBlocks(list, scene, material, candidates.inner, inner);
    list.freeBlock = list.blocks.size();
    appendFreeBlocks(list, scene, room);
    list.interfaceBlock = list.blocks.size();
    appendBlocks(list, scene, material, candidates.interface, interface);
    return {std::move(inner.slotOf), std::move(interface.slotOf)};
}

} // namespace

CandidateSlots packCandidates(ContactList& list, const Scene& scene, Candidates& candidates, double diameter)
{
    addWallBodies(list, scene, candidates);
    const std::vector<int> material = materialOfBodies(list, scene);
    CandidateSlots slots = list.general.empty()
        ? packSingle(list, scene, material, candidates, diameter) : packWithGeneral(list, scene, material, candidates, diameter);
    groupWallSlots(list, scene, candidates.inner, slots.inner);
    findMovingSlots(list, candidates.inner, slots.inner);
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (list.wall[slot] >= 0) list.slotsOfWalls.push_back(static_cast<std::uint32_t>(slot));
    }
    return slots;
}

ContactList buildContactList
(
    const Scene& scene, const WallSearch& wallSearch, const std::vector<double>& reach, std::vector<WallReach> wallReach,
    double diameter, Exchange& exchange, ContactList old, const ExpectedMotion& expected
)
{
    ContactList list = emptied(std::move(old));
    list.wallReach = std::move(wallReach);
    list.laws = ListLaws(scene.materials);
    list.areStraysFollowed = expected.areStraysFollowed;
    sortBodies(list, scene.grains, diameter);
    list.general = listGeneralBodies(scene.grains.clumps, list.grainOf);
    list.general.isThere = areClumpsAnywhere(scene.grains.clumps, exchange);
    const GrainPaths paths = pathsOfGrains(reach, expected, rangeOfLaws(scene.materials));
    setPaths(list, reach, paths, expected.time);
    const std::vector<GhostGrain> ghosts = exchange.findGhosts(scene.grains, expected.mayBeStopped ? anywhereOn(paths) : paths, scene.box);
    addGhosts(list, ghosts);
    Candidates candidates = findCandidates(list, ghosts, exchange.rank(), scene, wallSearch, expected.reachToMany);
    if (exchange.isParallel())
    {
        dropGhosts(list);
        keepNeeded(list, ghosts, candidates.interface);
        addGhosts(list, list.ghosts);
        joinHalo(list, candidates.interface, exchange);
    }
    packCandidates(list, scene, candidates, diameter);
    return list;
}

} // namespace nscd
