// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Which bodies a part has, and which sleeping grains are around others.
// Tested by tests/unit/nscd/step/awakePartTest.cpp, tests/unit/nscd/step/clumpSleepTest.cpp
#include "nscd/step/awakePart.hpp"

#include <algorithm>

namespace nscd
{

/// At a wall one that is not a grain's.
int AwakePart::otherBody(std::size_t slot, int body) const
{
    const ContactBlock& block = whole_.blocks[slot/blockLanes];
    const int a = block.a[slot % blockLanes];
    return a == body ? block.b[slot % blockLanes] : a;
}

/// Visits all members of a body's clump, or the body itself.
template<class Visit>
void AwakePart::forEachOfBody(int body, const Visit& visit) const
{
    const int number = whole_.general.member(body);
    if (number < 0) return visit(body);
    const auto [first, end] = whole_.general.besides(number);
    for (std::size_t k = first; k < end; ++k) visit(whole_.general.members[k].body);
}

/// Each body once, ascending.
void AwakePart::addWholeClumps()
{
    const std::vector<int> some = bodies_;
    if (!whole_.general.empty())
    {
        for (int body : some) forEachOfBody(body, [&](int member) { bodies_.push_back(member); });
    }
    std::sort(bodies_.begin(), bodies_.end());
    bodies_.erase(std::unique(bodies_.begin(), bodies_.end()), bodies_.end());
}

/// The clumps of the part's bodies. On several ranks it has all, and they keep their places.
void AwakePart::addGeneral(ContactList& part)
{
    const GeneralBodies& whole = whole_.general;
    if (whole.empty()) return;
    if (whole.halo.isParallel())
    {
        part.general = whole;
        return;
    }
    std::vector<int> numbers;
    for (int body : bodies_)
    {
        if (whole.member(body) >= 0) numbers.push_back(whole.member(body));
    }
    std::sort(numbers.begin(), numbers.end());
    part.general.isThere = true;
    part.general.memberOf.assign(bodies_.size(), -1);
    for (int number : numbers)
    {
        GeneralMember member = whole.members[number];
        const int clump = whole.clumpOf[member.owner];
        if (part.general.clumpOf.empty() || part.general.clumpOf.back() != clump) part.general.clumpOf.push_back(clump);
        member.owner = static_cast<int>(part.general.clumpOf.size()) - 1;
        member.body = static_cast<int>(std::lower_bound(bodies_.begin(), bodies_.end(), member.body) - bodies_.begin());
        part.general.memberOf[member.body] = static_cast<int>(part.general.members.size());
        part.general.members.push_back(member);
    }
    part.general.ownMembers = part.general.members.size();
    part.general.bodies.resize(part.general.clumpOf.size());
}

void AwakePart::addBodies(ContactList& part) const
{
    for (int body : bodies_)
    {
        part.position.push_back(whole_.position[body]);
        part.radius.push_back(whole_.radius[body]);
        part.inverseMass.push_back(isAwake_[body] ? whole_.inverseMass[body] : 0.0);
        part.id.push_back(whole_.id[body]);
        if (body >= whole_.owned()) continue;
        part.grainOf.push_back(whole_.grainOf[body]);
        part.positionAtBuild.push_back(whole_.positionAtBuild[body]);
        part.reach.push_back(whole_.reach[body]);
        part.slack.push_back(whole_.slack[body]);
        if (!whole_.path.empty()) part.path.push_back(whole_.path[body]);
    }
}

std::vector<int> AwakePart::sleepersAround(const std::vector<int>& grains, int rings, const GrainSleep& sleep, double deadBand) const
{
    std::vector<int> found;   // bodies
    std::vector<std::uint8_t> isFound(whole_.owned(), 0);
    const auto add = [&](int body)
    {
        if (isFound[body]) return;
        isFound[body] = 1;
        found.push_back(body);
    };
    for (int i : grains) forEachOfBody(bodyOf_[i], add);
    std::size_t first = 0;
    for (int ring = 0; ring < rings; ++ring)
    {
        const std::size_t last = found.size();
        for (; first < last; ++first)
        {
            const int body = found[first];
            for (std::uint32_t k = slotStart_[body]; k < slotStart_[body + 1]; ++k)
            {
                const int other = otherBody(slots_[k], body);
                if (other >= whole_.owned() || whole_.inverseMass[other] == 0.0) continue;
                const bool isClosed = whole_.gap[slots_[k]] <= deadBand || impulse(whole_, slots_[k]) != Vec3::Zero();
                if (isClosed && sleep.isAsleep(whole_.grainOf[other])) forEachOfBody(other, add);
            }
        }
    }
    for (int& body : found) body = whole_.grainOf[body];
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<int> AwakePart::sleepersBesideDriven(const Grains& grains, const GrainSleep& sleep) const
{
    std::vector<int> found;
    for (int body = 0; body < whole_.owned(); ++body)
    {
        const int driven = whole_.grainOf[body];
        if (!grains.isFixed[driven] || sleep.isAsleep(driven)) continue;
        for (std::uint32_t k = slotStart_[body]; k < slotStart_[body + 1]; ++k)
        {
            const int other = otherBody(slots_[k], body);
            if (other >= whole_.owned()) continue;
            const int i = whole_.grainOf[other];
            if (sleep.isAsleep(i) && !grains.isFixed[i]) found.push_back(i);
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

} // namespace nscd
