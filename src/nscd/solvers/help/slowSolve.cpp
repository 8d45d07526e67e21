// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Anderson mixing or momentum with a safeguard, and a queue for the last bad contacts.
#include "nscd/solvers/help/slowSolve.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

// Measured on solves of landing and settling beds that take plain sweeps 200 to 2000: depth and interval of the mixing matter
// little (2 to 5, 2 to 4); without the queue one solve in twenty goes to the cap, with it none did.
constexpr int patience = 10;
constexpr int coldPatience = 5;
constexpr int flowPatience = 3;  // the least of the three
/// A solve whose defect shrinks faster than this a sweep needs no mixing. Mixing overshoots, and where friction makes impulses
/// indeterminate an overshoot stays as self-stress: small scenes are better off without.
constexpr double fastContraction = 0.93;
/// The same where grains flow: the first sweeps tell more of the steep beginning than of what follows.
constexpr double fastFlowContraction = 0.85;
/// Mixed every sweep, a bed near rest keeps speeds of 4e-5 g dt instead of less than 1e-5, and its wall forces err by 1e-6 of the weight
/// instead of 1e-7.
constexpr int sweepsPerMixing = 3;
/// A mixing after which the sum of squared defects grows by more than this is taken back.
constexpr double growthAllowed = 4.0;
/// Solutions nearer than this multiple of the rms limit are near.
constexpr double nearRule = 6.0;
/// Sweeps in which mixing must bring the sum of squared defects below this share, else it pauses: high friction can trap it.
constexpr double leastProgress = 0.9;
constexpr int probation = 60;
constexpr int sweepsBetweenQueues = 10;
/// Of the largest defect allowed, what the queue leaves. Its defects are not quite those of the residual; 0.7 takes half the visits in flows.
constexpr double shareOfLimit = 0.5, shareInFlow = 0.7;
constexpr std::size_t sweepsPerQueue = 20;

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

SlowSolve::SlowSolve(ContactProblem& problem)
:
    problem_(problem),
    isCold_(isCold(problem))
{}

int SlowSolve::afterSweep(int sweeps, const DefectSums& sums, const StopRule& rule)
{
    if (!anderson_ && !momentum_)
    {
        // What each rank knows of itself, before anything depends on it: velocities extrapolated on some ranks alone would not be those of the impulses.
        if (sweeps == flowPatience) isCold_ = !problem_.halo.any(!isCold_);
        const int sweepsToWait = isCold_ ? coldPatience : isFlowing() ? flowPatience : patience;
        if (sweeps % sweepsToWait == 0 && isSlow(sweepsToWait, sums)) start(sweeps);
        return 0;
    }
    best_ = std::min(best_, sums.sumSquares);
    if (sweeps >= endOfTerm_) judgeTerm(sweeps);
    if (isPausing_) return isLocal(sweeps, sums, rule) ? solveLocally(sweeps, rule) : 0;
    ++sinceMixing_;
    if (isMixed_ && sinceMixing_ == 1 && sums.sumSquares > growthAllowed*squaresBefore_)
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
    return momentum_ ? !rule.isMet(sums) : sinceMixing_ >= sweepsPerMixing;
}

bool SlowSolve::isSlow(int sweepsBetween, const DefectSums& sums)
{
    const double fast = !isCold_ && isFlowing() ? fastFlowContraction : fastContraction;
    const bool isSlow = sums.sumSquares > std::pow(fast, 2*sweepsBetween)*squaresBefore_;
    squaresBefore_ = sums.sumSquares;
    return isSlow;
}

void SlowSolve::start(int sweeps)
{
    endOfTerm_ = sweeps + probation;
    makeMixing();
}

bool SlowSolve::isFlowing() const { return problem_.isFlowing() && !problem_.rolling && !problem_.clumps; }

void SlowSolve::makeMixing()
{
    if (isCold_ || isFlowing())
    {
        const auto kind = isCold_ ? SweepMomentum::Kind::falling : SweepMomentum::Kind::flowing;
        if (!momentum_) momentum_ = std::make_unique<SweepMomentum>(problem_, kind);
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
    if (!momentum_ || !problem_.isPacked) return forget();
    // Contacts that a packed problem gains stand behind the others, and have carried nothing so far.
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
    forgetDirections();
    if (momentum_) momentum_->advance();
    else gatherImpulses(problem_.blocks, problem_.active(), start_);
    sinceMixing_ = 0;
    isMixed_ = false;
}

void SlowSolve::judgeTerm(int sweeps)
{
    const bool isFailing = !isPausing_ && best_ > leastProgress*bestBefore_;
    if (isPausing_) restart();
    if (isFailing) pause_ *= 2;
    isPausing_ = isFailing;
    endOfTerm_ = sweeps + (isFailing ? pause_ : probation);
    bestBefore_ = best_;
}

void SlowSolve::mix(const DefectSums& sums, const StopRule& rule)
{
    squaresBefore_ = sums.sumSquares;
    if (momentum_)
    {
        if (sinceMixing_ > 1) momentum_->forget();
        momentum_->advance(rms(sums) < nearRule*rule.rmsLimit);
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

bool SlowSolve::isLocal(int sweeps, const DefectSums& sums, const StopRule& rule) const
{
    return sweeps - lastLocal_ > sweepsBetweenQueues && sums.maxSquare > rule.maxLimit*rule.maxLimit && rms(sums) < rule.rmsLimit;
}

int SlowSolve::solveLocally(int sweeps, const StopRule& rule)
{
    // Between ranks there are only sweeps: each works on contacts that no other can disturb.
    if (!queue_) queue_ = std::make_unique<ContactQueue>(problem_, problem_.clumps ? problem_.active() : problem_.inner());
    const std::size_t used = std::max<std::size_t>(1, queue_->slots().size());
    const double threshold = (problem_.isFlowing() ? shareInFlow : shareOfLimit)*rule.maxLimit;
    const std::size_t visits = queue_->work(queue_->defective(threshold), threshold, sweepsPerQueue*used);
    lastLocal_ = sweeps;
    restart();
    return static_cast<int>(problem_.halo.max(static_cast<double>((visits + used - 1)/used)));
}

} // namespace nscd
