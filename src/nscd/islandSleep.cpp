// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Islands by union and find over closed contacts.
#include "islandSleep.hpp"

#include <algorithm>
#include <numeric>

namespace nscd
{

namespace
{

constexpr int noIsland = -1;

Vec3 entry(const std::vector<Vec3>& values, std::size_t i) { return values.empty() ? Vec3(Vec3::Zero()) : values[i]; }

/// Sets of bodies that merge.
class DisjointSets
{
public:
    explicit DisjointSets(int size)
    :
        parent_(size)
    {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    int find(int k)
    {
        while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
        return k;
    }

    void join(int a, int b) { parent_[find(a)] = find(b); }

private:
    std::vector<int> parent_;
};

/// Calls visit(slot, a, b) for slots in which two bodies touch.
template<class Visit>
void forEachClosed(const ContactList& list, double deadBand, const Visit& visit)
{
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (!list.isUsed(slot) || (list.gap[slot] > deadBand && impulse(list, slot) == Vec3::Zero())) continue;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        visit(block.a[slot % blockLanes], block.b[slot % blockLanes]);
    }
}

} // namespace

void IslandSleep::wakeIslands(const std::unordered_set<int>& islands)
{
    if (islands.empty()) return;
    isEverybodyAsleep_ = false;
    for (std::size_t i = 0; i < isAsleep_.size(); ++i)
    {
        if (!isAsleep_[i] || islands.count(island_[i]) == 0) continue;
        isAsleep_[i] = 0;
        quietSteps_[i] = 0;
        --asleep_;
    }
}

void IslandSleep::wakeByForces(const Grains& grains, const ExternalForces& forces, double deltaT)
{
    std::unordered_set<int> disturbed;
    for (std::size_t i = 0; i < isAsleep_.size(); ++i)
    {
        if (!isAsleep_[i]) continue;
        const double limit = disturbance*speedScale_*grains.mass[i]/deltaT;
        const double change2 = (entry(forces.force, i) - force_[i]).squaredNorm();
        const double spin2 = (entry(forces.torque, i) - torque_[i]).squaredNorm()/(grains.radius[i]*grains.radius[i]);
        if (!(change2 <= limit*limit && spin2 <= limit*limit)) disturbed.insert(island_[i]);
    }
    wakeIslands(disturbed);
}

bool IslandSleep::isMoving(const ContactList& list, int body) const
{
    if (body < list.owned() && isAsleep(list.grainOf[body])) return false;
    const Body& moved = list.bodies[body];
    return moved.invMass > 0.0 || Vec3(moved.v) != Vec3::Zero() || Vec3(moved.s) != Vec3::Zero();
}

bool IslandSleep::wakeByContacts(const ContactList& list, double deltaT, double deadBand)
{
    std::unordered_set<int> touched;
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const int a = block.a[slot % blockLanes], b = block.b[slot % blockLanes];
        if (a == list.staticBody()) continue;
        const bool isMovingA = isMoving(list, a), isMovingB = isMoving(list, b);
        if (isMovingA == isMovingB) continue;
        const int sleeper = isMovingA ? b : a;
        if (sleeper >= list.owned() || !isAsleep(list.grainOf[sleeper])) continue;
        const double closing = -deltaT*normal(list, slot).dot(Vec3(list.bodies[a].v) - Vec3(list.bodies[b].v));
        if (impulse(list, slot) != Vec3::Zero() || list.gap[slot] <= std::max(deadBand, closing)) touched.insert(island_[list.grainOf[sleeper]]);
    }
    wakeIslands(touched);
    return !touched.empty();
}

void IslandSleep::countQuietSteps(const Grains& grains, double limit)
{
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const double spin2 = grains.radius[i]*grains.radius[i]*grains.omega[i].squaredNorm();
        const bool isQuiet = grains.velocity[i].squaredNorm() <= limit*limit && spin2 <= limit*limit;
        quietSteps_[i] = isQuiet ? quietSteps_[i] + 1 : 0;
    }
}

std::vector<int> IslandSleep::quietIslands(const ContactList& list, const Grains& grains, double deadBand) const
{
    DisjointSets sets(list.owned());
    std::vector<std::uint8_t> isRestless(list.owned(), 0);
    for (int body = 0; body < list.owned(); ++body)
    {
        const int i = list.grainOf[body];
        isRestless[body] = !isAsleep_[i] && (grains.isFixed[i] || quietSteps_[i] < stepsToSleep);
    }
    forEachClosed(list, deadBand, [&](int a, int b)
    {
        const auto isFreeGrain = [&](int body) { return body < list.owned() && !grains.isFixed[list.grainOf[body]]; };
        if (isFreeGrain(a) && isFreeGrain(b)) sets.join(a, b);
        else if (isFreeGrain(a) && isMoving(list, b)) isRestless[a] = 1;
        else if (isFreeGrain(b) && isMoving(list, a)) isRestless[b] = 1;
    });
    for (int body = 0; body < list.owned(); ++body)
    {
        if (isRestless[body]) isRestless[sets.find(body)] = 1;
    }
    std::vector<int> island(list.owned());
    for (int body = 0; body < list.owned(); ++body) island[body] = isRestless[sets.find(body)] ? noIsland : sets.find(body);
    return island;
}

bool IslandSleep::isEverythingStill(const Grains& grains) const
{
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const bool isHeldStill = grains.isFixed[i] && grains.velocity[i] == Vec3::Zero() && grains.omega[i] == Vec3::Zero();
        if (!isAsleep_[i] && !isHeldStill) return false;
    }
    return true;
}

void IslandSleep::fallAsleep(const ContactList& list, Grains& grains, const ExternalForces& forces, double speedScale, double deadBand)
{
    const std::size_t n = grains.size();
    quietSteps_.resize(n, 0);
    countQuietSteps(grains, restSpeed*speedScale);
    if (++steps_ % stepsToSleep != 0) return;
    if (std::none_of(quietSteps_.begin(), quietSteps_.end(), [](int steps) { return steps >= stepsToSleep; })) return;

    isAsleep_.resize(n, 0);
    island_.resize(n, noIsland);
    force_.resize(n);
    torque_.resize(n);
    const std::vector<int> island = quietIslands(list, grains, deadBand);
    for (int body = 0; body < list.owned(); ++body)
    {
        const int i = list.grainOf[body];
        if (isAsleep_[i] || island[body] == noIsland) continue;
        isAsleep_[i] = 1;
        ++asleep_;
        island_[i] = firstIsland_ + island[body];
        force_[i] = entry(forces.force, i);
        torque_[i] = entry(forces.torque, i);
        grains.velocity[i].setZero();
        grains.omega[i].setZero();
    }
    firstIsland_ += list.owned();
    speedScale_ = speedScale;
    isEverybodyAsleep_ = isEverythingStill(grains);
}

} // namespace nscd
