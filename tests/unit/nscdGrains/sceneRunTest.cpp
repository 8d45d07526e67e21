// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Whole runs: stopped and continued to the bit, results that are not lost, files as they should be.
#include "unit/fileSizeLimit.hpp"
#include "nscd/base/folderLock.hpp"
#include "nscd/tools/sceneCheckpoint.hpp"
#include "sceneFiles.hpp"
#include "sceneRun.hpp"

#include <sys/resource.h>
#include <sys/wait.h>

#include <cstdlib>
#include <cstring>
#include <sstream>

namespace fs = std::filesystem;
using sceneFiles::bytesOf;
using sceneFiles::changed;
using sceneFiles::goodScene;

namespace
{

class SceneRuns : public sceneFiles::InFolder
{
protected:
    std::string run(const std::string& scene, bool goesOn = false, bool overwrites = false) const
    {
        std::ostringstream log;
        nscdGrains::runScene({folder/scene, goesOn, overwrites}, log);
        return log.str();
    }

    std::string failure(const std::string& scene, bool goesOn = false, bool overwrites = false) const
    {
        try
        {
            run(scene, goesOn, overwrites);
        }
        catch (const std::exception& error)
        {
            return error.what();
        }
        return "";
    }

    /// A scene of that name, with results of that name.
    void writeScene(const std::string& name, const std::string& text) const { write(name, text + "results " + name + ".out;\n"); }

    std::string result(const std::string& scene, const std::string& file) const { return bytesOf(folder/(scene + ".out")/file); }
};

const char* const files[] =
{
    "report.csv", "grains.pvd", "contacts.pvd", "grains/grains.000000090.vtp", "contacts/contacts.000000090.vtp", "state/state.000000090"
};

} // namespace

TEST_F(SceneRuns, goOnToTheBit)
{
    writeScene("whole", goodScene());
    writeScene("again", goodScene());
    writeScene("parts", changed(goodScene(), "endTime   0.09", "endTime   0.03"));
    run("whole");
    run("again");
    run("parts");
    writeScene("parts", goodScene());
    EXPECT_NE(run("parts", true).find("time      0.03 to 0.09 s"), std::string::npos);
    for (const char* const file : files)
    {
        EXPECT_EQ(result("again", file), result("whole", file)) << file;
        EXPECT_EQ(result("parts", file), result("whole", file)) << file;
    }
    EXPECT_GT(nscd::readCheckpoint(folder/"whole.out/state/state.000000090").impulses.size(), 100u);

    // Another seed is another run: the comparison above can fail.
    writeScene("other", changed(goodScene(), "jitter 0.5", "jitter 0.5; seed 2"));
    run("other");
    EXPECT_NE(result("other", files[5]), result("whole", files[5]));
}

/// The system kills a process that writes beyond its limit: here in the middle of a file, which limit by limit is another one.
TEST_F(SceneRuns, goOnAfterTheyWereKilledWhileWriting)
{
    const std::string text = changed(changed(goodScene(), "writeInterval 0.03", "writeInterval 0.003"), "endTime   0.09", "endTime   0.36");
    writeScene("whole", text);
    run("whole");
    for (const rlim_t limit : {32000, 45000, 70000})
    {
        writeScene("killed", text);
        fs::remove_all(folder/"killed.out");
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0)
        {
            const rlimit noCore = {0, 0}, size = {limit, limit};
            setrlimit(RLIMIT_CORE, &noCore);
            setrlimit(RLIMIT_FSIZE, &size);
            run("killed");
            _exit(0);
        }
        int status = 0;
        waitpid(child, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGXFSZ) << "not killed at " << limit;
        run("killed", true);
        for (const char* const file : {"report.csv", "grains.pvd", "contacts.pvd", "state/state.000000360"})
        {
            EXPECT_EQ(result("killed", file), result("whole", file)) << file << " after " << limit;
        }
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) EXPECT_NE(entry.path().extension(), ".part");
    }
}

TEST_F(SceneRuns, letsFixedGrainsGoWhenTold)
{
    write("ball.txt", "0 0 0 0.02\n");
    writeScene("held", "deltaT 1e-3; endTime 0.1; writeInterval 0.1; fixedUntil 0.04; motion fixed; materials { m { density 2500; } } contacts { default { friction 0; } }\n"
        "grains { type table; file ball.txt; } gravity (0 0 -9.81);\n");
    EXPECT_NE(run("held").find("fixed     until 0.04 s"), std::string::npos);
    EXPECT_NEAR(nscd::readCheckpoint(folder/"held.out/state/state.000000100").grains.velocity[0].z(), -0.06*9.81, 1e-9);
}

/// Three discs on a floor: the pile stands if and only if friction between them is at least tan 15 degrees = 0.267949.
TEST_F(SceneRuns, keepAPyramidOfDiscsUpByFrictionAlone)
{
    write("discs.txt", "-0.01 0.01 0 0.02\n0.01 0.01 0 0.02\n0 0.0273205080756887 0 0.02\n");
    const auto top = [&](const std::string& friction)
    {
        writeScene("pyramid",
            "dimensions 2; deltaT 1e-3; endTime 0.5; materials { disc { density 2500; } floor {} }\n"
            "contacts { disc-disc { friction " + friction + "; } disc-floor { friction 0.09; } }\n"
            "grains { type table; file discs.txt; } wallMaterial floor;\n"
            "walls { floor { type polygon; vertices ((-0.1 0 0) (0.1 0 0)); } }\n"
            "solver { tolerance 1e-8; displacementTolerance 1e-8; maxSweeps 100000; }\n");
        run("pyramid", false, true);
        const nscd::SceneState state = nscd::readCheckpoint(folder/"pyramid.out/state/state.000000500");
        EXPECT_EQ(state.grains.position[2].z(), 0.0);
        return state.grains.position[2].y();
    };
    EXPECT_NEAR(top("0.270"), 0.0273205080756887, 1e-8);
    EXPECT_LT(top("0.265"), 0.0263);
}

TEST_F(SceneRuns, doNotLoseResults)
{
    writeScene("scene", goodScene());
    run("scene");
    const std::string before = result("scene", "report.csv");
    EXPECT_NE(failure("scene").find("-overwrite"), std::string::npos);
    // What is wrong with a scene is found before anything is removed.
    writeScene("scene", changed(goodScene(), "diameter 0.01", "diameter 0.05"));
    EXPECT_THROW(run("scene", false, true), input::InputError);
    EXPECT_EQ(result("scene", "report.csv"), before);

    // So is what the grain library alone refuses.
    const std::string needle = "count (1 1 1); diameter 0.01; clump { members ((0 0 0) (0.024 0 0)); diameter 0.01; } ";
    writeScene("scene", changed(changed(goodScene(), "count (5 5 5); diameter 0.01; spread 0.2; jitter 0.5; ", needle), "periodic  { }", "periodic  { y (0 0.06); }"));
    EXPECT_NE(failure("scene", false, true).find("scene: makes a scene that cannot run: period is 0.06"), std::string::npos) << failure("scene", false, true);
    EXPECT_EQ(result("scene", "report.csv"), before);

    write("scene.out/notes.txt", "mine");
    writeScene("scene", changed(goodScene(), "endTime   0.09", "endTime   0.03"));
    run("scene", false, true);
    EXPECT_NE(result("scene", "report.csv"), before);
    EXPECT_FALSE(fs::exists(folder/"scene.out/grains/grains.000000060.vtp"));
    EXPECT_EQ(result("scene", "notes.txt"), "mine");
}

TEST_F(SceneRuns, leaveTheResultsOfARunThatGoesOnAlone)
{
    writeScene("scene", goodScene());
    run("scene");
    const std::string before = result("scene", "report.csv");
    const nscd::FolderLock other(folder/"scene.out");
    writeScene("scene", changed(goodScene(), "endTime   0.09", "endTime   0.12"));
    for (const bool goesOn : {true, false}) EXPECT_NE(failure("scene", goesOn, !goesOn).find("another run is writing"), std::string::npos);
    EXPECT_EQ(result("scene", "report.csv"), before);
}

TEST_F(SceneRuns, keepTheStatesAskedFor)
{
    for (const int kept : {1, 2, 0})
    {
        writeScene("scene", goodScene() + "purgeWrite " + std::to_string(kept) + ";\n");
        run("scene", false, true);
        const auto states = std::distance(fs::directory_iterator(folder/"scene.out/state"), fs::directory_iterator());
        EXPECT_EQ(states, kept == 0 ? 3 : kept);
    }
}

TEST_F(SceneRuns, refuseToGoOnFromWhatDoesNotFit)
{
    writeScene("scene", goodScene());
    EXPECT_NE(failure("scene", true).find("holds no state to go on from"), std::string::npos);
    run("scene");
    EXPECT_NE(run("scene", true).find("nothing to do"), std::string::npos);

    const std::string longer = changed(goodScene(), "endTime   0.09", "endTime   0.12");
    writeScene("scene", changed(changed(longer, "{ glass { density 2500; }", "{ sand { density 2500; }"), "default", "default"));
    EXPECT_NE(failure("scene", true).find("lacks a material of the grains"), std::string::npos) << failure("scene", true);
    writeScene("scene", changed(changed(longer, "(0 0 -9.81)", "(0 -9.81 0)"), "gravity", "dimensions 2; gravity"));
    EXPECT_NE(failure("scene", true).find("dimensions"), std::string::npos) << failure("scene", true);

    // A wall that was put through the grains; whoever wants that says so.
    const std::string lid = "walls     { lid { type plane; point (0 0 0.02); normal (0 0 -1); } ";
    writeScene("scene", changed(longer, "walls     { ", lid));
    EXPECT_NE(failure("scene", true).find("keyword maxInitialOverlap is exceeded by"), std::string::npos) << failure("scene", true);
    EXPECT_NE(failure("scene", true).find("overlaps up to 0.1 of the smaller diameter"), std::string::npos);
    writeScene("scene", changed(longer, "walls     { ", "maxInitialOverlap 10; " + lid));
    EXPECT_NE(failure("scene", true).find("walls.csv has other columns"), std::string::npos) << failure("scene", true);

    // Another order of materials is the same scene.
    writeScene("scene", changed(longer, "glass { density 2500; } steel {}", "steel {} glass { density 2500; }"));
    run("scene", true);
    const nscd::SceneState state = nscd::readCheckpoint(folder/"scene.out/state/state.000000120");
    EXPECT_EQ(state.grains.material[0], 1);

    const std::string path = folder/"scene.out/state/state.000000120";
    fs::resize_file(path, fs::file_size(path) - 100);
    writeScene("scene", changed(goodScene(), "endTime   0.09", "endTime   0.15"));
    EXPECT_NE(failure("scene", true).find("remove it to go on from the state before"), std::string::npos);
    fs::remove(path);
    EXPECT_EQ(failure("scene", true), "");
}

TEST_F(SceneRuns, stopInWordsWhereTheyCannotWrite)
{
    writeScene("scene", goodScene());
    write("scene.out", "a file where the folder belongs");
    EXPECT_NE(failure("scene").find("cannot make the folder"), std::string::npos) << failure("scene");
    fs::remove(folder/"scene.out");

    const std::string message = [&]
    {
        const FileSizeLimit limit(12000);
        return limit.isSet() ? failure("scene") : "no limit could be set";
    }();
    EXPECT_NE(message.find("cannot write "), std::string::npos) << message;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) EXPECT_NE(entry.path().extension(), ".part");
}

TEST_F(SceneRuns, writeWhatParaViewReads)
{
    writeScene("scene", goodScene());
    run("scene");
    const std::string text = result("scene", "grains/grains.000000090.vtp");
    EXPECT_NE(text.find("NumberOfPoints=\"125\""), std::string::npos);
    // The first array behind the mark: its number of bytes, then positions as the state has them.
    const std::size_t data = text.find("<AppendedData encoding=\"raw\">\n_") + std::strlen("<AppendedData encoding=\"raw\">\n_");
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, &text[data], sizeof(bytes));
    ASSERT_EQ(bytes, 125u*24u);
    const nscd::SceneState state = nscd::readCheckpoint(folder/"scene.out/state/state.000000090");
    EXPECT_EQ(std::memcmp(&text[data + 8], state.grains.position[0].data(), bytes), 0);
    // Each array begins where its offset says, and the last one ends where the text goes on.
    std::size_t at = 0, last = 0, arrays = 0;
    for (std::size_t found = text.find("offset=\""); found != std::string::npos && found < data; found = text.find("offset=\"", found + 1))
    {
        last = std::strtoull(&text[found + 8], nullptr, 10);
        EXPECT_EQ(last, at);
        std::memcpy(&bytes, &text[data + last], sizeof(bytes));
        at = last + sizeof(bytes) + bytes;
        ++arrays;
    }
    EXPECT_EQ(arrays, 9u);
    EXPECT_EQ(text.compare(data + at, 18, "\n  </AppendedData>"), 0);

    const std::string series = result("scene", "grains.pvd");
    EXPECT_NE(series.find("<DataSet timestep=\"0.09\" file=\"grains/grains.000000090.vtp\"/>"), std::string::npos) << series;
    std::istringstream report(result("scene", "report.csv"));
    std::string line;
    int rows = 0;
    while (std::getline(report, line)) rows += line[0] >= '0' && line[0] <= '9';
    EXPECT_EQ(rows, 90);
    EXPECT_NE(result("scene", "report.csv").find("\ntime,deltaT,grains,contacts,sweeps,converged,residualRms"), std::string::npos);
}

/// Contacts that close at once at one grain, none of which carries an impulse yet: steps that do not reckon with all of them grow without end.
TEST_F(SceneRuns, ofGrainsShotOverABeltAreSolvedByProjectedGradients)
{
    writeScene
    (
        "shots",
        "deltaT 2.0755e-05; endTime 0.000477365; gravity (0 0 0); materials { steel { density 175.974; } }\n"
        "contacts { default { friction 2; restitution 0.3; } }\n"
        "grains { type lattice; box (0 0 0) (0.0462449 0.0346837 0.0115612); count (4 3 1); diameter 0.00584237; spread 0.666667; jitter 0.5;"
        " seed 281668; velocity (-21.3103 -24.8001 0); omega (0 0 -2.52808); }\n"
        "walls { tray { type box; box (0 0 0) (0.0462449 0.0346837 0.0368164); sides (xMin xMax yMin yMax zMin zMax); }\n"
        "        belt { type plane; point (0 0 0); normal (0 0 1); surfaceVelocity (46.9153 0 0); } }\n"
        "solver { type APG; maxSweeps 1000; }\n"
    );
    EXPECT_EQ(failure("shots"), "");
}

TEST(SceneRanks, areRefused)
{
    EXPECT_NO_THROW(nscdGrains::refuseRanks());
    for (const char* const variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    {
        setenv(variable, "1", 1);
        EXPECT_NO_THROW(nscdGrains::refuseRanks());
        setenv(variable, "2", 1);
        EXPECT_THROW(nscdGrains::refuseRanks(), std::runtime_error);
        unsetenv(variable);
    }
}

TEST(SceneOptions, areRead)
{
    const char* const given[] = {"my.scene", "-restart"};
    EXPECT_EQ(nscdGrains::readOptions(0, nullptr).scene, "scene");
    EXPECT_EQ(nscdGrains::readOptions(2, given).scene, "my.scene");
    EXPECT_TRUE(nscdGrains::readOptions(2, given).goesOn);
    const char* const bad[][2] = {{"-restrat", "x"}, {"a", "b"}, {"-restart", "-overwrite"}, {"a", "-pack"}};
    for (const auto& options : bad) EXPECT_THROW(nscdGrains::readOptions(2, options), input::InputError);
}
