// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Passes over contacts, on one rank and across several.
#include "nscd/solvers/problem/contactProblem.hpp"

#include "nscd/contacts/general/generalMoments.hpp"
#include "nscd/contacts/general/generalSweep.hpp"
#include "nscd/kernels/blockPrefetch.hpp"

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
    sums.work += more.work;
    if (!(more.maxSquare <= sums.maxSquare)) sums.maxSquare = more.maxSquare;
}

/// What is left of it behind so many blocks.
SweepOn behind(const SweepOn& on, std::size_t blocks)
{
    const std::size_t numbers = 3*blockLanes*blocks;
    return {on.before ? on.before + numbers : nullptr, on.lawBefore ? on.lawBefore + numbers : nullptr, on.theta};
}

DefectSums sweepWithLaw(ContactProblem& problem, BlockRange range, const SweepOn& on)
{
    Body* const bodies = problem.bodies.data();
    ContactBlock* const blocks = problem.blocks.data();
    LawBlock* const ofLaw = problem.lawBlocks->data();
    if (!on.before) return problem.kernels.sweepLaw(bodies, blocks, ofLaw, range);
    return problem.kernels.sweepLawOn(bodies, blocks, ofLaw, range, on.before, on.lawBefore, on.theta);
}

DefectSums evaluateBlocks(ContactProblem& problem, BlockRange range)
{
    const SweepFunction evaluate = problem.isFrictional ? problem.kernels.evaluate : problem.kernels.evaluateFrictionless;
    DefectSums sums = evaluate(problem.bodies.data(), problem.blocks.data(), range);
    if (problem.lawBlocks) add(sums, problem.kernels.evaluateLaw(problem.bodies.data(), problem.blocks.data(), problem.lawBlocks->data(), range));
    return sums;
}

DefectSums sweepGeneralBlocks(ContactProblem& problem, BlockRange range)
{
    Body* const bodies = problem.bodies.data();
    if (!problem.lawBlocks) return sweepGeneral(bodies, problem.blocks.data(), *problem.general, range);
    return sweepGeneralMoments(bodies, problem.blocks.data(), problem.lawBlocks->data(), *problem.general, range);
}

DefectSums evaluateGeneralBlocks(const ContactProblem& problem)
{
    DefectSums sums = evaluateGeneral(problem.bodies.data(), problem.blocks, *problem.general);
    if (problem.lawBlocks) add(sums, evaluateGeneralMoments(problem.bodies.data(), problem.blocks, *problem.lawBlocks, *problem.general));
    return sums;
}

} // namespace

DefectSums sweepBlocks(ContactProblem& problem, BlockRange range, const SweepOn& on)
{
    if (problem.lawBlocks) return sweepWithLaw(problem, range, on);
    const SweepKernels& kernels = problem.kernels;
    if (on.before)
    {
        const MomentumSweepFunction sweepOn = problem.isFrictional ? kernels.sweepOn : kernels.sweepOnFrictionless;
        return sweepOn(problem.bodies.data(), problem.blocks.data(), range, on.before, on.theta);
    }
    const SweepFunction sweep = problem.isFrictional ? kernels.sweep : kernels.sweepFrictionless;
    return sweep(problem.bodies.data(), problem.blocks.data(), range);
}

double netImpulse(const ContactProblem& problem)
{
    const StepTimes::Timer timer(problem.times, GrainPart::judgeContacts);
    double sum = 0.0;
    for (std::size_t k = 0; k < problem.freeVelocity->size(); ++k)
    {
        const Body& body = problem.bodies[k];
        const bool isMember = problem.general && problem.general->memberOf[k] >= 0;
        if (body.invMass > 0.0 && !isMember) sum += (Vec3(body.v) - (*problem.freeVelocity)[k]).norm()/body.invMass;
    }
    for (std::size_t k = 0; problem.general && k < problem.general->own(); ++k)
    {
        const GeneralBody& body = problem.general->bodies[k];
        if (body.invMass > 0.0) sum += (body.v - body.freeV).norm()/body.invMass;
    }
    return problem.halo.sum(sum);
}

double rms(const DefectSums& sums) { return std::sqrt(sums.sumSquares/std::max(1.0, sums.active)); }

void ContactProblem::giveVelocities()
{
    halo.giveVelocities(bodies);
    if (general) general->giveVelocities();
}

void ContactProblem::takeVelocities()
{
    halo.takeVelocities(bodies);
    if (general) general->takeVelocities();
}

BlockRange ContactProblem::activeIn(std::size_t first, std::size_t end) const
{
    const auto from = std::lower_bound(awake.begin(), awake.end(), first), to = std::lower_bound(from, awake.end(), end);
    return {awake.data() + (from - awake.begin()), static_cast<std::size_t>(to - from)};
}

BlockRange ContactProblem::inner() const { return activeIn(0, interfaceBlock); }
BlockRange ContactProblem::interface() const { return activeIn(interfaceBlock, all().count); }
BlockRange ContactProblem::innerGeneral() const { return activeIn(general->firstBlock, general->firstInterface); }
BlockRange ContactProblem::interfaceGeneral() const { return activeIn(general->firstInterface, blocks.size()); }

std::vector<std::uint32_t> ContactProblem::withinRank() const
{
    const BlockRange single = inner();
    std::vector<std::uint32_t> within(single.index, single.index + single.count);
    if (!general) return within;
    const BlockRange behind = innerGeneral();
    within.insert(within.end(), behind.index, behind.index + behind.count);
    return within;
}

DefectSums sweepActive(ContactProblem& problem, const SweepOn& on)
{
    const BlockRange insideRank = problem.inner();
    DefectSums inner = sweepBlocks(problem, insideRank, on);
    if (problem.general) add(inner, sweepGeneralBlocks(problem, problem.innerGeneral()));
    if (!problem.halo.isParallel()) return inner;
    problem.giveVelocities();
    DefectSums between = sweepBlocks(problem, problem.interface(), behind(on, insideRank.count));
    if (problem.general) add(between, sweepGeneralBlocks(problem, problem.interfaceGeneral()));
    problem.takeVelocities();
    return overRanks(problem.halo, inner, between);
}

void replaceImpulses(ContactProblem& problem, std::vector<double>& target)
{
    double* next = target.data();
    const auto behind = [&](BlockRange range) { return std::exchange(next, next + 3*blockLanes*range.count); };
    const BlockRange none{nullptr, 0}, inner = problem.inner(), interface = problem.interface();
    const BlockRange innerGeneral = problem.general ? problem.innerGeneral() : none, interfaceGeneral = problem.general ? problem.interfaceGeneral() : none;
    double *const ofInner = behind(inner), *const ofInterface = behind(interface), *const ofGeneral = behind(innerGeneral), *const ofLast = behind(interfaceGeneral);
    const auto replaceGeneral = [&](BlockRange range, double* values)
    {
        if (problem.general) replaceGeneralImpulses(problem.bodies.data(), problem.blocks.data(), *problem.general, range, values);
    };
    problem.kernels.replaceImpulses(problem.bodies.data(), problem.blocks.data(), inner, ofInner);
    replaceGeneral(innerGeneral, ofGeneral);
    if (!problem.halo.isParallel()) return;
    problem.giveVelocities();
    problem.kernels.replaceImpulses(problem.bodies.data(), problem.blocks.data(), interface, ofInterface);
    replaceGeneral(interfaceGeneral, ofLast);
    problem.takeVelocities();
}

DefectSums residualOfActive(ContactProblem& problem)
{
    const StepTimes::Timer timer(problem.times, GrainPart::judgeContacts);
    if (problem.general) return residual(problem);
    problem.giveVelocities();
    const DefectSums here = evaluateBlocks(problem, problem.active());
    return problem.halo.isParallel() ? overRanks(problem.halo, here, {0.0, 0.0, 0.0}) : here;
}

DefectSums residual(ContactProblem& problem)
{
    const StepTimes::Timer timer(problem.times, GrainPart::judgeContacts);
    problem.giveVelocities();
    DefectSums here = evaluateBlocks(problem, problem.isAllAwake() && !problem.general ? problem.active() : problem.all());
    if (problem.general) add(here, evaluateGeneralBlocks(problem));
    if (problem.leftOut) add(here, problem.leftOut->defects(problem));
    if (!problem.halo.isParallel()) return here;
    DefectSums everywhere = overRanks(problem.halo, here, {0.0, 0.0, 0.0});
    everywhere.work = problem.halo.sum(here.work);
    return everywhere;
}

bool wakeBlocks(ContactProblem& problem)
{
    if (problem.isAllAwake()) return false;
    const StepTimes::Timer timer(problem.times, GrainPart::judgeContacts);
    if (problem.leftOut) return problem.leftOut->wake(problem);
    const std::size_t before = problem.awake.size();
    std::vector<std::uint32_t> asleep;
    std::size_t next = 0;
    for (std::uint32_t k = 0; k < problem.blocks.size(); ++k)
    {
        const bool isAwake = next < before && problem.awake[next] == k;
        if (isAwake) ++next;
        else asleep.push_back(k);
    }
    problem.giveVelocities();
    const auto isActive = [&](std::uint32_t k)
    {
        if (problem.general && k >= problem.general->firstBlock)
        {
            return isGeneralBlockActive(problem.bodies.data(), problem.blocks.data(), *problem.general, k);
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

} // namespace nscd
