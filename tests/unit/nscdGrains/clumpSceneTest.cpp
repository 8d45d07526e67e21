// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Scenes with clumps: placed as written, run, gone on with to the bit; refused in words.
#include "nscd/tools/sceneCheckpoint.hpp"
#include "sceneFiles.hpp"
#include "sceneRun.hpp"

#include <sstream>

using sceneFiles::bytesOf;
using sceneFiles::changed;
using sceneFiles::goodScene;

namespace
{

const std::string lattice = "count (5 5 5); diameter 0.01; spread 0.2; jitter 0.5; ";

/// 3 x 3 x 4 dumbbells of two overlapping balls.
std::string clumpScene(const std::string& clump = "members ((-0.003 0 0) (0.003 0 0)); diameter 0.01; ")
{
    return changed(goodScene(), lattice, "count (3 3 4); diameter 0.018; clump { " + clump + "} ");
}

nscd::Grains placed(const std::string& text) { return sceneFiles::readAndPlace(text); }

std::string failure(const std::string& text)
{
    try
    {
        placed(text);
    }
    catch (const std::exception& error)
    {
        return error.what();
    }
    return "";
}

class ClumpScenes : public sceneFiles::InFolder
{
protected:
    void run(const std::string& name, const std::string& text, bool goesOn = false) const
    {
        std::ofstream(folder/name) << text << "results " << name << ".out;\n";
        std::ostringstream log;
        nscdGrains::runScene({folder/name, goesOn, false}, log);
    }
};

} // namespace

TEST_F(ClumpScenes, standInThePlacesOfTheirSource)
{
    const nscd::Grains random = placed(clumpScene());
    ASSERT_EQ(random.clumps.size(), 36u);
    ASSERT_EQ(random.size(), 72u);
    EXPECT_LT((random.clumps.position[0] - nscd::Vec3(0.01, 0.01, 0.01)).norm(), 1e-15);
    EXPECT_LT((0.5*(random.position[0] + random.position[1]) - random.clumps.position[0]).norm(), 1e-15);
    EXPECT_GT(random.clumps.orientation[0].angularDistance(random.clumps.orientation[1]), 1e-3);
    EXPECT_EQ(random.clumps.shapes.size(), 1u);

    const nscd::Grains turned = placed(clumpScene("members ((0 0 0) (0.006 0 0)); diameter 0.01; orientation asGiven; "));
    EXPECT_LT((turned.position[1] - turned.position[0] - nscd::Vec3(0.006, 0, 0)).norm(), 1e-15);
}

TEST_F(ClumpScenes, goOnToTheBitAndWriteWhatTheyAre)
{
    run("whole", clumpScene());
    run("parts", changed(clumpScene(), "endTime   0.09", "endTime   0.03"));
    run("parts", clumpScene(), true);
    for (const char* const file : {"report.csv", "grains/grains.000000090.vtp", "state/state.000000090"})
    {
        EXPECT_EQ(bytesOf(folder/"parts.out"/file), bytesOf(folder/"whole.out"/file)) << file;
    }
    EXPECT_EQ(nscd::readCheckpoint(folder/"whole.out/state/state.000000090").grains.clumps.size(), 36u);
    const std::string picture = bytesOf(folder/"whole.out/grains/grains.000000090.vtp");
    EXPECT_NE(picture.find("Name=\"clump\" NumberOfComponents=\"1\""), std::string::npos);
    EXPECT_NE(picture.find("Name=\"orientation\" NumberOfComponents=\"4\""), std::string::npos);
}

TEST_F(ClumpScenes, sleepAsSpheresDo)
{
    const nscdGrains::SceneSettings scene = nscdGrains::parseScene(clumpScene(), "scene");
    EXPECT_TRUE(scene.contact.sleep);
    EXPECT_TRUE(scene.notes.empty());
    EXPECT_FALSE(nscdGrains::parseScene(changed(clumpScene(), "type NLGS", "sleep off"), "scene").contact.sleep);
    EXPECT_TRUE(nscdGrains::parseScene(goodScene(), "scene").notes.empty());
    EXPECT_TRUE(nscdGrains::parseScene(goodScene(), "scene").contact.sleep);
}

TEST_F(ClumpScenes, badOnesAreRefusedInWords)
{
    const auto message = [](const std::string& clump) { return failure(clumpScene(clump)); };
    EXPECT_EQ(failure(clumpScene()), "");
    EXPECT_NE(message("diameter 0.01; ").find("keyword grains.clump.members is missing"), std::string::npos) << message("diameter 0.01; ");
    EXPECT_NE(message("members ((0 0 0)); ").find("keyword grains.clump.diameter is missing"), std::string::npos);
    EXPECT_NE(message("members ((0 0 0)); diameter -1; ").find("grains.clump.diameter is out of range"), std::string::npos);
    EXPECT_NE(message("members ((0 0 0)); diameter 0.01; orientation upright; ").find("orientation is not one of the words"), std::string::npos);
    EXPECT_NE(message("members ((0 0 0)); file a; diameter 1; ").find("stands beside file"), std::string::npos);
    EXPECT_NE(message("file none.txt; ").find("none.txt"), std::string::npos);
    EXPECT_NE(failure(changed(clumpScene(), "clump {", "spread 0.2; clump {")).find("spread stands beside clump"), std::string::npos);
    EXPECT_NE(failure(changed(clumpScene(), "clump {", "motion fixed; clump {")).find("clump cannot be held"), std::string::npos);
    EXPECT_NE(failure(changed(clumpScene(), "type NLGS", "type queue")).find("keyword solver.type knows no clumps"), std::string::npos);
    EXPECT_EQ(failure(changed(clumpScene(), "friction 0.3", "friction 0.3; rollingFriction 0.1")), "");
    // Two clumps one inside the other overlap; members of one may.
    EXPECT_NE(failure(changed(clumpScene(), "count (3 3 4)", "count (6 6 6)")).find("maxInitialOverlap is exceeded"), std::string::npos);
}
