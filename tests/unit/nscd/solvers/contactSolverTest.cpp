// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The solver suite: every solver and every vector path, judged by a residual recomputed from velocities and contacts.
#include "nscd/solvers/contactSolver.hpp"
#include "unit/nscd/scenes/heaps.hpp"
#include "unit/nscd/scenes/naturalMap.hpp"
#include "unit/nscd/scenes/randomProblem.hpp"

#include <gtest/gtest.h>

#include <cstring>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3;

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
