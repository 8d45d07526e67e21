// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Anderson mixing with a safeguard, and a queue for the last bad contacts.
#include "slowSolve.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

// Measured on solves of landing and settling beds that take plain sweeps 200 to 2000: depth and interval of the mixing matter
// little (2 to 5, 2 to 4); without the queue one solve in twenty goes to the cap, with it none did.
constexpr int patience = 10;
/// A solve whose defect shrinks faster than this a sweep needs no mixing. Mixing overshoots, and where friction makes impulses
/// indeterminate an overshoot stays as self-stress: small scenes are better off without.
constexpr double fastContraction = 0.93;
/// Mixing every sweep takes cold solves of 10 000 spheres 159 sweeps instead of 224, at the same time; but a bed near rest then keeps
/// speeds of 4e-5 g dt instead of less than 1e-5, and its wall forces err by 1e-6 of the weight instead of 1e-7.
constexpr int sweepsPerMixing = 3;
/// A mixing after which the sum of squared defects grows by more than this is taken back.
constexpr double growthAllowed = 4.0;
/// Sweeps in which mixing must bring the sum of squared defects below this share, else it pauses: high friction can trap it.
constexpr double leastProgress = 0.9;
constexpr int probation = 60;
constexpr int sweepsBetweenQueues = 10;
constexpr std::size_t sweepsPerQueue = 20;
/// Solves to this tolerance or a finer one scale layers when they start cold. A coarser one is met before weight has come down through
/// a deep bed, and sooner without: what is missing follows in the next steps.
constexpr double fineTolerance = 3e-3;
/// Layers are scaled this often, until it changes little or for a limited number of times: near the solution it only disturbs.
constexpr int sweepsPerScaling = 20;
constexpr double smallScaling = 0.1;
constexpr int mostScalings = 15;

/// Whether no contact carries an impulse.
bool isCold(const ContactProblem& problem)
{
    const BlockRange active = problem.active();
    bool isLoaded = false;
    for (std::size_t k = 0; k < active.count && !isLoaded; ++k)
    {
        const double* r = &problem.blocks[active[k]].r[0][0];
        isLoaded = std::any_of(r, r + 3*blockLanes, [](double x) { return x != 0.0; });
    }
    return !isLoaded;
}

} // namespace

SlowSolve::SlowSolve(ContactProblem& problem)
:
    problem_(problem),
    isScalingDone_(problem.halo.isParallel() || problem.clumps || !isCold(problem))
{}

int SlowSolve::afterSweep(int sweeps, const DefectSums& sums, const StopRule& rule)
{
    if (!anderson_)
    {
        if (sweeps % patience == 0 && isSlow(sums)) start(sweeps);
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
    if (isScalingDue(sweeps, rule)) scaleLayers(sweeps);
    else if (sinceMixing_ >= sweepsPerMixing) mix(sums);
    return 0;
}

bool SlowSolve::isScalingDue(int sweeps, const StopRule& rule) const
{
    return !isScalingDone_ && sweeps % sweepsPerScaling == 0 && rule.rmsLimit <= fineTolerance*rule.speedScale;
}

void SlowSolve::scaleLayers(int sweeps)
{
    if (!layers_) layers_ = std::make_unique<LayerScaling>(problem_);
    isScalingDone_ = layers_->apply() < smallScaling || ++scalings_ == mostScalings;
    restart();
    // Scaling trades balance of the whole for balance of each grain: what mixing achieves is measured from here.
    endOfTerm_ = sweeps + probation;
    best_ = bestBefore_ = std::numeric_limits<double>::max();
}

bool SlowSolve::isSlow(const DefectSums& sums)
{
    const bool isSlow = sums.sumSquares > std::pow(fastContraction, 2*patience)*squaresBefore_;
    squaresBefore_ = sums.sumSquares;
    return isSlow;
}

void SlowSolve::start(int sweeps)
{
    endOfTerm_ = sweeps + probation;
    makeMixing();
}

void SlowSolve::makeMixing()
{
    anderson_.reset();  // before the new one asks for as much memory
    anderson_ = std::make_unique<AndersonAcceleration>(problem_.active(), problem_.kernels.addDifferences, problem_.halo);
    restart();
}

void SlowSolve::forget()
{
    queue_.reset();
    if (anderson_) makeMixing();
}

void SlowSolve::restart()
{
    anderson_->forget();
    gatherImpulses(problem_.blocks, problem_.active(), start_);
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

void SlowSolve::mix(const DefectSums& sums)
{
    squaresBefore_ = sums.sumSquares;
    anderson_->mix(problem_.blocks, start_);
    replaceImpulses(problem_, start_);
    sinceMixing_ = 0;
    isMixed_ = true;
}

void SlowSolve::revert()
{
    start_ = anderson_->image();
    replaceImpulses(problem_, start_);
    anderson_->forget();
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
    const double threshold = 0.5*rule.maxLimit;
    const std::size_t visits = queue_->work(queue_->defective(threshold), threshold, sweepsPerQueue*used);
    lastLocal_ = sweeps;
    restart();
    return static_cast<int>(problem_.halo.max(static_cast<double>((visits + used - 1)/used)));
}

} // namespace nscd
