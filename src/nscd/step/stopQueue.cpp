// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Ways in pieces, looked up around those that stopped.
#include "nscd/step/stopQueue.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace nscd
{

namespace
{

constexpr double never = 2.0;

/// Two bodies that are no nearer than touching, to within a tolerance.
struct Touch
{
    double radii;
    double margin;   ///< as along walls: what touches to within the tolerance of contacts may pass

    Touch(const ContactList& list, int a, int b, double tolerance)
    :
        radii(list.radius[a] + list.radius[b]),
        margin(std::min(tolerance, 0.1*std::min(list.radius[a], list.radius[b])))
    {}
};

/// The time between `from` and `to`, shares of the step, at which a body that goes on by `way` a step has to stop, since it touches the origin's;
/// `start`: where it is at `from`.
double timeOfTouch(const Vec3& start, const Vec3& way, double from, double to, const Touch& touch)
{
    if (!(from < to)) return never;
    const double radii = touch.radii - touch.margin;
    if (start.squaredNorm() <= radii*radii) return start.dot(way) < 0.0 ? from : never;
    const double share = timeToOrigin(start, (to - from)*way, radii);
    if (share > 1.0) return never;
    const double along = share*(to - from), back = touch.margin/std::abs((start + along*way).normalized().dot(way));
    return std::max(from, from + along - back);
}

/// Part of a body's way between two times, as shares of the step.
struct Piece
{
    int body;
    double from, to;
};

class Queue
{
public:
    Queue(const ContactList& list, const PeriodicBox& box, double deltaT, double tolerance, std::vector<Stop>& stops)
    :
        list_(list),
        box_(box),
        deltaT_(deltaT),
        tolerance_(tolerance),
        stops_(stops),
        stopOf_(list.owned(), -1),
        isDone_(list.owned(), 0)
    {
        for (std::size_t k = 0; k < stops.size(); ++k)
        {
            stopOf_[stops[k].body] = static_cast<int>(k);
            next_.push({stops[k].time, stops[k].body});
        }
        cutWays();
    }

    void run()
    {
        while (!next_.empty())
        {
            const int body = next_.top().second;
            next_.pop();
            if (isDone_[body]) continue;
            isDone_[body] = 1;
            stopBehind(body);
        }
    }

private:
    Vec3 wayOf(int body) const { return deltaT_*Vec3(list_.bodies[body].v); }
    double timeOf(int body) const { return stopOf_[body] < 0 ? 1.0 : stops_[stopOf_[body]].time; }

    void cutWays()
    {
        constexpr double pieceInRadii = 4.0, mostPieces = 1000.0;
        std::vector<Vec3> middle;
        std::vector<double> size;
        for (int body = 0; body < list_.owned(); ++body)
        {
            if (!fliesAlone(list_, body)) continue;
            const Vec3 way = wayOf(body);
            const double radius = list_.radius[body], length = way.norm();
            const int count = static_cast<int>(std::max(1.0, std::min(mostPieces, std::ceil(length/(pieceInRadii*radius)))));
            for (int k = 0; k < count && k < timeOf(body)*count; ++k)
            {
                pieces_.push_back({body, static_cast<double>(k)/count, (k + 1.0)/count});
                middle.push_back(box_.wrap(list_.position[body] + (k + 0.5)/count*way));
                size.push_back(radius + 0.5*length/count);
            }
        }
        search_.fill(middle, size, box_);
        middle_ = std::move(middle);
    }

    void stopBehind(int stopped)
    {
        const Stop stop = stops_[stopOf_[stopped]];
        const Vec3 end = box_.wrap(list_.position[stopped] + stop.way);
        for (const BodyPair& found : search_.around(end, list_.radius[stopped], box_))
        {
            const Piece& piece = pieces_[found.b];
            if (isDone_[piece.body]) continue;
            Vec3 middle = middle_[found.b] - end;
            for (int axis = 0; axis < 3; ++axis) middle[axis] += found.image[axis]*box_.length[axis];
            stopOn(piece, middle, stop);
        }
    }

    /// `middle`: of the piece, seen from where the other body is.
    void stopOn(const Piece& piece, const Vec3& middle, const Stop& before)
    {
        const double from = std::max(piece.from, before.time), to = std::min(piece.to, timeOf(piece.body));
        const Vec3 way = wayOf(piece.body), start = middle + (from - 0.5*(piece.from + piece.to))*way;
        const double time = timeOfTouch(start, way, from, to, Touch(list_, piece.body, before.body, tolerance_));
        if (time == never) return;
        if (stopOf_[piece.body] < 0)
        {
            stopOf_[piece.body] = static_cast<int>(stops_.size());
            stops_.push_back({piece.body, time, Vec3::Zero()});
        }
        stops_[stopOf_[piece.body]] = {piece.body, time, time*way};
        next_.push({time, piece.body});
    }

    using Entry = std::pair<double, int>;   ///< time, body

    const ContactList& list_;
    const PeriodicBox& box_;
    double deltaT_;
    double tolerance_;
    std::vector<Stop>& stops_;
    std::vector<int> stopOf_;     ///< of each own body in stops_; -1: goes all its way
    std::vector<char> isDone_;
    std::vector<Piece> pieces_;
    std::vector<Vec3> middle_;    ///< of each piece, in the box [m]
    PairSearch search_;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> next_;
};

/// What ranks know of each other's bodies, per body of the list.
struct WaysOnRanks
{
    std::vector<Vec3> way;     ///< of the whole step [m]
    std::vector<Vec3> end;     ///< way to where it stops [m]
    std::vector<Vec3> time;    ///< of its stop, thrice

    WaysOnRanks(const ContactList& list, double deltaT, const std::vector<Stop>& stops)
    :
        way(list.halo.bodies(), Vec3::Zero()),
        time(list.halo.bodies(), Vec3::Constant(never))
    {
        for (int body = 0; body < list.owned(); ++body) way[body] = deltaT*Vec3(list.bodies[body].v);
        end = way;
        for (const Stop& stop : stops)
        {
            end[stop.body] = stop.way;
            time[stop.body].setConstant(stop.time);
        }
        for (std::vector<Vec3>* values : {&way, &end, &time}) list.halo.give(*values);
    }
};

} // namespace

bool stopBehindOtherRanks(const ContactList& list, const PeriodicBox& box, double deltaT, double tolerance, std::vector<Stop>& stops)
{
    if (!list.halo.isParallel()) return false;
    const WaysOnRanks known(list, deltaT, stops);
    std::vector<double> time(list.halo.bodies(), never);
    const auto stopBehind = [&](int body, int stopped, const Vec3& x)
    {
        const double from = known.time[stopped][0], to = std::min(1.0, known.time[body][0]);
        if (list.inverseMass[body] == 0.0) return;
        const double touch = timeOfTouch(x + from*known.way[body] - known.end[stopped], known.way[body], from, to, Touch(list, body, stopped, tolerance));
        time[body] = std::min(time[body], touch);
    };
    for (std::size_t slot = list.interfaceBlock*blockLanes; slot < list.slots(); ++slot)
    {
        if (!list.isUsed(slot)) continue;
        const int a = list.blocks[slot/blockLanes].a[slot % blockLanes], b = list.blocks[slot/blockLanes].b[slot % blockLanes];
        Vec3 x = list.position[a] - list.position[b];
        for (int axis = 0; axis < 3; ++axis) x[axis] -= list.image[slot][axis]*box.length[axis];
        stopBehind(a, b, x);
        stopBehind(b, a, -x);
    }
    list.halo.takeSmallest(time);
    std::vector<Stop> found;
    for (int body = 0; body < list.owned(); ++body)
    {
        if (time[body] < never) found.push_back({body, time[body], time[body]*known.way[body]});
    }
    const auto isEarlier = [&](const Stop& stop) { return time[stop.body] < never; };
    stops.erase(std::remove_if(stops.begin(), stops.end(), isEarlier), stops.end());
    stops.insert(stops.end(), found.begin(), found.end());
    return list.halo.any(!found.empty());
}

void addQueue(const ContactList& list, const PeriodicBox& box, double deltaT, double tolerance, std::vector<Stop>& stops)
{
    if (!stops.empty()) Queue(list, box, deltaT, tolerance, stops).run();
}

bool fliesAlone(const ContactList& list, int body)
{
    return list.inverseMass[body] != 0.0 && (list.general.empty() || list.general.memberOf[body] < 0);
}

} // namespace nscd
