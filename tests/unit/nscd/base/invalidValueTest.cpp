// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The words in which a value is refused.
#include "nscd/base/invalidValue.hpp"

#include <gtest/gtest.h>

TEST(InvalidValue, saysNameValueAndWhatIsAllowed)
{
    EXPECT_STREQ(nscd::invalidValue("radius", -0.5, "> 0 m").what(), "radius is -0.5, allowed: > 0 m");
    EXPECT_STREQ(nscd::invalidValue("solver", std::string("x"), "NLGS").what(), "solver is x, allowed: NLGS");
}
