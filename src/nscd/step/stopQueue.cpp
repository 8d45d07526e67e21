// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Ways in pieces, looked up around those that stopped.
#include "nscd/step/stopQueue.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <queue>
#include <utility>

namespace nscd
{

namespace
{

/// Ways of all bodies as seen from a wall, in pieces that are looked up by place.
class WaysInFrame
{
public:
    /// A way between two times, as shares of the step.
    struct Piece
    {
        int body;
        double from, to;
    };

    WaysInFrame(const WaysOfStep& ways, const StepFrame& frame) : box_(ways.box), way_(ways.list.owned(), Vec3::Zero())
    {
        const ContactList& list = ways.list;
        std::vector<double> size;
        for (int body = 0; body < list.owned(); ++body)
        {
            way_[body] = frame.seen(ways.start(body), ways.deltaT*Vec3(list.bodies[body].v));
            if (fliesAlone(list, body)) cut(body, ways.start(body), list.radius[body], size);
        }
        search_.fill(middle_, size, box_);
    }

    const Vec3& way(int body) const { return way_[body]; }

    /// Calls visit(piece, its middle as seen from x) for pieces of ways that come nearer to x than radii.
    template<class Visit>
    void forEachAround(const Vec3& x, double radius, const Visit& visit)
    {
        const Vec3 place = box_.wrap(x);
        for (const BodyPair& found : search_.around(place, radius, box_))
        {
            Vec3 middle = middle_[found.b] - place;
            for (int axis = 0; axis < 3; ++axis) middle[axis] += found.image[axis]*box_.length[axis];
            visit(pieces_[found.b], middle);
        }
    }

private:
    void cut(int body, const Vec3& start, double radius, std::vector<double>& size)
    {
        constexpr double pieceInRadii = 4.0, mostPieces = 1000.0;
        const double length = way_[body].norm();
        const int count = static_cast<int>(std::max(1.0, std::min(mostPieces, std::ceil(length/(pieceInRadii*radius)))));
        for (int k = 0; k < count; ++k)
        {
            pieces_.push_back({body, static_cast<double>(k)/count, (k + 1.0)/count});
            middle_.push_back(box_.wrap(start + (k + 0.5)/count*way_[body]));
            size.push_back(radius + 0.5*length/count);
        }
    }

    const PeriodicBox& box_;
    std::vector<Vec3> way_;       ///< of each own body [m]
    std::vector<Piece> pieces_;
    std::vector<Vec3> middle_;    ///< of each piece, in the box [m]
    PairSearch search_;
};

class Queue
{
public:
    Queue(const WaysOfStep& ways, std::vector<Stop>& stops)
    :
        ways_(ways),
        list_(ways.list),
        stops_(stops),
        stopOf_(list_.owned(), -1),
        isDone_(list_.owned(), 0),
        inFrame_(ways.frames.size())
    {
        for (std::size_t k = 0; k < stops.size(); ++k)
        {
            stopOf_[stops[k].body] = static_cast<int>(k);
            next_.push({stops[k].time, stops[k].body});
        }
    }

    void run()
    {
        while (!next_.empty())
        {
            const int body = next_.top().second;
            next_.pop();
            if (isDone_[body]) continue;
            isDone_[body] = 1;
            stopBehind(stops_[stopOf_[body]]);
        }
    }

private:
    double timeOf(int body) const { return stopOf_[body] < 0 ? 1.0 : stops_[stopOf_[body]].time; }

    void stopBehind(const Stop before)
    {
        std::unique_ptr<WaysInFrame>& ways = inFrame_[before.wall];
        if (!ways) ways = std::make_unique<WaysInFrame>(ways_, ways_.frames[before.wall]);
        const Vec3 start = ways_.start(before.body), place = start + ways_.frames[before.wall].seen(start, before.way);
        ways->forEachAround(place, list_.radius[before.body], [&](const WaysInFrame::Piece& piece, const Vec3& middle)
        {
            if (!isDone_[piece.body]) stopOn(piece, middle, ways->way(piece.body), before);
        });
    }

    /// `middle`: of the piece, seen from where the other body is.
    void stopOn(const WaysInFrame::Piece& piece, const Vec3& middle, const Vec3& way, const Stop& before)
    {
        const int body = piece.body;
        const double from = std::max(piece.from, before.time), to = std::min(piece.to, timeOf(body));
        const Vec3 start = middle + (from - 0.5*(piece.from + piece.to))*way;
        const double time = timeOfTouch(start, way, from, to, Touch(list_, body, before.body, ways_.tolerance));
        if (time == never) return;
        const Stop stop{body, time, ways_.frames[before.wall].unseen(ways_.start(body), time*way), before.wall};
        if (stopOf_[body] < 0)
        {
            stopOf_[body] = static_cast<int>(stops_.size());
            stops_.push_back(stop);
        }
        else stops_[stopOf_[body]] = stop;
        next_.push({time, body});
    }

    using Entry = std::pair<double, int>;   ///< time, body

    const WaysOfStep& ways_;
    const ContactList& list_;
    std::vector<Stop>& stops_;
    std::vector<int> stopOf_;     ///< of each own body in stops_; -1: goes all its way
    std::vector<char> isDone_;
    std::vector<std::unique_ptr<WaysInFrame>> inFrame_;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> next_;
};

} // namespace

void addQueue(const WaysOfStep& ways, std::vector<Stop>& stops)
{
    if (!stops.empty()) Queue(ways, stops).run();
}

} // namespace nscd
