// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Room for blocks, coefficients of each candidate, and its place.
#include "nscd/contacts/listBlocks.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

/// A share of all, and some.
constexpr std::size_t shareOfStrays = 64, fewestOfStrays = 16;

const ContactPair& coefficients(const std::vector<int>& material, const Scene& scene, const Candidate& candidate)
{
    const int materialB = candidate.wall >= 0
        ? scene.walls.patches[scene.walls.regions[candidate.wall].patch].material
        : material[candidate.b];
    return scene.materials.pair(material[candidate.a], materialB);
}

/// Room for a number of elements in an empty array, and some more if it grows: numbers of candidates go up and down. What is there goes first.
template<class Element>
void makeRoom(std::vector<Element>& array, std::size_t number)
{
    if (array.capacity() >= number) return;
    const std::size_t more = array.capacity() > 0 ? number/8 : 0;
    array = std::vector<Element>();
    array.reserve(number + more);
}

} // namespace

std::vector<int> materialOfBodies(const ContactList& list, const Scene& scene)
{
    std::vector<int> material(list.position.size());
    for (int body = 0; body < list.firstWallBody(); ++body)
    {
        const int own = list.ownBody(body);
        material[body] = own < list.owned() ? scene.grains.material[list.grainOf[own]] : list.ghosts[own - list.owned()].material;
    }
    return material;
}

std::size_t blocksForStrays(std::size_t used) { return used/shareOfStrays + fewestOfStrays; }

void reserveBlocks(ContactList& list, const Scene& scene, std::size_t needed)
{
    makeRoom(list.blocks, needed);
    makeRoom(list.gap, needed*blockLanes);
    makeRoom(list.wall, needed*blockLanes);
    makeRoom(list.image, needed*blockLanes);
    if (scene.materials.anyRestitution()) list.restitution.reserve(needed*blockLanes);
}

void appendFreeBlocks(ContactList& list, const Scene& scene, std::size_t number)
{
    const std::size_t slots = list.slots() + number*blockLanes;
    list.blocks.resize(list.blocks.size() + number, emptyBlock(list.staticBody()));
    list.gap.resize(slots, 0.0);
    list.wall.resize(slots, -1);
    list.image.resize(slots, {0, 0, 0});
    if (scene.materials.anyRestitution()) list.restitution.resize(slots, 0.0);
    list.laws.resize(slots);
}

void writeCandidates
(
    ContactList& list, const Scene& scene, const std::vector<int>& material, const std::vector<Candidate>& candidates, Batches& batches, std::size_t first
)
{
    list.candidates += candidates.size();
    for (std::size_t k = 0; k < candidates.size(); ++k)
    {
        const Candidate& candidate = candidates[k];
        const std::size_t slot = batches.slotOf[k] += static_cast<std::uint32_t>(first*blockLanes);
        ContactBlock& block = list.blocks[slot/blockLanes];
        block.a[slot % blockLanes] = candidate.a;
        block.b[slot % blockLanes] = candidate.b;
        const ContactPair& pair = coefficients(material, scene, candidate);
        block.friction[slot % blockLanes] = pair.friction;
        if (!list.restitution.empty()) list.restitution[slot] = pair.restitution;
        if (!list.laws.empty()) list.laws.set(slot, pair, list.radius[candidate.a], candidate.wall >= 0 ? 0.0 : list.radius[candidate.b]);
        list.wall[slot] = candidate.wall;
        list.image[slot] = candidate.image;
    }
}

void appendBlocks
(
    ContactList& list, const Scene& scene, const std::vector<int>& material, const std::vector<Candidate>& candidates, Batches& batches
)
{
    const std::size_t first = list.blocks.size();
    appendFreeBlocks(list, scene, batches.blocks);
    writeCandidates(list, scene, material, candidates, batches, first);
}

} // namespace nscd
