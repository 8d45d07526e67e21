// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Nonlinear conjugate gradients around Gauss-Seidel sweeps, as a solver behind the common signature.
// Tested by tests/unit/nscd/solvers/contactSolverTest.cpp
#include "nscd/solvers/contactSolver.hpp"
#include "nscd/solvers/help/andersonAcceleration.hpp"
#include "nscd/solvers/sweepLoop.hpp"

namespace nscd
{

namespace
{

constexpr int blockSize = 3*blockLanes;

/// With F one sweep and g = r - F(r): r' = F(r) + beta p, p' = beta p - g, beta = |g|^2/|g before|^2 (Fletcher-Reeves); where beta > 1,
/// r' = F(r) and p' = 0 (Silcowitz-Hansen, Niebe & Erleben 2010, algorithm 3; their first p is -g too). Deviations: the norm is that of
/// velocities in contacts, |g|^2 = sum of W_nn g_c^2, and r' is projected on the friction cones.
class ConjugateDirections
{
public:
    explicit ConjugateDirections(ContactProblem& problem) : problem_(problem) { forget(); }

    DefectSums pass() { return sweepActive(problem_); }

    int afterSweep(int, const DefectSums&, const StopRule&)
    {
        const double square = problem_.halo.sum(squareOfChange());
        if (!(before_ > 0.0)) keepImage(1.0);
        else if (square > before_) keepImage(0.0);
        else extrapolate(square/before_);
        before_ = square;
        return 0;
    }

    bool polish(const DefectSums& sums, const StopRule& rule) const { return rule.isPolished(sums); }
    void complete(SolveReport&, const StopRule&) {}

    void forget()
    {
        gatherImpulses(problem_.blocks, problem_.active(), start_);
        direction_.assign(start_.size(), 0.0f);
        before_ = 0.0;
    }

private:
    /// Impulses of the k-th active block.
    const double* image(std::size_t k) const { return &problem_.blocks[problem_.active()[k]].r[0][0]; }

    double squareOfChange() const
    {
        double sum = 0.0;
        for (std::size_t k = 0; k < problem_.active().count; ++k)
        {
            const ContactBlock& block = problem_.blocks[problem_.active()[k]];
            const double* start = start_.data() + k*blockSize;
            for (int lane = 0; lane < blockLanes; ++lane)
            {
                double change2 = 0.0;
                for (int m = 0; m < 3; ++m) change2 += std::pow(block.r[m][lane] - start[m*blockLanes + lane], 2);
                sum += change2*(problem_.bodies[block.a[lane]].invMass + problem_.bodies[block.b[lane]].invMass);
            }
        }
        return sum;
    }

    /// The sweep's result stands; p = `share` of what the sweep changed.
    void keepImage(double share)
    {
        for (std::size_t k = 0; k < problem_.active().count; ++k)
        {
            const double* r = image(k);
            for (std::size_t i = k*blockSize; i < (k + 1)*blockSize; ++i, ++r)
            {
                direction_[i] = static_cast<float>(share*(*r - start_[i]));
                start_[i] = *r;
            }
        }
    }

    void extrapolate(double beta)
    {
        for (std::size_t k = 0; k < problem_.active().count; ++k)
        {
            const double* r = image(k);
            for (std::size_t i = k*blockSize; i < (k + 1)*blockSize; ++i, ++r)
            {
                const double conjugate = beta*direction_[i];
                direction_[i] = static_cast<float>(conjugate + *r - start_[i]);
                start_[i] = *r + conjugate;
            }
        }
        replaceImpulses(problem_, start_);
    }

    ContactProblem& problem_;
    AndersonAcceleration::Impulses start_;  ///< before the sweep
    std::vector<float> direction_;          ///< p
    double before_ = 0.0;                   ///< |g|^2 of the sweep before; 0: there was none
};

} // namespace

SolveReport solveNncg(ContactProblem& problem, const ContactSettings& settings)
{
    if (!problem.halo.any(!problem.blocks.empty())) return SolveReport();
    ConjugateDirections directions(problem);
    return sweepUntilMet(problem, settings, directions);
}

} // namespace nscd
