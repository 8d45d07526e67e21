// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Help for a Gauss-Seidel solve that turns out to be slow.
// Tested by tests/unit/nscd/solvers/help/slowSolveTest.cpp, tests/unit/nscd/solvers/help/sweepMomentumTest.cpp, tests/unit/nscd/scene/solverStrategyTest.cpp
#pragma once

#include "nscd/solvers/help/andersonAcceleration.hpp"
#include "nscd/solvers/help/contactQueue.hpp"
#include "nscd/solvers/help/sweepMomentum.hpp"

#include <limits>
#include <memory>

namespace nscd
{

/// Watches the sweeps of one solve. After some sweeps it mixes iterates, or gives them momentum where most grains move or weight has to
/// come down (the solve began without any impulse, or forces are off), which shortens what is slow everywhere. When all that is left
/// is a few bad contacts it works those off by a queue, since clusters that wedge or slip take hundreds of visits and would
/// otherwise make as many sweeps over everything.
class SlowSolve
{
public:
    SlowSolve(ContactProblem& problem, const SolverStrategy& strategy);

    /// `sums`: defects that the sweep met, or those that it left, where these were looked at. Returns the work done beside sweeps, in sweeps.
    int afterSweep(int sweeps, const DefectSums& sums, const StopRule& rule);

    /// What the next sweep has to move the impulses on by, velocities having been moved.
    SweepOn forNextSweep() { return momentum_ ? momentum_->forNextSweep() : SweepOn(); }

    /// Newton steps for clusters so far, which are beside the sweeps.
    int newtonSteps() const { return newtonSteps_; }

    /// To be called when something else changed the solution: what was collected about it is of no use.
    void forget();
    /// To be called when blocks woke up.
    void wake();

private:
    bool areClustersDue(int sweeps, const DefectSums& sums, const StopRule& rule) const;
    void solveClusters(int sweeps, const StopRule& rule);
    bool isLocal(int sweeps, const DefectSums& sums, const StopRule& rule) const;
    bool areMany(std::size_t off, std::size_t used) const;
    int solveLocally(int sweeps, const StopRule& rule);
    bool isSlow(int sweepsBetween, const DefectSums& sums);
    void start(int sweeps);
    bool canBringForcesDown() const;
    void bringForcesDown(int sweeps);
    bool areForcesOff(const StopRule& rule) const;
    bool isShockOfABed(const StopRule& rule) const;
    bool isFlowing() const;
    bool hasHelp() const;
    void makeMixing();
    void restart();
    void judgeTerm(int sweeps, const StopRule& rule);
    void mix(const DefectSums& sums, const StopRule& rule);
    void revert();
    bool isMixingDue(const DefectSums& sums, const StopRule& rule) const;
    void forgetDirections();

    ContactProblem& problem_;
    const SolverStrategy& strategy_;
    bool isFalling_;            ///< weight has to come down: started without any impulse (here, until all ranks were asked), or forces are off
    bool haveClusters_;
    std::unique_ptr<AndersonAcceleration> anderson_;
    std::unique_ptr<SweepMomentum> momentum_;   ///< in its place where weight comes down, and in a flow
    AndersonAcceleration::Impulses start_;      ///< impulses after the last mixing
    std::unique_ptr<ContactQueue> queue_;
    int sinceMixing_ = 0;
    int lastLocal_ = 0;
    int lastClusters_ = 0;
    int newtonSteps_ = 0;
    bool isMixed_ = false;
    int pause_;
    int endOfTerm_ = 0;
    bool isPausing_ = false;
    double best_ = std::numeric_limits<double>::max();
    double bestBefore_ = std::numeric_limits<double>::max();
    double squaresBefore_ = std::numeric_limits<double>::max();
};

} // namespace nscd
