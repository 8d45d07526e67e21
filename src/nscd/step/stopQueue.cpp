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
        if (!(from < to)) return;
        const Vec3 way = wayOf(piece.body), start = middle + (from - 0.5*(piece.from + piece.to))*way;
        const double smaller = std::min(list_.radius[piece.body], list_.radius[before.body]), margin = std::min(tolerance_, 0.1*smaller);
        const double radii = list_.radius[piece.body] + list_.radius[before.body] - margin;
        const bool isTouching = start.squaredNorm() <= radii*radii && start.dot(way) < 0.0;
        const double time = isTouching ? 0.0 : timeToOrigin(start, (to - from)*way, radii);
        if (time > 1.0) return;
        const double there = from + time*(to - from);
        const double back = margin/std::abs((start + (there - from)*way).normalized().dot(way));
        setStop(piece.body, std::max(from, there - (isTouching ? 0.0 : back)));
    }

    void setStop(int body, double time)
    {
        if (stopOf_[body] < 0)
        {
            stopOf_[body] = static_cast<int>(stops_.size());
            stops_.push_back({body, 0.0, Vec3::Zero()});
        }
        Stop& stop = stops_[stopOf_[body]];
        stop.time = time;
        stop.way = time*wayOf(body);
        next_.push({time, body});
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

} // namespace

void addQueue(const ContactList& list, const PeriodicBox& box, double deltaT, double tolerance, std::vector<Stop>& stops)
{
    Queue(list, box, deltaT, tolerance, stops).run();
}

bool fliesAlone(const ContactList& list, int body)
{
    return list.inverseMass[body] != 0.0 && (list.general.empty() || list.general.memberOf[body] < 0);
}

} // namespace nscd
