// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Two passes over the impulses a sweep.
#include "sweepMomentum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nscd
{

namespace
{

constexpr int blockSize = 3*blockLanes;
/// With 1 and 1.2 beds 10 to 75 d deep take about as many sweeps (cold, to 1e-3); with 0.5 or 3 up to twice as many.
constexpr double limitPerDepth = 1.2;
constexpr double leastLimit = 0.9, mostLimit = 0.99;

/// Direction of the momentum of all bodies; zero where they have none.
Vec3 fallingDirection(const ContactProblem& problem)
{
    Vec3 momentum = Vec3::Zero();
    for (const Body& body : problem.bodies)
    {
        if (body.invMass > 0.0) momentum += Vec3(body.v)/body.invMass;
    }
    problem.halo.sum(momentum.data(), 3);
    return momentum.norm() > 0.0 ? Vec3(momentum.normalized()) : Vec3::Zero();
}

/// Extent of the bodies along the way they fall, in d.
double depth(const ContactProblem& problem)
{
    const Vec3 down = fallingDirection(problem);
    double ends[2] = {-std::numeric_limits<double>::max(), -std::numeric_limits<double>::max()};
    for (const Vec3& x : problem.position)
    {
        const double way = down.dot(x);
        ends[0] = std::max(ends[0], way);
        ends[1] = std::max(ends[1], -way);
    }
    problem.halo.max(ends, 2);
    return (ends[0] + ends[1])/problem.diameter;
}

} // namespace

SweepMomentum::SweepMomentum(const ContactProblem& problem)
:
    problem_(problem),
    limit_(std::clamp(1.0 - limitPerDepth/std::max(1.0, depth(problem)), leastLimit, mostLimit))
{}

double SweepMomentum::uphill(const Impulses& y) const
{
    const BlockRange active = problem_.active();
    double sum = 0.0;
    for (std::size_t k = 0; k < active.count; ++k)
    {
        const ContactBlock& block = problem_.blocks[active[k]];
        double products[blockLanes] = {};
        for (int m = 0; m < 3; ++m)
        {
            const std::size_t at = k*blockSize + m*blockLanes;
            for (int l = 0; l < blockLanes; ++l) products[l] += (y[at + l] - block.r[m][l])*(block.r[m][l] - image_[at + l]);
        }
        for (int l = 0; l < blockLanes; ++l) sum += block.invWn[l] > 0.0 ? products[l]/block.invWn[l] : 0.0;
    }
    return problem_.halo.sum(sum);
}

void SweepMomentum::mix(Impulses& y)
{
    if (!hasImage_)
    {
        gatherImpulses(problem_.blocks, problem_.active(), image_);
        y = image_;
        hasImage_ = true;
        return;
    }
    if (uphill(y) > 0.0) pace_ = 1.0;
    const double next = 0.5*(1.0 + std::sqrt(1.0 + 4.0*pace_*pace_)), theta = std::min((pace_ - 1.0)/next, limit_);
    pace_ = next;
    const BlockRange active = problem_.active();
    for (std::size_t k = 0; k < active.count; ++k)
    {
        const double* r = &problem_.blocks[active[k]].r[0][0];
        double* before = image_.data() + k*blockSize;
        double* out = y.data() + k*blockSize;
        for (int i = 0; i < blockSize; ++i)
        {
            out[i] = r[i] + theta*(r[i] - before[i]);
            before[i] = r[i];
        }
    }
}

} // namespace nscd
