// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Sources that let grains in: scenes that are wrong in one place, rows of report.csv, runs stopped and continued to the bit.
#include "input/dictionary/inputError.hpp"
#include "nscd/tools/sceneCheckpoint.hpp"
#include "sceneFiles.hpp"
#include "sceneRun.hpp"
#include "unit/input/frontEnds.hpp"

#include <map>
#include <sstream>

using frontEnds::Wrong;
using sceneFiles::changed;
using sceneFiles::sceneWith;

namespace
{

const std::string pour =
    "type entering; region { type box; box (0 0 0.1) (0.06 0.06 0.2); } rate 500; start 0.01; number 40; velocity (0 0 -0.5);"
    " sizes { type normal; mean 0.01; deviation 0.002; min 0.006; max 0.014; }";

const Wrong wrongEntries[] =
{
    {"misspeltRegion", "region {", "regoin {", 3, {"keyword grains.regoin is not a keyword here", "nearest: region"}},
    {"noRegion", "region { type box; box (0 0 0.1) (0.06 0.06 0.2); }", "", 3, {"keyword grains.region is missing"}},
    {"unknownRegion", "type box", "type bax", 3, {"keyword grains.region.type", "value:   bax", "cylinder", "nearest: box"}},
    {"emptyBox", "(0 0 0.1) (0.06", "(0 0 0.1) (-0.06", 3, {"keyword grains.region.box is empty"}},
    {"negativeRadius", "type box; box (0 0 0.1) (0.06 0.06 0.2);", "type sphere; center (0 0 0); radius -1;", 3, {"keyword grains.region.radius is out of range", "> 0"}},
    {"axisWithoutLength", "type box; box (0 0 0.1) (0.06 0.06 0.2);", "type cylinder; axis (0 0 1) (0 0 1); radius 1;", 3, {"keyword grains.region.axis has no length"}},
    {"noSurface", "type box; box (0 0 0.1) (0.06 0.06 0.2);", "type stl; file none.stl;", 3, {"keyword grains.region.file"}},
    {"keywordOfAnotherRegion", "type box;", "type box; radius 1;", 3, {"keyword grains.region.radius is not a keyword here"}},
    {"noRate", "rate 500;", "", 3, {"keyword grains.rate is missing", "massRate 0.1;"}},
    {"bothRates", "rate 500;", "rate 500; massRate 1;", 3, {"keyword grains.massRate stands beside rate"}},
    {"negativeRate", "rate 500", "rate -500", 3, {"keyword grains.rate is below zero", ">= 0"}},
    {"wordForRate", "rate 500", "rate fast", 3, {"keyword grains.rate is no function of time", "value:   fast"}},
    {"rateOutOfOrder", "rate 500", "rate table ((1 2) (0 3))", 3, {"keyword grains.rate has rows out of order"}},
    {"negativeStart", "start 0.01", "start -1", 3, {"keyword grains.start is out of range", ">= 0"}},
    {"noDuration", "start 0.01", "duration 0", 3, {"keyword grains.duration is out of range", "> 0"}},
    {"halfAGrain", "number 40", "number 40.5", 3, {"keyword grains.number is not a whole number", "value:   40.5"}},
    {"misspeltDuration", "start 0.01", "duratoin 1", 3, {"keyword grains.duratoin", "nearest: duration"}},
    {"unknownMaterial", "number 40", "material glas", 3, {"keyword grains.material", "nearest: glass"}},
    {"unknownSizes", "type normal", "type nromal", 3, {"keyword grains.sizes.type", "RosinRammler", "nearest: normal"}},
    {"sizesBesideDiameter", "number 40", "diameter 0.01", 3, {"keyword grains.sizes stands beside diameter"}},
    {"endsTurnedRound", "max 0.014", "max 0.004", 3, {"keyword grains.sizes.max is not above min", "more than 0.006"}},
    {"nothingBetweenTheEnds", "mean 0.01", "mean 0.1", 3, {"keyword grains.sizes cannot be drawn"}},
    {"noDeviation", "deviation 0.002;", "", 3, {"keyword grains.sizes.deviation is missing"}},
    {"byVolume", "type normal;", "type normal; by volume;", 3, {"keyword grains.sizes.by", "number, mass"}},
    {"tableWithoutRows", "type normal; mean 0.01; deviation 0.002; min 0.006; max 0.014;", "type general; distribution ();", 3, {"keyword grains.sizes cannot be drawn"}},
    {"massesOfAWideRange", "mean 0.01; deviation 0.002; min 0.006;", "mean 0.01; deviation 0.002; min 1e-4; by mass;", 3, {"keyword grains.sizes.by is for narrower ranges"}}
};

class WrongEntries : public testing::TestWithParam<Wrong> {};

class Entries : public sceneFiles::InFolder
{
protected:
    std::string run(const std::string& scene, const std::string& text, bool goesOn = false) const
    {
        write(scene, text + "results " + scene + ".out;\n");
        std::ostringstream log;
        nscdGrains::runScene({folder/scene, goesOn, false}, log);
        return log.str();
    }

    std::string result(const std::string& scene, const std::string& file) const { return sceneFiles::bytesOf(folder/(scene + ".out")/file); }

    /// Columns of report.csv by their names, one map a row.
    std::vector<std::map<std::string, double>> report(const std::string& scene) const
    {
        std::istringstream text(result(scene, "report.csv"));
        std::string line, name, value;
        std::getline(text, line);
        std::getline(text, line);
        const std::string names = line;
        std::vector<std::map<std::string, double>> rows;
        while (std::getline(text, line))
        {
            std::istringstream head(names), row(line);
            rows.emplace_back();
            while (std::getline(head, name, ',') && std::getline(row, value, ',')) rows.back()[name] = std::stod(value);
        }
        return rows;
    }
};

} // namespace

TEST_P(WrongEntries, areRefusedInWords)
{
    const Wrong& bad = GetParam();
    sceneFiles::expectRefused(sceneWith(changed(pour, bad.from, bad.to)), bad.line, bad.mentions);
}

INSTANTIATE_TEST_SUITE_P(Keywords, WrongEntries, testing::ValuesIn(wrongEntries), [](const auto& info) { return info.param.name; });

TEST_F(Entries, areCountedAndWeighedInEachRow)
{
    run("scene", sceneWith(pour));
    const auto rows = report("scene");
    ASSERT_EQ(rows.size(), 90u);
    for (std::size_t k = 0; k < rows.size(); ++k)
    {
        const auto& row = rows[k];
        // Two milliseconds a grain from 10 ms on, 40 of them at most.
        const double due = std::clamp((double(k + 1) - 10)/2, 0.0, 40.0);
        EXPECT_EQ(row.at("entered") + row.at("waiting"), std::floor(due + 1e-9)) << "row " << k;
        EXPECT_EQ(row.at("entered"), row.at("grains"));
        EXPECT_NEAR(row.at("enteredMass"), row.at("mass"), 1e-12*row.at("mass"));
    }
    EXPECT_EQ(rows.back().at("entered"), 40);
}

TEST_F(Entries, goOnToTheBit)
{
    // Those that wait are in the state: the region holds about ten.
    const std::string text = sceneWith(changed(changed(pour, "(0 0 0.1) (0.06 0.06 0.2)", "(0.02 0.02 0.15) (0.04 0.04 0.16)"), "rate 500", "rate 5000"));
    run("whole", text);
    run("parts", changed(text, "endTime   0.09", "endTime   0.03"));
    EXPECT_GT(report("parts").back().at("waiting"), 10);
    run("parts", text, true);
    for (const char* const file : {"report.csv", "grains/grains.000000090.vtp", "state/state.000000090"})
    {
        EXPECT_EQ(result("parts", file), result("whole", file)) << file;
    }
    // Another seed is another run: the comparison above can fail.
    run("other", changed(text, "number 40", "number 40; seed 2"));
    EXPECT_NE(result("other", "state/state.000000090"), result("whole", "state/state.000000090"));
}

TEST_F(Entries, keepTheirStatesByName)
{
    const std::string first = "a { " + pour + " } ", second = "b { " + changed(pour, "number 40", "number 3") + " } ";
    run("scene", changed(sceneWith(first + second), "endTime   0.09", "endTime   0.03"));
    const nscd::SceneState before = nscd::readCheckpoint(folder/"scene.out/state/state.000000030");
    ASSERT_EQ(before.entryNames, (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(before.entries[0].due, 10);
    EXPECT_EQ(before.entries[1].due, 3);
    EXPECT_EQ(before.nextId, std::int64_t(before.grains.size()));
    run("scene", sceneWith(second + first), true);
    const nscd::SceneState after = nscd::readCheckpoint(folder/"scene.out/state/state.000000090");
    ASSERT_EQ(after.entryNames, (std::vector<std::string>{"b", "a"}));
    EXPECT_EQ(after.entries[0].due, 3);
    EXPECT_EQ(after.entries[1].due, 40);
}

TEST_F(Entries, ofDiscsStayInTheirPlane)
{
    const std::string text = "dimensions 2; " + changed(changed(sceneWith(changed(pour, "(0 0 0.1) (0.06 0.06 0.2)", "(0 0.1 0) (0.06 0.19 0)")),
        "gravity   (0 0 -9.81)", "gravity   (0 -9.81 0)"), "(0.06 0.06 0.2); } }", "(0.06 0.2 0); } }");
    run("discs", changed(text, "velocity (0 0 -0.5)", "velocity (0 -0.5 0)"));
    const nscd::SceneState state = nscd::readCheckpoint(folder/"discs.out/state/state.000000090");
    EXPECT_GT(state.grains.size(), 20u);
    for (const nscd::Vec3& position : state.grains.position) EXPECT_EQ(position.z(), 0.0);
}

TEST_F(Entries, sayInTheLogHowManyWait)
{
    const std::string log = run("scene", sceneWith(changed(pour, "(0 0 0.1) (0.06 0.06 0.2)", "(0.03 0.03 0.15) (0.031 0.031 0.151)")));
    EXPECT_NE(log.find("entering  grains"), std::string::npos) << log;
    EXPECT_NE(log.find(" wait, "), std::string::npos) << log;
}
