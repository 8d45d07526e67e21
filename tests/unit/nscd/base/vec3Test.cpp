// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The matrix of a cross product.
#include "nscd/base/vec3.hpp"

#include <gtest/gtest.h>

using namespace nscd;

TEST(Vec3, crossMatrixIsTheCrossProduct)
{
    const Vec3 x(1.5, -2, 0.25);
    for (const Vec3& y : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(-3, 2, 7)}) EXPECT_EQ(crossMatrix(x)*y, x.cross(y));
    EXPECT_EQ(crossMatrix(x).transpose(), -crossMatrix(x));
}
