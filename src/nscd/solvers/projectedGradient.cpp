// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Accelerated projected gradient, as a solver behind the common signature: all contacts at once, whatever their order.
// Tested by tests/unit/nscd/solvers/contactSolverTest.cpp
#include "nscd/solvers/contactSolver.hpp"
#include "nscd/solvers/help/andersonAcceleration.hpp"
#include "nscd/solvers/problem/localContact.hpp"
#include "nscd/solvers/sweepLoop.hpp"

#include <algorithm>
#include <numeric>

namespace nscd
{

namespace
{

/// r' = Proj(y - D^-1 (u(y) + b)), y' = r' + theta (r' - r), theta = (t - 1)/t', t' = (1 + sqrt(1 + 4 t^2))/2 (Nesterov), with t = 1 again
/// where (y - r').D(r' - r) > 0 (O'Donoghue & Candes 2015, gradient scheme). Proj: normal part >= 0, tangential part within the disc of the
/// Tresca bound mu r'_n, which each iteration refreshes. D bounds W: a body with z loaded contacts counts z times in the
/// W_nn and W_tt of each, since |sum of z vectors|^2 <= z times the sum of their squares.
class ProjectedGradient
{
public:
    explicit ProjectedGradient(ContactProblem& problem) : problem_(problem), loaded_(problem.bodies.size())
    {
        gatherImpulses(problem_.blocks, problem_.active(), previous_);
        target_.resize(previous_.size());
    }

    DefectSums pass() { return residual(problem_); }

    int afterSweep(int, const DefectSums&, const StopRule&)
    {
        countLoaded();
        const double uphill = project();
        if (uphill > 0.0) t_ = 1.0;
        const double next = 0.5*(1.0 + std::sqrt(1.0 + 4.0*t_*t_)), theta = (t_ - 1.0)/next;
        t_ = next;
        for (std::size_t i = 0; i < target_.size(); ++i)
        {
            const double r = target_[i];
            target_[i] += theta*(r - previous_[i]);
            previous_[i] = r;
        }
        replaceImpulses(problem_, target_);
        return 0;
    }

    void forget() {}  // no block sleeps
    bool polish(const DefectSums& sums, const StopRule& rule) const { return rule.isPolished(sums); }
    void complete(SolveReport&, const StopRule&) {}

private:
    /// Counts for each body the contacts that are closed, carry an impulse, or get one now: those that stay without one do not change W's bound.
    void countLoaded()
    {
        std::fill(loaded_.begin(), loaded_.end(), 0);
        for (std::size_t slot = 0; slot < problem_.blocks.size()*blockLanes; ++slot)
        {
            const ContactBlock& block = problem_.blocks[slot/blockLanes];
            const int lane = slot % blockLanes;
            if (!isUsed(block, lane)) continue;
            const bool counts = block.bias[lane] == 0.0 || isLoaded(block, lane) || localChange(problem_, slot, 1.0, 1.0).defect > 0.0;
            if (!counts) continue;
            ++loaded_[block.a[lane]];
            ++loaded_[block.b[lane]];
        }
    }

    static bool isLoaded(const ContactBlock& block, int lane)
    {
        return block.r[0][lane] != 0.0 || block.r[1][lane] != 0.0 || block.r[2][lane] != 0.0;
    }

    /// Sets the target to r' and returns (y - r').D(r' - r).
    double project()
    {
        double uphill = 0.0;
        for (std::size_t slot = 0; slot < problem_.blocks.size()*blockLanes; ++slot)
        {
            const ContactBlock& block = problem_.blocks[slot/blockLanes];
            const int lane = slot % blockLanes;
            if (!isUsed(block, lane)) continue;
            const double za = std::max(1, loaded_[block.a[lane]]), zb = std::max(1, loaded_[block.b[lane]]);
            const Body& a = problem_.bodies[block.a[lane]];
            const Body& b = problem_.bodies[block.b[lane]];
            const double dn = za*a.invMass + zb*b.invMass, dt = dn + za*a.invSpin + zb*b.invSpin;
            const LocalChange change = localChange(problem_, slot, dn, dt);
            for (int m = 0; m < 3; ++m)
            {
                const std::size_t i = (3*(slot/blockLanes) + m)*blockLanes + lane;
                target_[i] = block.r[m][lane] + change.impulse[m];
                uphill -= change.impulse[m]*dn*(target_[i] - previous_[i]);
            }
        }
        return uphill;
    }

    ContactProblem& problem_;
    AndersonAcceleration::Impulses previous_;   ///< r
    AndersonAcceleration::Impulses target_;
    std::vector<int> loaded_;                   ///< z, per body
    double t_ = 1.0;
};

} // namespace

SolveReport solveProjectedGradient(ContactProblem& problem, const ContactSettings& settings)
{
    if (problem.blocks.empty()) return SolveReport();
    problem.awake.resize(problem.blocks.size());
    std::iota(problem.awake.begin(), problem.awake.end(), 0u);
    ProjectedGradient gradient(problem);
    return sweepUntilMet(problem, settings, gradient);
}

} // namespace nscd
