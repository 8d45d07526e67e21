// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of the function objects in nscdDEMFoam, on one and two ranks and over restarts: figures that are known beforehand, and bad input.
#include "caseTools.H"
#include "programCase.H"

#include <cmath>
#include <sstream>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

/// Five layers of 16 spheres, at heights of 0.01, 0.03, ..., 0.09 m, that touch nothing and rise by 5.3 mm a step to the exit at 0.2 m.
const std::string risingGrains =
    "materials { glass { density 2500; } } contacts { default { friction 0.3; } } fluid none;"
    "grains { type lattice; box (0 0 0) (0.1 0.1 0.1); count (4 4 5); diameter 0.01; velocity (0 0 5.3); }"
    "patches { front { type wall; } back { type exit; } }";

constexpr double grainMass = 2500*M_PI/6*1e-6;

Files weightlessFiles(const std::string& properties)
{
    Files files = dryFiles(properties);
    files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);";
    return files;
}

std::string functionsOf(const std::string& functions, const std::string& more = "")
{
    return more + "\nfunctions\n{\n" + functions + "\n}\n";
}

/// The last row of a function object's file, by the names at its head.
std::map<std::string, double> lastRow(const ProgramCase& c, const std::string& file)
{
    std::istringstream lines(c.contents("postProcessing/" + file));
    std::vector<std::string> names;
    std::map<std::string, double> row;
    for (std::string line; std::getline(lines, line);)
    {
        std::istringstream cells(line);
        std::string first;
        cells >> first;
        if (first == "#")
        {
            names.clear();
            for (std::string name; cells >> name;) names.push_back(name);
            continue;
        }
        cells.seekg(0);
        for (const std::string& name : names) cells >> row[name];
    }
    return row;
}

/// Refused with these pieces of text before a step was taken.
::testing::AssertionResult isRefused(const std::string& functions, const std::vector<std::string>& pieces)
{
    return isRefused(ProgramCase(weightlessFiles(risingGrains), functionsOf(functions)), pieces);
}

/// The run on one rank, or cut into as many parts on as many.
::testing::AssertionResult succeedsIn(const ProgramCase& c, const labelVector& parts)
{
    if (cmptProduct(parts) == 1) return succeeds(c.run());
    const ::testing::AssertionResult isCut = succeeds(c.decompose(parts));
    return isCut ? succeeds(c.runOn(cmptProduct(parts))) : isCut;
}

const std::string flux = "flux { type grainFlux; planes {"
    "middle { point (0 0 0.105); normal (0 0 1); } down { point (0 0 0.02); normal (0 0 -1); } rim { point (0 0 0.1995); normal (0 0 1); } } }";

/// After 10 steps: two layers are above the middle, one has come through the plane that faces down; none has left.
void expectFluxOfTenSteps(const ProgramCase& c)
{
    std::map<std::string, double> row = lastRow(c, "flux/0/grainFlux.dat");
    EXPECT_NEAR(row.at("Time"), 0.01, 1e-9);
    EXPECT_EQ(row.at("middle.numberForward"), 32);
    EXPECT_EQ(row.at("middle.numberBackward"), 0);
    EXPECT_NEAR(row.at("middle.massForward"), 32*grainMass, 1e-5*grainMass);
    EXPECT_EQ(row.at("down.numberForward"), 0);
    EXPECT_EQ(row.at("down.numberBackward"), 16);
    EXPECT_NEAR(row.at("down.massBackward"), 16*grainMass, 1e-5*grainMass);
    EXPECT_EQ(row.at("rim.numberForward"), 0);
    EXPECT_EQ(row.at("back.number"), 0);
}

/// After 31 steps: all layers are above the middle, three have left, each in the step in which it went through the rim.
void expectFluxToTheEnd(const ProgramCase& c, const std::string& startTime)
{
    std::map<std::string, double> row = lastRow(c, "flux/" + startTime + "/grainFlux.dat");
    EXPECT_NEAR(row.at("Time"), 0.031, 1e-9);
    EXPECT_EQ(row.at("middle.numberForward"), 80);
    EXPECT_EQ(row.at("down.numberBackward"), 16);
    EXPECT_EQ(row.at("rim.numberForward"), 48);
    EXPECT_EQ(row.at("rim.numberBackward"), 0);
    EXPECT_EQ(row.at("back.number"), 48);
    EXPECT_NEAR(row.at("back.mass"), 48*grainMass, 1e-5*grainMass);
}

const std::string precise = " writePrecision 9; } ";
const std::string toTheEnd = "endTime 0.031; writeInterval 31;";

std::string preciseFlux() { return flux.substr(0, flux.rfind('}')) + precise; }

} // namespace

TEST(GrainFlux, countsGrainsThroughPlanesAndExits)
{
    const ProgramCase c(weightlessFiles(risingGrains), functionsOf(preciseFlux()));
    EXPECT_TRUE(succeeds(c.run()));
    expectFluxOfTenSteps(c);
    c.writeControl(functionsOf(preciseFlux(), toTheEnd));
    EXPECT_TRUE(succeeds(c.run()));
    expectFluxToTheEnd(c, "0.01");
}

TEST(Ranks, countGrainsThroughPlanesAndOverARestartOnOthers)
{
    const ProgramCase c(weightlessFiles(risingGrains), functionsOf(preciseFlux()));
    EXPECT_TRUE(succeeds(c.decompose(labelVector(1, 1, 2))));
    EXPECT_TRUE(succeeds(c.runOn(2)));
    expectFluxOfTenSteps(c);
    c.writeControl(functionsOf(preciseFlux(), toTheEnd));
    EXPECT_TRUE(succeeds(c.runOn(2)));
    expectFluxToTheEnd(c, "0.01");
    const ProgramCase other(weightlessFiles(risingGrains), functionsOf(preciseFlux()));
    EXPECT_TRUE(succeeds(other.run()));
    EXPECT_TRUE(succeeds(other.decompose(labelVector(2, 1, 1))));
    other.writeControl(functionsOf(preciseFlux(), toTheEnd));
    EXPECT_TRUE(succeeds(other.runOn(2)));
    expectFluxToTheEnd(other, "0.01");
}

TEST(GrainFlux, refusesBadInput)
{
    const std::string start = "flux\n{\ntype grainFlux;\n";
    const std::vector<std::string> planeWords = {"system/controlDict", "functions.flux.planes.a"};
    EXPECT_TRUE(isRefused(start + "plane 3; }", {"system/controlDict", "line 8", "plane", "nearest: planes"}));
    EXPECT_TRUE(isRefused(start + "planes 3; }", {"system/controlDict", "line 8", "functions.flux.planes"}));
    EXPECT_TRUE(isRefused(start + "planes { a { point (0 0 0); } } }", {planeWords[0], planeWords[1], "normal", "is missing"}));
    EXPECT_TRUE(isRefused(start + "executeControl writeTime; }", {"executeControl", "would leave steps out of the count"}));
    EXPECT_TRUE(isRefused(start + "planes { a { pont (0 0 0); normal (0 0 1); } } }", {planeWords[0], planeWords[1], "point"}));
    EXPECT_TRUE(isRefused(start + "planes { a { point (0 0); normal (0 0 1); } } }", {planeWords[0], planeWords[1], "point", "( 0 0 )"}));
    EXPECT_TRUE(isRefused(start + "planes { a { point (0 0 0);\nnormal (0 0 0); } } }", {planeWords[1], "line 9", "normal", "(0 0 0)"}));
    EXPECT_TRUE(isRefused(start + "exits (bak); }", {"system/controlDict", "line 8", "functions.flux.exits", "bak", "nearest: back"}));
    EXPECT_TRUE(isRefused(start + "executeInterval 2; }", {"system/controlDict", "line 8", "executeInterval", "every step"}));
}

namespace
{

/// Layers 0.01 to 0.09 m high at the start, 0.053 m higher after 10 steps: four fifths of the mass are up to the fourth one.
void expectHeightOfALattice(const labelVector& parts)
{
    const std::string bed = "bed { type bedHeight; floor { point (0 0 0.003); normal (0 0 2); } share 0.79; writePrecision 9; }";
    const ProgramCase c(weightlessFiles(risingGrains), functionsOf(bed));
    EXPECT_TRUE(succeedsIn(c, parts));
    std::map<std::string, double> row = lastRow(c, "bed/0/bedHeight.dat");
    EXPECT_NEAR(row.at("Time"), 0.01, 1e-9);
    EXPECT_NEAR(row.at("twiceMean"), 2*(0.05 + 0.053 - 0.003), 1e-8);
    EXPECT_NEAR(row.at("share"), 0.07 + 0.053 - 0.003, 1e-8);
}

} // namespace

TEST(BedHeight, isThatOfALattice) { expectHeightOfALattice(labelVector(1, 1, 1)); }
TEST(Ranks, findTheHeightOfALattice) { expectHeightOfALattice(labelVector(1, 1, 2)); }

TEST(FunctionTypes, areRefusedWhereNoLibraryHasThem)
{
    EXPECT_TRUE(isRefused("flux { type grainFlix; }", {"system/controlDict", "functions.flux.type", "grainFlix", "nearest: grainFlux"}));
    EXPECT_TRUE(isRefused("flux { planes {} }", {"system/controlDict", "functions.flux", "has no type"}));
    const std::string mean = "means { type fieldAverage; fields (p); ", libs = "libs (\"libfieldFunctionObjects.so\"); ";
    EXPECT_TRUE(isRefused(mean + "}", {"system/controlDict", "functions.means.type", "fieldAverage", "`libs`"}));
    const std::string rest = "} other { type fieldAverage; enabled no; fields (); } typo { type grainFlix; enabled no; }";
    EXPECT_TRUE(succeeds(ProgramCase(weightlessFiles(risingGrains), functionsOf(mean + libs + "enabled no; " + rest)).run()));
    EXPECT_TRUE(succeeds(ProgramCase(weightlessFiles(risingGrains), functionsOf("a { type timeInfo; libs (\"libutilityFunctionObjects.so\"); }")).run()));
}

TEST(BedHeight, refusesBadInput)
{
    const std::string start = "bed\n{\ntype bedHeight;\n", floor = "floor { point (0 0 0); normal (0 0 1); } ";
    EXPECT_TRUE(isRefused(start + "share 0.5; }", {"system/controlDict", "functions.bed", "floor", "is missing"}));
    EXPECT_TRUE(isRefused(start + "flor 3; }", {"system/controlDict", "floor"}));
    EXPECT_TRUE(isRefused(start + "floor { point (0 0 0);\nnormal (0 0 0); } }", {"line 9", "functions.bed.floor.normal", "(0 0 0)"}));
    EXPECT_TRUE(isRefused(start + floor + "\nshare 1.5; }", {"system/controlDict", "line 9", "functions.bed.share", "1.5"}));
    EXPECT_TRUE(isRefused(start + floor + "\nshar 0.5; }", {"system/controlDict", "line 9", "shar", "nearest: share"}));
}

namespace
{

/// 64 spheres at rest, half of them red.
std::string twoColors(const std::string& red, const std::string& blue)
{
    const std::string lattice = " { type lattice; diameter 0.005; material ";
    return "materials { red { density 2500; } blue { density 2500; } } contacts { default { friction 0.3; } } fluid none; wallMaterial red;"
        "grains { a" + lattice + "red; " + red + " } b" + lattice + "blue; " + blue + " } }"
        "patches { front { type wall; } back { type exit; } }";
}

const std::string segregated = twoColors("box (0 0 0) (0.1 0.1 0.1); count (4 4 2);", "box (0 0 0.1) (0.1 0.1 0.2); count (4 4 2);");
const std::string regular = twoColors("box (0 0 0) (0.05 0.1 0.2); count (2 4 4);", "box (0.05 0 0) (0.1 0.1 0.2); count (2 4 4);");

std::string mixing(const std::string& samples)
{
    return "mixing { type mixingIndex; material red; box (0 0 0) (0.1 0.1 0.2); " + samples + " writePrecision 9; }";
}

std::map<std::string, double> mixtureOf(const std::string& grains, const std::string& samples, const labelVector& parts)
{
    const ProgramCase c(weightlessFiles(grains), functionsOf(mixing(samples)));
    EXPECT_TRUE(succeedsIn(c, parts));
    return lastRow(c, "mixing/0/mixingIndex.dat");
}

} // namespace

namespace
{

void expectMixingIndices(const labelVector& parts)
{
    std::map<std::string, double> row = mixtureOf(segregated, "count (1 1 2);", parts);
    EXPECT_NEAR(row.at("index"), 0, 1e-8);
    EXPECT_NEAR(row.at("share"), 0.5, 1e-8);
    EXPECT_EQ(row.at("samples"), 2);
    EXPECT_EQ(row.at("grainsPerSample"), 32);
    // Each of the four samples has 8 red and 8 blue ones: S = 0, M = 1/(1 - 1/n).
    row = mixtureOf(regular, "count (1 1 4);", parts);
    EXPECT_NEAR(row.at("index"), 1/(1 - 1.0/16), 1e-8);
    EXPECT_EQ(row.at("samples"), 4);
    // Two samples side by side part the same grains.
    row = mixtureOf(regular, "count (2 1 1);", parts);
    EXPECT_NEAR(row.at("index"), 0, 1e-8);
}

} // namespace

TEST(MixingIndex, isZeroOfTwoHalvesAndThatOfARegularMixtureAboveOne) { expectMixingIndices(labelVector(1, 1, 1)); }
TEST(Ranks, findMixingIndices) { expectMixingIndices(labelVector(1, 2, 1)); }

TEST(MixingIndex, weighsSamplesByTheirGrains)
{
    // Three samples along x of 16, 32 and 16 grains; red: all, half, none. S^2 = (16 + 16)/4/64 = 1/8, n = 64/3.
    std::map<std::string, double> row = mixtureOf(regular, "count (3 1 1);", labelVector(1, 1, 1));
    EXPECT_EQ(row.at("samples"), 3);
    EXPECT_NEAR(row.at("index"), (0.25 - 0.125)/(0.25 - 0.25*3/64), 1e-8);
}

TEST(MixingIndex, refusesBadInput)
{
    const std::string start = "mixing\n{\ntype mixingIndex;\n", box = "box (0 0 0) (1 1 1); ";
    EXPECT_TRUE(isRefused(start + "material glas; }", {"system/controlDict", "line 8", "functions.mixing.material", "glas", "nearest: glass"}));
    EXPECT_TRUE(isRefused(start + "material glass;\nbox (0 0 0) (1 0 1); count (1 1 1); }", {"line 9", "functions.mixing.box"}));
    EXPECT_TRUE(isRefused(start + "material glass; " + box + "\ncount (1 1); }", {"line 9", "functions.mixing.count", "three numbers"}));
    EXPECT_TRUE(isRefused(start + "material glass; " + box + "\ncount (0 1 1); }", {"line 9", "functions.mixing.count", "0"}));
    EXPECT_TRUE(isRefused(start + "material glass; " + box + "\ncount (300 300 300); }", {"line 9", "functions.mixing.count", "10 million"}));
    EXPECT_TRUE(isRefused(start + "material glass; " + box + "count (1 1 1);\nmaterials 3; }", {"line 9", "nearest: material"}));
}

namespace
{

void expectProbesOfTwoGrains(const labelVector& parts)
{
    const std::string probes = "probes { type grainProbes; ids (0 79); writePrecision 9; }";
    const ProgramCase c(weightlessFiles(risingGrains), functionsOf(probes, "endTime 0.021; writeInterval 21;"));
    EXPECT_TRUE(succeedsIn(c, parts));
    // Twenty-one steps: the first grain is 0.1113 m higher, the last one, of the topmost layer, has left in the last of them.
    std::map<std::string, double> row = lastRow(c, "probes/0/grainProbes.dat");
    EXPECT_EQ(row.at("0.present"), 1);
    EXPECT_NEAR(row.at("0.x"), 0.0125, 1e-8);
    EXPECT_NEAR(row.at("0.y"), 0.0125, 1e-8);
    EXPECT_NEAR(row.at("0.z"), 0.01 + 0.1113, 1e-8);
    EXPECT_NEAR(row.at("0.uz"), 5.3, 1e-8);
    EXPECT_EQ(row.at("79.present"), 0);
    EXPECT_EQ(row.at("79.z"), 0);
    const std::string text = c.contents("postProcessing/probes/0/grainProbes.dat");
    EXPECT_NE(text.find("79.uz"), std::string::npos);
}

} // namespace

TEST(GrainProbes, followGrainsUntilTheyLeave) { expectProbesOfTwoGrains(labelVector(1, 1, 1)); }
TEST(Ranks, followGrainsUntilTheyLeave) { expectProbesOfTwoGrains(labelVector(1, 1, 2)); }

TEST(GrainProbes, refuseBadInput)
{
    const std::string start = "probes\n{\ntype grainProbes;\n";
    EXPECT_TRUE(isRefused(start + "id (0 1); }", {"system/controlDict", "id"}));
    EXPECT_TRUE(isRefused(start + "ids (0 -1); }", {"system/controlDict", "line 8", "functions.probes.ids", "-1"}));
    EXPECT_TRUE(isRefused(start + "ids (); }", {"system/controlDict", "line 8", "functions.probes.ids"}));
    EXPECT_TRUE(isRefused(start + "ids (0);\nidss (1); }", {"system/controlDict", "line 9", "nearest: ids"}));
}
