// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Mass, mass center and inertia of clumps against closed forms and brute force.
#include "nscd/scene/clumps.hpp"
#include "nscd/scene/grains.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace nscd;

namespace
{

const double pi = std::acos(-1.0);

/// Two balls of radius r at z = -+c, as a body of revolution about z: slices of the half z > 0 by Simpson's rule.
struct Lens
{
    double volume, axial, transverse;   ///< moments of inertia of unit density
};

Lens twoBalls(double r, double c)
{
    const auto square = [&](double z) { return r*r - (z - c)*(z - c); };  // squared radius of the slice on the half z > 0
    Lens sum{0, 0, 0};
    const int n = 2000;
    const double h = (c + r)/n;
    for (int k = 0; k <= n; ++k)
    {
        const double z = k*h, weight = 2.0*h/3.0*(k == 0 || k == n ? 1 : k % 2 == 1 ? 4 : 2), a = pi*square(z);
        sum.volume += weight*a;
        sum.axial += weight*a*square(z)/2.0;
        sum.transverse += weight*a*(square(z)/4.0 + z*z);
    }
    return sum;
}

GrainShape discs()
{
    GrainShape shape;
    shape.dimensions = 2;
    shape.thickness = 0.5;
    return shape;
}

} // namespace

TEST(ClumpShape, separateBallsAddUp)
{
    const double r1 = 0.01, r2 = 0.02, density = 2500.0, m1 = density*4.0/3.0*pi*r1*r1*r1, m2 = 8.0*m1;
    const ClumpShape shape = makeClumpShape({{Vec3(1, 1, 1), r1}, {Vec3(1.03, 1, 1), r2}}, density, GrainShape());
    EXPECT_NEAR(shape.mass, m1 + m2, 1e-12*shape.mass);
    const double center = 1.0 + 0.03*m2/(m1 + m2);
    EXPECT_LT((shape.massCenter - Vec3(center, 1, 1)).norm(), 1e-14);
    const double axial = 0.4*(m1*r1*r1 + m2*r2*r2);
    const double transverse = axial + m1*m2/(m1 + m2)*0.03*0.03;
    EXPECT_LT((shape.inertia - Eigen::Matrix3d(Vec3(axial, transverse, transverse).asDiagonal())).norm(), 1e-11*transverse);
    EXPECT_LT((shape.members[1].center - shape.members[0].center - Vec3(0.03, 0, 0)).norm(), 1e-15);
}

TEST(ClumpShape, overlappingBallsCountOnce)
{
    for (double c : {0.9, 0.5, 0.1})
    {
        const Lens lens = twoBalls(1.0, c);
        for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(1, 2, 3).normalized().eval()})
        {
            const ClumpShape shape = makeClumpShape({{c*axis, 1.0}, {-c*axis, 1.0}, {Vec3::Zero(), 0.3}}, 3.0, GrainShape());
            const Eigen::Matrix3d expected = 3.0*(lens.transverse*Eigen::Matrix3d::Identity() + (lens.axial - lens.transverse)*axis*axis.transpose());
            EXPECT_NEAR(shape.mass, 3.0*lens.volume, 1e-10*shape.mass) << c;
            EXPECT_LT(shape.massCenter.norm(), 1e-10) << c;
            EXPECT_LT((shape.inertia - expected).norm(), 1e-10*expected.norm()) << c << " " << axis.transpose();
        }
    }
}

/// Four balls of different size, three of which share a corner: brute force on a grid, and no change by a turn.
TEST(ClumpShape, unionAgreesWithGridAndTurns)
{
    const std::vector<Ball> balls = {{Vec3(0, 0, 0), 1.0}, {Vec3(0.8, 0.1, 0), 0.7}, {Vec3(0.3, 0.8, 0.2), 0.8}, {Vec3(0.2, 0.2, 0.9), 0.6}};
    const ClumpShape shape = makeClumpShape(balls, 1.0, GrainShape());
    double volume = 0.0;
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
    const double h = 0.02;
    for (double x = -1.2; x < 1.8; x += h)
    {
        for (double y = -1.2; y < 1.8; y += h)
        {
            for (double z = -1.2; z < 1.8; z += h)
            {
                const Vec3 p = Vec3(x, y, z) + Vec3::Constant(0.5*h);
                bool isInside = false;
                for (const Ball& ball : balls) isInside = isInside || (p - ball.center).squaredNorm() < ball.radius*ball.radius;
                if (!isInside) continue;
                const Vec3 q = p - shape.massCenter;
                volume += h*h*h;
                inertia += h*h*h*(q.squaredNorm()*Eigen::Matrix3d::Identity() - q*q.transpose());
            }
        }
    }
    EXPECT_NEAR(shape.mass, volume, 1e-3*volume);
    EXPECT_LT((shape.inertia - inertia).norm(), 1e-3*inertia.norm());

    const Eigen::Matrix3d turn = Quaternion(0.3, 0.5, -0.2, 0.7).normalized().toRotationMatrix();
    std::vector<Ball> turned = balls;
    for (Ball& ball : turned) ball.center = turn*ball.center + Vec3(1, 2, 3);
    const ClumpShape other = makeClumpShape(turned, 1.0, GrainShape());
    EXPECT_NEAR(other.mass, shape.mass, 1e-10*shape.mass);
    EXPECT_LT((other.massCenter - turn*shape.massCenter - Vec3(1, 2, 3)).norm(), 1e-10);
    EXPECT_LT((other.inertia - turn*shape.inertia*turn.transpose()).norm(), 1e-10*shape.inertia.norm());
}

/// Two discs of radius 1 at x = -+c: closed form of the area; polar moment by strips of the half x > 0.
TEST(ClumpShape, overlappingDiscsCountOnce)
{
    const double c = 0.4, half = std::acos(c);
    const double area = 2.0*(pi - half + c*std::sqrt(1.0 - c*c));
    double polar = 0.0;
    const int n = 20000;
    for (int k = 0; k < n; ++k)
    {
        const double width = (pi - half)/n, angle = (k + 0.5)*width, x = c + std::cos(angle), y = std::sin(angle);
        polar += 2.0*(2.0*y*x*x + 2.0*y*y*y/3.0)*y*width;
    }
    const ClumpShape shape = makeClumpShape({{Vec3(c, 0, 5), 1.0}, {Vec3(-c, 0, 5), 1.0}}, 10.0, discs());
    EXPECT_NEAR(shape.mass, 10.0*0.5*area, 1e-12*shape.mass);
    EXPECT_LT((shape.massCenter - Vec3(0, 0, 5)).norm(), 1e-12);
    EXPECT_NEAR(shape.inertia(2, 2), 10.0*0.5*polar, 1e-7*shape.inertia(2, 2));
    EXPECT_EQ(shape.inertia(0, 0), shape.inertia(2, 2));
}

TEST(ClumpShape, badInputIsRefused)
{
    const GrainShape spheres;
    const std::vector<Ball> one = {{Vec3::Zero(), 1.0}};
    EXPECT_THROW(makeClumpShape({}, 1.0, spheres), std::invalid_argument);
    EXPECT_THROW(makeClumpShape({{Vec3::Zero(), -1.0}}, 1.0, spheres), std::invalid_argument);
    EXPECT_THROW(makeClumpShape({{Vec3(NAN, 0, 0), 1.0}}, 1.0, spheres), std::invalid_argument);
    EXPECT_THROW(makeClumpShape(one, 0.0, spheres), std::invalid_argument);
    EXPECT_THROW(makeClumpShape(one, -1.0, Vec3::Zero(), Eigen::Matrix3d::Identity(), spheres), std::invalid_argument);
    EXPECT_THROW(makeClumpShape(one, 1.0, Vec3::Zero(), -Eigen::Matrix3d::Identity(), spheres), std::invalid_argument);
    EXPECT_THROW(makeClumpShape(one, 1.0, Vec3::Zero(), Vec3(1, 1, 3).asDiagonal(), spheres), std::invalid_argument);
    EXPECT_THROW(makeClumpShape(one, 1.0, Vec3::Zero(), Vec3(1, 2, 3).asDiagonal(), discs()), std::invalid_argument);
    EXPECT_THROW(makeClumpShape({{Vec3(0, 0, 0), 1.0}, {Vec3(1, 1, 1), 1.0}}, 1.0, discs()), std::invalid_argument);
}
