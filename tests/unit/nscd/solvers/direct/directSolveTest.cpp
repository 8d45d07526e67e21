// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The direct method: its parts against brute force, what it solves that sweeps do not, and when it is used.
#include "nscd/solvers/direct/contactStiffness.hpp"
#include "nscd/solvers/direct/convexContact.hpp"
#include "nscd/solvers/direct/coulombCone.hpp"
#include "unit/nscd/scenes/scenes.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3, radius = 0.01;

std::mt19937 engine(5);

Vec3 randomVector()
{
    std::uniform_real_distribution<double> unit(-1, 1);
    return Vec3(unit(engine), unit(engine), unit(engine));
}

Scene stack(int grains, double topRatio = 1.0)
{
    Scene scene(3, 0.5, 0.0);
    for (int i = 0; i < grains; ++i) scene.addGrain(Vec3(0, 0, radius*(2*i + 1)), radius);
    scene.grains.mass.back() *= topRatio;
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    return scene;
}

double baseForceError(const Scene& scene, const nscd::GrainDynamics& dynamics)
{
    double load = 0.0;
    for (double m : scene.grains.mass) load += m*gravity;
    return std::abs(dynamics.wallForce()[0][2] + load)/load;
}

} // namespace

TEST(CoulombCone, impulsesAreAdmissibleAndMoveAsTheirDerivativeSays)
{
    for (double friction : {0.0, 0.01, 0.5, 5.0})
    {
        for (int k = 0; k < 200; ++k)
        {
            const Vec3 n = randomVector().normalized(), r = randomVector(), u = randomVector(), du = 1e-6*randomVector();
            const auto at = [&](const Vec3& velocity) { return nscd::smoothedImpulse(r, velocity, n, friction, 2.0, 0.1); };
            const nscd::ConePoint point = at(u);
            const double pn = point.impulse.dot(n), pt = (point.impulse - pn*n).norm();
            EXPECT_GT(pn, 0.0);
            EXPECT_LE(pt, friction*pn*(1 + 1e-9) + 1e-12);
            const Vec3 change = 0.5*(at(u + du).impulse - at(u - du).impulse);
            EXPECT_LT((change + point.stiffness*du).norm(), 1e-6*(1 + 1/std::max(0.01, friction))*1e-3 + 1e-6*change.norm());
        }
    }
}

TEST(CoulombCone, withoutSmoothingAndPenaltyOnlyComplementarityIsLeft)
{
    // A closed sticking contact keeps its multiplier; one that parts has none; one that slides holds mu r_n against u_t.
    const Vec3 n = Vec3::UnitZ(), r(0.1, 0, 1);
    EXPECT_LT((nscd::smoothedImpulse(r, Vec3::Zero(), n, 0.5, 1e3, 1e-9).impulse - r).norm(), 1e-6);
    EXPECT_LT(nscd::smoothedImpulse(Vec3::Zero(), Vec3(0, 0, 1), n, 0.5, 1e3, 1e-9).impulse.norm(), 1e-6);
    const Vec3 sliding = nscd::smoothedImpulse(Vec3(-0.5, 0, 1), Vec3(1e-6, 0, 0.5e-6), n, 0.5, 1e3, 1e-9).impulse;
    EXPECT_LT((sliding - Vec3(-0.5, 0, 1)).norm(), 1e-2);
}

TEST(ContactStiffness, solvesAsADenseMatrix)
{
    // Bodies 0..4; -1 does not move; one pair has two contacts.
    const std::vector<nscd::JoinedBodies> joined = {{0, 1}, {2, 1}, {3, 0}, {3, 4}, {4, 3}, {-1, 2}, {4, -1}};
    nscd::ContactStiffness sparse(joined, 5, {0, 1, 2, 3, 4, 5});
    Eigen::VectorXd mass(30), right(30);
    for (int k = 0; k < 30; ++k) mass[k] = 1.5 + randomVector()[0];
    for (int k = 0; k < 30; ++k) right[k] = randomVector()[0];
    Eigen::MatrixXd dense = mass.asDiagonal();
    sparse.start(mass);
    for (std::size_t k = 0; k < joined.size(); ++k)
    {
        const Vec3 n = randomVector().normalized();
        Eigen::Matrix3d d = Eigen::Matrix3d::Random();
        d = (d*d.transpose()).eval();
        sparse.add(k, n, d);
        Eigen::MatrixXd b = Eigen::MatrixXd::Zero(3, 30);
        for (int side = 0; side < 2; ++side)
        {
            if (joined[k][side] < 0) continue;
            for (int c = 0; c < 3; ++c)
            {
                b.col(6*joined[k][side] + c) = side == 0 ? Vec3(Vec3::Unit(c)) : Vec3(-Vec3::Unit(c));
                b.col(6*joined[k][side] + 3 + c) = n.cross(Vec3::Unit(c));
            }
        }
        dense += b.transpose()*d*b;
    }
    ASSERT_TRUE(sparse.factorize());
    EXPECT_LT((dense*sparse.solve(right) - right).norm(), 1e-12*right.norm());
    EXPECT_TRUE(std::isinf(sparse.analyze(1.0)));
    EXPECT_GT(sparse.analyze(1e9), 5*6*36.0 - 1);
}

TEST(Direct, stackOfThreeHundredFromCold)
{
    nscd::ContactSettings settings = tight();
    settings.solver = "direct";
    settings.tolerance = settings.displacementTolerance = 1e-8;
    const Scene scene = stack(300);
    auto dynamics = scene.build(settings);
    const nscd::StepReport report = step(dynamics, scene.g, deltaT);
    EXPECT_TRUE(report.solve.converged);
    EXPECT_EQ(report.solve.sweeps, 0);
    EXPECT_GT(report.solve.newtonSteps, 0);
    EXPECT_LT(baseForceError(scene, dynamics), 1e-6);
}

TEST(Direct, takesOverWhereSweepsWouldGoToTheCap)
{
    // Sweeps alone leave a base force off by more than a half.
    nscd::ContactSettings settings;
    settings.tolerance = settings.displacementTolerance = 1e-8;
    const Scene scene = stack(300);
    auto dynamics = scene.build(settings);
    const nscd::StepReport report = step(dynamics, scene.g, deltaT);
    EXPECT_TRUE(report.solve.converged);
    EXPECT_LT(baseForceError(scene, dynamics), 1e-6);
}

TEST(Direct, makesForcesUnderHeavyBodiesRight)
{
    for (double ratio : {1e3, 1e4})
    {
        const Scene scene = stack(20, ratio);
        auto dynamics = scene.build(nscd::ContactSettings());
        for (int k = 0; k < 50; ++k)
        {
            const nscd::StepReport report = step(dynamics, scene.g, deltaT);
            EXPECT_TRUE(report.solve.converged);
            EXPECT_EQ(nscd::warning(report.solve), "");
            ASSERT_LT(baseForceError(scene, dynamics), 1e-3) << ratio << " step " << k;
        }
    }
}

TEST(Direct, saysSoWhereItIsTooDearForAHeavyBody)
{
    nscd::ContactSettings settings;
    settings.maxSweeps = 100;  // what the direct method may cost goes with it
    const Scene scene = stack(20, 1e4);
    auto dynamics = scene.build(settings);
    const nscd::StepReport report = step(dynamics, scene.g, deltaT);
    EXPECT_NEAR(report.solve.hiddenMassRatio, 1e4, 1.0);
    EXPECT_NE(nscd::warning(report.solve).find("1:1e+04"), std::string::npos) << nscd::warning(report.solve);
}
