// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The names of the numbers.
#include "coupling/case/files/entryNumbers.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

const word nextId = "nextId";

/// Calls visit(name, value) for each number of a state.
template<class State, class Visit>
void forEachNumber(State& state, const Visit& visit)
{
    visit("due", state.due);
    visit("entered", state.entered);
    visit("tried", state.tried);
    visit("dueMass", state.dueMass);
    visit("enteredMass", state.enteredMass);
}

word nameOf(const nscd::EntrySource& source, const char* number) { return word("entry." + source.name + "." + number, false); }

} // namespace


void addEntries(const nscd::GrainEntry& entry, RunNumbers& numbers)
{
    numbers[nextId] = scalar(entry.nextId());
    for (std::size_t s = 0; s < entry.sources().size(); ++s)
    {
        forEachNumber(entry.states()[s], [&](const char* name, auto value) { numbers[nameOf(entry.sources()[s], name)] = scalar(value); });
    }
}


std::vector<nscd::EntryState> entryStates(const std::vector<nscd::EntrySource>& sources, const RunNumbers& numbers)
{
    std::vector<nscd::EntryState> states(sources.size());
    for (std::size_t s = 0; s < sources.size(); ++s)
    {
        forEachNumber(states[s], [&](const char* name, auto& value)
        {
            const auto written = numbers.find(nameOf(sources[s], name));
            if (written != numbers.end()) value = static_cast<std::decay_t<decltype(value)>>(written->second);
        });
    }
    return states;
}


std::int64_t nextIdentity(const nscd::Grains& grains, const RunNumbers& numbers, const nscd::Exchange& exchange)
{
    const auto written = numbers.find(nextId);
    if (written != numbers.end()) return static_cast<std::int64_t>(written->second);
    double largest = -1;
    for (const std::int64_t id : grains.id) largest = std::max(largest, double(id));
    exchange.max(&largest, 1);
    return static_cast<std::int64_t>(largest) + 1;
}

} // namespace nscdCoupling
} // namespace Foam
