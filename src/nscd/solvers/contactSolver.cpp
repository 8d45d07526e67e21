// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What all contact solvers share: stop rule, residual, table.
#include "nscd/solvers/contactSolver.hpp"

#include "nscd/base/invalidValue.hpp"
#include "nscd/kernels/blockPrefetch.hpp"
#include "nscd/solvers/help/packedContacts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nscd
{

namespace
{

DefectSums overRanks(const Halo& halo, const DefectSums& one, const DefectSums& other)
{
    double sums[2] = {one.sumSquares + other.sumSquares, one.active + other.active};
    double max = std::max(one.maxSquare, other.maxSquare);
    halo.sumAndMax(sums, max);
    return {sums[0], max, sums[1]};
}

void add(DefectSums& sums, const DefectSums& more)
{
    sums.sumSquares += more.sumSquares;
    sums.active += more.active;
    if (!(more.maxSquare <= sums.maxSquare)) sums.maxSquare = more.maxSquare;
}

} // namespace

DefectSums sweepBlocks(ContactProblem& problem, BlockRange range, double* before)
{
    const SweepKernels& kernels = problem.kernels;
    if (before)
    {
        const MomentumSweepFunction sweepOn = problem.isFrictional ? kernels.sweepOn : kernels.sweepOnFrictionless;
        return sweepOn(problem.bodies.data(), problem.blocks.data(), range, before, problem.theta);
    }
    const SweepFunction sweep = problem.isFrictional ? kernels.sweep : kernels.sweepFrictionless;
    const DefectSums contacts = sweep(problem.bodies.data(), problem.blocks.data(), range);
    if (!problem.rolling) return contacts;
    return together(contacts, sweepRolling(problem.bodies.data(), problem.blocks.data(), *problem.rolling, range));
}

double rms(const DefectSums& sums) { return std::sqrt(sums.sumSquares/std::max(1.0, sums.active)); }

StopRule makeStopRule(const ContactProblem& problem, const ContactSettings& settings, const DefectSums& first)
{
    const double lengthRate = problem.diameter/problem.deltaT;
    const double speed = std::max({problem.speedScale, 1e-3*rms(first), 1e-3*settings.deadBand*lengthRate});
    const SolverStrategy::Polish& polishing = settings.strategy.polish;
    const double polish = std::min(1.0, std::max(polishing.finest, polishing.perMotion*problem.motion));
    const double rmsLimit = settings.tolerance*speed, maxLimit = settings.displacementTolerance*lengthRate;
    return {rmsLimit, maxLimit, speed, polish*rmsLimit, polish < 1.0 ? polish*std::min(maxLimit, polishing.loneDefect*rmsLimit) : maxLimit};
}

BlockRange ContactProblem::inner() const
{
    const auto end = std::lower_bound(awake.begin(), awake.end(), interfaceBlock);
    return {awake.data(), static_cast<std::size_t>(end - awake.begin())};
}

BlockRange ContactProblem::interface() const
{
    const std::size_t inside = inner().count;
    return {awake.data() + inside, awake.size() - inside};
}

BlockRange ContactProblem::activeClumps() const
{
    const auto begin = std::lower_bound(awake.begin(), awake.end(), clumps->firstBlock);
    return {awake.data() + (begin - awake.begin()), static_cast<std::size_t>(awake.end() - begin)};
}

DefectSums sweepActive(ContactProblem& problem)
{
    double* const before = std::exchange(problem.before, nullptr);
    const BlockRange insideRank = problem.inner();
    DefectSums inner = sweepBlocks(problem, insideRank, before);
    if (problem.clumps) add(inner, sweepClumps(problem.bodies.data(), problem.blocks.data(), *problem.clumps, problem.activeClumps()));
    if (!problem.halo.isParallel()) return inner;
    problem.halo.giveVelocities(problem.bodies);
    const DefectSums between = sweepBlocks(problem, problem.interface(), before ? before + 3*blockLanes*insideRank.count : nullptr);
    problem.halo.takeVelocities(problem.bodies);
    return overRanks(problem.halo, inner, between);
}

void replaceImpulses(ContactProblem& problem, std::vector<double>& target)
{
    const BlockRange inner = problem.inner();
    problem.kernels.replaceImpulses(problem.bodies.data(), problem.blocks.data(), inner, target.data());
    if (problem.clumps)
    {
        double* ofClumps = target.data() + 3*blockLanes*inner.count;
        replaceClumpImpulses(problem.bodies.data(), problem.blocks.data(), *problem.clumps, problem.activeClumps(), ofClumps);
    }
    if (!problem.halo.isParallel()) return;
    double* between = target.data() + 3*blockLanes*inner.count;
    problem.halo.giveVelocities(problem.bodies);
    problem.kernels.replaceImpulses(problem.bodies.data(), problem.blocks.data(), problem.interface(), between);
    problem.halo.takeVelocities(problem.bodies);
}

DefectSums residualOfActive(ContactProblem& problem)
{
    if (problem.rolling || problem.clumps) return residual(problem);
    const SweepFunction evaluate = problem.isFrictional ? problem.kernels.evaluate : problem.kernels.evaluateFrictionless;
    problem.halo.giveVelocities(problem.bodies);
    const DefectSums here = evaluate(problem.bodies.data(), problem.blocks.data(), problem.active());
    return problem.halo.isParallel() ? overRanks(problem.halo, here, {0.0, 0.0, 0.0}) : here;
}

DefectSums residual(ContactProblem& problem)
{
    const SweepFunction evaluate = problem.isFrictional ? problem.kernels.evaluate : problem.kernels.evaluateFrictionless;
    problem.halo.giveVelocities(problem.bodies);
    ContactBlock* const blocks = problem.blocks.data() + problem.firstBlock;
    DefectSums here = evaluate(problem.bodies.data(), blocks, {nullptr, problem.all().count - problem.firstBlock});
    if (problem.rolling)
    {
        here = together(here, evaluateRolling(problem.bodies.data(), problem.blocks.data(), *problem.rolling, problem.all()));
    }
    if (problem.clumps) add(here, evaluateClumps(problem.bodies.data(), problem.blocks, *problem.clumps));
    if (problem.isPacked) add(here, problem.packing->defectsOfRest(problem));
    return problem.halo.isParallel() ? overRanks(problem.halo, here, {0.0, 0.0, 0.0}) : here;
}

bool wakeBlocks(ContactProblem& problem)
{
    if (problem.isPacked) return problem.packing->wake(problem);
    const std::size_t before = problem.awake.size();
    std::vector<std::uint32_t> asleep;
    std::size_t next = 0;
    for (std::uint32_t k = problem.firstBlock; k < problem.blocks.size(); ++k)
    {
        const bool isAwake = next < before && problem.awake[next] == k;
        if (isAwake) ++next;
        else asleep.push_back(k);
    }
    problem.halo.giveVelocities(problem.bodies);
    const auto isActive = [&](std::uint32_t k)
    {
        if (problem.clumps && k >= problem.clumps->firstBlock)
        {
            return isClumpBlockActive(problem.bodies.data(), problem.blocks.data(), *problem.clumps, k);
        }
        // Asleep, nothing is carried: what the law asks for is normal, so the frictionless evaluation tells.
        return problem.kernels.evaluateFrictionless(problem.bodies.data(), &problem.blocks[k], {nullptr, 1}).active > 0.0;
    };
    std::vector<std::uint32_t> woken;
    for (std::size_t m = 0; m < asleep.size(); ++m)
    {
        prefetch(problem.bodies.data(), problem.blocks.data(), {asleep.data(), asleep.size()}, m);
        if (isActive(asleep[m])) woken.push_back(asleep[m]);
    }
    // Ranges of the list stay valid unless it grows.
    if (!woken.empty())
    {
        std::vector<std::uint32_t> awake(before + woken.size());
        std::merge(problem.awake.begin(), problem.awake.end(), woken.begin(), woken.end(), awake.begin());
        problem.awake = std::move(awake);
    }
    return problem.halo.any(!woken.empty());
}

void reportResidual(SolveReport& report, const StopRule& rule, const DefectSums& sums)
{
    report.residualRms = rms(sums);
    report.residualMax = std::sqrt(sums.maxSquare);
    report.speedScale = rule.speedScale;
    report.contacts = static_cast<std::size_t>(sums.active);
    report.converged = rule.isMet(sums);
}

const std::vector<ContactSolverRow>& contactSolvers()
{
    static const std::vector<ContactSolverRow> rows =
    {
        {"NLGS", solveNlgs, "nonlinear Gauss-Seidel sweeps over all contacts, accelerated when slow", true},
        {"NNCG", solveNncg, "nonlinear conjugate gradients around Gauss-Seidel sweeps", true},
        {"APG", solveProjectedGradient, "accelerated projected gradient with refreshed Tresca bounds, whatever the order of contacts", false},
        {"queue", solveQueue, "the thesis' queue: only contacts whose neighborhood changed are solved again", false},
        {"direct", solveDirect, "Newton's method with sparse factors, for chains, walls and bodies of very different mass", false}
    };
    return rows;
}

const ContactSolverRow& findContactSolver(const std::string& name)
{
    std::string names;
    for (const ContactSolverRow& row : contactSolvers())
    {
        if (name == row.name) return row;
        names += (names.empty() ? "" : ", ") + std::string(row.name);
    }
    throw invalidValue("contact solver", name, names);
}

} // namespace nscd
