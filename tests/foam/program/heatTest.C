// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Heat in runs of the program: balances, exact exchange, steps of any length, restarts, and input that is refused.
#include "caseTools.H"
#include "heatCase.H"

#include "IFstream.H"

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

/// Fixed grains in a fluid at rest, in a box that no heat leaves.
Files restingFiles(const std::string& heat, const std::string& more = "")
{
    return
    {
        {"constant/grainProperties", glassOnly + heat + "patches { front { type wall; } back { type wall; } } motion fixed; "
            "grains { type lattice; box (0.02 0.02 0.02) (0.08 0.08 0.18); count (3 3 5); diameter 0.01; } " + more},
        {"0/T", temperatureField("300")}, {"system/fvSolution", heatSolution()},
        {"constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);"}
    };
}

std::vector<double> column(const ProgramCase& c, const std::string& name) { return c.reported("0", name); }

/// Errors of all steps over what the run holds of heat.
double largestError(const ProgramCase& c, const std::string& start = "0")
{
    const std::vector<double> error = c.reported(start, "heatError"), fluid = c.reported(start, "heatFluid"), grains = c.reported(start, "heatGrains");
    double largest = error.empty() ? GREAT : 0;
    for (std::size_t k = 0; k < error.size(); ++k) largest = std::max(largest, std::abs(error[k])/(fluid[k] + grains[k]));
    return largest;
}

double largestSize(const std::vector<double>& values)
{
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    return largest;
}

} // namespace

TEST(Heat, isBalancedWhereGrainsEnterFallAndLeave)
{
    const ProgramCase c(pouringFiles(), "endTime 0.06; deltaT 2e-3;");
    EXPECT_TRUE(succeeds(c.run()));
    EXPECT_GT(column(c, "exited").back(), 2);
    EXPECT_GT(column(c, "entered").back(), 20);
    EXPECT_LT(largestError(c), 1e-13);
    // What the error is small against: each part is at work, by more than a million times as much.
    const double size = 1e-13*column(c, "heatFluid").back();
    for (const char* part : {"heatIn", "heatToGrains", "heatEntered", "heatShifted"}) EXPECT_GT(largestSize(column(c, part)), 1e6*size) << part;
    EXPECT_LT(column(c, "heatToGrains").back(), 0) << "the grains are hotter";
    for (const double T : column(c, "grainTMin")) EXPECT_GE(T, 300 - 1e-9);
    for (const double T : column(c, "grainTMax")) EXPECT_LE(T, 350 + 1e-9);
}

TEST(Heat, leavesAUniformTemperatureAlone)
{
    Files files = pouringFiles();
    files["constant/grainProperties"].replace(files["constant/grainProperties"].find("temperature 350"), 15, "temperature 300");
    files["0/T"] = temperatureField("300", "300");
    const ProgramCase c(files, "endTime 0.06; deltaT 2e-3;");
    EXPECT_TRUE(succeeds(c.run()));
    for (const char* extreme : {"fluidTMin", "fluidTMax", "grainTMin", "grainTMax"})
    {
        for (const double T : column(c, extreme)) EXPECT_NEAR(T, 300, 1e-9) << extreme;
    }
}

/// A fluid of such a heat capacity that its temperature does not move, at rest: Nu is 2.
TEST(Heat, changesAGrainByTheExponentialWhateverTheStep)
{
    const std::string heat = "heat { law RanzMarshall; fluid { heatCapacity 1e15; conductivity 0.6; } "
        "materials { glass { heatCapacity 840; temperature 350; } } }\n";
    for (const std::string step : {"deltaT 0.5;", "deltaT 10;"})
    {
        const ProgramCase c(restingFiles(heat), "endTime 20; writeInterval 100; " + step);
        EXPECT_TRUE(succeeds(c.run()));
        const double expected = 300 + 50*std::exp(-6*2*0.6*20/(2500*840*1e-4));
        EXPECT_NEAR(column(c, "grainTMin").back(), expected, 1e-8) << step;
        EXPECT_NEAR(column(c, "grainTMax").back(), expected, 1e-8) << step;
    }
}

TEST(Heat, endsInTheMixingTemperatureInStepsOfAnyLength)
{
    const ProgramCase c(restingFiles(heatOfGlass), "endTime 1e7; deltaT 1e6; writeInterval 100;");
    EXPECT_TRUE(succeeds(c.run()));
    const double grains = 45*2500*std::acos(-1.0)/6*1e-6, fluid = 1000*(0.1*0.1*0.2 - grains/2500);
    const double mixed = (grains*840*350 + fluid*4182*300)/(grains*840 + fluid*4182);
    for (const char* extreme : {"fluidTMin", "fluidTMax", "grainTMin", "grainTMax"}) EXPECT_NEAR(column(c, extreme).back(), mixed, 1e-6) << extreme;
    EXPECT_LT(largestError(c), 1e-12);
}

TEST(Heat, ofHeldGrainsIsCounted)
{
    const std::string heat = "heat { law Wakao; fluid { heatCapacity 4182; conductivity 6; } "
        "materials { default { heatCapacity 840; temperature 350; held on; } } }\n";
    const ProgramCase c(restingFiles(heat), "endTime 10; deltaT 1; writeInterval 100;");
    EXPECT_TRUE(succeeds(c.run()));
    EXPECT_EQ(column(c, "grainTMin").back(), 350);
    EXPECT_LT(column(c, "heatHeld").back(), 0);
    EXPECT_EQ(column(c, "heatHeld"), column(c, "heatToGrains"));
    EXPECT_LT(largestError(c), 1e-13);
}

/// Grains that stand on one another between a hot grain below and a cold one on top, in a fluid that takes no heat to speak of: each contact
/// carries the weight above it, less that of the fluid.
TEST(Heat, goesThroughAStackOfGrainsAsThroughResistancesInSeries)
{
    const std::string grain = "heatCapacity 840; conductivity 1.1; youngModulus 7e7; poissonRatio 0.2; held ";
    const ProgramCase c(Files
    {
        {"constant/grainProperties", "materials { hot { density 2500; } glass { density 2500; } cold { density 2500; } } contacts { default { friction 0.3; } } "
            "wallMaterial glass; patches { front { type wall; } back { type wall; } } grains { type table; file \"stack.txt\"; material glass; } "
            "forces { drag { law Stokes; } } solver { tolerance 1e-8; displacementTolerance 1e-9; forceTolerance 1e-8; deadBand 1e-6; } "
            "heat { law RanzMarshall; contacts on; fluid { heatCapacity 1; conductivity 1e-12; } materials { hot { " + grain + "on; temperature 400; } "
            "glass { " + grain + "off; temperature 350; } cold { " + grain + "on; temperature 300; } } }"},
        {"0/T", temperatureField("350")}, {"system/fvSolution", heatSolution()}
    }, "endTime 0.1; deltaT 1e-3; writeInterval 100; writePrecision 15;");
    std::ofstream rows(std::string(c.path("constant/stack.txt")));
    for (int i = 0; i < 8; ++i) rows << "0.0375 0.0375 " << 0.005 + 0.01*i << " 0.01 " << (i == 0 ? "hot" : i == 7 ? "cold" : "glass") << "\n";
    rows.close();
    ASSERT_TRUE(succeeds(c.run()));
    EXPECT_LT(largestError(c), 1e-13);
    EXPECT_LT(c.reported("0", "heatHeld").back(), 0) << "the hot grain gives, and what is between stores";
    EXPECT_GT(c.reported("0", "grainTMax").back(), 350);
    // The first step from 350 K: what the hot grain gives is H (400 - 350), to the share that the next grain warms.
    const double volume = std::acos(-1.0)/6*1e-6, force = 7*volume*1500*9.81;
    const double H = 2*1.1*std::cbrt(0.75*force*2.5e-3*2*0.96/7e7), forceTop = volume*1500*9.81;
    const double top = 2*1.1*std::cbrt(0.75*forceTop*2.5e-3*2*0.96/7e7);
    const std::vector<double> held = c.reported("0", "heatHeld");
    EXPECT_NEAR(held.back()/(-1e-3*50*(H - top)), 1, 0.02);
}

/// Warm fluid at rest weighs less, and a grain in it is lifted by that much less.
TEST(Heat, ofAWarmFluidLiftsGrainsLess)
{
    const double beta = 1e-3, lost = beta*(350 - 300);
    Files files = restingFiles(with(heatOfGlass, "conductivity 6;", "conductivity 6; expansion 1e-3; reference 300;"));
    files["0/T"] = temperatureField("350");
    files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);";
    const ProgramCase c(files, "endTime 0.01; deltaT 1e-3; writePrecision 15;");
    EXPECT_TRUE(succeeds(c.run()));
    const double weight = 1000*9.81*std::acos(-1.0)/6*1e-6;
    IFstream is(c.path("0.01/lagrangian/grains/fFluid"));
    token head(is);
    const dictionary header(is);
    const List<vector> forces(is);
    ASSERT_EQ(forces.size(), 45);
    for (const vector& force : forces) EXPECT_NEAR(force.z(), weight*(1 - lost), 1e-6*weight);
    EXPECT_LT(largestSize(column(c, "momentumError")), 1e-9);
    EXPECT_TRUE(c.contents("0.01/bodyAcceleration").empty());
}

TEST(Heat, goesOnToTheBit)
{
    const std::string control = "writeFormat binary; deltaT 2e-3; ";
    const ProgramCase whole(pouringFiles(), control + "writeInterval 10; endTime 0.04;"), parts(pouringFiles(), control + "writeInterval 10; endTime 0.02;");
    EXPECT_TRUE(succeeds(whole.run()));
    EXPECT_TRUE(succeeds(parts.run()));
    parts.writeControl(control + "writeInterval 10; endTime 0.04;");
    EXPECT_TRUE(succeeds(parts.run()));
    for (const char* file : {"T", "U", "alpha.fluid", "lagrangian/grains/T", "lagrangian/grains/position"})
    {
        const std::string path = std::string("0.04/") + file;
        EXPECT_FALSE(whole.contents(path).empty()) << path;
        EXPECT_TRUE(whole.contents(path) == parts.contents(path)) << path;
    }
    EXPECT_LT(largestError(parts, "0.02"), 1e-13);
}

TEST(Heat, mayBeginFromATimeThatKnewNone)
{
    Files files = pouringFiles();
    const std::string withHeat = files["constant/grainProperties"];
    files["constant/grainProperties"] = with(withHeat, heatOfGlass, "");
    const ProgramCase c(files, "endTime 0.01; deltaT 2e-3; writeInterval 5;");
    EXPECT_TRUE(succeeds(c.run()));
    EXPECT_EQ(c.contents("postProcessing/grains/0/report.csv").find("heat"), std::string::npos);
    EXPECT_TRUE(c.contents("0.01/lagrangian/grains/T").empty());
    c.write("constant/grainProperties", withHeat);
    c.write("0.01/T", temperatureField("300", "320"));
    c.writeControl("endTime 0.02; deltaT 2e-3; writeInterval 5;");
    const ProgramRun run = c.run();
    EXPECT_TRUE(succeeds(run));
    EXPECT_TRUE(holds(run.log, {"lagrangian/grains/T was not written: all grains start with the temperature of their material"}));
    EXPECT_LT(largestError(c, "0.01"), 1e-13);
    EXPECT_EQ(c.reported("0.01", "grainTMax").size(), 5u);
}

TEST(BadHeat, isToldInWords)
{
    const std::string good = glassOnly + "\nheat\n{\nlaw Gunn;\nfluid { heatCapacity 4182; conductivity 0.6; }\n"
        "materials { glass { heatCapacity 840; temperature 350; } }\n}\ngrains {}";
    const auto said = [](const std::string& text) { return complaint([&] { nscdCoupling::readGrainProperties(dictionaryOf(text)); }); };
    EXPECT_EQ(said(good), "");
    EXPECT_EQ(said(with(good, "heatCapacity 840", "heatCapacity [0 2 -2 -1 0 0 0] 840")), "");
    EXPECT_TRUE(holds(said(with(good, "law Gunn", "law Gun")), {"heat.law", "value:   Gun", "RanzMarshall, Gunn, Wakao", "nearest: Gunn", "line 4"}));
    EXPECT_TRUE(holds(said(with(good, "law Gunn;", "")), {"heat.law is missing"}));
    EXPECT_TRUE(holds(said(with(good, "temperature 350", "temperature -3")), {"heat.materials.glass.temperature is out of range", "value:   -3", "> 0"}));
    EXPECT_TRUE(holds(said(with(good, "conductivity 0.6", "conductivity 0")), {"heat.fluid.conductivity is out of range", "line 5"}));
    EXPECT_TRUE(holds(said(with(good, "heatCapacity 840", "heatCapacity [0 2 -2 0 0 0 0] 840")), {"wrong dimensions", "[0 2 -2 -1 0 0 0]"}));
    EXPECT_TRUE(holds(said(with(good, "heatCapacity 840", "heatCapacty 840")), {"heatCapacty", "nearest: heatCapacity"}));
    EXPECT_TRUE(holds(said(with(good, "glass { heat", "glas { heat")), {"glas", "nearest: glass"}));
    EXPECT_TRUE(holds(said(with(good, "glass { heatCapacity 840; temperature 350; }", "")), {"lacks the material glass of grains"}));
    EXPECT_TRUE(holds(said(with(good, "\nheat\n", "\nhaet\n")), {"haet", "nearest: heat"}));
    EXPECT_TRUE(holds(said(with(good, "law Gunn;", "law Gunn; contacts on;")), {"heat.contacts needs conductivity and youngModulus of the material glass"}));
    EXPECT_TRUE(holds(said(with(good, "conductivity 0.6;", "conductivity 0.6; expansion 1e-3;")), {"heat.fluid.reference is missing"}));
    EXPECT_TRUE(holds(said(good + " fluid none;"), {"heat needs a fluid that is solved"}));
    EXPECT_TRUE(holds(said(good + " feedback off;"), {"this fluid does not feel the grains"}));
}

TEST(BadHeat, ofFieldsAndSchemesIsToldBeforeTheFirstStep)
{
    const auto refused = [](const std::string& file, const std::string& text, const std::vector<std::string>& pieces)
    {
        Files files = restingFiles(heatOfGlass);
        files[file] = text;
        return isRefused(ProgramCase(files), pieces);
    };
    EXPECT_TRUE(refused("0/T", "", {"0/T"}));
    EXPECT_TRUE(refused("0/T", temperatureField("-1"), {"0/T", "internalField", "is out of range", "-1"}));
    EXPECT_TRUE(refused("0/T", temperatureField("300", "0,5"), {"0/T", "front", "is out of range", "value:   0"}));
    EXPECT_TRUE(refused("0/T", with(temperatureField("300"), "[0 0 0 1", "[0 0 0 0"), {"0/T", "dimensions are wrong for T"}));
    EXPECT_TRUE(refused("system/fvSolution", solutionWith(2), {"fvSolution", "T"}));
}

TEST(BadHeat, ofDiscsIsRefused)
{
    BoxMeshSettings box = programBox();
    box.cells = labelVector(5, 8, 1);
    box.max = point(0.1, 0.2, 0.02);
    box.patchTypes = {"wall", "wall", "wall", "wall", "empty", "empty"};
    const ProgramCase c(Files
    {
        {"constant/grainProperties", glassOnly + heatOfGlass + "grains { type lattice; box (0 0 0) (0.1 0.2 0.02); count (2 2 1); diameter 0.01; }"},
        {"constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);"},
        {"0/T", "dimensions [0 0 0 1 0 0 0]; internalField uniform 300; boundaryField { \".*\" { type zeroGradient; } \"(front|back)\" { type empty; } }"},
        {"0/U", "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField { \".*\" { type noSlip; } \"(front|back)\" { type empty; } }"},
        {"0/p_rgh", "dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0; "
            "boundaryField { \".*\" { type fixedFluxPressure; value uniform 0; } \"(front|back)\" { type empty; } }"},
        {"system/fvSolution", heatSolution()}
    }, "", box);
    EXPECT_TRUE(isRefused(c, {"heat", "spheres", "discs"}));
}
