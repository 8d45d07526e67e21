// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// How far lists have to look, and steps in which grains may go through outlined walls, if nobody looks.
// Tested by tests/unit/nscd/step/stopsOnWayTest.cpp, tests/unit/nscd/step/fastFlowTest.cpp, tests/parallel/listsByPathsTest.cpp
#include "nscd/step/grainDynamicsParts.hpp"

#include "nscd/base/formattedText.hpp"
#include "nscd/base/invalidValue.hpp"
#include "nscd/contacts/strays.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

/// Mean diameters that a flow moves on by in a step to be looked at as one.
constexpr double fastFlow = 0.5;
/// A grain that falls is off its path by one dt a dt after a step, by 1 + 2 after two. What the skin holds of that lists need not allow for.
constexpr double fallsOfTwoSteps = 3.0;
/// Grains that may be followed before a list is built anew: a share of all, and some.
constexpr double mostStrays = 0.03;
constexpr std::size_t fewStrays = 8;
/// Of impacts, up to which lists are made by paths: by speeds, a second list of a step of rain on a bed had 250 candidates a grain.
constexpr double widestMargin = 2.0;

} // namespace

/// Pairs are listed for the nearest images on each side alone.
void GrainDynamics::Implementation::refuseBeyondPeriods(const std::vector<Vec3>& velocity, const Vec3& mean) const
{
    Vec3 fastest = Vec3::Zero();
    for (const Vec3& v : velocity) fastest = fastest.cwiseMax((v - mean).cwiseAbs());
    exchange->max(fastest.data(), 3);
    for (int axis = 0; axis < 3; ++axis)
    {
        if (!box.isPeriodic(axis) || deltaT*fastest[axis] <= box.length[axis]) continue;
        const std::string what = "way of a grain in a step along periodic axis " + std::to_string(axis) + ", relative to the mean of all,";
        throw invalidValue(what, deltaT*fastest[axis], "at most the period, " + formatted("%.3g", box.length[axis]) + " m: use a smaller time step");
    }
}

ListPlan GrainDynamics::Implementation::planList(const std::vector<Vec3>& velocity, double margin) const
{
    double sums[5] = {0.0, static_cast<double>(velocity.size()), 0.0, 0.0, 0.0};
    for (const Vec3& v : velocity)
    {
        sums[0] += v.squaredNorm();
        Eigen::Map<Vec3>(&sums[2]) += v;
    }
    exchange->sum(sums, 5);
    const double number = std::max(1.0, sums[1]), commonSpeed = std::sqrt(sums[0]/number);
    if (!std::isfinite(commonSpeed)) throw invalidValue("rms speed of grains", commonSpeed, "a finite value [m/s]");
    const double time = stepsPerList*deltaT;
    const Vec3 mean = Vec3(sums[2], sums[3], sums[4])/number;
    if (margin == 1.0 && box.any()) refuseBeyondPeriods(velocity, mean);
    // Grains that walls stop may leave their paths where walls take them along, or stay behind by so much that the nearest images of paths do not tell
    // who is near: what stops behind those of another rank would not find them.
    const bool mayLeavePaths = areWallsOutlined && (box.any() || walls.anyMotion());
    if (mayLeavePaths && exchange->isParallel()) return planBySpeeds(velocity, commonSpeed, time, margin);
    // Over many steps grains do not fly straight, nor where impacts were far from what was foreseen.
    if (margin <= widestMargin && !isListStale && stepsPerList == fewestStepsPerList)
    {
        return planByPaths(list, velocity, mean, diameter, deltaT, {fallsBeyondSkin(), margin, areListsLong, mayFollowStrays(), areNearOthers()});
    }
    if (deltaT*mean.norm() <= fastFlow*diameter) return planBySpeeds(velocity, commonSpeed, time, margin);
    return planAroundMean(velocity, mean, std::sqrt(std::max(0.0, sums[0]/number - mean.squaredNorm())), time, margin);
}

std::vector<double> GrainDynamics::Implementation::fallsBeyondSkin() const
{
    std::vector<double> beyond(fall.size());
    const double held = skinOfGrain()/(fallsOfTwoSteps*deltaT), longer = impulseDeltaT > 0.0 ? deltaT/impulseDeltaT : 1.0;
    std::transform(fall.begin(), fall.end(), beyond.begin(), [=](double change) { return longer*change > held ? longer*change : 0.0; });
    return beyond;
}

/// Where lists are long, a new one costs much. Not where walls move, or where laws act by the impulses at the start of a step. The same on all ranks.
bool GrainDynamics::Implementation::mayFollowStrays() const
{
    return areListsLong && !sleep.any() && list.general.empty() && list.wallReach.empty() && !list.laws.areOfStart();
}

/// Of grains: empty where strays are not followed anyway. A diameter is about what strays go beyond what the last list held.
std::vector<char> GrainDynamics::Implementation::areNearOthers() const
{
    std::vector<char> areNear;
    if (!exchange->isParallel() || !mayFollowStrays()) return areNear;
    for (const Vec3& x : grains.position) areNear.push_back(!exchange->isAwayFromOthers(box.wrap(x), diameter));
    return areNear;
}

/// What ranks do each for itself.
GrainDynamics::Implementation::Coverage GrainDynamics::Implementation::coverHere()
{
    const std::size_t most = static_cast<std::size_t>(mostStrays*static_cast<double>(grains.size())) + fewStrays, first = list.freeBlock;
    const std::vector<int> strays = findStrays(list, deltaT, most);
    if (strays.empty()) return Coverage::whole;
    if (strays.size() > most || !isWithinTime(list, deltaT)) return Coverage::none;
    if (!followStrays(list, strays, scene(), *wallSearch, *exchange, deltaT) || list.strays.size() > most) return Coverage::none;
    if (areWallsOutlined) isAnyFast = isAnyFast || areAnyFast(list, strays);
    return doAnyTouch(list, scene(), first, deltaT) ? Coverage::mended : Coverage::whole;
}

GrainDynamics::Implementation::Coverage GrainDynamics::Implementation::coverOrMend()
{
    const auto timer = times.time(GrainPart::findPairs);
    if (!mayFollowStrays() || areManyLeftOut) return coversStep() ? Coverage::whole : Coverage::none;
    const bool wasAnyFast = isAnyFast;
    double worst[2] = {static_cast<double>(coverHere()), isAnyFast ? 1.0 : 0.0};
    list.halo.max(worst, 2);
    isAnyFast = worst[1] > 0.0;
    // Where grains may be stopped, pairs of two ranks are listed otherwise.
    if (exchange->isParallel() && isAnyFast && !wasAnyFast) return Coverage::none;
    return static_cast<Coverage>(static_cast<int>(worst[0]));
}

WallsOfStep GrainDynamics::Implementation::wallsOfStep() const
{
    const double tolerance = (settings.deadBand + settings.displacementTolerance + settings.overlapTolerance)*diameter;
    return {scene(), *wallSearch, movingWalls, reachToMany, tolerance, reachAtRest()};
}

void GrainDynamics::Implementation::lookForFast(const ListPlan& plan, const std::vector<double>& reach, const std::vector<WallReach>& wallReach)
{
    isAnyFast = exchange->any(areAnyFast(grains, reach, wallReach));
    atMissedWalls.clear();
    reachToMany = isAnyFast ? reachesToMany(grains, *wallSearch, plan.speed, deltaT, reachAtRest()) : std::vector<double>();
    areManyLeftOut = isAnyFast && exchange->any(!reachToMany.empty());
}

double GrainDynamics::Implementation::moveBodies(StepReport& report)
{
    areSomeStopped = false;
    if (!isAnyFast) return moveGrains(list, grains, box, deltaT, isFrictional);
    const std::vector<Stop> stops = findStops(list, wallsOfStep(), deltaT);
    const double displacement = moveGrains(list, grains, box, deltaT, isFrictional);
    for (const Stop& stop : stops)
    {
        list.position[stop.body] += stop.way - deltaT*Vec3(list.bodies[stop.body].v);
        grains.position[list.grainOf[stop.body]] = box.wrap(list.position[stop.body]);
    }
    report.stoppedOnWay = static_cast<std::size_t>(list.halo.sum(static_cast<double>(stops.size())));
    areSomeStopped = report.stoppedOnWay > 0;
    list.halo.give(list.position);
    return displacement;
}

} // namespace nscd
