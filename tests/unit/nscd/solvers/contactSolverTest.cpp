// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The solver suite: every solver and every vector path, judged by a residual recomputed from velocities and contacts.
#include "nscd/kernels/applyImpulse.hpp"
#include "nscd/solvers/contactSolver.hpp"
#include "nscd/solvers/help/andersonAcceleration.hpp"
#include "unit/nscd/scenes/heaps.hpp"
#include "unit/nscd/scenes/naturalMap.hpp"
#include "nscd/kernels/sweepKernels.hpp"

#include <gtest/gtest.h>

#include <cstring>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3;

bool isAvailable(const std::string& path)
{
    try
    {
        nscd::chooseKernels(path.c_str());
        return true;
    }
    catch (const std::invalid_argument&)
    {
        return false;
    }
}

struct Variant
{
    std::string solver;
    std::string vectorPath;
};

class Solvers : public testing::TestWithParam<Variant>
{
protected:
    void SetUp() override
    {
        if (!isAvailable(GetParam().vectorPath)) GTEST_SKIP() << "this processor has no " << GetParam().vectorPath;
        settings.solver = GetParam().solver;
        settings.vectorPath = GetParam().vectorPath;
    }

    nscd::ContactSettings settings;
};

/// Runs the scene, and has each step judged: residual as reported, and within the stop rule where it says converged.
/// Returns the number of steps that did not converge.
int expectHonestSteps(const Scene& scene, double friction, const nscd::ContactSettings& settings, int steps)
{
    int unconverged = 0;
    auto dynamics = scene.build(settings);
    double diameter = 0.0;
    for (double r : scene.grains.radius) diameter += 2*r/scene.grains.size();
    Judge judge(scene, friction, settings.deadBand*diameter, deltaT);
    for (int k = 0; k < steps; ++k)
    {
        const nscd::Grains before = dynamics.grains();
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        const NaturalMap judged = judge(before, dynamics);
        // Contacts whose impulse is zero but for rounding may count or not: the sum of squares does not depend on them.
        const double reported = report.solve.residualRms*std::sqrt(std::max<double>(1, report.solve.contacts));
        EXPECT_NEAR(judged.norm, reported, 1e-6*gravity*deltaT) << "step " << k;
        EXPECT_NEAR(judged.max, report.solve.residualMax, 1e-6*gravity*deltaT) << "step " << k;
        if (!report.solve.converged)
        {
            ++unconverged;
            continue;
        }
        EXPECT_LE(judged.rms, 1.05*settings.tolerance*report.solve.speedScale) << "step " << k;
        EXPECT_LE(judged.max*deltaT, 1.001*settings.displacementTolerance*diameter) << "step " << k;
        EXPECT_LT(judged.overlap, settings.overlapTolerance*diameter) << "step " << k;
    }
    return unconverged;
}

} // namespace

TEST_P(Solvers, spheresFallIntoABox)
{
    EXPECT_EQ(expectHonestSteps(heap(3, 4, 6, 0.01, 0.6, 0.4), 0.4, settings, 150), 0);
}

TEST_P(Solvers, discsFallIntoABox)
{
    EXPECT_EQ(expectHonestSteps(heap(2, 6, 12, 0.01, 0.3, 0.5), 0.5, settings, 150), 0);
}

TEST_P(Solvers, smoothSpheresFallIntoABox)
{
    EXPECT_EQ(expectHonestSteps(heap(3, 4, 5, 0.01, 0.8, 0.0), 0.0, settings, 120), 0);
}

TEST_P(Solvers, extremeFrictionConvergesButForAFewStepsThatSaySo)
{
    EXPECT_EQ(expectHonestSteps(heap(2, 5, 8, 0.01, 0.7, 2.0), 2.0, settings, 100), 0);
    for (double friction : {10.0, 1e6}) EXPECT_LE(expectHonestSteps(heap(2, 5, 8, 0.01, 0.7, friction), friction, settings, 100), 3);
}

TEST_P(Solvers, stackOfTenToTightTolerance)
{
    Scene scene(3, 0.5, 0.0);
    for (int i = 0; i < 10; ++i) scene.addGrain(Vec3(0, 0, 0.01*(2*i + 1)), 0.01);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    settings.tolerance = settings.displacementTolerance = 1e-10;
    settings.maxSweeps = 100000;
    auto dynamics = scene.build(settings);
    step(dynamics, scene.g, deltaT);
    const double unit = dynamics.grains().mass[0]*gravity;
    EXPECT_NEAR(-dynamics.wallForce()[0][2], 10*unit, 1e-6*10*unit);
}

INSTANTIATE_TEST_SUITE_P
(
    , Solvers,
    testing::Values(Variant{"NLGS", "portable"}, Variant{"NLGS", "AVX2"}, Variant{"NLGS", "AVX512"}, Variant{"NNCG", "auto"},
                    Variant{"APG", "auto"}, Variant{"queue", "portable"}, Variant{"direct", "portable"}),
    [](const testing::TestParamInfo<Variant>& info) { return info.param.solver + "_" + info.param.vectorPath; }
);

namespace
{

/// Random contacts between random bodies, eight body-disjoint ones a block.
struct RandomProblem
{
    std::vector<nscd::Body> bodies;
    std::vector<nscd::ContactBlock> blocks;

    nscd::BlockRange all() const { return {nullptr, blocks.size()}; }

    explicit RandomProblem(int nBlocks)
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> unit(-1, 1);
        bodies.resize(40);
        for (nscd::Body& body : bodies)
        {
            body = {{unit(random), unit(random), unit(random)}, 1.5 + unit(random), {unit(random), unit(random), unit(random)}, 4 + unit(random)};
        }
        blocks.resize(nBlocks);
        std::vector<int> order(bodies.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
        for (nscd::ContactBlock& block : blocks)
        {
            std::shuffle(order.begin(), order.end(), random);
            for (int lane = 0; lane < nscd::blockLanes; ++lane)
            {
                const Vec3 n = Vec3(unit(random), unit(random), unit(random)).normalized();
                const nscd::Body& a = bodies[order[2*lane]];
                const nscd::Body& b = bodies[order[2*lane + 1]];
                for (int k = 0; k < 3; ++k)
                {
                    block.n[k][lane] = n[k];
                    block.r[k][lane] = 0.1*n[k];
                }
                block.bias[lane] = 0.2*unit(random);
                block.invWn[lane] = 1/(a.invMass + b.invMass);
                block.invWt[lane] = 1/(a.invMass + b.invMass + a.invSpin + b.invSpin);
                block.friction[lane] = 0.5;
                block.a[lane] = order[2*lane];
                block.b[lane] = order[2*lane + 1];
            }
        }
    }
};

void expectSameBodies(const std::vector<nscd::Body>& x, const std::vector<nscd::Body>& y, double tolerance)
{
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        for (int k = 0; k < 3; ++k)
        {
            ASSERT_NEAR(x[i].v[k], y[i].v[k], tolerance);
            ASSERT_NEAR(x[i].s[k], y[i].s[k], tolerance);
        }
    }
}

} // namespace

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

TEST(Solver, unknownNamesAreRefusedWithThoseThereAre)
{
    try
    {
        nscd::findContactSolver("NLGQ");
        FAIL();
    }
    catch (const std::invalid_argument& error)
    {
        EXPECT_NE(std::strstr(error.what(), "NLGS, NNCG, APG, queue, direct"), nullptr) << error.what();
    }
    EXPECT_THROW(nscd::chooseKernels("SSE9"), std::invalid_argument);
}

TEST(Solver, reportsThatItDidNotConverge)
{
    const Scene scene = heap(3, 4, 8, 0.01, 0.8, 0.5);
    for (const char* solver : {"NLGS", "NNCG", "APG", "queue"})
    {
        nscd::ContactSettings settings;
        settings.solver = solver;
        settings.maxSweeps = 2;
        settings.tolerance = 1e-8;
        auto dynamics = scene.build(settings);
        int capped = 0;
        for (int k = 0; k < 150; ++k)
        {
            const nscd::StepReport report = step(dynamics, scene.g, deltaT);
            if (report.solve.converged) continue;
            ++capped;
            EXPECT_GT(report.solve.residualRms, settings.tolerance*report.solve.speedScale);
        }
        EXPECT_GT(capped, 10) << solver;
    }
}
