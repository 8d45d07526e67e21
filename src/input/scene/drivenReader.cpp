// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading driven grains, and moving them.
#include "input/scene/drivenReader.hpp"

#include "input/scene/functionReader.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace input
{

namespace
{

/// Ascending.
std::vector<std::int64_t> readIds(const CheckedEntries& given)
{
    const std::vector<long> listed = given.integers("ids", 0);
    std::vector<std::int64_t> ids(listed.begin(), listed.end());
    std::sort(ids.begin(), ids.end());
    const auto twice = std::adjacent_find(ids.begin(), ids.end());
    if (twice != ids.end()) given.reject("ids", "names grain " + std::to_string(*twice) + " twice", "each grain once");
    return ids;
}

DrivenGroup readGroup(const CheckedEntries& list, const std::string& name, int emptyAxis)
{
    const CheckedEntries given(list.sub(name));
    DrivenGroup group;
    group.place = list.place(name);
    group.grains.ids = readIds(given);
    group.grains.velocity = readVectorFunction(given, "velocity", emptyAxis);
    if (given.found("omega")) group.grains.omega = readSpinFunction(given, "omega", emptyAxis);
    given.finish();
    return group;
}

} // namespace

std::vector<DrivenGroup> readDriven(const CheckedEntries& top, int emptyAxis)
{
    const Dictionary dict = top.subOrEmpty("driven");
    const CheckedEntries list(dict);
    std::vector<DrivenGroup> groups;
    std::set<std::int64_t> seen;
    for (const Entry& entry : dict.entries)
    {
        groups.push_back(readGroup(list, entry.keyword, emptyAxis));
        for (const std::int64_t id : groups.back().grains.ids)
        {
            if (!seen.insert(id).second) list.reject(entry.keyword, "drives grain " + std::to_string(id) + ", which another group drives too");
        }
    }
    return groups;
}

void holdDriven(const std::vector<DrivenGroup>& groups, nscd::Grains& grains, const nscd::Exchange& exchange, bool mayHaveLeft)
{
    double total = static_cast<double>(grains.size());
    exchange.sum(&total, 1);
    for (const DrivenGroup& group : groups)
    {
        double found = static_cast<double>(nscd::hold(group.grains, grains));
        exchange.sum(&found, 1);
        const double missing = static_cast<double>(group.grains.ids.size()) - found;
        if (missing == 0.0 || mayHaveLeft) continue;
        const std::string allowed = textOf("0 to ", static_cast<std::int64_t>(total) - 1, ", in the order of the sources");
        throw InputError({group.place, "names grains by ids that are not there", textOf(missing, " of its ids"), allowed});
    }
}

void driveGrains(const std::vector<DrivenGroup>& groups, nscd::GrainDynamics& dynamics, double from, double to)
{
    for (const DrivenGroup& group : groups)
    {
        try
        {
            nscd::drive(group.grains, dynamics, from, to);
        }
        catch (const std::invalid_argument& error)
        {
            throw InputError({group.place, std::string("cannot be followed: ") + error.what()});
        }
    }
}

bool letGo(const std::vector<DrivenGroup>& groups, nscd::Grains& grains)
{
    const auto isDriven = [&](std::int64_t id)
    {
        return std::any_of(groups.begin(), groups.end(), [=](const DrivenGroup& g) { return std::binary_search(g.grains.ids.begin(), g.grains.ids.end(), id); });
    };
    bool isAny = false;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        if (!grains.isFixed[i] || isDriven(grains.id[i])) continue;
        grains.isFixed[i] = 0;
        isAny = true;
    }
    return isAny;
}

bool HeldUntil::letGo
(
    double now, double deltaT, const std::vector<DrivenGroup>& groups, nscd::GrainDynamics& dynamics, const nscd::Exchange& exchange
)
{
    constexpr double roundOff = 1e-6;   // of sums of steps [steps]
    if (now < time_ - roundOff*deltaT) return false;
    time_ = std::numeric_limits<double>::infinity();
    nscd::Grains grains = dynamics.grains();
    if (!exchange.any(input::letGo(groups, grains))) return false;
    dynamics.setGrains(std::move(grains));
    return true;
}

} // namespace input
