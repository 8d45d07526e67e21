// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Members of clumps in a contact list.
#include "nscd/contacts/clumps/clumpCandidates.hpp"

#include "nscd/contacts/clumps/clumpVisits.hpp"
#include "nscd/contacts/contactCandidates.hpp"
#include "nscd/scene/clumps.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

bool isOfClump(const ContactList& list, const Candidate& c)
{
    return list.clumps.memberOf[c.a] >= 0 || (c.b < list.owned() && list.clumps.memberOf[c.b] >= 0);
}

} // namespace

ClumpList listClumps(const Clumps& clumps, const std::vector<int>& grainOf)
{
    ClumpList list;
    std::vector<int> bodyOf(grainOf.size());
    for (std::size_t body = 0; body < grainOf.size(); ++body) bodyOf[grainOf[body]] = static_cast<int>(body);
    list.bodies.resize(clumps.size());
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
    return list;
}

int bodyForClump(const ClumpList& clumps, int body)
{
    int member = body < static_cast<int>(clumps.memberOf.size()) ? clumps.memberOf[body] : -1;
    if (member < 0) return body;
    while (member > 0 && clumps.members[member - 1].clump == clumps.members[member].clump) --member;
    return clumps.members[member].body;
}

void removeWithinClumps(std::vector<Candidate>& candidates, const ClumpList& clumps)
{
    const auto clumpOf = [&](int body) { return clumps.memberOf[body] < 0 ? -1 : clumps.members[clumps.memberOf[body]].clump; };
    const auto isWithin = [&](const Candidate& c) { return c.wall < 0 && clumpOf(c.a) >= 0 && clumpOf(c.a) == clumpOf(c.b); };
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(), isWithin), candidates.end());
}

Batches batchWithClumps(ContactList& list, const Scene& scene, const std::vector<Candidate>& candidates, double diameter)
{
    std::vector<Candidate> single;
    for (const Candidate& c : candidates)
    {
        if (!isOfClump(list, c)) single.push_back(c);
    }
    const Batches ofSingle = batchNearAndFar(list, scene, single, diameter);
    Batches all{ofSingle.blocks, std::vector<std::uint32_t>(candidates.size())};
    list.clumps.firstBlock = ofSingle.blocks;
    std::size_t next = 0, last = ofSingle.blocks*blockLanes;
    for (std::size_t k = 0; k < candidates.size(); ++k)
    {
        all.slotOf[k] = isOfClump(list, candidates[k]) ? last++ : ofSingle.slotOf[next++];
    }
    all.blocks = (last + blockLanes - 1)/blockLanes;
    list.clumps.slots.resize((all.blocks - ofSingle.blocks)*blockLanes);
    return all;
}

} // namespace nscd
