// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Look-up of grains by identity.
#include "storedImpulses.hpp"

#include <unordered_map>

namespace nscd
{

std::vector<StoredImpulse> byIdentity(const std::vector<PairImpulse>& impulses, const Grains& grains)
{
    std::vector<StoredImpulse> stored;
    stored.reserve(impulses.size());
    for (const PairImpulse& entry : impulses)
    {
        stored.push_back({grains.id[entry.a], entry.b >= 0 ? grains.id[entry.b] : entry.b, entry.impulse});
    }
    return stored;
}

std::vector<PairImpulse> byIndex(const std::vector<StoredImpulse>& impulses, const Grains& grains)
{
    std::unordered_map<std::int64_t, int> indexOf;
    for (std::size_t i = 0; i < grains.size(); ++i) indexOf[grains.id[i]] = static_cast<int>(i);
    std::vector<PairImpulse> found;
    found.reserve(impulses.size());
    for (const StoredImpulse& entry : impulses)
    {
        const auto a = indexOf.find(entry.idA);
        const auto b = indexOf.find(entry.idB);
        if (a == indexOf.end() || (entry.idB >= 0 && b == indexOf.end())) continue;
        found.push_back({a->second, entry.idB >= 0 ? b->second : static_cast<int>(entry.idB), entry.impulse});
    }
    return found;
}

} // namespace nscd
