// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Scenes that are wrong in one place: each is refused with file, line, keyword, value, and what is allowed. What nscdDEMFoam refuses too is in
// tests/unit/input; here are these, and what nscdGrains alone reads.
#include "sceneFiles.hpp"
#include "unit/input/rightInputs.hpp"
#include "unit/input/wrongInputs.hpp"
#include "unit/input/wrongMotions.hpp"

using frontEnds::Complaint;
using frontEnds::Space;
using frontEnds::Wrong;
using frontEnds::WrongFile;
using sceneFiles::goodScene;

namespace
{

/// What makes a scene of a text, in the last line.
std::string sceneOf(const std::string& text, Space space)
{
    const std::string more = space == Space::discs ? "dimensions 2; " : space == Space::periodicY ? "periodic { y (0 0.06); } " : "";
    return text + more + "deltaT 1e-3; endTime 0.09;\n";
}

class SharedInputs : public sceneFiles::InFolder
{
protected:
    frontEnds::FrontEnd frontEnd() const
    {
        return [this](const std::string& text, Space space, const std::string& file)
        {
            write("grains.txt", file);
            return sceneFiles::complaint(sceneOf(text, space), folder/"scene");
        };
    }
};

const Wrong badScenes[] =
{
    {"misspeltTopKeyword", "writeInterval 0.03", "writeInteval 0.03", 10, {"keyword writeInteval is not a keyword here", "nearest: writeInterval"}},
    {"misspeltNeededKeyword", "deltaT ", "deltat ", 8, {"keyword deltat", "deltaT is missing", "nearest: deltaT"}},
    {"misspeltDimensions", "tray { type box; box (0 0 0) (0.06 0.06 0.2); }", "floor { type polygon; vertices ((0 0 0) (1 0 0)); } } dimensons 2; planes {", 5,
        {"keyword dimensons is not a keyword here", "nearest: dimensions"}},
    {"missingKeyword", "endTime   0.09;", "", 0, {"keyword endTime is missing", "allowed: endTime value;"}},
    {"missingDictionary", "contacts  { default { friction 0.3; restitution 0.2; } }", "", 0, {"keyword contacts is missing"}},
    {"dictionaryForValue", "deltaT    1e-3;", "deltaT    { }", 8, {"keyword deltaT is a dictionary where a value belongs"}},
    {"nanTime", "endTime   0.09", "endTime   nan", 9, {"keyword endTime is not a finite number", "value:   nan"}},
    {"infiniteTime", "endTime   0.09", "endTime   inf", 9, {"keyword endTime is not a finite number", "value:   inf"}},
    {"overflowingNumber", "endTime   0.09", "endTime   1e999", 9, {"keyword endTime is not a finite number"}},
    {"negativeStep", "deltaT    1e-3", "deltaT    -1e-3", 8, {"keyword deltaT is out of range", "value:   -1e-3", "> 0"}},
    {"zeroStep", "deltaT    1e-3", "deltaT    0", 8, {"keyword deltaT is out of range"}},
    {"endBeforeFirstStep", "endTime   0.09", "endTime   1e-5", 9, {"keyword endTime is shorter than a step"}},
    {"endlessRun", "endTime   0.09", "endTime   1e12", 9, {"keyword endTime makes too many steps", "value:   1e12"}},
    {"zeroWriteInterval", "writeInterval 0.03", "writeInterval 0", 10, {"keyword writeInterval is out of range"}},
    {"fractionOfStates", "gravity ", "purgeWrite 1.5; gravity ", 11, {"keyword purgeWrite is not a whole number", "value:   1.5"}},
    {"twoNumbers", "deltaT    1e-3;", "deltaT    1e-3 2e-3;", 8, {"keyword deltaT is not a single number", "value:   1e-3 2e-3"}},
    {"missingSemicolon", "deltaT    1e-3;", "deltaT    1e-3", 8, {"keyword deltaT is not a single number (a missing semicolon?)"}},
    {"missingLastSemicolon", "gravity   (0 0 -9.81);", "gravity   (0 0 -9.81)", 11, {"keyword gravity has no semicolon"}},
    {"missingValue", "deltaT    1e-3;", "deltaT;", 8, {"keyword deltaT has no value"}},
    {"unclosedDictionary", "solver    { type NLGS; }", "solver    { type NLGS;", 7, {"keyword solver begins a dictionary that does not end"}},
    {"closingBraceTooMany", "solver    { type NLGS; }", "solver    { type NLGS; } }", 7, {"has no keyword here", "value:   }"}},
    {"unclosedString", "type NLGS;", "type \"NLGS;", 7, {"begins a string that does not end"}},
    {"unclosedComment", "gravity ", "/* gravity ", 11, {"begins a comment that does not end"}},
    {"keywordTwice", "endTime   0.09;", "deltaT 2;", 9, {"keyword deltaT is given twice, first in line 8"}},
    {"numberForKeyword", "deltaT    1e-3", "1e-3 deltaT", 8, {"has a number where a keyword belongs", "value:   1e-3"}},
    {"macro", "deltaT    1e-3", "deltaT    $dt", 8, {"holds $"}},
    {"include", "gravity ", "#include \"other\"\ngravity ", 11, {"holds #"}},
    {"binaryFile", "gravity ", "\x01\x02", 11, {"holds a character that is no text"}},
    {"shortVector", "gravity   (0 0 -9.81)", "gravity   (0 -9.81)", 11, {"keyword gravity is not a vector", "value:   ( 0 -9.81 )"}},
    {"vectorWithAWord", "gravity   (0 0 -9.81)", "gravity   (0 0 down)", 11, {"keyword gravity is not a finite number"}},
    {"noMaterial", "{ glass { density 2500; } steel {} }", "{ }", 1, {"keyword materials names no material"}},
    {"noGrains", "grains    { type lattice; box (0 0 0) (0.06 0.06 0.08); count (5 5 5); diameter 0.01; spread 0.2; jitter 0.5; }",
        "grains { }", 3, {"keyword grains names no source of grains"}},
    {"periodTooShort", "periodic  { }", "periodic  { y (0 0.008); }", 6, {"keyword periodic makes a period shorter than a grain", "value:   0.008 along y"}},
    {"emptyPeriod", "periodic  { }", "periodic  { y (1 0); }", 6, {"keyword periodic.y is empty"}},
    {"unknownAxis", "periodic  { }", "periodic  { w (0 1); }", 6, {"keyword periodic.w is not a keyword here", "allowed: x, y, z"}},
    {"oneDimension", "gravity ", "dimensions 1; gravity ", 11, {"keyword dimensions is out of range"}},
    {"thicknessOfSpheres", "gravity ", "thickness 1; gravity ", 11, {"keyword thickness is for discs"}},
    {"gravityOutOfPlane", "gravity ", "dimensions 2; gravity ", 11, {"keyword gravity points out of the plane of the grains"}},
    {"hugeTime", "endTime   0.09", "endTime   1e300", 9, {"keyword endTime is too large"}},
    {"stepInMeters", "deltaT    1e-3", "deltaT    [0 1 0 0 0 0 0] 1e-3", 8, {"keyword deltaT has wrong dimensions", "[0 0 1 0 0 0 0]"}}
};

class BadScenes : public testing::TestWithParam<Wrong> {};

class WrongInputs : public SharedInputs, public testing::WithParamInterface<Wrong> {};
class WrongFiles : public SharedInputs, public testing::WithParamInterface<WrongFile> {};
class RightInputs : public SharedInputs, public testing::WithParamInterface<frontEnds::Right> {};
class WrongSurfaces : public SharedInputs {};

} // namespace

TEST_P(WrongInputs, areRefusedInWords) { frontEnds::expectRefused(GetParam(), frontEnd(), "scene"); }
TEST_P(WrongFiles, areRefusedInWords) { frontEnds::expectRefused(GetParam(), frontEnd(), "scene"); }

TEST_P(RightInputs, areAccepted)
{
    const frontEnds::Right& right = GetParam();
    EXPECT_EQ(frontEnd()(frontEnds::changed(frontEnds::rightText(), right.from, right.to), right.space, "").text, "");
}

const auto nameOf = [](const auto& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(Keywords, WrongInputs, testing::ValuesIn(frontEnds::wrongInputs()), nameOf);
INSTANTIATE_TEST_SUITE_P(Walls, WrongInputs, testing::ValuesIn(frontEnds::wrongWalls()), nameOf);
INSTANTIATE_TEST_SUITE_P(Motions, WrongInputs, testing::ValuesIn(frontEnds::wrongMotions()), nameOf);
INSTANTIATE_TEST_SUITE_P(Grains, WrongFiles, testing::ValuesIn(frontEnds::wrongFiles()), nameOf);
INSTANTIATE_TEST_SUITE_P(Texts, RightInputs, testing::ValuesIn(frontEnds::rightInputs()), nameOf);

TEST_P(BadScenes, areRefusedInWords)
{
    const Wrong& bad = GetParam();
    const Complaint said = sceneFiles::complaint(frontEnds::changed(goodScene(), bad.from, bad.to), "folder/bad.scene");
    ASSERT_FALSE(said.text.empty()) << "was accepted";
    EXPECT_EQ(said.file, "folder/bad.scene");
    EXPECT_EQ(said.line, bad.line) << said.text;
    frontEnds::expectMentions(said, bad.mentions);
}

INSTANTIATE_TEST_SUITE_P(Scene, BadScenes, testing::ValuesIn(badScenes), nameOf);

TEST_F(WrongSurfaces, areRefusedInWords)
{
    const std::string text = frontEnds::changed(frontEnds::rightText(), "walls     { ", "walls     { s { type stl; file bad.stl; } ");
    for (const auto& [stl, words] : frontEnds::wrongSurfaces())
    {
        write("bad.stl", stl);
        const Complaint said = frontEnd()(text, Space::spheres, "");
        EXPECT_EQ(said.line, 5) << stl;
        frontEnds::expectMentions(said, {"keyword walls.s.file ", words});
    }
}
