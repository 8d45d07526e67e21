// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// nscdDEMFoam refuses what nscdGrains refuses, and takes the same settings from what both accept (tests/unit/input).
#include "caseTools.H"

#include "coupling/case/start/grainScene.H"

#include "input/scene/drivenReader.hpp"
#include "input/scene/sceneReader.hpp"
#include "unit/input/rightInputs.hpp"
#include "unit/input/wrongInputs.hpp"
#include "unit/input/wrongMotions.hpp"

#include "OSspecific.H"

#include <fstream>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;
using frontEnds::Complaint;
using frontEnds::Space;

namespace
{

BoxMeshSettings settingsOf(Space space)
{
    BoxMeshSettings settings;
    settings.max = point(0.06, 0.06, 0.2);
    if (space == Space::periodicY) settings.patchTypes = {"wall", "wall", "cyclic", "cyclic", "wall", "wall"};
    if (space != Space::discs) return settings;
    settings.cells.z() = 1;
    settings.min.z() = -0.2;
    settings.patchTypes = {"wall", "wall", "wall", "wall", "empty", "empty"};
    return settings;
}

struct Case
{
    explicit Case(Space space) : box(settingsOf(space)) {}

    void write(const std::string& name, const std::string& contents) const
    {
        mkDir((box.casePath()/"constant"/name).path());
        std::ofstream(box.casePath()/"constant"/name) << contents;
    }

    GrainProperties read(const std::string& text)
    {
        write("grainProperties", "FoamFile { version 2.0; format ascii; class dictionary; object grainProperties; } " + text);
        return readGrainProperties(box.time(), surroundingsIn(box.mesh()));
    }

    /// All that is done before the first step.
    void start(const std::string& text)
    {
        const GrainProperties properties = read(text);
        const GrainScene scene = makeGrainScene(properties, box.mesh(), vector(0, -9.81, 0));
        nscd::Grains grains = makeFirstGrains(properties, scene, box.mesh());
        toldByFoam([&] { input::holdDriven(properties.driven, grains); });
    }

    Complaint complaint(const std::string& text)
    {
        const Quiet quiet;
        try
        {
            start(text);
        }
        catch (const Foam::IOerror& error)
        {
            return {error.ioFileName(), int(error.ioStartLineNumber()), error.message()};
        }
        return {};
    }

    BoxMesh box;
};

Complaint ofFoam(const std::string& text, Space space, const std::string& file)
{
    Case c(space);
    c.write("grains.txt", file);
    return c.complaint(text);
}

/// The same text by the parser that nscdGrains has.
std::string everythingWithoutFoam(const std::string& text, const input::Surroundings& around)
{
    const input::Dictionary dict = input::parseDictionary(text, "text");
    input::Scene scene;
    input::readScene(input::CheckedEntries(dict), around, scene);
    return frontEnds::everythingOf(scene);
}

class WrongInputs : public ::testing::TestWithParam<frontEnds::Wrong> {};
class WrongFiles : public ::testing::TestWithParam<frontEnds::WrongFile> {};
class RightInputs : public ::testing::TestWithParam<frontEnds::Right> {};

} // namespace

TEST_P(WrongInputs, areRefusedInWords) { frontEnds::expectRefused(GetParam(), ofFoam, "grainProperties"); }
TEST_P(WrongFiles, areRefusedInWords) { frontEnds::expectRefused(GetParam(), ofFoam, "grainProperties"); }

TEST_P(RightInputs, setWhatTheySetInNscdGrains)
{
    const frontEnds::Right& right = GetParam();
    const std::string text = frontEnds::changed(frontEnds::rightText(), right.from, right.to);
    EXPECT_EQ(ofFoam(text, right.space, "").text, "");
    Case c(right.space);
    EXPECT_EQ(frontEnds::everythingOf(c.read(text)), everythingWithoutFoam(text, surroundingsIn(c.box.mesh())));
}

const auto nameOf = [](const auto& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(Keywords, WrongInputs, ::testing::ValuesIn(frontEnds::wrongInputs()), nameOf);
INSTANTIATE_TEST_SUITE_P(Walls, WrongInputs, ::testing::ValuesIn(frontEnds::wrongWalls()), nameOf);
INSTANTIATE_TEST_SUITE_P(Motions, WrongInputs, ::testing::ValuesIn(frontEnds::wrongMotions()), nameOf);
INSTANTIATE_TEST_SUITE_P(Grains, WrongFiles, ::testing::ValuesIn(frontEnds::wrongFiles()), nameOf);
INSTANTIATE_TEST_SUITE_P(Texts, RightInputs, ::testing::ValuesIn(frontEnds::rightInputs()), nameOf);

TEST(WrongSurfaces, areRefusedInWords)
{
    const std::string text = frontEnds::changed(frontEnds::rightText(), "walls     { ", "walls     { s { type stl; file bad.stl; } ");
    for (const auto& surface : frontEnds::wrongSurfaces())
    {
        Case c(Space::spheres);
        c.write("triSurface/bad.stl", surface.first);
        const Complaint said = c.complaint(text);
        EXPECT_EQ(said.line, 5) << surface.first;
        frontEnds::expectMentions(said, {"keyword walls.s.file ", surface.second});
    }
}
