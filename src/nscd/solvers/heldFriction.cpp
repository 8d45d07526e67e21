// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Rounds of convex problems.
#include "nscd/solvers/heldFriction.hpp"

#include "nscd/solvers/help/sweepMomentum.hpp"
#include "nscd/solvers/problem/localContact.hpp"
#include "nscd/solvers/sweepLoop.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace nscd
{

namespace
{

/// Sweeps with the momentum of a problem that is convex: restarted where it goes uphill, it may be large. None with general bodies, for which
/// momentum would put impulses back on the cones of Coulomb's law.
class ConvexHelp
{
public:
    ConvexHelp(ContactProblem& problem, const SolverStrategy& strategy) : problem_(problem), strategy_(strategy.momentum)
    {
        strategy_.leastLimit = strategy_.mostLimit;
        forget();
    }

    DefectSums pass() { return sweepActive(problem_, momentum_->forNextSweep()); }
    int afterSweep(int, const DefectSums& sums, const StopRule& rule)
    {
        if (problem_.general) return 0;
        if (rule.isMet(sums)) momentum_->forget();
        else momentum_->advance();
        return 0;
    }
    bool polish(const DefectSums&, const StopRule&) { return true; }
    void forget() { momentum_ = std::make_unique<SweepMomentum>(problem_, SweepMomentum::Kind::falling, strategy_); }
    void complete(SolveReport&, const StopRule&) {}

private:
    ContactProblem& problem_;
    SolverStrategy::Momentum strategy_;
    std::unique_ptr<SweepMomentum> momentum_;
};

/// Sweeps and nothing else.
struct PlainHelp
{
    ContactProblem& problem;

    DefectSums pass() { return sweepActive(problem); }
    int afterSweep(int, const DefectSums&, const StopRule&) { return 0; }
    bool polish(const DefectSums&, const StopRule&) { return true; }
    void forget() {}
    void complete(SolveReport&, const StopRule&) {}
};

/// The problem with friction held, on the same blocks and bodies.
ContactProblem heldProblem(const ContactProblem& problem, const SweepKernels& kernels)
{
    ContactProblem convex
    {
        problem.bodies, problem.blocks, problem.awake, problem.interfaceBlock, problem.halo, kernels, true, problem.deltaT, problem.speedScale,
        problem.diameter, problem.position
    };
    convex.motion = problem.motion;
    convex.isDriven = problem.isDriven;
    convex.freeVelocity = problem.freeVelocity;
    convex.general = problem.general;
    return convex;
}

} // namespace

FrictionBounds::FrictionBounds(ContactProblem& problem) : problem_(problem), other_(problem.blocks.size()*blockLanes, 0.0) { swap(); }

FrictionBounds::~FrictionBounds() { swap(); }

void FrictionBounds::swap()
{
    for (std::size_t k = 0; k < problem_.blocks.size(); ++k) std::swap_ranges(problem_.blocks[k].friction, problem_.blocks[k].friction + blockLanes, &other_[k*blockLanes]);
    if (problem_.general) problem_.general->isFrictionHeld = !problem_.general->isFrictionHeld;
}

double FrictionBounds::normalImpulse(std::size_t slot) const
{
    const ContactBlock& block = problem_.blocks[slot/blockLanes];
    const int lane = slot % blockLanes;
    return std::max(0.0, block.n[0][lane]*block.r[0][lane] + block.n[1][lane]*block.r[1][lane] + block.n[2][lane]*block.r[2][lane]);
}

void FrictionBounds::limit(double factor)
{
    most_.assign(other_.size(), 0.0);
    std::vector<double> ofBody(problem_.bodies.size(), 0.0);
    const auto bodiesOf = [&](std::size_t slot)
    {
        const ContactBlock& block = problem_.blocks[slot/blockLanes];
        return std::array<int, 2>{block.a[slot % blockLanes], block.b[slot % blockLanes]};
    };
    for (std::size_t slot = 0; slot < other_.size(); ++slot)
    {
        for (int body : bodiesOf(slot)) ofBody[body] = std::max(ofBody[body], normalImpulse(slot));
    }
    for (std::size_t slot = 0; slot < other_.size(); ++slot)
    {
        for (int body : bodiesOf(slot))
        {
            const double mobility = problem_.bodies[body].invMass;
            if (mobility > 0.0) most_[slot] = std::max(most_[slot], factor*(ofBody[body] + problem_.speedScale/mobility));
        }
    }
}

void FrictionBounds::follow(double share, bool mayRise)
{
    for (std::size_t slot = 0; slot < other_.size(); ++slot)
    {
        double& tau = problem_.blocks[slot/blockLanes].friction[slot % blockLanes];
        const double mu = other_[slot], next = tau + share*(std::min(mu*normalImpulse(slot), std::min(mu, 1.0)*most_[slot]) - tau);
        tau = mayRise ? next : std::min(tau, next);
    }
}

void FrictionBounds::fade(double share)
{
    for (ContactBlock& block : problem_.blocks)
    {
        for (double& tau : block.friction) tau *= share;
    }
}

double FrictionBounds::off() const
{
    double sums[2] = {0.0, 0.0};
    for (std::size_t slot = 0; slot < other_.size(); ++slot)
    {
        const ContactBlock& block = problem_.blocks[slot/blockLanes];
        const int lane = slot % blockLanes;
        const double tau = block.friction[lane], rn = normalImpulse(slot), law = other_[slot]*rn;
        const double r2 = block.r[0][lane]*block.r[0][lane] + block.r[1][lane]*block.r[1][lane] + block.r[2][lane]*block.r[2][lane];
        const double size = std::sqrt(std::max(0.0, r2 - rn*rn));
        constexpr double atBound = 0.999;
        sums[0] += size >= atBound*tau ? std::abs(tau - law) : std::max(0.0, size - law);
        sums[1] += law;
    }
    problem_.halo.sum(sums, 2);
    return sums[1] > 0.0 ? sums[0]/sums[1] : 0.0;
}

HeldSolve::HeldSolve(ContactProblem& problem, const ContactSettings& settings)
:
    problem_(problem),
    settings_(settings),
    kernels_(held(problem.kernels)),
    convex_(heldProblem(problem, kernels_)),
    bounds_(problem),
    rule_(makeStopRule(problem, settings, residual(convex_)))
{}

void HeldSolve::sweep(int mostSweeps)
{
    ContactSettings ofRound = settings_;
    ofRound.maxSweeps = mostSweeps;
    ConvexHelp help(convex_, settings_.strategy);
    convexReport_ = together(convexReport_, sweepUntilMet(convex_, ofRound, help));
}

bool HeldSolve::isCoulomb()
{
    report_.frictionOff = bounds_.off();
    bounds_.swap();
    reportResidual(report_, rule_, problem_);
    bounds_.swap();
    return report_.converged;
}

bool HeldSolve::follow()
{
    const SolverStrategy::Held& strategy = settings_.strategy.held;
    for (int round = 0; round < strategy.following + strategy.falling; ++round)
    {
        bounds_.follow(round < strategy.following/2 ? 1.0 : strategy.share, round < strategy.following);
        sweep(strategy.sweeps);
        if (convexReport_.converged && isCoulomb()) return true;
    }
    return false;
}

void HeldSolve::fade()
{
    const SolverStrategy::Held& strategy = settings_.strategy.held;
    sweep(settings_.maxSweeps);
    for (int round = 0; round < strategy.fading && convexReport_.atCap; ++round)
    {
        bounds_.fade(round + 1 < strategy.fading ? strategy.share : 0.0);
        sweep(settings_.maxSweeps);
    }
}

SolveReport HeldSolve::solve()
{
    sweep(settings_.maxSweeps);
    bounds_.limit(settings_.strategy.held.pressure);
    if (!follow())
    {
        fade();
        isCoulomb();
    }
    report_.isHeld = !report_.converged && !convexReport_.atCap;
    report_.atCap = !report_.converged && convexReport_.atCap;
    return together(convexReport_, report_);
}

SolveReport solveHeld(ContactProblem& problem, const ContactSettings& settings) { return HeldSolve(problem, settings).solve(); }

SolveReport solvePressed(ContactProblem& problem, const ContactSettings& settings)
{
    const SweepKernels kernels = held(problem.kernels);
    const FrictionBounds bounds(problem);   // all zero
    ContactProblem convex = heldProblem(problem, kernels);
    PlainHelp help{convex};
    SolveReport report = sweepUntilMet(convex, settings, help);
    report.atCap = !report.converged;
    if (!problem.isFrictional) return report;
    report.frictionOff = bounds.off();
    report.isHeld = report.converged;
    report.converged = false;
    return report;
}

} // namespace nscd
