// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Arcs of a slice, and slices of a body.
#include "nscd/scene/unionMoments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace nscd
{

namespace
{

constexpr double pi = 3.14159265358979323846;
constexpr double agreement = 1e-12;
constexpr int maxBisections = 30;

/// Nodes and weights of Gauss and Legendre on [0, 1], exact to degree 19.
constexpr std::array<std::pair<double, double>, 5> halfRule =
{{
    {0.1488743389816312, 0.2955242247147529},
    {0.4333953941292472, 0.2692667193099963},
    {0.6794095682990244, 0.2190863625159820},
    {0.8650633666889845, 0.1494513491505806},
    {0.9739065285171717, 0.0666713443086881}
}};

template<class Value, class Function>
Value gauss(const Function& f, Value sum)
{
    for (const auto& [node, weight] : halfRule) sum += 0.5*weight*(f(0.5 + 0.5*node) + f(0.5 - 0.5*node));
    return sum;
}

/// 1, x, y, xx, yy, xy over a slice.
using SliceMoments = Eigen::Matrix<double, 6, 1>;
/// 1, x, y, z, xx, yy, zz, xy, xz, yz over a body.
using BodyMoments = Eigen::Matrix<double, 10, 1>;

using Arc = std::pair<double, double>;  // from, to [rad]

/// Boundary integrals whose differences are the moments: area = 1/2 int x dy - y dx, and so on.
SliceMoments integrateArc(const Ball& disc, const Arc& arc)
{
    const int pieces = 1 + static_cast<int>((arc.second - arc.first)/(0.5*pi));
    const double width = (arc.second - arc.first)/pieces;
    SliceMoments sum = SliceMoments::Zero();
    for (int k = 0; k < pieces; ++k)
    {
        sum += gauss([&](double s)
        {
            const double angle = arc.first + (k + s)*width, c = std::cos(angle), d = std::sin(angle);
            const double x = disc.center[0] + disc.radius*c, y = disc.center[1] + disc.radius*d;
            const double dx = -disc.radius*d*width, dy = disc.radius*c*width;
            SliceMoments value;
            value << 0.5*(x*dy - y*dx), 0.5*x*x*dy, -0.5*y*y*dx, x*x*x*dy/3.0, -y*y*y*dx/3.0, 0.5*x*x*y*dy;
            return value;
        }, SliceMoments(SliceMoments::Zero()));
    }
    return sum;
}

void addCovered(std::vector<Arc>& covered, double from, double to)
{
    const double turns = 2.0*pi*std::floor(from/(2.0*pi));
    from -= turns;
    to -= turns;
    covered.push_back({from, std::min(to, 2.0*pi)});
    if (to > 2.0*pi) covered.push_back({0.0, to - 2.0*pi});
}

/// Arcs of disc i inside other discs. Of discs that are the same the first counts.
std::vector<Arc> coveredArcs(const std::vector<Ball>& discs, std::size_t i)
{
    std::vector<Arc> covered;
    for (std::size_t j = 0; j < discs.size(); ++j)
    {
        if (j == i) continue;
        const double dx = discs[j].center[0] - discs[i].center[0], dy = discs[j].center[1] - discs[i].center[1];
        const double d = std::hypot(dx, dy), a = discs[i].radius, b = discs[j].radius;
        const bool isSame = d == 0.0 && a == b;
        if (d >= a + b || (d <= a - b && !isSame) || (isSame && j > i)) continue;
        if (d <= b - a) return {{0.0, 2.0*pi}};
        const double half = std::acos(std::max(-1.0, std::min(1.0, (d*d + a*a - b*b)/(2.0*d*a)))), middle = std::atan2(dy, dx);
        addCovered(covered, middle - half, middle + half);
    }
    std::sort(covered.begin(), covered.end());
    return covered;
}

SliceMoments integrateSlice(const std::vector<Ball>& discs)
{
    SliceMoments sum = SliceMoments::Zero();
    for (std::size_t i = 0; i < discs.size(); ++i)
    {
        double reached = 0.0;
        for (const Arc& arc : coveredArcs(discs, i))
        {
            if (arc.first > reached) sum += integrateArc(discs[i], {reached, arc.first});
            reached = std::max(reached, arc.second);
        }
        if (reached < 2.0*pi) sum += integrateArc(discs[i], {reached, 2.0*pi});
    }
    return sum;
}

BodyMoments sliceAt(const std::vector<Ball>& balls, double z)
{
    std::vector<Ball> discs;
    for (const Ball& ball : balls)
    {
        const double h = z - ball.center[2], r2 = ball.radius*ball.radius - h*h;
        if (r2 > 0.0) discs.push_back({ball.center, std::sqrt(r2)});
    }
    const SliceMoments m = integrateSlice(discs);
    BodyMoments all;
    all << m[0], m[1], m[2], z*m[0], m[3], m[4], z*z*m[0], m[5], z*m[1], z*m[2];
    return all;
}

BodyMoments integratePiece(const std::vector<Ball>& balls, double a, double b)
{
    return gauss([&](double s) { return BodyMoments(6.0*s*(1.0 - s)*(b - a)*sliceAt(balls, a + (b - a)*s*s*(3.0 - 2.0*s))); },
                 BodyMoments(BodyMoments::Zero()));
}

BodyMoments integrateAdaptively
(
    const std::vector<Ball>& balls, double a, double b, const BodyMoments& whole, const BodyMoments& allowed, int bisections
)
{
    const double middle = 0.5*(a + b);
    const BodyMoments low = integratePiece(balls, a, middle), high = integratePiece(balls, middle, b);
    const bool isDone = ((low + high - whole).array().abs() <= allowed.array()).all() || bisections == maxBisections;
    if (isDone) return low + high;
    return integrateAdaptively(balls, a, middle, low, 0.5*allowed, bisections + 1)
         + integrateAdaptively(balls, middle, b, high, 0.5*allowed, bisections + 1);
}

/// What each moment is measured against: those of the same volume at the union's size.
BodyMoments scales(const std::vector<Ball>& balls)
{
    double volume = 0.0, size = 0.0;
    for (const Ball& ball : balls)
    {
        volume = std::max(volume, 4.0/3.0*pi*ball.radius*ball.radius*ball.radius);
        size = std::max(size, ball.center.norm() + ball.radius);
    }
    BodyMoments scale = BodyMoments::Constant(volume*size*size);
    scale[0] = volume;
    scale.segment<3>(1).setConstant(volume*size);
    return scale;
}

} // namespace

VolumeMoments unionOfBalls(const std::vector<Ball>& balls)
{
    std::vector<double> ends;
    for (const Ball& ball : balls)
    {
        ends.push_back(ball.center[2] - ball.radius);
        ends.push_back(ball.center[2] + ball.radius);
    }
    std::sort(ends.begin(), ends.end());
    const BodyMoments allowed = agreement*scales(balls);
    BodyMoments m = BodyMoments::Zero();
    for (std::size_t k = 1; k < ends.size(); ++k)
    {
        const double a = ends[k - 1], b = ends[k];
        if (b > a) m += integrateAdaptively(balls, a, b, integratePiece(balls, a, b), allowed, 0);
    }
    VolumeMoments moments;
    moments.volume = m[0];
    moments.first = m.segment<3>(1);
    moments.second << m[4], m[7], m[8], m[7], m[5], m[9], m[8], m[9], m[6];
    return moments;
}

VolumeMoments unionOfDiscs(const std::vector<Ball>& discs)
{
    const SliceMoments m = integrateSlice(discs);
    VolumeMoments moments;
    moments.volume = m[0];
    moments.first << m[1], m[2], 0.0;
    moments.second << m[3], m[5], 0.0, m[5], m[4], 0.0, 0.0, 0.0, 0.0;
    return moments;
}

} // namespace nscd
