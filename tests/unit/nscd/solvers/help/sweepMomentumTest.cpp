// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Momentum of sweeps: its first iterates by hand, and what it does for a cold column.
#include "unit/nscd/scenes/fallingColumn.hpp"
#include "nscd/contacts/contactBatching.hpp"
#include "nscd/solvers/help/sweepMomentum.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>
#include <utility>

using namespace scenes;

namespace
{

/// theta of the iteration of Nesterov, by itself.
double nextTheta(double& t)
{
    const double next = 0.5*(1.0 + std::sqrt(1.0 + 4.0*t*t)), theta = (t - 1.0)/next;
    t = next;
    return theta;
}

/// Velocities of the free fall and of the impulses.
void setVelocities(Column& column)
{
    for (std::size_t i = 0; i + 1 < column.bodies.size(); ++i)
    {
        const double above = i + 1 < column.blocks.size() ? column.blocks[i + 1].r[2][0] : 0.0;
        column.bodies[i].v[2] = -1.0 + column.blocks[i].r[2][0] - above;
    }
}

/// What the next sweep begins with.
void moveImpulsesOn(nscd::ContactProblem& problem, const nscd::SweepOn& on)
{
    if (on.before) problem.kernels.extrapolate(problem.blocks.data(), problem.active(), on.before, on.theta);
}

/// Sets the impulse of the only contact, as a sweep would, and lets momentum act. Returns y.
double advanceFrom(double impulse, Column& column, nscd::ContactProblem& problem, nscd::SweepMomentum& momentum, bool isNear = false)
{
    column.blocks[0].r[2][0] = impulse;
    setVelocities(column);
    momentum.advance(isNear);
    moveImpulsesOn(problem, momentum.forNextSweep());
    EXPECT_NEAR(column.bodies[0].v[2], -1.0 + column.blocks[0].r[2][0], 1e-13);
    return column.blocks[0].r[2][0];
}

constexpr auto falling = nscd::SweepMomentum::Kind::falling, flowing = nscd::SweepMomentum::Kind::flowing;

} // namespace

TEST(SweepMomentum, followsNesterovUntilAStepGoesUphill)
{
    Column column(1, Vec3::UnitZ());
    nscd::ContactProblem problem = column.problem();
    const nscd::SolverStrategy strategy;
    nscd::SweepMomentum momentum(problem, falling, strategy.momentum);
    EXPECT_EQ(advanceFrom(1.0, column, problem, momentum), 1.0);
    double r = 1.0, t = 1.0, y = 1.0;
    for (int k = 0; k < 8; ++k)
    {
        const double before = r;
        r = y + 0.5;
        const double expected = r + nextTheta(t)*(r - before);
        y = advanceFrom(r, column, problem, momentum);
        EXPECT_NEAR(y, expected, 1e-14);
    }
    // The sweep turns back, though not behind the last image: no momentum for once, then from the start again.
    const double before = r;
    r = y - 0.01;
    ASSERT_GT(r, before);
    t = 1.0;
    EXPECT_NEAR(advanceFrom(r, column, problem, momentum), r, 1e-14);
    nextTheta(t);
    EXPECT_NEAR(advanceFrom(r + 1.0, column, problem, momentum), r + 1.0 + nextTheta(t), 1e-14);
}

TEST(SweepMomentum, isLimitedByTheDepthAlongTheFall)
{
    const auto limitOf = [](int size, const Vec3& up)
    {
        Column column(size, up);
        nscd::ContactProblem problem = column.problem();
        const nscd::SolverStrategy strategy;
        nscd::SweepMomentum momentum(problem, falling, strategy.momentum);
        double r = 0.0, y = 0.0, theta = 0.0;
        for (int k = 0; k < 2000; ++k)
        {
            const double before = r;
            r = column.blocks[0].r[0][0] = y + 1.0;
            momentum.advance();
            y = column.blocks[0].r[0][0];
            theta = (y - r)/(r - before);
        }
        return theta;
    };
    EXPECT_NEAR(limitOf(51, Vec3::UnitZ()), 1.0 - 1.2/50.0, 1e-9);
    EXPECT_NEAR(limitOf(51, Vec3(1, -2, 2)/3.0), 1.0 - 1.2/50.0, 1e-9);
    EXPECT_NEAR(limitOf(5, Vec3::UnitZ()), 0.9, 1e-9);
    EXPECT_NEAR(limitOf(400, Vec3::UnitZ()), 0.99, 1e-9);
}

TEST(SweepMomentum, isSteadyInAFlowAndTakenBackToTheBit)
{
    Column column(3, Vec3::UnitZ());
    nscd::ContactProblem problem = column.problem();
    const nscd::SolverStrategy strategy;
    nscd::SweepMomentum momentum(problem, flowing, strategy.momentum);
    momentum.advance();
    EXPECT_NEAR(advanceFrom(1.0, column, problem, momentum), 1.0 + 0.9*1.0, 1e-14);
    EXPECT_NEAR(advanceFrom(1.7, column, problem, momentum, true), 1.7 + 0.8*0.7, 1e-14);
    momentum.revert();
    EXPECT_EQ(column.blocks[0].r[2][0], 1.7);
    EXPECT_EQ(column.bodies[0].v[2], -1.0 + 1.7);
}

/// A sweep that moves impulses on does what moving them on and sweeping does, whatever the kernel.
TEST(SweepMomentum, ofASweepIsThatBeforeIt)
{
    for (const char* name : {"portable", "AVX2", "AVX512"})
    for (int kind = 0; kind < 5; ++kind)   // spheres, smooth ones, discs
    {
        nscd::SweepKernels kernels{};
        try { kernels = nscd::chooseKernels(name); }
        catch (const std::invalid_argument&) { continue; }
        Column one(7, Vec3(0.6, 0, 0.8)), other(7, Vec3(0.6, 0, 0.8));
        std::vector<double> before, alike;
        for (Column* column : {&one, &other})
        {
            for (int k = 0; k < 7; ++k)
            for (int m = 0; m < 3; ++m) column->blocks[k].r[m][0] = 0.1*(k + 1)*(m + 1);
        }
        for (int k = 0; k < 7*3*nscd::blockLanes; ++k) before.push_back(0.01*k);
        alike = before;
        const nscd::SweepFunction sweeps[] = {kernels.sweep, kernels.sweepFrictionless, kernels.sweepDiscs[0], kernels.sweepDiscs[1], kernels.sweepDiscs[2]};
        const nscd::MomentumSweepFunction sweepsOn[] =
            {kernels.sweepOn, kernels.sweepOnFrictionless, kernels.sweepOnDiscs[0], kernels.sweepOnDiscs[1], kernels.sweepOnDiscs[2]};
        const nscd::BlockRange all{nullptr, 7};
        kernels.extrapolate(one.blocks.data(), all, before.data(), 0.7);
        const nscd::DefectSums met = sweeps[kind](one.bodies.data(), one.blocks.data(), all);
        const nscd::DefectSums metToo = sweepsOn[kind](other.bodies.data(), other.blocks.data(), all, alike.data(), 0.7);
        EXPECT_EQ(met.sumSquares, metToo.sumSquares) << name << ' ' << kind;
        EXPECT_EQ(before, alike) << name << ' ' << kind;
        EXPECT_EQ(std::memcmp(one.blocks.data(), other.blocks.data(), 7*sizeof(nscd::ContactBlock)), 0) << name << ' ' << kind;
        EXPECT_EQ(std::memcmp(one.bodies.data(), other.bodies.data(), 8*sizeof(nscd::Body)), 0) << name << ' ' << kind;
    }
}

// Plain sweeps take ln(1e4) (2 N + 1)^2/pi^2 = 13 700 for it.
TEST(SweepMomentum, bringsTheWeightOfAColdColumnDown)
{
    Column column(60, Vec3::UnitZ());
    nscd::ContactProblem problem = column.problem();
    nscd::ContactSettings settings;
    settings.tolerance = 1e-4;
    settings.displacementTolerance = 1.0;
    settings.polishSweeps = 0;
    const nscd::SolveReport report = nscd::solveNlgs(problem, settings);
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.newtonSteps, 0);
    EXPECT_LT(report.sweeps, 400);
    EXPECT_NEAR(column.blocks[0].r[2][0], 60.0, 0.36);  // N^2 times that of velocities
}

/// Blocks that come in behind those within this rank, and behind those with others: the history of the others stays theirs.
TEST(SweepMomentum, takesInWhatComesBehindEitherKind)
{
    Column column(3, Vec3::UnitZ());
    nscd::ContactProblem problem = column.problem();
    problem.interfaceBlock = 2;
    const nscd::SolverStrategy strategy;
    nscd::SweepMomentum momentum(problem, flowing, strategy.momentum);
    for (int k = 0; k < 3; ++k) column.blocks[k].r[2][0] = 1.0 + k;
    momentum.advance();
    const nscd::ContactBlock last = column.blocks[2], none = nscd::emptyBlock(3);
    column.blocks = {column.blocks[0], column.blocks[1], none, last, none};
    column.awake = {0, 1, 2, 3, 4};
    problem.interfaceBlock = 3;
    momentum.grow();
    for (int k : {0, 1, 3}) column.blocks[k].r[2][0] += 1.0;
    momentum.advance();
    const nscd::SweepOn on = momentum.forNextSweep();
    ASSERT_TRUE(on.before);
    const double expected[] = {1.0, 2.0, 0.0, 3.0, 0.0};
    for (int k = 0; k < 5; ++k) EXPECT_EQ(on.before[3*nscd::blockLanes*k + 2*nscd::blockLanes], expected[k]) << k;
}

/// A rank that has no active block when momentum starts, and gets one.
TEST(SweepMomentum, takesInTheFirstBlockOfARank)
{
    Column column(1, Vec3::UnitZ());
    const std::vector<nscd::ContactBlock> later = std::exchange(column.blocks, {});
    column.awake.clear();
    nscd::ContactProblem problem = column.problem();
    const nscd::SolverStrategy strategy;
    nscd::SweepMomentum momentum(problem, flowing, strategy.momentum);
    momentum.advance();
    column.blocks = later;
    column.awake = {0};
    problem.interfaceBlock = 1;
    momentum.grow();
    EXPECT_NEAR(advanceFrom(1.0, column, problem, momentum), 1.9, 1e-14);
    momentum.revert();
    EXPECT_EQ(column.blocks[0].r[2][0], 1.0);
}
