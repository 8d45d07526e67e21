// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The sparse matrix of bodies in contact against a dense one.
#include "nscd/solvers/direct/contactStiffness.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace nscd;

namespace
{

std::mt19937 engine(5);

Vec3 randomVector()
{
    std::uniform_real_distribution<double> unit(-1, 1);
    const double x = unit(engine), y = unit(engine), z = unit(engine);
    return Vec3(x, y, z);
}

} // namespace

TEST(ContactStiffness, solvesAsADenseMatrix)
{
    // Bodies 0..4; -1 does not move; one pair has two contacts.
    const std::vector<JoinedBodies> joined = {{0, 1}, {2, 1}, {3, 0}, {3, 4}, {4, 3}, {-1, 2}, {4, -1}};
    ContactStiffness sparse(joined, 5, {0, 1, 2, 3, 4, 5});
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

TEST(ContactStiffness, leavesOutComponentsThatNothingMovesAlong)
{
    const std::vector<JoinedBodies> joined = {{0, 1}, {1, -1}};
    const Vec3 n = Vec3::UnitZ();
    ContactStiffness whole(joined, 2, {0, 1, 2, 3, 4, 5}), normal(joined, 2, {2});
    Eigen::VectorXd right = Eigen::VectorXd::Zero(12);
    right[2] = 1.0;
    right[8] = -3.0;
    for (ContactStiffness* matrix : {&whole, &normal})
    {
        matrix->start(Eigen::VectorXd::Constant(12, 2.0));
        for (std::size_t k = 0; k < 2; ++k) matrix->add(k, n, 5.0*n*n.transpose());
        ASSERT_TRUE(matrix->factorize());
    }
    EXPECT_LT((whole.solve(right) - normal.solve(right)).norm(), 1e-15);
}

TEST(ContactStiffness, saysWhenItIsNotPositiveDefinite)
{
    ContactStiffness matrix({{0, -1}}, 1, {0, 1, 2, 3, 4, 5});
    matrix.start(Eigen::VectorXd::Constant(6, 1.0));
    matrix.add(0, Vec3::UnitZ(), -2.0*Eigen::Matrix3d::Identity());
    EXPECT_FALSE(matrix.factorize());
}
