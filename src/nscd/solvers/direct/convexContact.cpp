// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Newton steps with a line search on the slope.
#include "nscd/solvers/direct/convexContact.hpp"

#include "nscd/solvers/direct/coulombCone.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

constexpr int maxSteps = 60;
/// A step may end where J still falls or rises no steeper than this share of its fall at the start.
constexpr double slopeLeft = 0.5;
constexpr int maxTrials = 30;
/// After a step of at least this share of its length the smoothing shrinks by this factor: by 0.01 the stack of 1000 takes twice the steps.
constexpr double fullStep = 0.9, lessSmooth = 0.1;

std::vector<JoinedBodies> joinedBodies(const std::vector<ConeContact>& contacts)
{
    std::vector<JoinedBodies> joined;
    joined.reserve(contacts.size());
    for (const ConeContact& c : contacts) joined.push_back(c.joined);
    return joined;
}

} // namespace

ConvexContact::ConvexContact
(
    std::vector<ConeContact> contacts, const Eigen::VectorXd& motion, Eigen::VectorXd mass, MotionComponents components
)
:
    contacts_(std::move(contacts)),
    stiffnesses_(contacts_.size()),
    mass_(std::move(mass)),
    stiffness_(joinedBodies(contacts_), static_cast<int>(mass_.size()/6), std::move(components))
{
    free_ = motion - impulsesOnBodies().cwiseQuotient(mass_);
}

Vec3 ConvexContact::relativeVelocity(const ConeContact& c, const Eigen::VectorXd& x) const
{
    Vec3 u = c.wallVelocity;
    for (int side = 0; side < 2; ++side)
    {
        if (c.joined[side] < 0) continue;
        const Vec3 v = x.segment<3>(6*c.joined[side]), s = x.segment<3>(6*c.joined[side] + 3);
        u += (side == 0 ? v : Vec3(-v)) + c.n.cross(s);
    }
    return u;
}

Eigen::VectorXd ConvexContact::impulsesOnBodies() const
{
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(mass_.size());
    for (const ConeContact& c : contacts_)
    {
        const Vec3 turning = c.impulse.cross(c.n);
        for (int side = 0; side < 2; ++side)
        {
            if (c.joined[side] < 0) continue;
            sum.segment<3>(6*c.joined[side]) += side == 0 ? c.impulse : Vec3(-c.impulse);
            sum.segment<3>(6*c.joined[side] + 3) += turning;
        }
    }
    return sum;
}

Eigen::VectorXd ConvexContact::motion() const { return free_ + impulsesOnBodies().cwiseQuotient(mass_); }

Eigen::VectorXd ConvexContact::gradient(const Eigen::VectorXd& x)
{
    for (std::size_t k = 0; k < contacts_.size(); ++k)
    {
        ConeContact& c = contacts_[k];
        const Vec3 u = relativeVelocity(c, x) + (c.bias + c.friction*c.slip)*c.n;
        const ConePoint point = smoothedImpulse(c.multiplier, u, c.n, c.friction, c.penalty, smoothing_);
        c.impulse = point.impulse;
        stiffnesses_[k] = point.stiffness;
    }
    return mass_.cwiseProduct(x - free_) - impulsesOnBodies();
}

Eigen::VectorXd ConvexContact::newtonStep(const Eigen::VectorXd& gradient)
{
    stiffness_.start(mass_);
    for (std::size_t k = 0; k < contacts_.size(); ++k)
    {
        stiffness_.add(k, contacts_[k].n, stiffnesses_[k]);
    }
    if (!stiffness_.factorize()) return -gradient.cwiseQuotient(mass_);
    return -stiffness_.solve(gradient);
}

double ConvexContact::moveAlong(Eigen::VectorXd& x, const Eigen::VectorXd& step, double startSlope)
{
    // J is convex: its slope along the step grows, and is judged instead of J, whose changes drown in rounding.
    double low = 0.0, high = 1.0, lowSlope = startSlope, highSlope = slope(x + step, step);
    double share = 1.0;
    for (int trial = 0; trial < maxTrials && highSlope > slopeLeft*std::abs(startSlope); ++trial)
    {
        share = low + (high - low)*std::min(0.9, std::max(0.1, lowSlope/(lowSlope - highSlope)));
        const double here = slope(x + share*step, step);
        if (std::abs(here) <= slopeLeft*std::abs(startSlope)) break;
        (here > 0.0 ? high : low) = share;
        (here > 0.0 ? highSlope : lowSlope) = here;
    }
    x += share*step;
    return share;
}

int ConvexContact::minimize(Eigen::VectorXd& x, double limit, double firstSmoothing, double lastSmoothing)
{
    smoothing_ = std::max(firstSmoothing, lastSmoothing);
    for (int steps = 0; ; ++steps)
    {
        const Eigen::VectorXd g = gradient(x);
        const bool isOff = g.cwiseQuotient(mass_).cwiseAbs().maxCoeff() > limit, isSmooth = smoothing_ > lastSmoothing;
        if ((!isOff && !isSmooth) || steps == maxSteps) return steps;
        const Eigen::VectorXd step = newtonStep(g);
        const double startSlope = g.dot(step);
        // No way down: rounding is all that is left.
        if (!(startSlope < 0.0) && !isSmooth) return steps;
        const double share = startSlope < 0.0 ? moveAlong(x, step, startSlope) : 1.0;
        if (share >= fullStep) smoothing_ = std::max(lastSmoothing, lessSmooth*smoothing_);
    }
}

} // namespace nscd
