// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// General bodies in a contact list: which there are, and where their contacts go.
#include "nscd/contacts/generalCandidates.hpp"

#include "nscd/contacts/contactCandidates.hpp"
#include "nscd/contacts/general/generalSweep.hpp"
#include "nscd/contacts/listBlocks.hpp"
#include "nscd/scene/clumps.hpp"

#include <algorithm>
#include <numeric>

namespace nscd
{

namespace
{

bool isGeneral(const ContactList& list, const Candidate& c) { return list.general.member(c.a) >= 0 || list.general.member(c.b) >= 0; }

/// The candidates of general bodies, or the others, and their places among all.
struct SomeCandidates
{
    std::vector<Candidate> candidates;
    std::vector<std::uint32_t> places;

    SomeCandidates(const ContactList& list, const std::vector<Candidate>& all, bool areGeneral)
    {
        for (std::uint32_t k = 0; k < all.size(); ++k)
        {
            if (isGeneral(list, all[k]) != areGeneral) continue;
            candidates.push_back(all[k]);
            places.push_back(k);
        }
    }
};

/// In their order: no kernel works on them, so that lanes need not be independent.
Batches batchInOrder(const std::vector<Candidate>& candidates)
{
    Batches batches{(candidates.size() + blockLanes - 1)/blockLanes, std::vector<std::uint32_t>(candidates.size())};
    std::iota(batches.slotOf.begin(), batches.slotOf.end(), 0);
    return batches;
}

void appendSome
(
    ContactList& list, const Scene& scene, const std::vector<int>& material, const SomeCandidates& some, Batches batches, std::vector<std::uint32_t>& slotOf
)
{
    appendBlocks(list, scene, material, some.candidates, batches);
    for (std::size_t k = 0; k < some.places.size(); ++k) slotOf[some.places[k]] = batches.slotOf[k];
}

/// Members of clumps of other ranks are those of ghost bodies; their arms come with each step.
void addGhostMembers(ContactList& list)
{
    GeneralBodies& general = list.general;
    general.memberOf.resize(list.owned() + list.ghosts.size(), -1);
    for (std::size_t g = 0; g < list.ghosts.size(); ++g)
    {
        const int owner = general.halo.bodyOfGhost()[g], body = list.owned() + static_cast<int>(g);
        if (owner < 0) continue;
        general.memberOf[body] = static_cast<int>(general.members.size());
        general.members.push_back({owner, body, Vec3::Zero(), Vec3::Zero()});
    }
}

std::vector<int> sortedOnce(std::vector<int> values)
{
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

} // namespace

GeneralBodies listGeneralBodies(const Clumps& clumps, const std::vector<int>& grainOf)
{
    GeneralBodies list;
    std::vector<int> bodyOf(grainOf.size());
    for (std::size_t body = 0; body < grainOf.size(); ++body) bodyOf[grainOf[body]] = static_cast<int>(body);
    list.bodies.resize(clumps.size());
    list.clumpOf.resize(clumps.size());
    std::iota(list.clumpOf.begin(), list.clumpOf.end(), 0);
    list.isThere = !clumps.empty();
    list.memberOf.assign(clumps.empty() ? 0 : grainOf.size(), -1);
    for (std::size_t c = 0; c < clumps.size(); ++c)
    {
        const std::vector<Ball>& balls = clumps.shapeOf(c).members;
        for (std::size_t k = 0; k < balls.size(); ++k)
        {
            const int body = bodyOf[clumps.firstMember[c] + k];
            list.memberOf[body] = static_cast<int>(list.members.size());
            list.members.push_back({static_cast<int>(c), body, balls[k].center, Vec3::Zero()});
        }
    }
    list.ownMembers = list.members.size();
    return list;
}

void removeWithinBodies(std::vector<Candidate>& candidates, const GeneralBodies& general)
{
    const auto ownerOf = [&](int body) { return general.member(body) < 0 ? -1 : general.members[general.memberOf[body]].owner; };
    const auto isWithin = [&](const Candidate& c) { return c.wall < 0 && ownerOf(c.a) >= 0 && ownerOf(c.a) == ownerOf(c.b); };
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(), isWithin), candidates.end());
}

bool areClumpsAnywhere(const Clumps& clumps, const Exchange& exchange)
{
    return clumps.shapes.empty() ? !clumps.empty() : exchange.any(!clumps.empty());
}

void joinGeneralBodies(ContactList& list, const std::vector<Candidate>& interface, Exchange& exchange)
{
    GeneralBodies& general = list.general;
    const auto ownerOf = [&](int body) { return general.member(body) < 0 ? -1 : general.members[general.memberOf[body]].owner; };
    std::vector<int> sharedOwners, here;
    for (int body : list.halo.shared()) sharedOwners.push_back(ownerOf(body));
    for (const Candidate& c : interface)
    {
        if (c.a < list.owned() && ownerOf(c.a) >= 0) here.push_back(ownerOf(c.a));
    }
    general.halo = GeneralHalo(exchange, static_cast<int>(general.bodies.size()), list.ghosts, std::move(sharedOwners), sortedOnce(std::move(here)));
    general.bodies.resize(general.halo.bodies());
    addGhostMembers(list);
}

CandidateSlots packWithGeneral(ContactList& list, const Scene& scene, const std::vector<int>& material, const Candidates& candidates, double diameter)
{
    const SomeCandidates inner(list, candidates.inner, false), interface(list, candidates.interface, false);
    const SomeCandidates generalInner(list, candidates.inner, true), generalInterface(list, candidates.interface, true);
    const Batches ofInner = batchNearAndFar(list, scene, inner.candidates, diameter), ofInterface = batchNearAndFar(list, scene, interface.candidates, diameter);
    const Batches ofGeneral = batchInOrder(generalInner.candidates), ofGeneralInterface = batchInOrder(generalInterface.candidates);
    reserveBlocks(list, scene, ofInner.blocks + ofInterface.blocks + ofGeneral.blocks + ofGeneralInterface.blocks);
    CandidateSlots slots{std::vector<std::uint32_t>(candidates.inner.size()), std::vector<std::uint32_t>(candidates.interface.size())};
    appendSome(list, scene, material, inner, ofInner, slots.inner);
    list.freeBlock = list.interfaceBlock = list.blocks.size();
    appendSome(list, scene, material, interface, ofInterface, slots.interface);
    list.general.firstBlock = list.blocks.size();
    appendSome(list, scene, material, generalInner, ofGeneral, slots.inner);
    list.general.firstInterface = list.blocks.size();
    appendSome(list, scene, material, generalInterface, ofGeneralInterface, slots.interface);
    list.general.slots.resize((list.blocks.size() - list.general.firstBlock)*blockLanes);
    return slots;
}

bool isBetweenRanks(const ContactList& list, std::size_t slot)
{
    const std::size_t block = slot/blockLanes;
    if (list.general.empty()) return block >= list.interfaceBlock;
    return block >= list.general.firstInterface || (block >= list.interfaceBlock && block < list.general.firstBlock);
}

} // namespace nscd
