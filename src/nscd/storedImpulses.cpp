// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Look-up of impulses by pairs of grains.
#include "storedImpulses.hpp"

#include <numeric>
#include <unordered_map>

namespace nscd
{

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

std::unordered_map<std::int64_t, int> numberById(const std::vector<GhostGrain>& ghosts)
{
    std::unordered_map<std::int64_t, int> number;
    for (std::size_t g = 0; g < ghosts.size(); ++g) number[ghosts[g].id] = static_cast<int>(g);
    return number;
}

/// What other ranks solve now goes to them; what they had that is solved here comes back.
std::vector<InterfaceImpulse> handOver(const ContactList& list, const std::vector<InterfaceImpulse>& impulses, Exchange& exchange)
{
    std::vector<std::int64_t> idOf(list.owned());
    for (int body = 0; body < list.owned(); ++body) idOf[list.grainOf[body]] = list.id[body];
    const std::unordered_map<std::int64_t, int> elsewhere = numberById(list.solvedElsewhere);
    std::vector<InterfaceImpulse> here;
    std::vector<ImpulseForOwner> away;
    for (const InterfaceImpulse& entry : impulses)
    {
        const auto ghost = elsewhere.find(entry.id);
        if (ghost == elsewhere.end())
        {
            here.push_back(entry);
            continue;
        }
        const GhostGrain& other = list.solvedElsewhere[ghost->second];
        away.push_back({other.owner, other.index, idOf[entry.own], -entry.impulse});
    }
    for (const ImpulseForOwner& entry : exchange.deliver(away)) here.push_back({entry.index, entry.id, entry.impulse});
    return here;
}

/// Impulses between own grains and ghosts of this list, these numbered as ContactList::grain does.
void addInterface(const ContactList& list, const std::vector<InterfaceImpulse>& impulses, std::vector<PairImpulse>& pairs)
{
    const std::unordered_map<std::int64_t, int> number = numberById(list.ghosts);
    for (const InterfaceImpulse& entry : impulses)
    {
        const auto ghost = number.find(entry.id);
        if (ghost != number.end()) pairs.push_back({entry.own, list.owned() + ghost->second, entry.impulse});
    }
}

/// Calls visit(slot, impulse of its pair) for slots that carry one.
template<class Visit>
void forEachLoaded(const ContactList& list, const Visit& visit)
{
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (!list.isUsed(slot)) continue;
        const Vec3 r = impulse(list, slot);
        if (r == Vec3::Zero()) continue;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const int wall = list.wall[slot];
        const int b = wall >= 0 ? -1 - wall : list.grain(block.b[slot % blockLanes]);
        visit(slot, PairImpulse{list.grain(block.a[slot % blockLanes]), b, r});
    }
}

void assignPairs(ContactList& list, const std::vector<PairImpulse>& impulses)
{
    if (impulses.empty()) return;
    ImpulsesByGrain table = groupByGrain(impulses, list.grainOf.size());
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (!list.isUsed(slot)) continue;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const int grainA = list.grain(block.a[slot % blockLanes]);
        const int grainB = list.wall[slot] >= 0 ? -1 - list.wall[slot] : list.grain(block.b[slot % blockLanes]);
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

} // namespace

std::vector<SlotImpulse> loadedSlots(const ContactList& list)
{
    std::vector<SlotImpulse> loaded;
    forEachLoaded(list, [&](std::size_t slot, const PairImpulse& pair) { loaded.push_back({slot, pair}); });
    return loaded;
}

ImpulseRecord collectImpulses(const ContactList& list)
{
    ImpulseRecord record;
    forEachLoaded(list, [&](std::size_t, const PairImpulse& pair)
    {
        const int ghost = pair.b - list.owned();
        if (ghost < 0) record.inner.push_back(pair);
        else record.interface.push_back({pair.a, list.ghosts[ghost].id, pair.impulse});
    });
    return record;
}

void assignImpulses(ContactList& list, ImpulseRecord record, Exchange& exchange)
{
    if (exchange.isParallel()) addInterface(list, handOver(list, record.interface, exchange), record.inner);
    assignPairs(list, record.inner);
}

std::vector<StoredImpulse> byIdentity(const ImpulseRecord& record, const Grains& grains)
{
    std::vector<StoredImpulse> stored;
    stored.reserve(record.inner.size() + record.interface.size());
    for (const PairImpulse& entry : record.inner)
    {
        stored.push_back({grains.id[entry.a], entry.b >= 0 ? grains.id[entry.b] : entry.b, entry.impulse});
    }
    for (const InterfaceImpulse& entry : record.interface) stored.push_back({grains.id[entry.own], entry.id, entry.impulse});
    return stored;
}

ImpulseRecord byIndex(const std::vector<StoredImpulse>& impulses, const Grains& grains)
{
    std::unordered_map<std::int64_t, int> indexOf;
    for (std::size_t i = 0; i < grains.size(); ++i) indexOf[grains.id[i]] = static_cast<int>(i);
    ImpulseRecord record;
    for (const StoredImpulse& entry : impulses)
    {
        const auto a = indexOf.find(entry.idA);
        const auto b = indexOf.find(entry.idB);
        const bool isWall = entry.idB < 0;
        if (a != indexOf.end() && (isWall || b != indexOf.end()))
        {
            record.inner.push_back({a->second, isWall ? static_cast<int>(entry.idB) : b->second, entry.impulse});
        }
        else if (a != indexOf.end()) record.interface.push_back({a->second, entry.idB, entry.impulse});
        else if (b != indexOf.end()) record.interface.push_back({b->second, entry.idA, -entry.impulse});
    }
    return record;
}

} // namespace nscd
