// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Ways given to ghosts, and the times at which these have to stop given back.
#include "nscd/step/stopsBetweenRanks.hpp"

#include "nscd/contacts/generalCandidates.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

/// What ranks know of each other's bodies, per body of the list.
struct WaysOnRanks
{
    std::vector<Vec3> way;     ///< of the whole step [m]
    std::vector<Vec3> end;     ///< way to where it stops [m]
    std::vector<Vec3> stop;    ///< time and wall of its stop

    WaysOnRanks(const WaysOfStep& ways, const std::vector<Stop>& stops)
    :
        way(ways.list.halo.bodies(), Vec3::Zero()),
        stop(ways.list.halo.bodies(), Vec3::Constant(never))
    {
        for (int body = 0; body < ways.list.owned(); ++body) way[body] = ways.deltaT*Vec3(ways.list.bodies[body].v);
        end = way;
        for (const Stop& s : stops)
        {
            end[s.body] = s.way;
            stop[s.body] = Vec3(s.time, s.wall, 0.0);
        }
        for (std::vector<Vec3>* values : {&way, &end, &stop}) ways.list.halo.give(*values);
    }
};

/// When bodies have to stop behind others that each wall takes along, by contacts between ranks.
class StopsBetweenRanks
{
public:
    StopsBetweenRanks(const WaysOfStep& ways, const std::vector<Stop>& stops)
    :
        ways_(ways),
        known_(ways, stops),
        time_(ways.frames.size(), std::vector<double>(ways.list.halo.bodies(), never))
    {
        const ContactList& list = ways.list;
        for (std::size_t slot = list.interfaceBlock*blockLanes; slot < list.slots(); ++slot)
        {
            if (!list.isUsed(slot) || !isBetweenRanks(list, slot)) continue;
            const int a = list.blocks[slot/blockLanes].a[slot % blockLanes], b = list.blocks[slot/blockLanes].b[slot % blockLanes];
            Vec3 x = list.position[a] - list.position[b];
            for (int axis = 0; axis < 3; ++axis) x[axis] -= list.image[slot][axis]*ways.box.length[axis];
            stopBehind(a, b, x);
            stopBehind(b, a, -x);
        }
        for (std::vector<double>& times : time_) list.halo.takeSmallest(times);
    }

    bool hasToStop(int body) const { return time_[firstWall(body)][body] < never; }

    Stop stop(int body) const
    {
        const int wall = firstWall(body);
        const double time = time_[wall][body];
        const Vec3 start = ways_.start(body), way = ways_.frames[wall].seen(start, known_.way[body]);
        return {body, time, ways_.frames[wall].unseen(start, time*way), wall};
    }

private:
    int firstWall(int body) const
    {
        const auto isEarlier = [body](const std::vector<double>& a, const std::vector<double>& b) { return a[body] < b[body]; };
        return static_cast<int>(std::min_element(time_.begin(), time_.end(), isEarlier) - time_.begin());
    }

    /// `x`: from where the other body starts to where this one does.
    void stopBehind(int body, int stopped, const Vec3& x)
    {
        const double from = known_.stop[stopped][0], to = std::min(1.0, known_.stop[body][0]);
        if (!(from < to) || !fliesAlone(ways_.list, body)) return;
        const int wall = static_cast<int>(known_.stop[stopped][1]);
        const StepFrame& frame = ways_.frames[wall];
        const Vec3 start = ways_.start(stopped), way = frame.seen(start + x, known_.way[body]);
        const Vec3 apart = x + from*way - frame.seen(start, known_.end[stopped]);
        const double touch = timeOfTouch(apart, way, from, to, Touch(ways_.list, body, stopped, ways_.tolerance));
        time_[wall][body] = std::min(time_[wall][body], touch);
    }

    const WaysOfStep& ways_;
    WaysOnRanks known_;
    std::vector<std::vector<double>> time_;   ///< by wall, of each body
};

} // namespace

bool stopBehindOtherRanks(const WaysOfStep& ways, std::vector<Stop>& stops)
{
    if (!ways.list.halo.isParallel()) return false;
    const StopsBetweenRanks found(ways, stops);
    const auto isReplaced = [&](const Stop& stop) { return found.hasToStop(stop.body); };
    stops.erase(std::remove_if(stops.begin(), stops.end(), isReplaced), stops.end());
    bool isAny = false;
    for (int body = 0; body < ways.list.owned(); ++body)
    {
        if (!found.hasToStop(body)) continue;
        stops.push_back(found.stop(body));
        isAny = true;
    }
    return ways.list.halo.any(isAny);
}

} // namespace nscd
