// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Text of dictionaries, values asked of them, and what is said of those that are wrong.
#include "input/dictionary/checkedEntries.hpp"

#include <gtest/gtest.h>

using input::CheckedEntries;
using input::Dictionary;
using input::Vec3;

namespace
{

/// What a use of `text` as a dictionary throws; nothing: empty.
template<class Use>
std::string complaint(const std::string& text, const Use& use)
{
    try
    {
        const Dictionary dict = input::parseDictionary(text, "scene");
        use(CheckedEntries(dict));
    }
    catch (const input::InputError& error)
    {
        return error.what();
    }
    return "";
}

double density(const std::string& value)
{
    const Dictionary dict = input::parseDictionary("d " + value + ";", "scene");
    return CheckedEntries(dict).number("d", input::above(0, input::unit::density));
}

} // namespace

TEST(Dictionaries, keepLinesPathsAndKindsOfTokens)
{
    const Dictionary dict = input::parseDictionary("FoamFile { a 1; }\n/* two\n lines */ a // end\n{ \"b c\" (1 x \"y\"); ; }\n", "scene");
    ASSERT_EQ(dict.entries.size(), 1u);
    EXPECT_EQ(dict.entries[0].line, 3);
    EXPECT_FALSE(dict.entries[0].isQuoted);
    const Dictionary& a = *dict.entries[0].dict;
    ASSERT_EQ(a.entries.size(), 1u);
    const input::Entry& entry = a.entries[0];
    EXPECT_TRUE(entry.isQuoted);
    EXPECT_EQ(a.placeOf("b c").keyword, "a.b c");
    EXPECT_EQ(a.placeOf("b c").line, 4);
    EXPECT_EQ(a.placeOf("none").line, 3);
    ASSERT_EQ(entry.value.size(), 5u);
    EXPECT_TRUE(entry.value[0].isMark('('));
    EXPECT_EQ(entry.value[1].number, 1.0);
    EXPECT_EQ(entry.value[2].kind, input::Token::Kind::word);
    EXPECT_EQ(entry.value[3].kind, input::Token::Kind::quoted);
}

TEST(Dictionaries, numbersAreWholeWords)
{
    for (const char* word : {"0", "-1", "+2.5", ".5", "5.", "1e-3", "-1E+30", "1e-320"})
    {
        double number = 0.0;
        EXPECT_TRUE(input::readNumber(word, number)) << word;
        EXPECT_EQ(number, std::strtod(word, nullptr));
    }
    for (const char* word : {"", "-", "e", "1e", "nan", "inf", "1e999", "-1e999", "0x10", "5mm", "1,5", "1-2"})
    {
        double number = 0.0;
        EXPECT_FALSE(input::readNumber(word, number)) << word;
    }
}

TEST(Dictionaries, mayBeFiftyDeep)
{
    const auto nested = [](int depth)
    {
        std::string text;
        for (int k = 0; k < depth; ++k) text += "a {";
        return text + std::string(depth, '}');
    };
    EXPECT_NO_THROW(input::parseDictionary(nested(50), "scene"));
    EXPECT_THROW(input::parseDictionary(nested(51), "scene"), input::InputError);
    EXPECT_THROW(input::parseDictionary(nested(100000), "scene"), input::InputError);
}

TEST(Entries, dimensionsMayStandBeforeNumbers)
{
    for (const char* value : {"7", "[1 -3 0 0 0 0 0] 7", "[1 -3 0 0 0] 7", "rho [1 -3 0 0 0 0 0] 7"}) EXPECT_EQ(density(value), 7.0) << value;
    for (const char* value : {"[1 -2 0 0 0 0 0] 7", "[1 -3 0 1 0 0 0] 7", "[1 -3 0] 7", "[kg] 7", "[1 -3 0 0 0 0 0]", "[1 -3 0 0 0 0 0 7", "[] 7", "rho 7"})
    {
        EXPECT_THROW(density(value), input::InputError) << value;
    }
    const Dictionary dict = input::parseDictionary("v [0 1 -1 0 0 0 0] (1 2 3); b [0 1 0 0 0] (0 0 0) (1 1 1);", "scene");
    EXPECT_EQ(CheckedEntries(dict).vec("v", input::unit::velocity), Vec3(1, 2, 3));
    EXPECT_EQ(CheckedEntries(dict).twoVecs("b", input::unit::length)[1], Vec3(1, 1, 1));
}

TEST(Entries, numbersAreOfASizeThatCanBeReckonedWith)
{
    for (const char* value : {"1e30", "1e-30"}) EXPECT_NO_THROW(density(value)) << value;
    for (const char* value : {"1.1e30", "1e300", "0.9e-30", "1e-300"}) EXPECT_THROW(density(value), input::InputError) << value;
    const Dictionary dict = input::parseDictionary("zero 0; tiny 1e-300; point (1e-300 0 -1e30); far (0 0 -2e30);", "scene");
    const CheckedEntries given(dict);
    EXPECT_EQ(given.number("zero", input::atLeast(0)), 0.0);
    EXPECT_EQ(given.number("tiny", input::atLeast(0)), 1e-300);
    EXPECT_EQ(given.number("tiny", input::anyNumber()), 1e-300);
    EXPECT_NO_THROW(given.vec("point", input::unit::length));
    EXPECT_THROW(given.vec("far", input::unit::length), input::InputError);
}

TEST(Entries, rangesSayWhatTheyAllow)
{
    EXPECT_EQ(input::anyNumber().describe(), "a finite number");
    EXPECT_EQ(input::atLeast(2).describe(), "a finite number >= 2");
    EXPECT_EQ(input::within(0, 1).describe(), "a finite number > 0 and < 1");
    EXPECT_TRUE(input::between(0, 1).contains(1));
    EXPECT_FALSE(input::within(0, 1).contains(1));
    EXPECT_FALSE(input::above(1).contains(1));
}

TEST(Entries, sayAllOfAMistake)
{
    const std::string said = complaint("a { b\n1.5; }", [](const CheckedEntries& top) { CheckedEntries(top.sub("a")).integer("b", 2); });
    EXPECT_EQ(said, "scene, line 1: keyword a.b is out of range\n  value:   1.5\n  allowed: a finite number >= 2");
    const std::string nearest = complaint("frction 1;", [](const CheckedEntries& top) { top.number("friction", input::atLeast(0)); });
    EXPECT_EQ(nearest, "scene, line 1: keyword frction is not a keyword here, and friction is missing\n  value:   frction\n"
        "  allowed: friction value;\n  nearest: friction");
    const std::string missing = complaint("other 1;", [](const CheckedEntries& top) { top.number("friction", input::atLeast(0)); });
    EXPECT_EQ(missing, "scene: keyword friction is missing\n  allowed: friction value;");
}

TEST(Entries, whatNobodyDeclaredIsRefused)
{
    const auto read = [](const CheckedEntries& top)
    {
        top.found("a");
        top.number("b", input::anyNumber(), 1.0);
        top.subOrEmpty("c");
        top.finish();
    };
    EXPECT_EQ(complaint("a 1; b 2; c {}", read), "");
    EXPECT_EQ(complaint("a 1;\nd 2;", read), "scene, line 2: keyword d is not a keyword here\n  value:   d\n  allowed: a, b, c");
}

/// Beside entries that somebody else reads.
TEST(Entries, whatMayBeMisspeltIsRefused)
{
    const auto read = [](const CheckedEntries& top) { top.refuseMisspelt({"deltaT", "maxDeltaT", "maxCo"}); };
    EXPECT_EQ(complaint("deltaT 1; startTime 0; maxDi 3;", read), "");
    EXPECT_EQ(complaint("deltaT 1;\nmxaCo 2;", read), "scene, line 2: keyword mxaCo is not a keyword here\n  value:   mxaCo\n  allowed: maxCo\n  nearest: maxCo");
}

TEST(Entries, listsAndWords)
{
    const Dictionary dict = input::parseDictionary("ids (3 1); counted 2 (3 1); words (a b); none (); pair (0 1); points ((0 0 0) (1 2 3)); on yes; name \"a b\";", "scene");
    const CheckedEntries given(dict);
    EXPECT_EQ(given.integers("ids", 0), (std::vector<long>{3, 1}));
    EXPECT_EQ(given.integers("counted", 0), (std::vector<long>{3, 1}));
    EXPECT_EQ(given.choices("words", {"a", "b", "c"}, {}), (input::Words{"a", "b"}));
    EXPECT_EQ(given.choices("none", {"a"}, {"a"}), input::Words{});
    EXPECT_EQ(given.choices("missing", {"a"}, {"a"}), input::Words{"a"});
    EXPECT_EQ(given.pair("pair", input::unit::one)[1], 1.0);
    EXPECT_EQ(given.vecList("points", input::unit::length)[1], Vec3(1, 2, 3));
    EXPECT_TRUE(given.flag("on", false));
    EXPECT_EQ(given.text("name"), "a b");
    EXPECT_THROW(given.choices("words", {"a", "c"}, {}), input::InputError);
    EXPECT_THROW(given.integers("words", 0), input::InputError);
    EXPECT_THROW(given.text("pair"), input::InputError);
}
