// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The nearest word to a mistyped one.
#include "nscd/base/nearestWord.hpp"

#include <gtest/gtest.h>

using nscd::editDistance;
using nscd::nearestWord;

TEST(NearestWord, countsInsertionsDeletionsReplacementsAndSwaps)
{
    EXPECT_EQ(editDistance("", ""), 0);
    EXPECT_EQ(editDistance("", "abc"), 3);
    EXPECT_EQ(editDistance("abc", ""), 3);
    EXPECT_EQ(editDistance("kitten", "sitting"), 3);
    EXPECT_EQ(editDistance("DiFelice", "DiFelcie"), 1);
    EXPECT_EQ(editDistance("DIFELICE", "diFelice"), 0);
    EXPECT_EQ(editDistance("Ergun", "Ergn"), 1);
    EXPECT_EQ(editDistance("ca", "abc"), 3);
}

TEST(NearestWord, findsWhatWasMeantAndNothingElse)
{
    const std::vector<std::string> names = {"Stokes", "DallaValle", "DiFelice", "WenYu", "Ergun", "Gidaspow"};
    EXPECT_EQ(nearestWord("dallavale", names), "DallaValle");
    EXPECT_EQ(nearestWord("DiFelcie", names), "DiFelice");
    EXPECT_EQ(nearestWord("Wen-Yu", names), "WenYu");
    EXPECT_EQ(nearestWord("Gidaspov", names), "Gidaspow");
    EXPECT_EQ(nearestWord("banana", names), "");
    EXPECT_EQ(nearestWord("", names), "");
    EXPECT_EQ(nearestWord("x", {}), "");
}

TEST(NearestWord, takesTheFirstOfEquals)
{
    EXPECT_EQ(nearestWord("abcx", {"abcd", "abce"}), "abcd");
    EXPECT_EQ(nearestWord("abce", {"abcd", "abce"}), "abce");
}
