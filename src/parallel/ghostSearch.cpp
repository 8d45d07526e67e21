// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Boxes up the tree of ranks, grains down.
#include "parallel/ghostSearch.hpp"

#include "nscd/base/invalidValue.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>

namespace nscd
{

namespace
{

using Box = Eigen::AlignedBox3d;

/// A ghost on its way: GhostGrain without Eigen's types.
struct ReachBall
{
    std::array<double, 3> position, center, path;
    double size, radius, slack, inverseMass;
    std::int64_t id;
    int material, owner, index, clump;
};

std::vector<ReachBall> ballsOf(int rank, const Grains& grains, const GrainPaths& paths, const PeriodicBox& box)
{
    std::vector<ReachBall> balls;
    balls.reserve(grains.nOwned);
    const std::vector<int> clumpOf = clumpOfGrains(grains);
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        const Vec3 x = box.wrap(grains.position[i]), path = paths.path.empty() ? Vec3(Vec3::Zero()) : paths.path[i];
        const Vec3 center = box.wrap(x + 0.5*path);
        const double size = grains.radius[i] + paths.range + paths.slack[i] + 0.5*(path - paths.meanPath).norm();
        const double inverseMass = grains.isFixed[i] ? 0.0 : 1.0/grains.mass[i];
        const int index = static_cast<int>(i);
        balls.push_back
        ({
            {x[0], x[1], x[2]}, {center[0], center[1], center[2]}, {path[0], path[1], path[2]}, size, grains.radius[i], paths.slack[i], inverseMass,
            grains.id[i], grains.material[i], rank, index, clumpOf.empty() ? -1 : clumpOf[i]
        });
    }
    return balls;
}

struct Interval
{
    double lower = 0.0, upper = 0.0;

    double length() const { return upper - lower; }
};

/// Around the balls along an axis, where images are meant of those that lie before `cut` [m].
Interval intervalBehind(const std::vector<ReachBall>& balls, int axis, double cut, double period)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Interval around{infinity, -infinity};
    for (const ReachBall& ball : balls)
    {
        const double x = ball.center[axis] + (ball.center[axis] < cut ? period : 0.0);
        around = {std::min(around.lower, x - ball.size), std::max(around.upper, x + ball.size)};
    }
    return around;
}

/// Middle of the longest part of a periodic axis in which no center lies, to a share of the period [m].
double middleOfLongestGap(const std::vector<ReachBall>& balls, int axis, double lower, double period)
{
    constexpr int parts = 64;
    std::array<bool, parts> isTaken{};
    for (const ReachBall& ball : balls) isTaken[std::min(parts - 1, static_cast<int>(parts*((ball.center[axis] - lower)/period)))] = true;
    int longest = 0, end = 0, run = 0;
    for (int k = 0; k < 2*parts; ++k)
    {
        run = isTaken[k % parts] ? 0 : std::min(run + 1, parts);
        if (run > longest) { longest = run; end = k + 1; }
    }
    return lower + std::fmod((end - 0.5*longest)/parts, 1.0)*period;
}

/// Around the balls along an axis. A rank at a periodic side has grains that went across it: their images beside the others are meant, or its
/// box would be as long as the period.
Interval intervalAround(const std::vector<ReachBall>& balls, int axis, double lower, double period)
{
    const Interval plain = intervalBehind(balls, axis, 0.0, 0.0);
    if (!(period > 0.0)) return plain;
    const Interval moved = intervalBehind(balls, axis, middleOfLongestGap(balls, axis, lower, period), period);
    if (moved.length() >= plain.length()) return plain;
    const double back = moved.lower + moved.upper > 2.0*(lower + period) ? period : 0.0;
    return {moved.lower - back, moved.upper - back};
}

Box boxAround(const std::vector<ReachBall>& balls, const PeriodicBox& box)
{
    Box around;
    if (balls.empty()) return around;
    for (int k = 0; k < 3; ++k)
    {
        const Interval along = intervalAround(balls, k, box.lower[k], box.length[k]);
        around.min()[k] = along.lower;
        around.max()[k] = along.upper;
    }
    return around;
}

double square(double a) { return a*a; }

/// Distance of a coordinate, or of the nearest of its images, to an interval [m].
double gapTo(double x, double lower, double upper, double period)
{
    const auto gap = [=](double image) { return std::max({0.0, lower - image, image - upper}); };
    // One period to either side is enough: coordinates lie in the first period, and the middle of an interval does too or the interval
    // is a whole period long.
    return period > 0.0 ? std::min({gap(x), gap(x - period), gap(x + period)}) : gap(x);
}

bool meets(const Vec3& center, double size, const Box& around, const PeriodicBox& box)
{
    if (around.isEmpty()) return false;
    double distance2 = 0.0;
    for (int k = 0; k < 3; ++k)
    {
        const double gap = gapTo(center[k], around.min()[k], around.max()[k], box.length[k]);
        distance2 += gap*gap;
    }
    // Spheres that touch to the last digit meet, whatever the rounding of their box: true up to coordinates of 1e6 radii.
    return distance2 <= square((1.0 + 1e-9)*size);
}

bool meets(const ReachBall& ball, const Box& around, const PeriodicBox& box) { return meets(Vec3(ball.center.data()), ball.size, around, box); }

/// Whether a sphere, or an image of it, lies in a box.
bool isWithin(const Vec3& center, double size, const Box& around, const PeriodicBox& box)
{
    bool isIn = true;
    for (int k = 0; k < 3; ++k)
    {
        const auto isImageIn = [&](double x) { return x - size >= around.min()[k] && x + size <= around.max()[k]; };
        isIn = isIn && (isImageIn(center[k]) || isImageIn(center[k] - box.length[k]) || isImageIn(center[k] + box.length[k]));
    }
    return isIn;
}

GhostGrain ghostOf(const ReachBall& ball)
{
    return {Vec3(ball.position.data()), Vec3(ball.path.data()), ball.radius, ball.slack, ball.inverseMass, ball.id, ball.material, ball.owner, ball.index, ball.clump};
}

/// Balls of other ranks that meet this rank's box: at the last level, this rank is a half.
std::vector<ReachBall> routeDown(const RankTree& tree, const std::vector<HalfBoxes>& halves, const std::vector<ReachBall>& own, const PeriodicBox& box)
{
    std::vector<ReachBall> received;
    for (std::size_t l = 0; l < halves.size(); ++l)
    {
        const auto meetsOther = [&](const ReachBall& ball) { return meets(ball, halves[l].other, box); };
        const auto missesOwn = [&](const ReachBall& ball) { return !meets(ball, halves[l].own, box); };
        std::vector<ReachBall> sent;
        std::copy_if(own.begin(), own.end(), std::back_inserter(sent), meetsOther);
        std::copy_if(received.begin(), received.end(), std::back_inserter(sent), meetsOther);
        received.erase(std::remove_if(received.begin(), received.end(), missesOwn), received.end());
        const std::vector<ReachBall> arrived = sendAcross(tree.levels()[l], sent);
        received.insert(received.end(), arrived.begin(), arrived.end());
    }
    return received;
}

} // namespace

bool CoveredBoxes::isOfThisRankAlone(const Vec3& center, double size) const
{
    if (halves_.empty()) return true;
    const auto meetsOther = [&](const HalfBoxes& half) { return meets(center, size, half.other, box_); };
    return isWithin(center, size, halves_.back().own, box_) && std::none_of(halves_.begin(), halves_.end(), meetsOther);
}

std::vector<GhostGrain> findGhosts
(
    const RankTree& tree, const Grains& owned, const GrainPaths& paths, const PeriodicBox& box, CoveredBoxes& covered
)
{
    if (paths.slack.size() < owned.nOwned) throw invalidValue("number of slacks", paths.slack.size(), "one for each grain owned");
    if (!paths.path.empty() && paths.path.size() < owned.nOwned) throw invalidValue("number of paths", paths.path.size(), "one for each grain owned, or none");
    const std::vector<ReachBall> own = ballsOf(tree.all().rank(), owned, paths, box);
    const std::vector<HalfBoxes> halves = boxesOfHalves(tree, boxAround(own, box));
    std::vector<ReachBall> balls = routeDown(tree, halves, own, box);
    covered = CoveredBoxes(halves, box);
    const auto byOwner = [](const ReachBall& a, const ReachBall& b) { return std::tie(a.owner, a.index) < std::tie(b.owner, b.index); };
    std::sort(balls.begin(), balls.end(), byOwner);

    std::vector<GhostGrain> ghosts;
    ghosts.reserve(balls.size());
    std::transform(balls.begin(), balls.end(), std::back_inserter(ghosts), ghostOf);
    return ghosts;
}

} // namespace nscd
