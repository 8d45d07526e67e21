// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Functions of time as they are written, and those of a program that knows more of them.
#include "input/scene/functionReader.hpp"

#include <gtest/gtest.h>

#include <cmath>

using nscd::Vec3;

namespace
{

/// A program that calls all its functions 7, and knows `ramp` besides the usual ones.
struct MoreFunctions : input::Functions
{
    input::Words types() const override { return {"constant", "ramp", "sine", "table"}; }
    nscd::ScalarOfTime scalar(const std::string&) const override { return [](double) { return 7.0; }; }
    nscd::VectorOfTime vector(const std::string&) const override { return [](double) { return Vec3(7, 7, 7); }; }
};

nscd::ScalarOfTime scalarOf(const std::string& value, bool hasMore = false)
{
    input::Dictionary dict = input::parseDictionary("f " + value, "scene");
    if (hasMore) dict.functions = std::make_shared<MoreFunctions>();
    return input::readScalarFunction(input::CheckedEntries(dict), "f");
}

nscd::VectorOfTime vectorOf(const std::string& value, int emptyAxis = -1)
{
    const input::Dictionary dict = input::parseDictionary("f " + value, "scene");
    return input::readVectorFunction(input::CheckedEntries(dict), "f", emptyAxis);
}

} // namespace

TEST(FunctionsOfTime, areThoseOfOpenFOAM)
{
    for (const char* value : {"2.5;", "constant 2.5;", "{ type constant; value 2.5; }", "table ((0 2.5));"}) EXPECT_EQ(scalarOf(value)(7), 2.5) << value;
    for (const char* value : {"table ((0 1) (2 3) (3 -1));", "{ type table; values ((0 1) (2 3) (3 -1)); }"})
    {
        const nscd::ScalarOfTime f = scalarOf(value);
        const double at[][2] = {{-1, 1}, {0, 1}, {0.5, 1.5}, {2, 3}, {2.25, 2}, {3, -1}, {9, -1}};
        for (const auto& pair : at) EXPECT_NEAR(f(pair[0]), pair[1], 1e-15) << pair[0];
    }
    const nscd::ScalarOfTime sine = scalarOf("{ type sine; frequency 5; amplitude 2; scale 3; level -1; t0 0.01; }");
    EXPECT_NEAR(sine(0.07), -1 + 6*std::sin(2*M_PI*5*0.06), 1e-14);
    EXPECT_EQ(vectorOf("(1 2 3);")(4), Vec3(1, 2, 3));
    EXPECT_EQ(vectorOf("table ((0 (0 0 0)) (2 (1 2 -4)));")(1), Vec3(0.5, 1, -2));
    const nscd::VectorOfTime shaken = vectorOf("{ type sine; frequency 1; amplitude 2; scale (1 0 -1); level (0 3 0); }");
    EXPECT_NEAR((shaken(0.25) - Vec3(2, 3, -2)).norm(), 0, 1e-14);
}

TEST(FunctionsOfTime, discsStayInTheirPlane)
{
    EXPECT_EQ(vectorOf("table ((0 (0 1 0)) (1 (0 2 0)));", 2)(1), Vec3(0, 2, 0));
    EXPECT_THROW(vectorOf("table ((0 (0 1 0)) (1 (0 2 1)));", 2), input::InputError);
    EXPECT_THROW(vectorOf("table ((0 (0 1 0)) (1 (0 2 1)));", 1), input::InputError);
    EXPECT_THROW(vectorOf("{ type sine; frequency 1; amplitude 2; scale (1 0 -1); level (0 3 0); }", 2), input::InputError);
}

TEST(FunctionsOfTime, ofAProgramThatKnowsMoreAreItsOwn)
{
    const bool hasMore = true;
    for (const char* value : {"2.5;", "constant 2.5;", "table ((0 2.5));", "ramp;", "{ type ramp; anything 1; }",
                              "{ type sine; frequency 5; amplitude 2; scale 3; level -1; }", "{ type sine; frequency table ((0 1)); amplitude 2; scale 3; level -1; }"})
    {
        EXPECT_EQ(scalarOf(value, hasMore)(1), 7) << value;
    }
    // These it need not know.
    EXPECT_EQ(scalarOf("{ type constant; value 2.5; }", hasMore)(1), 2.5);
    EXPECT_EQ(scalarOf("{ type table; values ((0 0) (2 5)); }", hasMore)(1), 2.5);
    EXPECT_EQ(scalarOf("{ type table; values ((0 0) (2 5)); outOfBounds repeat; }", hasMore)(1), 7);
}

TEST(FunctionsOfTime, ofAProgramThatKnowsMoreAreCheckedAllTheSame)
{
    for (const char* value : {"2.5 3;", "constant;", "1e300;", "table ((1 0) (0 1));", "table ((0 1)) 5;", "rampe;", "{ type rampe; }", "{ }",
                              "{ type sine; frequency -5; amplitude 2; scale 3; level -1; }", "{ type sine; frequency 5; amplitude 2; scale 3; }"})
    {
        EXPECT_THROW(scalarOf(value, true), input::InputError) << value;
    }
    EXPECT_THROW(scalarOf("ramp;"), input::InputError);
}

TEST(FunctionsOfTime, mayKeepTheirNumbersBesideThemselves)
{
    input::Dictionary dict = input::parseDictionary("f ramp; fCoeffs { start 1; }", "scene");
    dict.functions = std::make_shared<MoreFunctions>();
    const input::CheckedEntries given(dict);
    input::readScalarFunction(given, "f");
    EXPECT_NO_THROW(given.finish());
}
