// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// General bodies in a contact list: which there are, and where their contacts go.
#include "nscd/contacts/generalCandidates.hpp"

#include "nscd/contacts/contactCandidates.hpp"
#include "nscd/contacts/general/generalSweep.hpp"
#include "nscd/scene/clumps.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

bool isGeneral(const ContactList& list, const Candidate& c)
{
    return list.general.memberOf[c.a] >= 0 || (c.b < list.owned() && list.general.memberOf[c.b] >= 0);
}

} // namespace

GeneralBodies listGeneralBodies(const Clumps& clumps, const std::vector<int>& grainOf)
{
    GeneralBodies list;
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

int GeneralBodies::representative(int body) const
{
    int member = body < static_cast<int>(memberOf.size()) ? memberOf[body] : -1;
    if (member < 0) return body;
    while (member > 0 && members[member - 1].owner == members[member].owner) --member;
    return members[member].body;
}

void removeWithinBodies(std::vector<Candidate>& candidates, const GeneralBodies& general)
{
    const auto ownerOf = [&](int body) { return general.memberOf[body] < 0 ? -1 : general.members[general.memberOf[body]].owner; };
    const auto isWithin = [&](const Candidate& c) { return c.wall < 0 && ownerOf(c.a) >= 0 && ownerOf(c.a) == ownerOf(c.b); };
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(), isWithin), candidates.end());
}

Batches batchWithGeneral(ContactList& list, const Scene& scene, const std::vector<Candidate>& candidates, double diameter)
{
    std::vector<Candidate> single;
    for (const Candidate& c : candidates)
    {
        if (!isGeneral(list, c)) single.push_back(c);
    }
    const Batches ofSingle = batchNearAndFar(list, scene, single, diameter);
    Batches all{ofSingle.blocks, std::vector<std::uint32_t>(candidates.size())};
    list.general.firstBlock = ofSingle.blocks;
    std::size_t next = 0, last = ofSingle.blocks*blockLanes;
    for (std::size_t k = 0; k < candidates.size(); ++k)
    {
        all.slotOf[k] = isGeneral(list, candidates[k]) ? last++ : ofSingle.slotOf[next++];
    }
    all.blocks = (last + blockLanes - 1)/blockLanes;
    list.general.slots.resize((all.blocks - ofSingle.blocks)*blockLanes);
    return all;
}

} // namespace nscd
