// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Nonlinear Gauss-Seidel (Algorithm 2 of the method): sweeps over all contacts, warm started, accelerated when slow.
#include "andersonAcceleration.hpp"
#include "contactSolver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

namespace nscd
{

namespace
{

constexpr int andersonDepth = 5;
constexpr int sweepsPerMixing = 8;
/// Sweeps before acceleration starts. A mixing costs as much as several sweeps, so it pays in long chains of contacts only.
constexpr int patience = 200;

/// Impulses of all lanes as one vector, block by block: x, y, z of eight lanes each.
Eigen::VectorXd gatherImpulses(const std::vector<ContactBlock>& blocks)
{
    Eigen::VectorXd r(blocks.size()*3*blockLanes);
    double* out = r.data();
    for (const ContactBlock& block : blocks) out = std::copy(&block.r[0][0], &block.r[0][0] + 3*blockLanes, out);
    return r;
}

/// W_nn of each component of the impulse vector; zero in unused lanes.
Eigen::VectorXd contactWeights(const std::vector<ContactBlock>& blocks)
{
    Eigen::VectorXd weight(blocks.size()*3*blockLanes);
    for (std::size_t k = 0; k < blocks.size(); ++k)
    {
        for (int m = 0; m < 3*blockLanes; ++m)
        {
            const double invWn = blocks[k].invWn[m % blockLanes];
            weight[k*3*blockLanes + m] = invWn > 0.0 ? 1.0/invWn : 0.0;
        }
    }
    return weight;
}

/// The admissible impulse nearest in spirit: no attraction, tangential part within the friction disc.
void projectOnCone(const ContactBlock& block, int lane, double r[3])
{
    const double n[3] = {block.n[0][lane], block.n[1][lane], block.n[2][lane]};
    const double rn = r[0]*n[0] + r[1]*n[1] + r[2]*n[2];
    const double limit = block.friction[lane]*std::max(0.0, rn);
    double t[3];
    for (int k = 0; k < 3; ++k) t[k] = r[k] - rn*n[k];
    const double size = std::sqrt(t[0]*t[0] + t[1]*t[1] + t[2]*t[2]);
    const double scale = size > limit ? limit/size : 1.0;
    for (int k = 0; k < 3; ++k) r[k] = std::max(0.0, rn)*n[k] + scale*t[k];
}

/// Replaces all impulses by the projection of `target`, and moves the velocities along.
void replaceImpulses(ContactProblem& problem, const Eigen::VectorXd& target)
{
    for (std::size_t k = 0; k < problem.blocks.size(); ++k)
    {
        ContactBlock& block = problem.blocks[k];
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            if (!(block.invWn[lane] > 0.0)) continue;
            double r[3], n[3], delta[3];
            for (int m = 0; m < 3; ++m)
            {
                r[m] = target[k*3*blockLanes + m*blockLanes + lane];
                n[m] = block.n[m][lane];
            }
            projectOnCone(block, lane, r);
            for (int m = 0; m < 3; ++m)
            {
                delta[m] = r[m] - block.r[m][lane];
                block.r[m][lane] = r[m];
            }
            applyImpulse(problem.bodies[block.a[lane]], problem.bodies[block.b[lane]], n, delta);
        }
    }
}

/// Watches the sweeps of one solve and mixes iterates once it turns out to be slow.
class Accelerator
{
public:
    void afterSweep(ContactProblem& problem, int sweeps, const DefectSums& sums)
    {
        if (!mixing_)
        {
            if (sweeps < patience) return;
            mixing_ = std::make_unique<AndersonAcceleration>(contactWeights(problem.blocks), andersonDepth);
            start_ = gatherImpulses(problem.blocks);
            sinceMixing_ = 0;
            return;
        }
        if (++sinceMixing_ < sweepsPerMixing) return;
        sinceMixing_ = 0;
        // A mixed iterate that made things much worse spoils the history it came from.
        if (sums.sumSquares > 4.0*bestSquares_) mixing_->forget();
        bestSquares_ = std::min(bestSquares_, sums.sumSquares);
        replaceImpulses(problem, mixing_->next(start_, gatherImpulses(problem.blocks)));
        start_ = gatherImpulses(problem.blocks);
    }

private:
    std::unique_ptr<AndersonAcceleration> mixing_;
    Eigen::VectorXd start_;
    int sinceMixing_ = 0;
    double bestSquares_ = 0.1*std::numeric_limits<double>::max();  // four times it must not overflow
};

} // namespace

SolveReport solveNlgs(ContactProblem& problem, const ContactSettings& settings)
{
    SolveReport report;
    if (problem.blocks.empty()) return report;

    const SweepFunction sweep = problem.isFrictional ? problem.kernels.sweep : problem.kernels.sweepFrictionless;
    StopRule rule{};
    Accelerator accelerator;
    while (report.sweeps < settings.maxSweeps)
    {
        const DefectSums sums = sweep(problem.bodies.data(), problem.blocks.data(), problem.blocks.size());
        if (!std::isfinite(sums.sumSquares)) throw std::runtime_error("contact solve met a velocity that is not finite");
        if (++report.sweeps == 1) rule = makeStopRule(problem, settings, sums);
        if (rule.isMet(sums))
        {
            reportResidual(report, rule, residual(problem));
            if (report.converged) return report;
        }
        if (settings.accelerate) accelerator.afterSweep(problem, report.sweeps, sums);
    }
    reportResidual(report, rule, residual(problem));
    return report;
}

} // namespace nscd
