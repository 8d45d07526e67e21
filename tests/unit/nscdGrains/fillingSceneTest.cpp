// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Sources that fill a region: scenes that are wrong in one place, grains of sources before, what the log says.
#include "input/dictionary/inputError.hpp"
#include "sceneFiles.hpp"
#include "sceneRun.hpp"
#include "unit/input/frontEnds.hpp"

#include <sstream>

using frontEnds::Wrong;
using sceneFiles::changed;
using sceneFiles::sceneWith;

namespace
{

const std::string loose = "type filling; region { type box; box (0 0 0) (0.06 0.06 0.2); } number 60; sizes { type uniform; min 0.008; max 0.012; } velocity (0 0 -0.5);";
const std::string dense = "type filling; region { type box; box (0 0 0) (0.06 0.06 0.2); } packing { solidFraction 0.52; } diameter 0.01;";

const Wrong wrongFillings[] =
{
    {"noAmount", "number 60;", "", 3, {"keyword grains.number is missing", "one of number", "packing { solidFraction 0.6; }"}},
    {"twoAmounts", "number 60;", "number 60; mass 1;", 3, {"keyword grains.mass stands beside number"}},
    {"packingBesideFraction", "number 60;", "solidFraction 0.3; packing { solidFraction 0.6; }", 3, {"keyword grains.packing stands beside solidFraction"}},
    {"misspeltPacking", "number 60;", "packng { solidFraction 0.6; }", 3, {"keyword grains.packng is not a keyword here", "nearest: packing"}},
    {"noGrain", "number 60", "number 0", 3, {"keyword grains.number is out of range", ">= 1"}},
    {"halfAGrain", "number 60", "number 60.5", 3, {"keyword grains.number is not a whole number"}},
    {"negativeMass", "number 60", "mass -1", 3, {"keyword grains.mass is out of range", "> 0"}},
    {"massInMeters", "number 60", "mass [0 1 0 0 0 0 0] 1", 3, {"keyword grains.mass has wrong dimensions", "[1 0 0 0 0 0 0]"}},
    {"fractionOfOne", "number 60", "solidFraction 1.5", 3, {"keyword grains.solidFraction is out of range"}},
    {"fractionBeyondAddition", "number 60; sizes { type uniform; min 0.008; max 0.012; }", "solidFraction 0.5; diameter 0.01;", 3,
        {"keyword grains.solidFraction is more than grains of one size reach at random", "up to 0.384", "packing { solidFraction 0.5; }"}},
    {"numberBeyondAddition", "number 60; sizes { type uniform; min 0.008; max 0.012; }", "number 700; diameter 0.01;", 3,
        {"keyword grains.number makes a solid fraction of 0.509", "more than grains of one size reach at random", "a solid fraction up to 0.384;", "packing { solidFraction 0.509"}},
    {"massBeyondAddition", "number 60; sizes { type uniform; min 0.008; max 0.012; }", "mass 1; diameter 0.01;", 3,
        {"keyword grains.mass makes a solid fraction of 0.55", "more than grains of one size reach at random", "a solid fraction up to 0.384"}},
    {"fractionBeyondPacking", "number 60;", "packing { solidFraction 0.7; }", 3, {"keyword grains.packing.solidFraction is out of range", "0.64"}},
    {"packingWithoutFraction", "number 60;", "packing { }", 3, {"keyword grains.packing.solidFraction is missing"}},
    {"keywordInPacking", "number 60;", "packing { solidFraction 0.6; number 3; }", 3, {"keyword grains.packing.number is of loose grains"}},
    {"numberInPacking", "number 60;", "packing { number 60; }", 3, {"keyword grains.packing.number is of loose grains, and stands in the place of packing"}},
    {"tooMany", "number 60", "number 999999999", 3, {"keyword grains.number makes too many grains", "memory of this machine"}},
    {"tooFine", "number 60; sizes { type uniform; min 0.008; max 0.012; }", "solidFraction 0.3; diameter 1e-7;", 3, {"keyword grains.solidFraction makes too many grains"}},
    {"noRegion", "region { type box; box (0 0 0) (0.06 0.06 0.2); }", "", 3, {"keyword grains.region is missing"}},
    {"flatRegion", "(0.06 0.06 0.2); }", "(0.06 0.06 0); }", 3, {"keyword grains.region is flat"}},
    {"noSizes", "sizes { type uniform; min 0.008; max 0.012; }", "", 3, {"keyword grains.diameter is missing"}},
    {"clump", "number 60;", "number 60; clump { members ((0 0 0)); diameter 0.01; }", 3, {"keyword grains.clump is not a keyword here"}},
    {"file", "number 60;", "number 60; file x;", 3, {"keyword grains.file is not a keyword here"}},
    {"noRoom", "number 60", "number 2000", 3, {"keyword grains.number asks for 2000 grains", "found places for", "packing"}},
    {"tooLittle", "number 60", "mass 1e-9", 3, {"keyword grains.mass is not enough for one grain"}}
};

class WrongFillings : public testing::TestWithParam<Wrong> {};

class Fillings : public sceneFiles::InFolder {};

} // namespace

TEST_P(WrongFillings, areRefusedInWords)
{
    const Wrong& bad = GetParam();
    sceneFiles::expectRefused(sceneWith(changed(loose, bad.from, bad.to)), bad.line, bad.mentions);
}

INSTANTIATE_TEST_SUITE_P(Keywords, WrongFillings, testing::ValuesIn(wrongFillings), [](const auto& info) { return info.param.name; });

TEST_F(Fillings, longerThanThePeriodAreRefused)
{
    const std::string open = changed(changed(sceneWith(loose), "periodic  { }", "periodic  { x (0 0.05); }"), "walls     { tray { type box; box (0 0 0) (0.06 0.06 0.2); } }", "walls     { }");
    sceneFiles::expectRefused(open, 3, {"region is longer than the period"});
}

/// 0.45 of the region: more than grains of one size reach at random where there is room for many.
TEST_F(Fillings, ofOneGrainMayBeAsTightAsItFits)
{
    const std::string one = changed(changed(loose, "(0.06 0.06 0.2)", "(0.0105 0.0105 0.0105)"), "number 60; sizes { type uniform; min 0.008; max 0.012; }", "number 1; diameter 0.01;");
    EXPECT_EQ(sceneFiles::readAndPlace(sceneWith(one)).size(), 1u);
}

/// readAndPlace() refuses overlaps with walls and with one another; those allowed by maxInitialOverlap would be seen by the other test.
TEST_F(Fillings, leaveTheGrainsOfSourcesBeforeAlone)
{
    for (const std::string& source : {loose, dense})
    {
        const std::string both = "a { type lattice; box (0 0 0) (0.06 0.06 0.06); count (2 2 2); diameter 0.02; } b { " + source + " }";
        const nscd::Grains grains = sceneFiles::readAndPlace(changed(sceneWith(both), "periodic", "maxInitialOverlap 0; periodic"));
        ASSERT_GT(grains.size(), 60u);
        EXPECT_EQ(grains.position[0], nscd::Vec3(0.015, 0.015, 0.015));
        EXPECT_EQ(grains.id.back(), std::int64_t(grains.size()) - 1);
    }
    EXPECT_EQ(sceneFiles::readAndPlace(sceneWith(loose)).velocity[59], nscd::Vec3(0, 0, -0.5));
}

TEST_F(Fillings, areReadBackToTheBitFromTheTableThatPackWrites)
{
    write("scene", sceneWith("a { " + loose + " } b { type lattice; box (0.02 0.02 0.19) (0.04 0.04 0.2); count (1 1 1); diameter 0.007; }") + "maxInitialOverlap 1;");
    std::ostringstream log;
    nscdGrains::RunOptions options{folder/"scene", false, false, folder/"grains.txt"};
    nscdGrains::runScene(options, log);
    EXPECT_FALSE(std::filesystem::exists(folder/"results"));
    const nscd::Grains first = nscdGrains::placeGrains(nscdGrains::readScene(folder/"scene"));
    write("again", sceneWith("type table; file grains.txt;") + "maxInitialOverlap 1;");
    const nscd::Grains again = nscdGrains::placeGrains(nscdGrains::readScene(folder/"again"));
    ASSERT_EQ(again.size(), 61u);
    EXPECT_EQ(again.position, first.position);
    EXPECT_EQ(again.radius, first.radius);
    EXPECT_EQ(again.material, first.material);
    // Another one is not written over it.
    EXPECT_THROW(nscdGrains::runScene(options, log), std::runtime_error);
    options.overwrites = true;
    EXPECT_NO_THROW(nscdGrains::runScene(options, log));
}

TEST_F(Fillings, areToldInTheLogWithTheirTime)
{
    write("scene", changed(sceneWith(dense), "endTime   0.09", "endTime   0.002") + "results out;\n");
    std::ostringstream log;
    nscdGrains::runScene({folder/"scene", false, false}, log);
    EXPECT_NE(log.str().find("filling: "), std::string::npos) << log.str();
    EXPECT_NE(log.str().find("solid fraction 0.5"), std::string::npos) << log.str();
    EXPECT_NE(log.str().find(" sweeps, "), std::string::npos) << log.str();
}
