// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Caps on spheres, and shadows.
#include "nscd/scene/clumpForm.hpp"

#include "nscd/scene/grains.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace nscd
{

namespace
{

constexpr double pi = 3.14159265358979323846;
constexpr double agreement = 1e-11;
constexpr int maxBisections = 40;

/// Part of a sphere within another ball: points whose direction is within `angle` of `axis`.
struct Cap
{
    Vec3 axis;      ///< unit
    double angle;   ///< [rad]; pi: all of the sphere
};

/// Caps of ball i that are in others. Of balls that are the same the first counts.
std::vector<Cap> coveredCaps(const std::vector<Ball>& balls, std::size_t i)
{
    std::vector<Cap> caps;
    for (std::size_t j = 0; j < balls.size(); ++j)
    {
        if (j == i) continue;
        const Vec3 to = balls[j].center - balls[i].center;
        const double d = to.norm(), a = balls[i].radius, b = balls[j].radius;
        const bool isSame = d == 0.0 && a == b;
        if (d >= a + b || (d <= a - b && !isSame) || (isSame && j > i)) continue;
        if (d <= b - a) return {{Vec3::UnitZ(), pi}};
        caps.push_back({to/d, std::acos(std::max(-1.0, std::min(1.0, (d*d + a*a - b*b)/(2.0*d*a))))});
    }
    return caps;
}

using Arc = std::pair<double, double>;  // from, to [rad]

/// The arc of a circle of latitude that a cap covers; empty, or all of it, where the circle does not cross the cap's edge.
Arc arcOf(const Cap& cap, double cosine)
{
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine*cosine)), across = std::hypot(cap.axis[0], cap.axis[1]);
    const double reach = sine*across, rest = std::cos(cap.angle) - cosine*cap.axis[2];
    const double middle = std::atan2(cap.axis[1], cap.axis[0]);
    if (rest >= reach) return {middle, middle};
    const double half = rest <= -reach ? pi : std::acos(rest/reach);
    return {middle - half, middle + half};
}

/// Angle of a circle of latitude that no cap covers [rad].
double openAngle(const std::vector<Cap>& caps, double cosine)
{
    std::vector<Arc> covered;
    for (const Cap& cap : caps)
    {
        Arc arc = arcOf(cap, cosine);
        const double turns = 2.0*pi*std::floor(arc.first/(2.0*pi));
        arc = {arc.first - turns, arc.second - turns};
        covered.push_back({arc.first, std::min(arc.second, 2.0*pi)});
        if (arc.second > 2.0*pi) covered.push_back({0.0, arc.second - 2.0*pi});
    }
    std::sort(covered.begin(), covered.end());
    double open = 0.0, reached = 0.0;
    for (const Arc& arc : covered)
    {
        open += std::max(0.0, arc.first - reached);
        reached = std::max(reached, arc.second);
    }
    return open + std::max(0.0, 2.0*pi - reached);
}

/// Gauss and Legendre with 5 points; roots at the ends do no harm by x = a + (b - a)(3 s^2 - 2 s^3).
double integratePiece(const std::vector<Cap>& caps, double a, double b)
{
    constexpr std::array<std::pair<double, double>, 3> rule = {{{0.0, 0.5688888888888889}, {0.5384693101056831, 0.4786286704993665}, {0.9061798459386640, 0.2369268850561891}}};
    double sum = 0.0;
    const auto add = [&](double node, double weight)
    {
        const double s = 0.5*(1.0 + node);
        sum += 3.0*weight*s*(1.0 - s)*(b - a)*openAngle(caps, a + (b - a)*s*s*(3.0 - 2.0*s));
    };
    add(rule[0].first, rule[0].second);
    for (std::size_t k = 1; k < rule.size(); ++k)
    {
        add(rule[k].first, rule[k].second);
        add(-rule[k].first, rule[k].second);
    }
    return sum;
}

double integrateAdaptively(const std::vector<Cap>& caps, double a, double b, double whole, double allowed, int bisections)
{
    const double middle = 0.5*(a + b);
    const double low = integratePiece(caps, a, middle), high = integratePiece(caps, middle, b);
    if (std::abs(low + high - whole) <= allowed || bisections == maxBisections) return low + high;
    return integrateAdaptively(caps, a, middle, low, 0.5*allowed, bisections + 1)
         + integrateAdaptively(caps, middle, b, high, 0.5*allowed, bisections + 1);
}

/// Solid angle of a sphere that no cap covers [sr].
double openSolidAngle(const std::vector<Cap>& caps)
{
    if (caps.empty()) return 4.0*pi;
    std::vector<double> ends = {-1.0, 1.0};
    for (const Cap& cap : caps)
    {
        if (cap.angle >= pi) return 0.0;
        const double polar = std::acos(std::max(-1.0, std::min(1.0, cap.axis[2])));
        ends.push_back(std::cos(std::max(0.0, polar - cap.angle)));
        ends.push_back(std::cos(std::min(pi, polar + cap.angle)));
        // A cap over a pole covers whole circles from there on.
        ends.push_back(std::cos(std::abs(polar - cap.angle)));
        ends.push_back(std::cos(std::min(polar + cap.angle, 2.0*pi - polar - cap.angle)));
    }
    std::sort(ends.begin(), ends.end());
    double sum = 0.0;
    for (std::size_t k = 1; k < ends.size(); ++k)
    {
        const double a = ends[k - 1], b = ends[k];
        if (b > a) sum += integrateAdaptively(caps, a, b, integratePiece(caps, a, b), agreement, 0);
    }
    return sum;
}

} // namespace

double ClumpForm::equivalentDiameter() const { return std::cbrt(6.0*volume/pi); }

double ClumpForm::sphericity() const
{
    const double d = equivalentDiameter();
    return std::min(1.0, pi*d*d/surface);
}

double surfaceOfBalls(const std::vector<Ball>& balls)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < balls.size(); ++i) sum += balls[i].radius*balls[i].radius*openSolidAngle(coveredCaps(balls, i));
    return sum;
}

ClumpForm formOf(const ClumpShape& clump, const GrainShape& shape)
{
    ClumpForm form;
    form.volume = makeClumpShape(clump.members, 1.0, shape).mass;
    if (shape.dimensions == 3) form.surface = surfaceOfBalls(clump.members);
    return form;
}

double projectedArea(const std::vector<Ball>& members, const Vec3& direction)
{
    const Quaternion toZ = Quaternion::FromTwoVectors(direction, Vec3::UnitZ());
    std::vector<Ball> shadows;
    for (const Ball& member : members) shadows.push_back({toZ*member.center, member.radius});
    return unionOfDiscs(shadows).volume;
}

} // namespace nscd
