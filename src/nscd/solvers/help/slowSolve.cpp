// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Anderson mixing or momentum with a safeguard, and a queue for the last bad contacts.
#include "nscd/solvers/help/slowSolve.hpp"

#include "nscd/solvers/help/stiffClusters.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

/// Whether no contact carries an impulse.
bool isCold(const ContactProblem& problem)
{
    const BlockRange active = problem.active();
    for (std::size_t k = 0; k < active.count; ++k)
    {
        const double* r = &problem.blocks[active[k]].r[0][0];
        if (std::any_of(r, r + 3*blockLanes, [](double x) { return x != 0.0; })) return false;
    }
    return true;
}

} // namespace

SlowSolve::SlowSolve(ContactProblem& problem, const SolverStrategy& strategy)
:
    problem_(problem),
    strategy_(strategy),
    isFalling_(isCold(problem)),
    haveClusters_(haveStiffClusters(problem, strategy.clusters)),
    pause_(strategy.slowness.pause)
{}

int SlowSolve::afterSweep(int sweeps, const DefectSums& sums, const StopRule& rule)
{
    if (areClustersDue(sweeps, sums, rule))
    {
        solveClusters(sweeps, rule);
        return 0;
    }
    if (rule.wereForcesOff && !isFalling_ && sweeps > strategy_.slowness.flowPatience && canBringForcesDown())
    {
        bringForcesDown(sweeps);
        return 0;
    }
    if (!anderson_ && !momentum_)
    {
        // What each rank knows of itself, before anything depends on it: velocities extrapolated on some ranks alone would not be those of the impulses.
        if (sweeps == strategy_.slowness.flowPatience) isFalling_ = !problem_.halo.any(!isFalling_);
        const int sweepsToWait = isFalling_ ? strategy_.slowness.coldPatience : isFlowing() ? strategy_.slowness.flowPatience : strategy_.slowness.patience;
        if (sweeps % sweepsToWait == 0 && isSlow(sweepsToWait, sums))
        {
            isFalling_ = isFalling_ || (canBringForcesDown() && areForcesOff(rule));
            if (hasHelp()) start(sweeps);
        }
        return isLocal(sweeps, sums, rule) && !hasHelp() ? solveLocally(sweeps, rule) : 0;
    }
    best_ = std::min(best_, sums.sumSquares);
    if (sweeps >= endOfTerm_) judgeTerm(sweeps, rule);
    if (isPausing_) return isLocal(sweeps, sums, rule) ? solveLocally(sweeps, rule) : 0;
    ++sinceMixing_;
    if (isMixed_ && sinceMixing_ == 1 && sums.sumSquares > strategy_.slowness.growthAllowed*squaresBefore_)
    {
        revert();
        return 0;
    }
    if (isLocal(sweeps, sums, rule)) return solveLocally(sweeps, rule);
    if (isMixingDue(sums, rule)) mix(sums, rule);
    return 0;
}

bool SlowSolve::isMixingDue(const DefectSums& sums, const StopRule& rule) const
{
    // Momentum would lead out of the rule again while a solution is polished.
    return momentum_ ? !rule.isMet(sums) : sinceMixing_ >= strategy_.mixing.sweepsBetween;
}

bool SlowSolve::isSlow(int sweepsBetween, const DefectSums& sums)
{
    const double fast = !isFalling_ && isFlowing() ? strategy_.slowness.fastFlowContraction : strategy_.slowness.fastContraction;
    const bool isSlow = sums.sumSquares > std::pow(fast, 2*sweepsBetween)*squaresBefore_;
    squaresBefore_ = sums.sumSquares;
    return isSlow;
}

/// By momentum, where mixing is used otherwise: that hardly moves what is off in a bed as a whole.
bool SlowSolve::canBringForcesDown() const { return strategy_.momentum.isOn && !problem_.areForcesBounded(); }

bool SlowSolve::areForcesOff(const StopRule& rule) const { return forceErrorNow(rule, problem_, residual(problem_)) > rule.forceLimit; }

/// What is left of a shock that has come near its solution and crawls on is off in all of a bed.
bool SlowSolve::isShockOfABed(const StopRule& rule) const
{
    return problem_.isShock && momentum_ && !isFalling_ && best_ > strategy_.slowness.slowShock*bestBefore_ && areForcesOff(rule);
}

void SlowSolve::start(int sweeps)
{
    endOfTerm_ = sweeps + strategy_.slowness.probation;
    pause_ = strategy_.slowness.pause;
    isPausing_ = false;
    best_ = bestBefore_ = std::numeric_limits<double>::max();
    makeMixing();
}

/// Whatever helped so far.
void SlowSolve::bringForcesDown(int sweeps)
{
    isFalling_ = true;
    anderson_.reset();
    momentum_.reset();
    start(sweeps);
}

bool SlowSolve::hasHelp() const { return isFalling_ || isFlowing() ? strategy_.momentum.isOn : strategy_.mixing.isOn; }

bool SlowSolve::isFlowing() const { return problem_.isFlowing() && !problem_.general; }

void SlowSolve::makeMixing()
{
    if (isFalling_ || isFlowing())
    {
        const auto kind = isFalling_ ? SweepMomentum::Kind::falling : SweepMomentum::Kind::flowing;
        if (!momentum_) momentum_ = std::make_unique<SweepMomentum>(problem_, kind, strategy_.momentum);
    }
    else
    {
        anderson_.reset();  // before the new one asks for as much memory
        anderson_ = std::make_unique<AndersonAcceleration>(problem_.active(), problem_.kernels.addDifferences, problem_.halo);
    }
    restart();
}

void SlowSolve::forget()
{
    queue_.reset();
    if (anderson_ || momentum_) makeMixing();
}

void SlowSolve::wake()
{
    if (!momentum_ || !problem_.leftOut) return forget();
    // Contacts that a packed problem gains stand behind those of their kind, and have carried nothing so far.
    queue_.reset();
    momentum_->grow();
}

void SlowSolve::forgetDirections()
{
    if (momentum_) momentum_->forget();
    else anderson_->forget();
}

void SlowSolve::restart()
{
    if (!momentum_ && !anderson_) return;
    forgetDirections();
    if (momentum_) momentum_->advance();
    else gatherImpulses(problem_.blocks, problem_.active(), start_);
    sinceMixing_ = 0;
    isMixed_ = false;
}

void SlowSolve::judgeTerm(int sweeps, const StopRule& rule)
{
    if (isShockOfABed(rule)) return bringForcesDown(sweeps);
    const bool isFailing = !isPausing_ && best_ > strategy_.slowness.leastProgress*bestBefore_;
    if (isPausing_) restart();
    if (isFailing && !(isFalling_ && canBringForcesDown())) pause_ *= 2;
    isPausing_ = isFailing;
    endOfTerm_ = sweeps + (isFailing ? pause_ : strategy_.slowness.probation);
    bestBefore_ = best_;
}

void SlowSolve::mix(const DefectSums& sums, const StopRule& rule)
{
    squaresBefore_ = sums.sumSquares;
    if (momentum_)
    {
        if (sinceMixing_ > 1) momentum_->forget();
        momentum_->advance(rms(sums) < strategy_.momentum.nearRule*rule.rmsLimit);
    }
    else
    {
        anderson_->mix(problem_.blocks, start_);
        replaceImpulses(problem_, start_);
    }
    sinceMixing_ = 0;
    isMixed_ = true;
}

void SlowSolve::revert()
{
    if (momentum_) momentum_->revert();
    else
    {
        start_ = anderson_->image();
        replaceImpulses(problem_, start_);
    }
    forgetDirections();
    sinceMixing_ = 0;
    isMixed_ = false;
}

bool SlowSolve::areClustersDue(int sweeps, const DefectSums& sums, const StopRule& rule) const
{
    return haveClusters_ && sweeps - lastClusters_ >= strategy_.clusters.sweepsBetween && !rule.isMet(sums);
}

void SlowSolve::solveClusters(int sweeps, const StopRule& rule)
{
    newtonSteps_ += StiffClusters(problem_, strategy_.clusters).solve(strategy_.clusters.shareOfLimit*std::min(rule.maxLimit, rule.rmsLimit));
    lastClusters_ = sweeps;
    queue_.reset();
    restart();
}

bool SlowSolve::isLocal(int sweeps, const DefectSums& sums, const StopRule& rule) const
{
    return strategy_.queue.isOn && sweeps - lastLocal_ > strategy_.queue.sweepsBetween && sums.maxSquare > rule.maxLimit*rule.maxLimit && rms(sums) < rule.rmsLimit;
}

/// On all ranks.
bool SlowSolve::areMany(std::size_t off, std::size_t used) const
{
    double sums[2] = {static_cast<double>(off), static_cast<double>(used)};
    problem_.halo.sum(sums, 2);
    return sums[0] > std::max(strategy_.queue.fewOff, strategy_.queue.mostOff*sums[1]);
}

int SlowSolve::solveLocally(int sweeps, const StopRule& rule)
{
    // Between ranks there are only sweeps: each works on contacts that no other can disturb.
    const std::vector<std::uint32_t> within = queue_ ? std::vector<std::uint32_t>() : problem_.withinRank();
    if (!queue_) queue_ = std::make_unique<ContactQueue>(problem_, BlockRange{within.data(), within.size()});
    const std::size_t used = std::max<std::size_t>(1, queue_->slots().size());
    const double threshold = (problem_.isFlowing() ? strategy_.queue.shareInFlow : strategy_.queue.shareOfLimit)*rule.maxLimit;
    lastLocal_ = sweeps;
    const std::vector<std::uint32_t> off = queue_->defective(threshold);
    if (areMany(off.size(), used)) return 0;
    const std::size_t visits = queue_->work(off, threshold, strategy_.queue.mostSweeps*used);
    restart();
    return static_cast<int>(problem_.halo.max(static_cast<double>((visits + used - 1)/used)));
}

} // namespace nscd
