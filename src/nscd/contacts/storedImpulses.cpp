// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Look-up of impulses by pairs of grains.
#include "nscd/contacts/storedImpulses.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace nscd
{

namespace
{

/// Impulses by their bodies' numbers instead of grains', so that what is near in space is near in memory; grouped by the lower one, and
/// on that one.
struct ImpulsesByBody
{
    std::vector<int> start;
    std::vector<PairImpulse> entries;
    std::vector<LawImpulses> ofLaws;   ///< of each entry, or empty
};

ImpulsesByBody groupByBody(const ContactList& list, const std::vector<PairImpulse>& impulses, const std::vector<LawImpulses>& ofLaws)
{
    std::vector<int> bodyOf(list.owned());
    for (int body = 0; body < list.owned(); ++body) bodyOf[list.grainOf[body]] = body;
    const auto number = [&](int grain) { return grain >= 0 && grain < list.owned() ? bodyOf[grain] : grain; };
    const auto isSwapped = [](int a, int b) { return b >= 0 && b < a; };

    ImpulsesByBody table;
    table.start.assign(list.firstWallBody() + 2, 0);
    table.entries.resize(impulses.size());
    table.ofLaws.resize(ofLaws.size());
    for (const PairImpulse& entry : impulses)
    {
        const int a = number(entry.a), b = number(entry.b);
        ++table.start[(isSwapped(a, b) ? b : a) + 2];
    }
    // Shifted by one: filling moves each start on to where its group ends, which is where the next one starts.
    std::partial_sum(table.start.begin(), table.start.end(), table.start.begin());
    for (std::size_t k = 0; k < impulses.size(); ++k)
    {
        const int a = number(impulses[k].a), b = number(impulses[k].b);
        const bool swap = isSwapped(a, b);
        const int place = table.start[(swap ? b : a) + 1]++;
        table.entries[place] = swap ? PairImpulse{b, a, -impulses[k].impulse} : PairImpulse{a, b, impulses[k].impulse};
        if (!ofLaws.empty()) table.ofLaws[place] = swap ? -ofLaws[k] : ofLaws[k];
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
/// `value(k)`: the impulse of entry k to be handed over, its own or a law's.
template<class Value>
std::vector<InterfaceImpulse> handOver
(
    const ContactList& list, const std::vector<InterfaceImpulse>& impulses, const Value& value, Exchange& exchange
)
{
    std::vector<std::int64_t> idOf(list.owned());
    for (int body = 0; body < list.owned(); ++body) idOf[list.grainOf[body]] = list.id[body];
    const std::unordered_map<std::int64_t, int> elsewhere = numberById(list.solvedElsewhere);
    std::vector<InterfaceImpulse> here;
    std::vector<ImpulseForOwner> away;
    for (std::size_t k = 0; k < impulses.size(); ++k)
    {
        const InterfaceImpulse& entry = impulses[k];
        const auto ghost = elsewhere.find(entry.id);
        if (ghost == elsewhere.end())
        {
            here.push_back({entry.own, entry.id, value(k)});
            continue;
        }
        const GhostGrain& other = list.solvedElsewhere[ghost->second];
        away.push_back({other.owner, other.index, idOf[entry.own], -value(k)});
    }
    for (const ImpulseForOwner& entry : exchange.deliver(away)) here.push_back({entry.index, entry.id, entry.impulse});
    return here;
}

/// Adds impulses between own grains and ghosts of this list, these numbered as ContactList::grain does, to the inner ones.
void addInterface(const ContactList& list, ImpulseRecord& record, Exchange& exchange)
{
    const std::vector<InterfaceImpulse>& entries = record.interface;
    const std::vector<InterfaceImpulse> here = handOver(list, entries, [&](std::size_t k) { return entries[k].impulse; }, exchange);
    std::vector<LawImpulses> ofLaws(list.laws.haveImpulses() ? here.size() : 0, noLawImpulses());
    for (std::size_t m = 0; m < lawImpulses && list.laws.haveImpulses(); ++m)
    {
        const auto one = handOver(list, entries, [&](std::size_t k) { return record.interfaceOfLaws[k][m]; }, exchange);
        for (std::size_t k = 0; k < one.size(); ++k) ofLaws[k][m] = one[k].impulse;
    }

    const std::unordered_map<std::int64_t, int> number = numberById(list.ghosts);
    for (std::size_t k = 0; k < here.size(); ++k)
    {
        const auto ghost = number.find(here[k].id);
        if (ghost == number.end()) continue;
        record.inner.push_back({here[k].own, list.owned() + ghost->second, here[k].impulse});
        if (!ofLaws.empty()) record.innerOfLaws.push_back(ofLaws[k]);
    }
}

/// Calls visit(slot, impulse of its pair) for slots that carry one or, when asked for, attract.
template<class Visit>
void forEachLoaded(const ContactList& list, bool withAttracting, const Visit& visit)
{
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        const Vec3 r = impulse(list, slot);
        if (!list.isUsed(slot)) continue;
        if (r == Vec3::Zero() && !(withAttracting && list.laws.known(slot) != Vec3::Zero())) continue;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const int wall = list.wall[slot];
        const int b = wall >= 0 ? -1 - wall : list.grain(block.b[slot % blockLanes]);
        visit(slot, PairImpulse{list.grain(block.a[slot % blockLanes]), b, r});
    }
}

/// Of several images of a pair, the entry best aligned with normal n.
PairImpulse* findBest(ImpulsesByBody& table, int first, int second, const Vec3& n)
{
    PairImpulse* best = nullptr;
    for (int k = table.start[first]; k < table.start[first + 1]; ++k)
    {
        PairImpulse& entry = table.entries[k];
        if (entry.b != second || !(entry.impulse.dot(n) > 0.0)) continue;
        if (!best || entry.impulse.dot(n) > best->impulse.dot(n)) best = &entry;
    }
    return best;
}

void assignPairs(ContactList& list, const ImpulseRecord& record)
{
    if (record.inner.empty()) return;
    ImpulsesByBody table = groupByBody(list, record.inner, record.innerOfLaws);
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (!list.isUsed(slot)) continue;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const int a = list.ownBody(block.a[slot % blockLanes]);
        const int b = list.wall[slot] >= 0 ? -1 - list.wall[slot] : list.ownBody(block.b[slot % blockLanes]);
        const bool isSwapped = b >= 0 && b < a;
        const Vec3 n = (isSwapped ? -1.0 : 1.0)*normal(list, slot);
        PairImpulse* const best = isSwapped ? findBest(table, b, a, n) : findBest(table, a, b, n);
        if (!best) continue;
        setImpulse(list, slot, isSwapped ? Vec3(-best->impulse) : best->impulse);
        if (list.laws.haveImpulses())
        {
            const LawImpulses& ofLaws = table.ofLaws[best - table.entries.data()];
            list.laws.setImpulses(slot, isSwapped ? -ofLaws : ofLaws);
        }
        best->impulse.setZero();
    }
}

} // namespace

std::vector<SlotImpulse> loadedSlots(const ContactList& list)
{
    std::vector<SlotImpulse> loaded;
    forEachLoaded(list, true, [&](std::size_t slot, const PairImpulse& pair) { loaded.push_back({slot, pair}); });
    return loaded;
}

ImpulseRecord collectImpulses(const ContactList& list)
{
    ImpulseRecord record;
    record.inner.reserve(list.candidates);
    forEachLoaded(list, false, [&](std::size_t slot, const PairImpulse& pair)
    {
        const int ghost = pair.b - list.owned();
        if (ghost < 0) record.inner.push_back(pair);
        else record.interface.push_back({pair.a, list.ghosts[ghost].id, pair.impulse});
        if (list.laws.haveImpulses()) (ghost < 0 ? record.innerOfLaws : record.interfaceOfLaws).push_back(list.laws.impulses(slot));
    });
    return record;
}

void assignImpulses(ContactList& list, ImpulseRecord record, Exchange& exchange)
{
    // What is restored may have been stored without.
    const bool areKept = list.laws.haveImpulses();
    record.innerOfLaws.resize(areKept ? record.inner.size() : 0, noLawImpulses());
    record.interfaceOfLaws.resize(areKept ? record.interface.size() : 0, noLawImpulses());
    if (exchange.isParallel()) addInterface(list, record, exchange);
    assignPairs(list, record);
}

std::vector<StoredImpulse> byIdentity(const ImpulseRecord& record, const Grains& grains)
{
    const auto entry = [](const std::vector<LawImpulses>& values, std::size_t k) { return values.empty() ? noLawImpulses() : values[k]; };
    std::vector<StoredImpulse> stored;
    stored.reserve(record.inner.size() + record.interface.size());
    for (std::size_t k = 0; k < record.inner.size(); ++k)
    {
        const PairImpulse& pair = record.inner[k];
        const std::int64_t idB = pair.b >= 0 ? grains.id[pair.b] : pair.b;
        stored.push_back({grains.id[pair.a], idB, pair.impulse, entry(record.innerOfLaws, k)});
    }
    for (std::size_t k = 0; k < record.interface.size(); ++k)
    {
        const InterfaceImpulse& pair = record.interface[k];
        stored.push_back({grains.id[pair.own], pair.id, pair.impulse, entry(record.interfaceOfLaws, k)});
    }
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
        const bool hasA = a != indexOf.end();
        if (hasA && (isWall || b != indexOf.end()))
        {
            record.inner.push_back({a->second, isWall ? static_cast<int>(entry.idB) : b->second, entry.impulse});
            record.innerOfLaws.push_back(entry.ofLaws);
        }
        else if (hasA || b != indexOf.end())
        {
            record.interface.push_back
            ({
                hasA ? a->second : b->second, hasA ? entry.idB : entry.idA, hasA ? entry.impulse : Vec3(-entry.impulse)
            });
            record.interfaceOfLaws.push_back(hasA ? entry.ofLaws : -entry.ofLaws);
        }
    }
    return record;
}

} // namespace nscd
