// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of report.csv, of the seven timers, and of grains that leave.
#include "caseTools.H"

#include "coupling/case/log/grainReport.H"
#include "coupling/case/log/progressLog.H"
#include "coupling/case/log/timingTable.H"
#include "coupling/case/start/grainScene.H"
#include "coupling/case/walls/grainExits.H"

#include "OSspecific.H"

#include <fstream>
#include <sstream>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;
using nscd::Vec3;

namespace
{

std::vector<std::string> linesOf(const fileName& path)
{
    std::ifstream file(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
}

std::vector<std::string> cellsOf(const std::string& line)
{
    std::istringstream is(line);
    std::vector<std::string> cells;
    for (std::string cell; std::getline(is, cell, ',');) cells.push_back(cell);
    return cells;
}

std::map<std::string, double> rowOf(const std::vector<std::string>& lines, std::size_t row)
{
    const std::vector<std::string> names = cellsOf(lines.at(1)), values = cellsOf(lines.at(2 + row));
    std::map<std::string, double> result;
    for (std::size_t k = 0; k < names.size(); ++k) result[names[k]] = std::stod(values.at(k));
    return result;
}

} // namespace

TEST(GrainReport, hasTheColumnsThatScriptsRelyOn)
{
    BoxMesh box;
    const GrainReport report(box.time());
    EXPECT_EQ(report.path(), box.casePath()/"postProcessing/grains/0/report.csv");
    const std::vector<std::string> lines = linesOf(report.path());
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0].front(), '#');
    EXPECT_EQ(cellsOf(lines[0]).size(), cellsOf(lines[1]).size());
    const std::string start =
        "time,deltaT,grains,contacts,sweeps,converged,residualRms,residualMax,overlapMax,overlapMean,kineticEnergy,"
        "massCenterX,massCenterY,massCenterZ,wallForceX,wallForceY,wallForceZ,grainVolume,momentumError";
    EXPECT_EQ(lines[1].substr(0, start.size()), start);
}

TEST(GrainReport, everyRowIsOnDiskAtOnceWithEveryDigit)
{
    BoxMesh box;
    GrainReport report(box.time());
    StepRow row;
    row.time = 1.0/3;
    row.deltaT = 1e-4/3;
    row.grains = 12345678901;
    row.report.solve.contacts = 7;
    row.report.solve.sweeps = 5;
    row.report.solve.converged = false;
    row.report.solve.atCap = true;
    row.report.solve.residualRms = 1e-9/7;
    row.report.solve.residualMax = 2;
    row.report.solve.forceError = 22;
    row.report.overlapMax = 3;
    row.report.overlapMean = 4;
    row.report.overlapUncorrected = 23;
    row.kineticEnergy = 6;
    row.massCenter = vector(8, 9, 10);
    row.wallForce = vector(11, 12, 13);
    row.grainVolume = 14;
    row.momentumError = 1e-17/3;
    row.momentumDebt = 21;
    row.solidVolume = 24;
    row.volumeOutside = 25;
    row.volumeMoved = 26;
    row.volumeUnresolved = 27;
    row.volumeError = 28;
    report.write(row);
    row.time = 0.5;
    row.report.solve.converged = true;
    report.write(row);

    // The report is still open, as it is when a run is killed.
    const std::vector<std::string> lines = linesOf(report.path());
    ASSERT_EQ(lines.size(), 4u);
    const std::map<std::string, double> expected =
    {
        {"time", 1.0/3}, {"deltaT", 1e-4/3}, {"grains", 12345678901.0}, {"contacts", 7}, {"sweeps", 5}, {"converged", 0},
        {"residualRms", 1e-9/7}, {"residualMax", 2}, {"overlapMax", 3}, {"overlapMean", 4}, {"kineticEnergy", 6},
        {"massCenterX", 8}, {"massCenterY", 9}, {"massCenterZ", 10}, {"wallForceX", 11}, {"wallForceY", 12},
        {"wallForceZ", 13}, {"grainVolume", 14}, {"momentumError", 1e-17/3}, {"momentumDebt", 21}, {"forceError", 22},
        {"overlapUncorrected", 23}, {"solidVolume", 24}, {"volumeOutside", 25}, {"volumeMoved", 26}, {"volumeUnresolved", 27}, {"volumeError", 28}, {"atCap", 1}
    };
    const std::map<std::string, double> given = rowOf(lines, 0);
    for (const auto& value : expected) EXPECT_EQ(given.at(value.first), value.second) << value.first;
    EXPECT_EQ(rowOf(lines, 1).at("time"), 0.5);
    EXPECT_EQ(rowOf(lines, 1).at("converged"), 1);
}

TEST(GrainReport, whereItCannotBeWrittenTheRunStops)
{
    BoxMesh box;
    mkDir(box.casePath()/"postProcessing/grains/0/report.csv");
    EXPECT_TRUE(holds(errorMessage([&] { GrainReport report(box.time()); }), {"Cannot write", "report.csv"}));
}

TEST(TimingTable, addsUpWhatEachPartTook)
{
    TimingTable timing;
    timing.add(StepPart::solveFluid, 2);
    timing.add(StepPart::solveFluid, 3);
    timing.add(StepPart::reportStep, 1);
    EXPECT_EQ(timing.seconds(StepPart::solveFluid), 5);
    EXPECT_EQ(timing.seconds(StepPart::sampleFluid), 0);
    EXPECT_EQ(timing.total(), 6);
    EXPECT_STREQ(stepPartNames[int(StepPart::solveFluid)], "solveFluid");
    { const auto timer = timing.time(StepPart::sampleFluid); }
    EXPECT_GT(timing.seconds(StepPart::sampleFluid), 0);
    OStringStream os;
    timing.print(os, 10, ::nscd::StepTimes());
    for (const char* part : ::nscd::grainPartNames) EXPECT_NE(os.str().find(part), std::string::npos) << part;
}

TEST(ProgressLog, saysOnceWhatIsDoneWithoutBeingAskedFor)
{
    const auto notesOf = [](const FluidSummary& fluid, const StepRow& row)
    {
        BoxMesh box;
        OStringStream os;
        ProgressLog log(box.time(), os, true);
        log.step(StepRow(), FluidSummary());
        log.step(row, fluid);
        log.step(row, fluid);
        std::vector<std::string> notes;
        std::istringstream lines(os.str());
        for (std::string line; std::getline(lines, line);)
        {
            if (line.compare(0, 8, "  Note: ") == 0) notes.push_back(line.substr(8));
        }
        return notes;
    };
    const FluidSummary plain;
    FluidSummary lagged, held, owing, owingLittle;
    StepRow moving;
    lagged.isLagged = held.isLagged = true;
    lagged.dragRatioMax = 0.01;    // that of grains which are held is 0: nothing is to be predicted of them
    owing.owedShare = 0.02;
    owingLittle.owedShare = 0.005;
    moving.volumeMoved = 1e-9;
    EXPECT_TRUE(notesOf(plain, StepRow()).empty());
    EXPECT_TRUE(notesOf(held, StepRow()).empty());
    EXPECT_TRUE(notesOf(owingLittle, StepRow()).empty());
    const std::vector<std::tuple<FluidSummary, StepRow, const char*>> cases =
    {
        {lagged, StepRow(), "without a predictor"}, {owing, StepRow(), "half of what they owe"}, {plain, moving, "minFluidFraction"}
    };
    for (const auto& [fluid, row, words] : cases)
    {
        const std::vector<std::string> notes = notesOf(fluid, row);
        ASSERT_EQ(notes.size(), 1u);
        EXPECT_NE(notes[0].find(words), std::string::npos) << notes[0];
    }
}

// Of every kind: how many steps, the first, the worst.
TEST(ProgressLog, countsWarningsInItsSummary)
{
    BoxMesh box;
    OStringStream os;
    ProgressLog log(box.time(), os, true);
    for (int k = 1; k <= 4; ++k)
    {
        StepRow row;
        row.time = 0.25*k;
        row.grainVolume = 1;
        row.volumeOutside = k == 3 ? 0.5 : 0.002*(k > 1);
        row.report.solve.hiddenMassRatio = k == 4 ? 1e4 : 0;
        row.report.overlapUncorrected = 0.01*k;
        FluidSummary fluid;
        fluid.stepOverRelaxation = k > 2 ? 100*k : 9;
        fluid.viscousReach = k > 3 ? 23 : 3;
        log.step(row, fluid);
    }
    log.finish(TimingTable(), ::nscd::StepTimes());
    EXPECT_TRUE(holds(os.str(),
    {
        "grains outside the mesh 3 steps, first at 0.5 s, worst 0.5 of the grains' volume",
        "stiff in small cells   2 steps, first at 0.75 s, worst 400 relaxation times a step",
        "viscosity across cells 1 steps, first at 1 s, worst 23",
        "unlike masses          1 steps, first at 1 s, worst 1e+04 times as heavy",
        "before its correction 0.04 d"
    })) << os.str();
}

namespace
{

/// Grains at these heights in a box whose top is an exit and whose other sides are walls.
struct LeakyBox
{
    LeakyBox()
    :
        box(settings())
    {
        roles.role = std::vector<PatchRole>(6, PatchRole::wall);
        roles.role[box.mesh().boundaryMesh().findPatchID("back")] = PatchRole::exit;
        roles.material = std::vector<int>(6, 0);
    }

    static BoxMeshSettings settings()
    {
        BoxMeshSettings settings;
        settings.patchTypes = {"wall", "wall", "wall", "wall", "wall", "patch"};
        return settings;
    }

    void add(const Vec3& position)
    {
        grains.add(position, 0.01, 2500, 0, std::int64_t(grains.size()));
        const bool isInside = (position.array() > 0).all() && (position.array() < 1).all();
        cells.append(isInside ? 0 : -1);
    }

    std::vector<std::size_t> exited() { return findExited(grains, cells, box.mesh(), roles, nullptr).grains; }

    BoxMesh box;
    PatchRoles roles;
    nscd::Grains grains;
    labelList cells;
};

} // namespace

TEST(GrainExits, takeOutGrainsBeyondAnExitAndKeepTheOrder)
{
    LeakyBox leaky;
    for (const double z : {0.5, 1.02, 0.7, 1.5, 0.9}) leaky.add(Vec3(0.3, 0.3, z));
    const std::vector<std::size_t> exited = leaky.exited();
    EXPECT_EQ(exited, (std::vector<std::size_t>{1, 3}));
    eraseGrains(leaky.grains, exited);
    EXPECT_EQ(leaky.grains.id, (std::vector<std::int64_t>{0, 2, 4}));
    EXPECT_EQ(leaky.grains.nOwned, 3u);
    EXPECT_EQ(leaky.grains.position[1].z(), 0.7);
    EXPECT_EQ(leaky.grains.velocity.size(), 3u);
    EXPECT_EQ(leaky.grains.orientation.size(), 3u);
}

/// As dust does that turns in a cyclone, when it drops into the bin beside the wall.
TEST(GrainExits, aGrainBeyondTheEdgeOfAnExitAndAWallLeftByTheExit)
{
    LeakyBox leaky;
    for (const double side : {-0.02, 1.02})
    {
        leaky.add(Vec3(0.3, side, 1.01));
        leaky.add(Vec3(side, 0.3, 1.01));
    }
    EXPECT_EQ(leaky.exited().size(), 4u);
}

TEST(GrainExits, aGrainThatGotThroughAWallStopsTheRun)
{
    LeakyBox leaky;
    leaky.add(Vec3(0.3, -0.02, 0.5));
    EXPECT_TRUE(holds(errorMessage([&] { leaky.exited(); }), {"Grain 0", "(0.3 -0.02 0.5)", "bottom", "no exit"}));
}
