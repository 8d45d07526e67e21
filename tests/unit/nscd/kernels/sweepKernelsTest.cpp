// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The kernels of every vector path against plain code and against one another.
#include "nscd/kernels/applyImpulse.hpp"
#include "nscd/solvers/help/andersonAcceleration.hpp"
#include "nscd/solvers/problem/localContact.hpp"
#include "unit/nscd/scenes/randomProblem.hpp"

using namespace scenes;
using nscd::Vec3;

namespace
{

const char* const vectorPaths[] = {"portable", "AVX2", "AVX512"};

/// A pass over all contacts, one by one; returns the largest defect.
double sweepPlainly(RandomProblem& random)
{
    nscd::ContactProblem problem = random.problem();
    double largest = 0.0;
    for (std::size_t slot = 0; slot < random.blocks.size()*nscd::blockLanes; ++slot)
    {
        const nscd::LocalChange change = nscd::localChange(problem, slot);
        nscd::apply(problem, slot, change);
        largest = std::max(largest, change.defect);
    }
    return largest;
}

} // namespace

TEST(SweepKernels, sweepAsPlainCodeDoes)
{
    for (const char* path : vectorPaths)
    {
        if (!isAvailable(path)) continue;
        const nscd::SweepKernels kernels = nscd::chooseKernels(path);
        RandomProblem x(30), y(30);
        for (int sweep = 0; sweep < 5; ++sweep)
        {
            const double largest = sweepPlainly(x);
            const nscd::DefectSums sums = kernels.sweep(y.bodies.data(), y.blocks.data(), y.all());
            EXPECT_NEAR(std::sqrt(sums.maxSquare), largest, 1e-12*largest) << path;
        }
        expectSameBodies(x.bodies, y.bodies, 1e-12);
    }
}

TEST(SweepKernels, passOverTheBlocksOfARangeAlone)
{
    const nscd::SweepKernels kernels = nscd::chooseKernels("auto");
    RandomProblem some(10), start(10);
    const std::vector<std::uint32_t> index = {7, 2};
    kernels.sweep(some.bodies.data(), some.blocks.data(), {index.data(), index.size()});
    for (std::size_t k = 0; k < 10; ++k)
    {
        const bool isChanged = !std::equal(some.blocks[k].r[0], some.blocks[k].r[0] + 3*nscd::blockLanes, start.blocks[k].r[0]);
        EXPECT_EQ(isChanged, k == 7 || k == 2) << k;
    }
}

TEST(SweepKernels, agreeOnEveryPath)
{
    const nscd::SweepKernels portable = nscd::chooseKernels("portable");
    for (const char* path : {"AVX2", "AVX512"})
    {
        if (!isAvailable(path)) continue;
        const nscd::SweepKernels wide = nscd::chooseKernels(path);
        EXPECT_STREQ(wide.name, path);
        RandomProblem x(20), y(20);
        using Function = nscd::SweepFunction nscd::SweepKernels::*;
        for (Function f : {&nscd::SweepKernels::sweep, &nscd::SweepKernels::evaluate, &nscd::SweepKernels::sweepFrictionless,
                           &nscd::SweepKernels::evaluateFrictionless})
        {
            const nscd::DefectSums a = (portable.*f)(x.bodies.data(), x.blocks.data(), x.all());
            const nscd::DefectSums b = (wide.*f)(y.bodies.data(), y.blocks.data(), y.all());
            EXPECT_NEAR(a.sumSquares, b.sumSquares, 1e-12*a.sumSquares) << path;
            EXPECT_NEAR(a.maxSquare, b.maxSquare, 1e-12*a.maxSquare) << path;
            EXPECT_EQ(a.active, b.active) << path;
            expectSameBodies(x.bodies, y.bodies, 1e-13);
        }
        std::vector<double> target(24*x.blocks.size(), 0.3), same = target;
        portable.replaceImpulses(x.bodies.data(), x.blocks.data(), x.all(), target.data());
        wide.replaceImpulses(y.bodies.data(), y.blocks.data(), y.all(), same.data());
        expectSameBodies(x.bodies, y.bodies, 1e-13);
        for (std::size_t i = 0; i < target.size(); ++i) ASSERT_NEAR(target[i], same[i], 1e-14);
    }
}

TEST(SweepKernels, mixTheSameOnEveryPath)
{
    const nscd::SweepKernels portable = nscd::chooseKernels("portable");
    for (const char* path : {"AVX2", "AVX512"})
    {
        if (!isAvailable(path)) continue;
        const nscd::SweepKernels wide = nscd::chooseKernels(path);
        RandomProblem problem(20);
        const nscd::Halo alone;
        nscd::AndersonAcceleration one(problem.all(), portable.addDifferences, alone), other(problem.all(), wide.addDifferences, alone);
        for (int mixing = 0; mixing < 2*nscd::mixingDepth; ++mixing)
        {
            std::vector<double> r;
            nscd::gatherImpulses(problem.blocks, problem.all(), r);
            std::vector<double> same = r;
            portable.sweep(problem.bodies.data(), problem.blocks.data(), problem.all());
            one.mix(problem.blocks, r);
            other.mix(problem.blocks, same);
            for (std::size_t i = 0; i < r.size(); ++i) ASSERT_NEAR(r[i], same[i], 1e-9) << path << " " << mixing;
        }
    }
}

TEST(SweepKernels, keepVelocitiesEqualToFreeOnesPlusImpulses)
{
    const nscd::SweepKernels kernels = nscd::chooseKernels("auto");
    RandomProblem problem(20), start(20);
    for (int sweep = 0; sweep < 10; ++sweep) kernels.sweep(problem.bodies.data(), problem.blocks.data(), problem.all());
    std::vector<double> target(24*problem.blocks.size(), -0.2);
    kernels.replaceImpulses(problem.bodies.data(), problem.blocks.data(), problem.all(), target.data());
    for (std::size_t k = 0; k < start.blocks.size(); ++k)
    {
        for (int lane = 0; lane < nscd::blockLanes; ++lane)
        {
            nscd::ContactBlock& block = start.blocks[k];
            double n[3], delta[3];
            for (int m = 0; m < 3; ++m)
            {
                n[m] = block.n[m][lane];
                delta[m] = problem.blocks[k].r[m][lane] - block.r[m][lane];
            }
            nscd::applyImpulse(start.bodies[block.a[lane]], start.bodies[block.b[lane]], n, delta);
        }
    }
    expectSameBodies(problem.bodies, start.bodies, 1e-12);
}

TEST(SweepKernels, theWidestPathIsTakenAndOthersAreRefused)
{
    EXPECT_STREQ(nscd::chooseKernels("portable").name, "portable");
    EXPECT_STREQ(nscd::chooseKernels("auto").name, isAvailable("AVX512") ? "AVX512" : isAvailable("AVX2") ? "AVX2" : "portable");
    EXPECT_THROW(nscd::chooseKernels("SSE9"), std::invalid_argument);
}

TEST(SweepKernels, thoseOfSimplerScenesStandInThePlaceOfAllOthers)
{
    const nscd::SweepKernels kernels = nscd::chooseKernels("auto"), normal = nscd::normalOnly(kernels), discs = nscd::planar(kernels, 1);
    EXPECT_EQ(normal.sweep, kernels.sweepFrictionless);
    EXPECT_EQ(normal.sweepOn, kernels.sweepOnFrictionless);
    EXPECT_EQ(normal.evaluate, kernels.evaluateFrictionless);
    EXPECT_EQ(normal.replaceImpulses, kernels.replaceFrictionless);
    EXPECT_EQ(normal.startWarm, kernels.startWarmFrictionless);
    EXPECT_EQ(discs.sweep, kernels.sweepDiscs[1]);
    EXPECT_EQ(discs.sweepOn, kernels.sweepOnDiscs[1]);
    EXPECT_EQ(discs.evaluate, kernels.evaluateDiscs[1]);
}
