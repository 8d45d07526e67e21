// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What OpenFOAM's parser would take without a word is found, and what it may take is let pass.
#include "input/dictionary/openFoamText.hpp"

#include <gtest/gtest.h>

namespace
{

std::string complaint(const std::string& text)
{
    try
    {
        input::checkOpenFoamText(text, "dict");
    }
    catch (const input::InputError& error)
    {
        return error.what();
    }
    return "";
}

} // namespace

TEST(OpenFoamText, keywordsGivenTwiceAreFound)
{
    EXPECT_EQ(complaint("a 1;\nb { c 1; d (1 2);\nc 2; }"), "dict, line 3: keyword b.c is given twice, first in line 2\n  allowed: once");
    EXPECT_NE(complaint("a { b 1; }\na { c 1; }"), "");
    EXPECT_NE(complaint("\"a.*\" 1; \"a.*\" 2;"), "");
    EXPECT_NE(complaint("a #calc \"1 + 2\"; a 1;"), "");
    EXPECT_NE(complaint("#include \"other\"\na 1; a 2;"), "");
    EXPECT_NE(complaint("a { #include \"other\" } b 1; b 2;"), "");
    EXPECT_NE(complaint("c #{ a; } #}; b 1; b 2;"), "");
    EXPECT_NE(complaint("a (b { c 1; } (1 2)); a 2;"), "");
}

/// OpenFOAM warns of a brace too many, and takes the rest of the text for something else.
TEST(OpenFoamText, semicolonsMissingBeforeADictionaryAreFound)
{
    EXPECT_EQ(complaint("w { n (0 0 1)\nm { t 1; } }"), "dict, line 1: keyword w.n has no semicolon before {\n  allowed: keyword value;");
    EXPECT_NE(complaint("a 1 b { c 2; }"), "");
    EXPECT_EQ(complaint("a 3{0}; b List<vector> 2{(0 0 0)}; c #eval{ 1 + 2 }; d #eval { 3 }; e (f { g 1; }); h #{ i { } #}; j ${k};"), "");
}

TEST(OpenFoamText, numbersThatOverflowAreFound)
{
    EXPECT_EQ(complaint("a { b\n-1e999; }"), "dict, line 1: keyword a.b is not a finite number\n  value:   -1e999\n  allowed: a number up to 1e308");
    EXPECT_NE(complaint("a table ((0 1) (1 1e999));"), "");
    EXPECT_EQ(complaint("a 1e300; b 1e-999; c \"1e999\"; d x1e999;"), "");
}

TEST(OpenFoamText, numbersThatOverflowAreFoundInAnyText)
{
    const auto complaintOf = [](const std::string& text)
    {
        try
        {
            input::checkFieldText(text, "U");
        }
        catch (const input::InputError& error)
        {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(complaintOf("2\n(\n(1 2e1 3)\n(1e3 -1.5e+0999 2)\n)"), "U, line 4: holds a number that no computer holds\n  value:   -1.5e+0999\n  allowed: a number up to 1e308");
    EXPECT_NE(complaintOf("1.E999"), "");
    EXPECT_NE(complaintOf("// of 1\n1e999"), "");
    EXPECT_EQ(complaintOf("// 1e999\n1e308 1e-999 one1e999 e999 1e99 the 1e0000001"), "");
    std::string deep = "a\n";
    for (int k = 0; k < 51; ++k) deep += "{ ";
    EXPECT_EQ(complaintOf(deep), "U, line 2: is nested too deep\n  allowed: at most 50 levels");
    EXPECT_EQ(complaintOf(deep.substr(0, deep.size() - 2) + "} {"), "");
}

TEST(OpenFoamText, keywordsOfOthersMayBeGivenTwice)
{
    EXPECT_NO_THROW(input::checkOpenFoamText("a 1; a 2;", "dict", input::Repeats::allowed));
    EXPECT_THROW(input::checkOpenFoamText("a 1e999; a 2;", "dict", input::Repeats::allowed), input::InputError);
}

TEST(OpenFoamText, deepDictionariesAreFound)
{
    std::string text;
    for (int k = 0; k < 100000; ++k) text += "z { ";
    EXPECT_NE(complaint(text).find("nested too deep"), std::string::npos);
}

TEST(OpenFoamText, whatMayBeMeantPasses)
{
    for (const char* const text :
    {
        "a 1; b { a 2; } c { a 3; }",
        "a 1; $b; $b; c { $..a; d 1; } ${e}; ${e};",
        "#inputMode merge\na 1; a 2;",
        "#ifeq $a 1\nb 1;\n#else\nb 2;\n#endif",
        "div(phi,U) 1; div(phi,k) 2;",
        "a \"quoted \\\" a\"; b 1;",
        "a { #include \"other\" } b { #include \"other\" }",
        "#remove (a b)\nc 1;",
        "a 1; } a 2;",
        "( a 1; a 2; )",
        "a { b 1;",
        "a",
        "a {",
        ";;; a 1;",
        ""
    })
    {
        EXPECT_EQ(complaint(text), "") << text;
    }
}
