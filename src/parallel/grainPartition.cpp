// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tickets of the grains go down the tree of ranks; their homes are told where they ended.
#include "parallel/grainPartition.hpp"

#include "nscd/base/invalidValue.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace nscd
{

namespace
{

struct Ticket
{
    std::array<double, 3> position;
    double weight;
    int home;   ///< rank
    int index;  ///< there
};

/// Where a cut is sought: in [lower, upper) along an axis.
struct Bracket
{
    int axis;
    double lower, upper;
    double weightBelow = 0.0;
    double weight = 0.0;  ///< inside
    double count = std::numeric_limits<double>::infinity();
};

// A round of the search divides the bracket by `parts` with one reduction; `maxRounds` of them divide by 2^52.
constexpr int parts = 16;
constexpr int maxRounds = 13;

void checkInput(const std::vector<Vec3>& position, const std::vector<double>& weight)
{
    if (weight.size() != position.size()) throw invalidValue("number of weights", weight.size(), std::to_string(position.size()));
    for (std::size_t i = 0; i < weight.size(); ++i)
    {
        const bool isWeight = weight[i] >= 0.0 && std::isfinite(weight[i]);
        if (!isWeight) throw invalidValue("weight of a grain", weight[i], "finite values >= 0");
        if (!position[i].allFinite()) throw invalidValue("position of a grain", position[i].transpose(), "finite values [m]");
    }
}

std::vector<Ticket> writeTickets(int home, const std::vector<Vec3>& position, const std::vector<double>& weight)
{
    std::vector<Ticket> tickets;
    tickets.reserve(position.size());
    for (std::size_t i = 0; i < position.size(); ++i)
    {
        const Vec3& x = position[i];
        tickets.push_back({{x[0], x[1], x[2]}, weight[i], home, static_cast<int>(i)});
    }
    return tickets;
}

/// The longest axis of the box around the group's tickets, and its ends; lower > upper without tickets.
Bracket longestAxis(const Communicator& group, const std::vector<Ticket>& tickets)
{
    std::array<double, 6> ends;
    ends.fill(-std::numeric_limits<double>::infinity());
    for (const Ticket& ticket : tickets)
    {
        for (int k = 0; k < 3; ++k)
        {
            ends[k] = std::max(ends[k], -ticket.position[k]);
            ends[k + 3] = std::max(ends[k + 3], ticket.position[k]);
        }
    }
    group.max(ends.data(), 6);
    int axis = 0;
    for (int k : {1, 2})
    {
        if (ends[k] + ends[k + 3] > ends[axis] + ends[axis + 3]) axis = k;
    }
    return {axis, -ends[axis], std::nextafter(ends[axis + 3], std::numeric_limits<double>::infinity())};
}

double targetBelow(const RankLevel& level, const std::vector<Ticket>& tickets)
{
    double total = 0.0;
    for (const Ticket& ticket : tickets) total += ticket.weight;
    level.group.sum(&total, 1);
    return total*level.lowSize/level.group.size();
}

std::array<double, parts + 1> edgesOf(const Bracket& bracket)
{
    std::array<double, parts + 1> edges;
    for (int p = 0; p <= parts; ++p) edges[p] = bracket.lower + (bracket.upper - bracket.lower)*p/parts;
    edges[parts] = bracket.upper;
    return edges;
}

/// Keeps the part of the bracket in which the weight below reaches `target`.
void narrow(Bracket& bracket, double target, const Communicator& group, const std::vector<Ticket>& tickets)
{
    const auto edges = edgesOf(bracket);
    std::array<double, 2*parts> sums{};  // weights, counts
    for (const Ticket& ticket : tickets)
    {
        const double x = ticket.position[bracket.axis];
        if (x < bracket.lower || x >= bracket.upper) continue;
        const auto part = std::upper_bound(edges.begin() + 1, edges.end() - 1, x) - (edges.begin() + 1);
        sums[part] += ticket.weight;
        sums[parts + part] += 1.0;
    }
    group.sum(sums.data(), 2*parts);

    int p = 0;
    while (p < parts - 1 && bracket.weightBelow + sums[p] < target) bracket.weightBelow += sums[p++];
    bracket.lower = edges[p];
    bracket.upper = edges[p + 1];
    bracket.weight = sums[p];
    bracket.count = sums[parts + p];
}

/// Tickets that stay on this rank's side of its group's cut, and those that come from the other.
std::vector<Ticket> halve(const RankLevel& level, std::vector<Ticket> tickets)
{
    Bracket bracket = longestAxis(level.group, tickets);
    if (bracket.lower > bracket.upper) return tickets;  // none in the group; its ends are infinite, and no number to reckon with
    const double target = targetBelow(level, tickets);
    for (int round = 0; round < maxRounds && bracket.count > 1.0; ++round) narrow(bracket, target, level.group, tickets);
    const bool isLowerNearer = target - bracket.weightBelow < bracket.weightBelow + bracket.weight - target;
    const double cut = isLowerNearer ? bracket.lower : bracket.upper;

    const auto stays = [&](const Ticket& ticket) { return (ticket.position[bracket.axis] < cut) == level.isLow(); };
    const auto leaving = std::stable_partition(tickets.begin(), tickets.end(), stays);
    const std::vector<Ticket> arrived = sendAcross(level, std::vector<Ticket>(leaving, tickets.end()));
    tickets.erase(leaving, tickets.end());
    tickets.insert(tickets.end(), arrived.begin(), arrived.end());
    return tickets;
}

/// Tells each ticket's home that the ticket ended here; returns where those of this rank's grains ended.
std::vector<int> tellHomes(const Communicator& all, const std::vector<Ticket>& tickets, std::size_t nOwn)
{
    std::vector<int> index, home;
    for (const Ticket& ticket : tickets)
    {
        index.push_back(ticket.index);
        home.push_back(ticket.home);
    }
    std::vector<int> destination(nOwn);
    for (const Message& message : all.exchange(messagesByRank(index, home)))
    {
        for (int i : valuesOf<int>({message})) destination[i] = message.rank;
    }
    return destination;
}

} // namespace

std::vector<int> partitionGrains(const RankTree& tree, const std::vector<Vec3>& position, const std::vector<double>& weight)
{
    checkInput(position, weight);
    std::vector<Ticket> tickets = writeTickets(tree.all().rank(), position, weight);
    for (const RankLevel& level : tree.levels()) tickets = halve(level, std::move(tickets));
    return tellHomes(tree.all(), tickets, position.size());
}

double imbalance(const Communicator& all, double load)
{
    double total = load, largest = load;
    all.sum(&total, 1);
    all.max(&largest, 1);
    return total > 0.0 ? largest*all.size()/total : 1.0;
}

} // namespace nscd
