// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Paths, impacts and speeds.
#include "nscd/step/listPlan.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

/// What an impact may change a grain's velocity by, in the largest difference between its velocity and those of the candidates it may meet: what a
/// heavy one does to it at once. Where strays are followed, less: at 0.8 in the bed that bubbles 37 of 24 750 grains are strays in a step for 6, and lists
/// hold 6.3 candidates a grain for 7.5; at 0.6 there are 390, and half as many lists again are built for them. Near other
/// ranks, where they are not followed, all of it, and as much as impacts do in the mean (rms): in that bed on two ranks 31 lists in 50 steps for 48, 4.6
/// candidates a grain for 4.3; with 1.5 times as much 30, and without the mean 36.
constexpr double impactShare = 1.0, impactShareOfStrays = 0.8;
/// Candidates that pass at more than this [d] give no impacts: fast grains and those around them would make each other candidates without end (rain on a
/// bed: 80 a grain in place of 21). With a quarter of it a collapse needs two lists in place of one.
constexpr double widestMiss = 1.0;
/// Steps that grains are expected to move on as they do. In a collapse lists cost 9 ms a step with 4; with 2 and 3 steps 16 and 13, and 5 gain nothing. Where
/// grains hit each other at speed, as in rain on a bed, one list for that long holds more candidates than two for half of it; long ones last no longer for it.
constexpr double mostSteps = 4.0, fewestSteps = 1.5, fewestStepsOfLongLists = 1.0;
/// How far impacts may throw grains off their paths in the mean (rms) [d] before lists are made for fewer steps: at first, and while lists are long.
constexpr double widestScatter = 0.5, widestScatterOfLongLists = 0.25;

/// Two bodies that may hit each other.
struct Impact
{
    int a, b;
    double way;        ///< until they pass within the miss [m]; < 0 where they do already
    double approach;   ///< along their present normal [m/s]
    double speed2;     ///< of one relative to the other, squared [m2/s2]
};

/// Pairs that pass within `miss` [m] at some instant of a time. Two bodies on straight paths come no nearer than along their present normal.
std::vector<Impact> foreseenImpacts(const ContactList& list, const std::vector<Vec3>& velocity, double time, double miss)
{
    std::vector<Vec3> ofBody(list.firstWallBody());
    for (int body = 0; body < list.firstWallBody(); ++body) ofBody[body] = body < list.owned() ? velocity[list.grainOf[body]] : Vec3(list.bodies[body].v);
    std::vector<Impact> impacts;
    impacts.reserve(list.candidates);
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const int a = block.a[slot % blockLanes], b = block.b[slot % blockLanes];
        if (b >= list.firstWallBody()) continue;
        const Vec3 u = ofBody[a] - ofBody[b];
        const Impact impact{a, b, list.gap[slot] - miss, -normal(list, slot).dot(u), u.squaredNorm()};
        if (impact.way <= std::max(0.0, time*impact.approach)) impacts.push_back(impact);
    }
    return impacts;
}

/// Of each grain: the speed at which impacts within a time may throw it off its path; by the time that is left after them, in the mean over all of it, where
/// `isByTimeLeft`. Of impacts between ranks one of these knows.
std::vector<double> speedsOf(const std::vector<Impact>& impacts, const ContactList& list, double time, bool isByTimeLeft)
{
    std::vector<double> relative2(list.firstWallBody(), 0.0);
    for (const Impact& impact : impacts)
    {
        const double approach = time*impact.approach;
        if (impact.way > approach) continue;
        const double share = isByTimeLeft && impact.way > 0.0 ? 1.0 - impact.way/approach : 1.0, speed2 = share*share*impact.speed2;
        relative2[impact.a] = std::max(relative2[impact.a], speed2);
        relative2[impact.b] = std::max(relative2[impact.b], speed2);
    }
    list.halo.takeLargest(relative2);
    std::vector<double> speed(list.owned());
    for (int body = 0; body < list.owned(); ++body) speed[list.grainOf[body]] = std::sqrt(relative2[body]);
    return speed;
}

/// Over all ranks.
double rms(const std::vector<double>& speeds, const Halo& halo)
{
    double sums[2] = {0.0, static_cast<double>(speeds.size())};
    for (double speed : speeds) sums[0] += speed*speed;
    halo.sum(sums, 2);
    return std::sqrt(sums[0]/std::max(1.0, sums[1]));
}

/// Steps for which impacts throw grains off their paths by `widest` [m] in the mean (rms), within limits.
double stepsOfPaths(double impacts, double widest, double fewest, double deltaT)
{
    const double scatter = deltaT*impacts;
    return mostSteps*scatter <= widest ? mostSteps : std::max(fewest, widest/scatter);
}

} // namespace

ListPlan planByPaths(const ContactList& list, const std::vector<Vec3>& velocity, const Vec3& mean, double diameter, double deltaT, const OffPaths& off)
{
    const double miss = widestMiss*diameter, widest = (off.areListsLong ? widestScatterOfLongLists : widestScatter)*diameter;
    ListPlan plan;
    const std::vector<Impact> foreseen = foreseenImpacts(list, velocity, mostSteps*deltaT, miss);
    plan.speed = speedsOf(foreseen, list, mostSteps*deltaT, false);
    const double impacts = rms(plan.speed, list.halo);
    double steps = stepsOfPaths(off.margin*impacts, widest, off.areListsLong ? fewestStepsOfLongLists : fewestSteps, deltaT);
    if (off.areStraysFollowed) steps = std::ceil(steps);
    if (off.areListsLong) plan.speed = speedsOf(foreseen, list, steps*deltaT, true);
    plan.expected.time = steps*deltaT;
    plan.expected.velocity = velocity;
    plan.expected.meanVelocity = mean;
    // After n steps a grain that falls is off its path by n (n + 1)/2 a dt^2.
    const double fallsOfMean = 0.5*(steps + 1.0);
    for (std::size_t i = 0; i < plan.speed.size(); ++i)
    {
        const bool isNear = !off.isNearOthers.empty() && off.isNearOthers[i] != 0;
        const double ofImpacts = off.margin*(off.areStraysFollowed && !isNear ? impactShareOfStrays : impactShare)*plan.speed[i];
        // Where impacts were not foreseen, one that was hit may have hit another.
        const double ofOthers = (isNear ? off.margin : off.margin - 1.0)*impacts;
        plan.speed[i] = velocity[i].norm() + std::max(ofImpacts, ofOthers) + (off.fall.empty() ? 0.0 : fallsOfMean*off.fall[i]);
    }
    return plan;
}

ListPlan planAroundMean(const std::vector<Vec3>& velocity, const Vec3& mean, double rms, double time, double margin)
{
    ListPlan plan;
    for (const Vec3& v : velocity) plan.speed.push_back(mean.norm() + margin*std::max((v - mean).norm(), rms));
    plan.expected.velocity.assign(velocity.size(), mean);
    plan.expected.meanVelocity = mean;
    plan.expected.time = time;
    return plan;
}

ListPlan planBySpeeds(const std::vector<Vec3>& velocity, double common, double time, double margin)
{
    ListPlan plan;
    for (const Vec3& v : velocity) plan.speed.push_back(margin*std::max(v.norm(), common));
    plan.expected.time = time;
    return plan;
}

} // namespace nscd
