// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Passes over impulses and velocities after a sweep.
#include "nscd/solvers/help/sweepMomentum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nscd
{

namespace
{

constexpr int blockSize = 3*blockLanes;

/// Direction of the momentum that all bodies would have without contacts, where that is known, else of what they have; zero where they have none.
Vec3 fallingDirection(const ContactProblem& problem)
{
    Vec3 momentum = Vec3::Zero();
    const std::size_t count = problem.freeVelocity ? problem.freeVelocity->size() : problem.bodies.size();
    for (std::size_t k = 0; k < count; ++k)
    {
        const Body& body = problem.bodies[k];
        if (body.invMass > 0.0) momentum += (problem.freeVelocity ? (*problem.freeVelocity)[k] : Vec3(body.v))/body.invMass;
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

double limitOfDepth(double depth, const SolverStrategy::Momentum& strategy)
{
    return std::clamp(1.0 - strategy.limitPerDepth/std::max(1.0, depth), strategy.leastLimit, strategy.mostLimit);
}

} // namespace

SweepMomentum::SweepMomentum(ContactProblem& problem, Kind kind, const SolverStrategy::Momentum& strategy)
:
    problem_(problem),
    kind_(kind),
    strategy_(strategy),
    limit_(kind == Kind::flowing ? strategy.flowing : limitOfDepth(depth(problem), strategy))
{}

double SweepMomentum::uphill() const
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
            for (int l = 0; l < blockLanes; ++l) products[l] += (start_[at + l] - block.r[m][l])*(block.r[m][l] - image_[at + l]);
        }
        for (int l = 0; l < blockLanes; ++l) sum += block.invWn[l] > 0.0 ? products[l]/block.invWn[l] : 0.0;
    }
    return problem_.halo.sum(sum);
}

double SweepMomentum::nextTheta(bool isNear)
{
    if (kind_ == Kind::flowing) return isNear ? strategy_.near : strategy_.flowing;
    if (uphill() > 0.0) pace_ = 1.0;
    const double next = 0.5*(1.0 + std::sqrt(1.0 + 4.0*pace_*pace_)), theta = std::min((pace_ - 1.0)/next, limit_);
    pace_ = next;
    return theta;
}

void SweepMomentum::keepImage()
{
    gatherImpulses(problem_.blocks, problem_.active(), image_);
    gatherLaw();
    bodies_ = problem_.bodies;
    inner_ = problem_.inner().count;
    hasImage_ = true;
}

void SweepMomentum::gatherLaw()
{
    if (!problem_.lawBlocks) return;
    const BlockRange active = problem_.active();
    ofLaw_.resize(blockSize*active.count);
    for (std::size_t k = 0; k < active.count; ++k) std::copy_n(&(*problem_.lawBlocks)[active[k]].q[0][0], blockSize, ofLaw_.data() + k*blockSize);
}

void SweepMomentum::extrapolateLaw(double theta)
{
    const BlockRange active = problem_.active();
    for (std::size_t k = 0; problem_.lawBlocks && k < active.count; ++k)
    {
        double *const q = &(*problem_.lawBlocks)[active[k]].q[0][0], *const before = ofLaw_.data() + k*blockSize;
        for (int i = 0; i < blockSize; ++i)
        {
            const double now = q[i];
            q[i] += theta*(now - before[i]);
            before[i] = now;
        }
    }
}

void SweepMomentum::extrapolate(double theta)
{
    if (!isLinear()) return extrapolateImpulsesAlone(theta);
    const SweepKernels& kernels = problem_.kernels;
    kernels.extrapolateBodies(problem_.bodies.data(), bodies_.data(), bodies_.size(), theta);
    if (kind_ == Kind::flowing)
    {
        // The sweep that follows comes by all blocks anyway.
        forNextSweep_ = {image_.data(), ofLaw_.data(), theta};
        return;
    }
    kernels.extrapolate(problem_.blocks.data(), problem_.active(), image_.data(), theta);
    extrapolateLaw(theta);
    gatherImpulses(problem_.blocks, problem_.active(), start_);
}

/// Where blocks do not tell all that moves bodies (general bodies): velocities follow the impulses, projected on their cones.
void SweepMomentum::extrapolateImpulsesAlone(double theta)
{
    gatherImpulses(problem_.blocks, problem_.active(), start_);
    image_.swap(start_);
    for (std::size_t i = 0; i < start_.size(); ++i) start_[i] = image_[i] + theta*(image_[i] - start_[i]);
    replaceImpulses(problem_, start_);
}

void SweepMomentum::advance(bool isNear)
{
    if (hasImage_) return extrapolate(nextTheta(isNear));
    keepImage();
    start_ = image_;
}

void SweepMomentum::grow()
{
    const std::size_t numbers = blockSize*problem_.active().count, innerNow = problem_.inner().count;
    // Also where a rank had none so far.
    for (Impulses* impulses : {&image_, &start_, &ofLaw_})
    {
        if (impulses == &ofLaw_ && !problem_.lawBlocks) continue;
        impulses->insert(impulses->begin() + static_cast<std::ptrdiff_t>(blockSize*inner_), blockSize*(innerNow - inner_), 0.0);
        impulses->resize(numbers, 0.0);
    }
    inner_ = innerNow;
}

void SweepMomentum::revert()
{
    if (!isLinear()) return replaceImpulses(problem_, start_ = image_);
    const BlockRange active = problem_.active();
    for (std::size_t k = 0; k < active.count; ++k)
    {
        const double* const held = image_.data() + k*blockSize;
        std::copy(held, held + blockSize, &problem_.blocks[active[k]].r[0][0]);
        if (problem_.lawBlocks) std::copy_n(ofLaw_.data() + k*blockSize, blockSize, &(*problem_.lawBlocks)[active[k]].q[0][0]);
    }
    problem_.bodies = bodies_;
}

} // namespace nscd
