// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of nscdDEMFoam itself on small cases: what stops it before the first step, what it writes, and restarts.
#include "caseTools.H"
#include "programCase.H"

#include "nscd/base/folderLock.hpp"

#include "IFstream.H"
#include "OSspecific.H"

#include <fstream>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

const std::string grains =
    "materials { glass { density 2500; } } contacts { default { friction 0.3; restitution 0.4; } }"
    "grains { type lattice; box (0.02 0.02 0.02) (0.08 0.08 0.06); count (3 3 2); diameter 0.01; jitter 0.5; }"
    "patches { front { type wall; } back { type exit; } } ";

::testing::AssertionResult isRefusedWith
(
    const std::string& file, const std::string& contents, const std::vector<std::string>& pieces
)
{
    return isRefused(ProgramCase(Files{{file, contents}}), pieces);
}

/// A field of the grains at the last written time.
List<vector> grainVectors(const ProgramCase& c, const std::string& field)
{
    IFstream is(c.path(c.latestTime() + "/lagrangian/grains/" + field));
    token head(is);
    const dictionary header(is);
    return List<vector>(is);
}

/// Does something while the program runs a case that would never end, from the third step on, and gives the status in which it ends.
int inTheMidstOf(const ProgramCase& c, const std::string& action)
{
    std::ofstream(c.path("Allrun")) << "cd " << c.path("") << "\n$FOAM_USER_APPBIN/nscdDEMFoam > log.midst 2>&1 &\nrun=$!\n(sleep 60; kill -KILL $run) &\n"
        << "until grep -q ^0.003 postProcessing/grains/0/report.csv 2> /dev/null || ! kill -0 $run; do sleep 0.01; done\n"
        << action << "\nwait $run\nstatus=$?\nkill $!\nexit $status\n";
    return std::system(("bash " + c.path("Allrun") + " > /dev/null 2>&1").c_str());
}

} // namespace

TEST(Program, stopsAtBadGrainPropertiesWithFileAndLine)
{
    EXPECT_TRUE(isRefusedWith("constant/grainProperties", "\n\n" + grains + "\nfeedbak off;",
        {"constant/grainProperties", "line 5", "feedbak", "nearest: feedback"}));
}

TEST(Program, stopsWhereAFileIsMissing)
{
    const std::vector<std::string> files =
    {
        "constant/grainProperties", "constant/g", "constant/transportProperties", "constant/turbulenceProperties",
        "0/U", "0/p_rgh", "system/fvSchemes", "system/fvSolution"
    };
    for (const std::string& file : files) EXPECT_TRUE(isRefusedWith(file, "", {fileName(file).name()})) << file;
}

TEST(Program, stopsAtFluidPropertiesThatMakeNoSense)
{
    const std::string file = "constant/transportProperties", model = "\n transportModel Newtonian; ";
    EXPECT_TRUE(isRefusedWith(file, model + "nu 1e-6;", {file, "rho", "is missing"}));
    EXPECT_TRUE(isRefusedWith(file, model + "nu 1e-6; rho -1;", {file, "line 3", "rho", "> 0"}));
    EXPECT_TRUE(isRefusedWith(file, model + "nu -1e-6; rho 1;", {file, "line 3", "nu", "> 0"}));
    EXPECT_TRUE(isRefusedWith(file, model + "nu 1e-6; rho [0 1 0 0 0 0 0] 1;", {file, "rho", "wrong dimensions"}));
    EXPECT_TRUE(isRefusedWith("constant/g", "dimensions [0 1 -2 0 0 0 0];\nvalue (0 0 1e40);", {"constant/g", "line 3", "value is too large", "1e+30"}));
    EXPECT_TRUE(isRefusedWith("0/p_rgh",
        "dimensions [0 2 -2 0 0 0 0];\ninternalField uniform 0; boundaryField { \".*\" { type zeroGradient; } }",
        {"0/p_rgh", "line 2", "[0 2 -2 0 0 0 0]", "[1 -1 -2 0 0 0 0]", "Pa"}));
}

TEST(Program, stopsAtSourcesOfOpenFOAMThatItWouldIgnore)
{
    const std::string source = "\nheat\n{ type scalarSemiImplicitSource; selectionMode all; volumeMode specific; injectionRateSuSp { T (1 0); } }";
    EXPECT_TRUE(isRefusedWith("constant/fvOptions", source, {"constant/fvOptions", "line 4", "heat", "no field that is solved here", "U, alpha.fluid"}));
    EXPECT_TRUE(isRefusedWith("system/fvOptions", source, {"system/fvOptions", "heat"}));
    EXPECT_TRUE(isRefusedWith("system/fvOptions", "a { type porosity; }", {"system/fvOptions", "porosity", "explicitPorositySource"}));
    const std::string mean = "\npump { type meanVelocityForce; selectionMode all; fields (U); Ubar (0 0 1); }";
    EXPECT_TRUE(isRefusedWith("constant/fvOptions", mean, {"constant/fvOptions", "pump", "meanVelocityForce", "`meanFlow`"}));
    EXPECT_TRUE(isRefused(ProgramCase(Files{{"constant/fvOptions", mean}, {"constant/grainProperties", grains + "fluid none;"}}),
        {"constant/fvOptions", "line 3", "pump", "fluid none"}));
}

TEST(Program, stopsAtFilesOfOpenFOAMThatItWouldIgnore)
{
    const std::string zone = "\nrotor { cellZone rotor; }";
    EXPECT_TRUE(isRefusedWith("constant/MRFProperties", zone, {"constant/MRFProperties", "rotor.cellZone", "no cell zone"}));
    EXPECT_TRUE(isRefusedWith("constant/dynamicMeshDict", "mover { type motionSolver; }", {"constant/dynamicMeshDict", "moves the mesh"}));
    const std::string gas = "thermoType { type hePsiThermo; equationOfState perfectGas; }";
    EXPECT_TRUE(isRefusedWith("constant/thermophysicalProperties", gas, {"constant/thermophysicalProperties", "thermoType", "rho in constant/transportProperties"}));
    const ProgramCase harmless(Files{{"constant/fvOptions", "\n"}, {"constant/MRFProperties", "\n"}, {"constant/dynamicMeshDict", "dynamicFvMesh staticFvMesh;"}});
    EXPECT_TRUE(succeeds(harmless.run()));
}

TEST(Program, stopsAtTimeControlsThatAreNotPositive)
{
    EXPECT_TRUE(isRefused(ProgramCase(Files(), "deltaT 0;"), {"system/controlDict", "deltaT"}));
    EXPECT_TRUE(isRefused(ProgramCase(Files(), "deltaT -1e-3;"), {"system/controlDict", "deltaT"}));
    EXPECT_TRUE(isRefused(ProgramCase(Files(), "deltaT 0.0101;"), {"system/controlDict", "deltaT", "at most endTime, 0.01"}));
    EXPECT_TRUE(isRefused(ProgramCase(Files(), "endTime 7e77;"), {"system/controlDict", "keyword endTime is too large"}));
    EXPECT_TRUE(isRefused(ProgramCase(Files(), "writeControl runTime; writeInterval -1;"), {"controlDict", "writeInterval"}));
    EXPECT_TRUE(isRefused(ProgramCase(Files(), "adjustTimeStep yes; maxDeltaT -1;"), {"controlDict", "maxDeltaT"}));
    // OpenFOAM counts written times in 32 bits.
    const std::string often = "writeControl runTime; endTime 1; writeInterval ";
    EXPECT_TRUE(isRefused(ProgramCase(Files(), often + "1e-307;"), {"controlDict", "writeInterval"}));
    EXPECT_TRUE(isRefused(ProgramCase(Files(), often + "1e-10;"), {"controlDict", "writeInterval", "more written times than can be counted"}));
}

TEST(Program, stopsAtMisspeltControlsOfTheFluid)
{
    EXPECT_TRUE(isRefused(ProgramCase(Files(), "adjustTimeStep yes; mxaCo 0.2;"), {"system/controlDict", "mxaCo", "nearest: maxCo"}));
    const auto isRefusedWithControl = [](const std::string& control, const std::vector<std::string>& pieces)
    {
        return isRefusedWith("system/fvSolution", with(solutionWith(2), "nCorrectors 2;", control), pieces);
    };
    EXPECT_TRUE(isRefusedWith("system/fvSolution", with(solutionWith(2), "solvers", "solvres"), {"fvSolution", "solvres", "nearest: solvers"}));
    EXPECT_TRUE(isRefusedWith("system/fvSolution", with(solutionWith(2), "PIMPLE", "PMIPLE"), {"fvSolution", "PMIPLE", "nearest: PIMPLE"}));
    EXPECT_TRUE(isRefusedWith("system/fvSolution", with(solutionWith(2), "PIMPLE", "PIMPLE 5; other"), {"fvSolution", "PIMPLE is not a dictionary"}));
    EXPECT_TRUE(isRefusedWithControl("ommentumPredictor no;", {"fvSolution", "ommentumPredictor", "nearest: momentumPredictor"}));
    // Joined by a dot or, since v2312, by a slash.
    EXPECT_TRUE(isRefusedWithControl("nCorrectors 0;", {"fvSolution", "PIMPLE at line", "keyword nCorrectors is out of range", ">= 1"}));
    EXPECT_TRUE(isRefusedWithControl("nOuterCorrectors 0;", {"fvSolution", "PIMPLE at line", "keyword nOuterCorrectors is out of range", ">= 1"}));
}

/// OpenFOAM aborts at the first three, and ends without a word at the last.
TEST(Program, stopsWithoutASignalWhereOpenFOAMAborts)
{
    const std::string field = "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField { \".*\" ";
    EXPECT_TRUE(isRefused(ProgramCase(Files(), "deltaT { a 1; }"), {"system/controlDict", "deltaT", "dictionary"}));
    EXPECT_TRUE(isRefusedWith("0/U", field + "{ type fixedValue; value { a 1; } } }", {"0/U", "value", "dictionary"}));
    const std::string schemes = "ddtSchemes { default Euler; } divSchemes { default none; div(phi,U) Gauss linearUpwindV grad(U); "
        "div((nuEff*dev2(T(grad(U))))) Gauss linear; } gradSchemes { default Gauss linear; } interpolationSchemes { default linear; } "
        "snGradSchemes { default corrected; } laplacianSchemes ";
    const std::string laplacian = "{ default Gauss linear corrected; }";
    EXPECT_TRUE(isRefusedWith("system/fvSchemes", schemes + "5;", {"system/fvSchemes", "laplacianSchemes"}));
    EXPECT_TRUE(isRefusedWith("system/fvSchemes", with(schemes, "gradSchemes { default Gauss linear", "gradSchemes { default Gauss lienar") + laplacian, {"lienar"}));
}

/// An abort that OpenFOAM has no words for, here one from outside, stays the signal that it is. A run that went on would be killed: 137.
TEST(Program, anyOtherAbortStaysASignal)
{
    const ProgramCase c(Files{{"constant/grainProperties", grains + "fluid none;"}}, "endTime 10000; writeInterval 100000000;");
    EXPECT_EQ(WEXITSTATUS(inTheMidstOf(c, "kill -ABRT $run")), 134) << c.contents("log.midst");
}

TEST(Program, stopsInWordsAtTextThatOpenFOAMCannotRead)
{
    const std::string pressure = "dimensions [1 -1 -2 0 0 0 0];\ninternalField uniform ", boundary = "; boundaryField { \".*\" { type zeroGradient; } }";
    EXPECT_TRUE(isRefused(ProgramCase(Files(), "\nmaxCo 1e999;"), {"system/controlDict", "line 3", "keyword maxCo", "1e999"}));
    EXPECT_TRUE(isRefusedWith("0/p_rgh", pressure + "1e999" + boundary, {"0/p_rgh", "line 3", "no computer holds", "1e999"}));
    EXPECT_TRUE(isRefusedWith("0/p_rgh", "dimensions [five -1 -2 0 0 0 0];", {"0/p_rgh", "cannot be read", "five"}));
    EXPECT_TRUE(isRefusedWith("0/p_rgh", pressure + "-1e200" + boundary, {"0/p_rgh", "line 3", "too large", "1e+30"}));
    EXPECT_TRUE(isRefusedWith("system/fvSolution", "solvers { p { tolerance 1e999; } }", {"fvSolution", "solvers.p.tolerance", "1e999"}));
    std::string deep = "simulationType laminar; ";
    for (int k = 0; k < 100000; ++k) deep += "a { ";
    EXPECT_TRUE(isRefusedWith("constant/turbulenceProperties", deep, {"turbulenceProperties", "nested too deep"}));
    EXPECT_TRUE(isRefusedWith("0/U", deep, {"0/U", "nested too deep"}));
}

/// Products overflow in the contact solver, with OpenFOAM's floating-point exceptions on.
TEST(Program, stopsInWordsAtFlowsThatNoGrainCanFollow)
{
    const std::string rolling = with(grains, "friction 0.3;", "friction 0.3; rollingFriction 0.01; spinningFriction 0.01;");
    const std::string dense = with(rolling, "count (3 3 2); diameter 0.01", "count (4 4 3); diameter 0.013");
    const ProgramCase plain;
    const std::string field = with(plain.contents("0/U"), "uniform (0 0 0)", "uniform (0 0 1e28)");
    EXPECT_TRUE(isRefused(ProgramCase(Files{{"constant/grainProperties", dense}, {"0/U", field.substr(field.find("dimensions"))}}), {"FOAM FATAL ERROR"}));
}

TEST(Program, stopsInWordsAtAMeshWhoseFilesDoNotFit)
{
    const ProgramCase c;
    const auto isRefusedWithEdit = [&](const std::string& file, const std::string& from, const std::string& to, const std::vector<std::string>& pieces)
    {
        const std::string path = "constant/polyMesh/" + file, text = c.contents(path);
        const std::size_t at = text.find(from);
        std::ofstream(c.path(path)) << std::string(text).replace(at, from.size(), to);
        const ::testing::AssertionResult result = isRefused(c, pieces);
        std::ofstream(c.path(path)) << text;
        return result;
    };
    EXPECT_TRUE(isRefusedWithEdit("owner", "\n(\n0\n", "\n(\n99999\n", {"polyMesh/owner", "leaves cell 128 too few faces"}));
    EXPECT_TRUE(isRefusedWithEdit("neighbour", "\n(\n1\n", "\n(\n99999\n", {"polyMesh/owner", "leaves cell 128 too few faces"}));
    EXPECT_TRUE(isRefusedWithEdit("points", "(0 0 0)", "(1e200 0 0)", {"polyMesh/points", "too far away"}));
    EXPECT_TRUE(isRefusedWithEdit("points", "(0 0 0)", "(1e999 0 0)", {"polyMesh/points", "no computer holds"}));
    EXPECT_TRUE(isRefusedWithEdit("owner", "\n(\n0\n", "\n(\n-1\n", {"constant/polyMesh", "cannot be read", "Illegal cell label -1"}));
    EXPECT_TRUE(isRefusedWithEdit("boundary", "startFace", "startFace 7; old", {"polyMesh/boundary", "begins patch left elsewhere"}));
    EXPECT_TRUE(succeeds(c.run()));
}

/// Cyclic patches ask for the geometry of cells as soon as they are made.
TEST(Program, stopsInWordsAtAPeriodicMeshThatIsNotWhole)
{
    BoxMeshSettings box = programBox();
    box.patchTypes = {"cyclic", "cyclic", "wall", "wall", "wall", "wall"};
    const ProgramCase c(Files(), "", box);
    const std::string path = "constant/polyMesh/points", text = c.contents(path), first = "(0 0 0)";
    std::ofstream(c.path(path)) << std::string(text).replace(text.find(first), first.size(), "(1e200 0 0)");
    EXPECT_TRUE(isRefused(c, {"polyMesh/points", "too far away"}));
    std::ofstream(c.path(path)) << text;
    std::ofstream(c.path("constant/polyMesh/owner")) << "";
    EXPECT_TRUE(isRefused(c, {"polyMesh/owner", "is missing"}));
    rm(c.path("constant/polyMesh/owner"));
    EXPECT_TRUE(isRefused(c, {"polyMesh/owner", "is missing"}));
}

/// OpenFOAM divides by what stands there, or runs for ever, once it has seen the edit (it looks for files 10 s newer; here any is seen).
TEST(Program, stopsInWordsAtAControlDictEditedWhileItRuns)
{
    const std::vector<std::pair<std::string, std::string>> edits =
    {
        {"writeInterval", "writeControl adjustableRunTime; writeInterval 0;"}, {"writeInterval", "writeControl runTime; writeInterval -1;"},
        {"deltaT", "deltaT 0;"}, {"deltaT", "deltaT 20000;"}, {"maxCo", "adjustTimeStep yes; maxCo -1;"}
    };
    for (const auto& [keyword, edit] : edits)
    {
        const std::string control = "runTimeModifiable yes; endTime 10000; writeInterval 100000000;";
        const ProgramCase c(Files{{"constant/grainProperties", grains + "fluid none;"}}, control);
        c.write("edited", "startFrom latestTime; startTime 0; stopAt endTime; deltaT 1e-3; " + control + "\n" + edit);
        EXPECT_EQ(WEXITSTATUS(inTheMidstOf(c, "touch edited; mv edited system/controlDict")), 1) << edit;
        EXPECT_TRUE(holds(c.contents("log.midst"), {"system/controlDict", "line 3", "keyword " + keyword})) << edit;
    }
}

TEST(Program, runsWithTheShortestGrainProperties)
{
    const ProgramCase c;
    EXPECT_TRUE(succeeds(c.run()));
    EXPECT_EQ(c.reported("0", "time").size(), 10u);
    EXPECT_EQ(c.reported("0", "grains").back(), 18);
    for (const char* file : {"U", "p_rgh", "p", "alpha.fluid", "phi", "lagrangian/grains/positions", "lagrangian/grains/fFluid"})
    {
        EXPECT_TRUE(isFile(c.path("0.01")/file)) << file;
    }
}

/// 10 mm/s superficially through a floor where grains leave less than all of the area to the fluid.
TEST(Program, tellsTheFlowOfEachInlet)
{
    const std::string walls = "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField { "
        "\"(left|right|bottom|top)\" { type noSlip; } back { type pressureInletOutletVelocity; value uniform (0 0 0); } ";
    const Files files
    {
        {"0/U", walls + "front { type interstitialInletVelocity; inletVelocity uniform (0 0 0.01); alpha alpha.fluid; value uniform (0 0 0); } }"},
        {"constant/grainProperties",
            "materials { glass { density 2500; } } contacts { default { friction 0.3; } } fluid solved; motion fixed; voidFraction { filterWidth 0; }"
            "grains { type lattice; box (0 0 0) (0.1 0.1 0.05); count (5 5 2); diameter 0.02; }"
            "patches { front { type wall; } back { type exit; } }"}
    };
    const ProgramRun run = ProgramCase(files).run();
    EXPECT_TRUE(succeeds(run));
    // 25 grains of 0.02 m in a layer of cells 0.025 m high: 1 - pi/6 0.02^3/0.025/0.02^2 = 0.5811 of the volume is fluid's.
    EXPECT_TRUE(holds(run.log, {"front: 0.01 m/s superficial, 0.01721 m/s interstitial (alpha.fluid 0.5811), 0.0001 m3/s"})) << run.log;
    EXPECT_EQ(ProgramCase().run().log.find("superficial"), std::string::npos);
}

/// As the Allrun and Allclean of OpenFOAM's tutorials do.
TEST(Program, isRunByTheFunctionsOfOpenFOAMsTutorials)
{
    const ProgramCase c;
    std::ofstream(c.path("Allrun")) << "cd " << c.path("") << "\n. $WM_PROJECT_DIR/bin/tools/RunFunctions\nrunApplication $(getApplication)\n"
        << ". $WM_PROJECT_DIR/bin/tools/CleanFunctions\ntest -e log.nscdDEMFoam && grep End log.nscdDEMFoam && cleanTimeDirectories\n";
    EXPECT_EQ(std::system(("bash " + c.path("Allrun") + " > /dev/null 2>&1").c_str()), 0);
    EXPECT_EQ(c.latestTime(), "0");
}

TEST(Program, takesTheReferenceOfThePressureThatACaseNames)
{
    const std::string named = with(solutionWith(2), "nCorrectors 2;", "nCorrectors 2; pRefCell 3; pRefValue 7;");
    const ProgramRun run = ProgramCase(Files{{"system/fvSolution", named}}).run();
    EXPECT_TRUE(succeeds(run));
    EXPECT_EQ(run.log.find("already exists"), std::string::npos) << run.log;
}

TEST(Program, runsWithoutFluidFields)
{
    Files files;
    for (const char* file : {"constant/transportProperties", "constant/turbulenceProperties", "0/U", "0/p_rgh"}) files[file] = "";
    files["constant/grainProperties"] = grains + "fluid none;";
    const ProgramCase c(files);
    EXPECT_TRUE(succeeds(c.run()));
    // Free fall of all grains: z falls by g dt^2 n(n+1)/2 in n steps of the symplectic Euler scheme.
    const std::vector<double> z = c.reported("0", "massCenterZ");
    ASSERT_EQ(z.size(), 10u);
    EXPECT_NEAR(z[9] - z[0], -9.81e-6*(55 - 1), 1e-12);
}

TEST(Program, runsWithoutGrains)
{
    const ProgramCase c(Files{{"constant/grainProperties", "materials { glass { density 1; } } contacts {} grains {}"}});
    EXPECT_TRUE(succeeds(c.run()));
    EXPECT_EQ(c.reported("0", "grains").back(), 0);
}

TEST(Program, drivesGrainsAlongTheIntegralOfTheirVelocity)
{
    // From 0 to 1 m/s within the 10 ms of the run: 5 mm up, whatever the steps within a step, and whatever falls on them.
    const std::string driven = "driven { a { ids (0 5); velocity table ((0 (0 0 0)) (0.01 (0 0 1))); omega (0 0 4); } } ";
    const ProgramCase held(Files{{"constant/grainProperties", grains + "driven { a { ids (0 5); velocity (0 0 0); } } fluid none;"}}, "writePrecision 12;");
    EXPECT_TRUE(succeeds(held.run()));
    const List<vector> start = grainVectors(held, "position");
    for (const std::string more : {"fluid none; timeStep { subCycles 3; }", ""})
    {
        const ProgramCase c(Files{{"constant/grainProperties", grains + driven + more}}, "writePrecision 12;");
        EXPECT_TRUE(succeeds(c.run()));
        const List<vector> position = grainVectors(c, "position");
        for (const label id : {0, 5})
        {
            EXPECT_NEAR(position[id].z(), start[id].z() + 0.005, 1e-10);
            EXPECT_NEAR(grainVectors(c, "omega")[id].z(), 4, 1e-10);
        }
        EXPECT_LT(position[1].z(), start[0].z() + 0.001);
    }
}

TEST(Program, letsFixedGrainsGoWhenTold)
{
    // Of 10 steps of 1 ms the last six are free; what is driven stays so. From a restart without the grain that was driven, that one falls too.
    const std::string fixed = "motion fixed; fixedUntil 0.004; fluid none; ";
    const ProgramCase c(Files{{"constant/grainProperties", grains + fixed + "driven { a { ids (5); velocity (0 0 0); } }"}}, "writePrecision 12;");
    EXPECT_TRUE(succeeds(c.run()));
    const List<vector> first = grainVectors(c, "U");
    EXPECT_NEAR(first[1].z(), -0.006*9.81, 1e-9);
    EXPECT_EQ(first[5], vector::zero);
    c.write("constant/grainProperties", grains + fixed);
    c.writeControl("endTime 0.02; writePrecision 12;");
    EXPECT_TRUE(succeeds(c.run()));
    const List<vector> second = grainVectors(c, "U");
    EXPECT_NEAR(second[1].z(), -0.016*9.81, 1e-9);
    EXPECT_NEAR(second[5].z(), -0.01*9.81, 1e-9);
}

TEST(BadStart, fixedGrainsThatAreLetGoMayNotOverlap)
{
    const std::string overlapping = "materials { glass { density 2500; } } contacts { default { friction 0.3; } } fluid none; motion fixed; "
        "grains { type lattice; box (0.04 0.04 0.04) (0.06 0.06 0.06); count (2 1 1); diameter 0.012; } patches { front { type wall; } back { type exit; } } ";
    EXPECT_TRUE(succeeds(ProgramCase(Files{{"constant/grainProperties", overlapping}}).run()));
    EXPECT_TRUE(isRefusedWith("constant/grainProperties", overlapping + "fixedUntil 0.5;", {"maxInitialOverlap", "grains 0 and 1 overlap"}));
}

TEST(BadStart, drivenGrainsMustBeThere)
{
    EXPECT_TRUE(isRefusedWith("constant/grainProperties", grains + "driven { a { ids (3 18); velocity (0 0 1); } }", {"driven.a", "not there"}));
}

/// The fluid's equation has the factor alpha before the pressure's gradient all the same.
TEST(Program, saysThatAForceLeftOutIsMomentumLost)
{
    const auto log = [](const std::string& more) { return ProgramCase(Files{{"constant/grainProperties", grains + more}}).run().log; };
    EXPECT_TRUE(holds(log("forces { pressureGradient off; viscous off; }"), {"pressureGradient, viscous off: the fluid loses momentum"}));
    EXPECT_TRUE(holds(log("forces { viscous off; }"), {" viscous off: the fluid loses momentum"}));
    EXPECT_EQ(log("forces { viscous off; } feedback off;").find("loses momentum"), std::string::npos);
    EXPECT_EQ(log("").find("loses momentum"), std::string::npos);
}

TEST(Program, runsWithTheDragSwitchedOffAndSubCycles)
{
    const ProgramCase c(Files{{"constant/grainProperties", grains + "forces { drag { law none; } } timeStep { subCycles 3; }"}});
    EXPECT_TRUE(succeeds(c.run()));
}

namespace
{

const std::string schemes =
    "gradSchemes { default Gauss linear; } laplacianSchemes { default Gauss linear corrected; }"
    "interpolationSchemes { default linear; } snGradSchemes { default corrected; }";
const std::string divSchemes = "divSchemes { default Gauss linear; }";

std::string solvers(const std::string& pressure, const std::string& velocity)
{
    const std::string rest = "preconditioner none; tolerance 1e-9; relTol 0; }";
    return "solvers { " + pressure + " " + rest + velocity + " " + rest + " } PIMPLE { nCorrectors 2; }";
}

} // namespace

namespace
{

/// Grains that fall into a slanted vessel one cell thick, full of water.
ProgramCase flatVessel(const std::string& shape)
{
    BoxMeshSettings box = programBox();
    box.cells = labelVector(5, 8, 1);
    box.max = point(0.1, 0.2, 0.02);
    box.patchTypes = {"wall", "wall", "wall", "patch", "empty", "empty"};
    box.movePoint = [](const point& x) { return point(x.x() + 0.2*x.y(), x.y() - 0.1*x.x(), x.z()); };
    const std::string flat = "\"(front|back)\" { type empty; } \"(left|right|bottom)\" ";
    return ProgramCase
    ({
        {"constant/grainProperties",
            shape + "materials { glass { density 2500; } } contacts { default { friction 0.3; } } grains { type lattice; "
            "box (0.03 0 0) (0.1 0.15 0.02); count (4 9 1); diameter 0.0155; spread 0.03; jitter 0.5; velocity (0.1 -0.5 0); } patches { top { type exit; } }"},
        {"constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);"},
        {"0/U", "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField { " + flat
          + "{ type noSlip; } top { type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0); } }"},
        {"0/p_rgh",
            "dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0; boundaryField { " + flat
          + "{ type fixedFluxPressure; value uniform 0; } top { type fixedValue; value uniform 0; } }"}
    }, "endTime 0.03;", box);
}

void expectMotionInThePlane(const ProgramCase& c)
{
    EXPECT_TRUE(succeeds(c.run()));
    EXPECT_GT(c.reported("0", "contacts").back(), 4);
    vector across(Zero);
    for (const vector& u : grainVectors(c, "U")) across.z() = max(across.z(), mag(u.z()));
    for (const vector& spin : grainVectors(c, "omega"))
    {
        across.x() = max(across.x(), mag(spin.x()));
        across.y() = max(across.y(), mag(spin.y()));
    }
    EXPECT_EQ(across, vector(Zero));
}

} // namespace

TEST(Program, keepsDiscsInTheirPlane)
{
    expectMotionInThePlane(flatVessel(""));
}

TEST(Program, keepsSpheresInTheirPlane)
{
    const ProgramCase c = flatVessel("shape sphere; ");
    expectMotionInThePlane(c);
    EXPECT_NEAR(c.reported("0", "solidVolume").back()/c.reported("0", "grainVolume").back(), 1, 1e-9);
}

TEST(Program, stopsAtSchemesThatAreMissingOrUnknown)
{
    const std::string file = "system/fvSchemes";
    EXPECT_TRUE(isRefusedWith(file, "ddtSchemes {}" + divSchemes + schemes, {"fvSchemes", "ddt"}));
    EXPECT_TRUE(isRefusedWith(file, "ddtSchemes { default Eulr; }" + divSchemes + schemes, {"fvSchemes", "Eulr", "Euler"}));
    EXPECT_TRUE(isRefusedWith(file, "ddtSchemes { default steadyState; }" + divSchemes + schemes,
        {"fvSchemes", "ddtSchemes", "steadyState", "no time step"}));
    EXPECT_TRUE(isRefusedWith(file, "ddtSchemes { default Euler; } divSchemes {}" + schemes, {"fvSchemes", "div(phi,U)"}));
}

TEST(Program, stopsAtSolversThatAreMissingOrUnknown)
{
    const std::string file = "system/fvSolution";
    const std::string velocity = "\"U.*\" { solver PBiCGStab;", pressure = "\"p_rgh.*\" { solver PCG;";
    EXPECT_TRUE(isRefusedWith(file, solvers("p_rgh { solver PCG;", velocity), {"fvSolution", "p_rghFinal"}));
    EXPECT_TRUE(isRefusedWith(file, solvers(pressure, "U { solver PBiCGStab;"), {"fvSolution", "UFinal"}));
    EXPECT_TRUE(isRefusedWith(file, solvers("\"p_rgh.*\" { solver PCC;", velocity), {"fvSolution", "PCC", "nearest: PCG"}));
    EXPECT_TRUE(isRefusedWith(file, solvers(pressure, "\"U.*\" { solver PCG;"), {"fvSolution", "PCG", "PBiCGStab"}));
}

/// A solver that is content at once leaves the fluid as it is; of minIter it is not asked.
TEST(Program, stopsAtTolerancesThatSolveNothing)
{
    const auto solution = [](const std::string& pressure, const std::string& velocity)
    {
        return "solvers { \n\"p_rgh.*\" { solver PCG; preconditioner DIC; " + pressure + " }\n\"U.*\" { solver PBiCGStab; preconditioner DILU; " + velocity
            + " } } PIMPLE { nCorrectors 2; }";
    };
    const std::string file = "system/fvSolution", right = "tolerance 1e-9; relTol 0.1;";
    EXPECT_TRUE(isRefusedWith(file, solution("tolerance 1e-9; relTol 1e12;", right), {file, "line 3", "relTol is out of range", "1e+12", ">= 0 and <= 1"}));
    EXPECT_TRUE(isRefusedWith(file, solution(right, "tolerance 1e-9; relTol 1.5;"), {file, "line 4", "relTol is out of range", "<= 1"}));
    EXPECT_TRUE(isRefusedWith(file, solution(right, "tolerance 1e-9; relTol -0.1;"), {file, "line 4", "relTol is out of range", ">= 0"}));
    EXPECT_TRUE(isRefusedWith(file, solution("tolerance 1e3; relTol 0;", right), {file, "line 3", "tolerance is out of range", "<= 1"}));
    EXPECT_TRUE(succeeds(ProgramCase(Files{{file, solution(right, "tolerance 2; relTol 2; minIter 3;")}}).run()));
}

TEST(Program, stopsAtWhatTheTurbulenceModelLacks)
{
    const auto field = [](const std::string& dimensions, const std::string& value)
    {
        return "dimensions " + dimensions + "; internalField uniform " + value
            + "; boundaryField { \".*\" { type zeroGradient; } }";
    };
    Files files =
    {
        {"constant/turbulenceProperties", "simulationType LES; LES { LESModel kEqn; turbulence on; printCoeffs off;"
            " delta cubeRootVol; cubeRootVolCoeffs { deltaCoeff 1; } }"},
        {"0/nut", field("[0 2 -1 0 0 0 0]", "0")}
    };
    EXPECT_TRUE(isRefused(ProgramCase(files), {"0/k"}));
    files["0/k"] = field("[0 2 -3 0 0 0 0]", "1e-4");
    EXPECT_TRUE(isRefused(ProgramCase(files), {"0/k", "are wrong for k", "m2/s2"}));
    files["0/k"] = field("[0 2 -2 0 0 0 0]", "-1");
    EXPECT_TRUE(isRefused(ProgramCase(files), {"0/k", "internalField is out of range", ">= 0"}));
    files["0/k"] = field("[0 2 -2 0 0 0 0]", "1e200");
    EXPECT_TRUE(isRefused(ProgramCase(files), {"0/k", "internalField holds a number that is too large"}));
    files["0/epsilon"] = field("[0 2 -3 0 0 0 0]", "0");
    files["0/k"] = field("[0 2 -2 0 0 0 0]", "1e-4");
    EXPECT_TRUE(isRefused(ProgramCase(files), {"0/epsilon", "internalField is out of range", "> 0"}));
    files.erase("0/epsilon");
    EXPECT_TRUE(isRefused(ProgramCase(files), {"fvSolution", "kFinal"}));
    const std::string rest = "preconditioner none; tolerance 1e-9; relTol 0; }";
    files["system/fvSolution"] =
        "solvers { \"p_rgh.*\" { solver PCG; " + rest + "\"(U|k).*\" { solver PBiCGStab; " + rest + "} PIMPLE {}";
    EXPECT_TRUE(succeeds(ProgramCase(files).run()));
    files["system/fvSchemes"] =
        "ddtSchemes { default Euler; } divSchemes { div(phi,U) Gauss upwind; div((nuEff*dev2(T(grad(U))))) Gauss linear; }"
        + schemes;
    EXPECT_TRUE(isRefused(ProgramCase(files), {"fvSchemes", "div(phi,k)"}));
}

TEST(Program, refusesToBeOneOfManyThatRunTheWholeCase)
{
    setEnv("OMPI_COMM_WORLD_SIZE", "2", true);
    EXPECT_TRUE(isRefused(ProgramCase(), {"without the option -parallel", "one rank only"}));
    unsetenv("OMPI_COMM_WORLD_SIZE");
}

namespace
{

/// Files of one written time that two runs must share to the bit, grainState with its numbers among them.
const std::vector<std::string> stateFiles =
{
    "lagrangian/grains/position", "lagrangian/grains/U", "lagrangian/grains/omega", "lagrangian/grains/orientation",
    "lagrangian/grains/fContact", "lagrangian/grains/dragDebt", "lagrangian/contacts/impulse", "lagrangian/contacts/idB",
    "uniform/grainState"
};

/// A run of 20 steps, and one of 10 and 10: the files of the last time that differ.
std::vector<std::string> filesThatDiffer
(
    const std::string& properties, const std::string& control, const std::vector<std::string>& files
)
{
    const Files start{{"constant/grainProperties", properties}};
    const std::string common = "writeFormat binary; writeInterval 10; " + control;
    const ProgramCase parts(start, common + " stopAt nextWrite; endTime 1;");
    for (const ProgramRun& run : {parts.run(), parts.run()}) EXPECT_TRUE(succeeds(run));
    const std::string last = parts.latestTime();
    const ProgramCase whole(start, common + " endTime " + last + ";");
    EXPECT_TRUE(succeeds(whole.run()));
    EXPECT_EQ(whole.reported("0", "time").size(), 20u);
    EXPECT_GT(whole.reported("0", "contacts").at(9), 0);
    const std::vector<double> deltaT = whole.reported("0", "deltaT");
    EXPECT_EQ(deltaT.at(9) != deltaT.at(10), control.find("adjustTimeStep") != std::string::npos);

    std::vector<std::string> different;
    for (const std::string& file : files)
    {
        const std::string contents = whole.contents(last + "/" + file);
        if (contents.empty() || contents != parts.contents(last + "/" + file)) different.push_back(file);
    }
    return different;
}

const std::string restingGrains =
    "materials { glass { density 2500; } } contacts { default { friction 0.3; restitution 0.4; } }"
    "grains { type lattice; box (0 0 0) (0.1 0.1 0.06); count (5 5 3); diameter 0.0199; spread 0.003; jitter 0.8; "
    "velocity (0.3 0.1 -0.5); }"
    "patches { front { type wall; } back { type exit; } } ";

} // namespace

TEST(Program, aDryRunGoesOnFromAWrittenTimeAsIfNeverStopped)
{
    EXPECT_EQ(filesThatDiffer(restingGrains + "fluid none;", "", stateFiles), std::vector<std::string>());
}

TEST(Program, aRunWithRollingFrictionAndCohesionGoesOnFromAWrittenTimeAsIfNeverStopped)
{
    const std::string plain = "friction 0.3; restitution 0.4;";
    const std::string properties = with(restingGrains, plain, plain + " rollingFriction 0.05; spinningFriction 0.02; cohesion 0.05;");
    std::vector<std::string> files = stateFiles;
    files.push_back("lagrangian/contacts/rolling");
    EXPECT_EQ(filesThatDiffer(properties, "", files), std::vector<std::string>());
}

TEST(Program, aRunWithFilmsBetweenGrainsGoesOnFromAWrittenTimeAsIfNeverStopped)
{
    const std::string plain = "friction 0.3; restitution 0.4;";
    EXPECT_EQ(filesThatDiffer(with(restingGrains, plain, plain + " roughness 1e-5; lubricationRange 1e-3;"), "", stateFiles), std::vector<std::string>());
}

TEST(Program, aCoupledRunGoesOnFromAWrittenTimeAsIfNeverStopped)
{
    std::vector<std::string> files = stateFiles;
    for (const char* field : {"U", "p_rgh", "phi", "alpha.fluid"}) files.push_back(field);
    EXPECT_EQ(filesThatDiffer(restingGrains, "", files), std::vector<std::string>());
}

TEST(Program, aRunWithLiftGoesOnFromAWrittenTimeAsIfNeverStopped)
{
    std::vector<std::string> files = stateFiles;
    for (const char* field : {"lagrangian/grains/fFluid", "U", "p_rgh"}) files.push_back(field);
    EXPECT_EQ(filesThatDiffer(restingGrains + "forces { saffmanLift on; magnusLift on; }", "", files), std::vector<std::string>());
}

TEST(Program, aRunWithAHistoryOfSlipsGoesOnFromAWrittenTimeAsIfNeverStopped)
{
    std::vector<std::string> files = stateFiles;
    for (const char* field : {"lagrangian/grains/slipHistory12", "U", "p_rgh"}) files.push_back(field);
    EXPECT_EQ(filesThatDiffer(restingGrains + "forces { addedMass on; basset on; }", "", files), std::vector<std::string>());
}

TEST(Program, aRunWithAdjustedStepsGoesOnFromAWrittenTimeAsIfNeverStopped)
{
    const std::string control = "writePrecision 6; adjustTimeStep yes; maxCo 0.004;";
    EXPECT_EQ(filesThatDiffer(restingGrains, control, stateFiles), std::vector<std::string>());
}

TEST(Program, anAsciiRestartGoesOnToTheWritePrecision)
{
    // A solve that stops by a coarse tolerance may stop a sweep earlier for the last digit of its start.
    const std::string solver = "solver { tolerance 1e-9; displacementTolerance 1e-12; maxSweeps 100000; } fluid none;";
    const Files start{{"constant/grainProperties", restingGrains + solver}};
    const ProgramCase whole(start, "endTime 0.02;"), parts(start);
    for (const ProgramRun& run : {whole.run(), parts.run()}) EXPECT_TRUE(succeeds(run));
    parts.writeControl("endTime 0.02;");
    EXPECT_TRUE(succeeds(parts.run()));
    const double energy = whole.reported("0", "kineticEnergy").at(19);
    EXPECT_GT(whole.reported("0", "contacts").at(9), 0);
    // Twelve digits are written; shocks magnify what is lost.
    EXPECT_NEAR(parts.reported("0.01", "kineticEnergy").at(9), energy, 1e-8*energy);
}

TEST(Program, saysWhatItDoesWithoutBeingAskedFor)
{
    const auto noteIsSaid = [](const Files& files, const std::string& words)
    {
        const std::string log = ProgramCase(files).run().log;
        const std::size_t first = log.find(words);
        return first != std::string::npos && log.find(words, first + 1) == std::string::npos;
    };
    EXPECT_TRUE(noteIsSaid({{"constant/transportProperties", "transportModel Newtonian; nu 1e-5; rho 1;"}}, "Note: weak drag in a light fluid"));
    EXPECT_TRUE(noteIsSaid({{"constant/grainProperties", grains + "voidFraction { minFluidFraction 0.95; }"}}, "Note: cells are fuller"));
    EXPECT_TRUE(noteIsSaid({{"constant/grainProperties", with(restingGrains, "(0.3 0.1 -0.5)", "(0 0 -1)")}}, "Note: grains took other momentum"));
    EXPECT_EQ(ProgramCase().run().log.find("Note: weak"), std::string::npos);
}

/// A start in which viscosity reaches across eight cells: one correction of the pressure leaves the momentum balance open, eight do not.
TEST(Program, warnsOfViscosityThatCorrectionsDoNotFollow)
{
    const auto warns = [](int correctors, const std::string& nu)
    {
        const Files files{{"constant/transportProperties", "transportModel Newtonian; rho 1000; nu " + nu + ";"}, {"system/fvSolution", solutionWith(correctors)}};
        return ProgramCase(files, "endTime 1e-3; ").run().log.find("Warning: corrections of the pressure") != std::string::npos;
    };
    EXPECT_TRUE(warns(1, "40"));
    EXPECT_FALSE(warns(8, "40"));
    EXPECT_FALSE(warns(1, "1e-2"));
}

/// Half outside, where the mesh has no wall: what of its body is above the outlet, and the error that its whole volume inside is.
TEST(Program, countsWhatOfAGrainIsOutsideTheMesh)
{
    const std::string alone = "materials { glass { density 2500; } } contacts { default { friction 0.3; } }"
        "patches { front { type wall; } back { type exit; } }"
        "grains { type lattice; box (0.045 0.045 0.1949) (0.055 0.055 0.2049); count (1 1 1); diameter 0.01; }";
    const ProgramCase c(Files{{"constant/grainProperties", alone}}, "endTime 0.001;");
    const ProgramRun run = c.run();
    EXPECT_TRUE(succeeds(run));
    const auto reported = [&](const char* column) { return c.reported("0", column).at(0); };
    const double inside = (0.2 - reported("massCenterZ"))/0.005, outside = (2 + inside)*sqr(1 - inside)/4;
    EXPECT_GT(outside, 0.4);
    EXPECT_NEAR(reported("volumeOutside")/reported("grainVolume"), outside, 1e-9);
    EXPECT_NEAR(reported("volumeError"), outside, 1e-9);
    EXPECT_NEAR(reported("solidVolume")/reported("grainVolume"), 1, 1e-12);
    EXPECT_TRUE(holds(run.log, {"Warning: grains are partly outside the mesh", "worst volume error     0.4", "grains outside the mesh 1 steps"}));
    const ProgramCase plain;
    EXPECT_TRUE(succeeds(plain.run()));
    for (const double error : plain.reported("0", "volumeError")) EXPECT_LT(error, 1e-12);
}

/// What somebody has changed since the time was written, and what another run is about to write.
TEST(Program, refusesToGoOnFromWhatDoesNotFit)
{
    const std::string properties = grains + "fluid none;";
    const ProgramCase c(Files{{"constant/grainProperties", properties}});
    EXPECT_TRUE(succeeds(c.run()));
    c.writeControl("endTime 0.02;");
    const auto isRefusedNow = [&](const std::vector<std::string>& pieces)
    {
        const ProgramRun run = c.run();
        return run.status == 1 ? holds(run.log, pieces) : ::testing::AssertionFailure() << run.status << ": " << run.log;
    };
    c.write("constant/grainProperties", properties + " planes { lid { point (0 0 0.04); normal (0 0 -1); } }");
    EXPECT_TRUE(isRefusedNow({"maxInitialOverlap is exceeded by", "and the wall lid overlap", "up to 0.1 of the smaller diameter"}));
    c.write("constant/grainProperties", properties);

    const fileName ids = "0.01/lagrangian/grains/origId";
    const std::string text = c.contents(ids);
    const std::size_t list = text.find("\n1\n2\n");
    ASSERT_NE(list, std::string::npos) << text;
    std::ofstream(c.path(ids)) << std::string(text).replace(list, 5, "\n1\n1\n");
    EXPECT_TRUE(isRefusedNow({"lagrangian/grains/origId", "names two grains alike", "value:   1"}));
    std::ofstream(c.path(ids)) << text;
    {
        const ::nscd::FolderLock other(c.path(""));
        EXPECT_TRUE(isRefusedNow({"another run is writing into the folder"}));
    }
    EXPECT_TRUE(succeeds(c.run()));
}

TEST(Program, looksForGrainsOutsideTheMeshWhenItGoesOn)
{
    const ProgramCase c;
    EXPECT_TRUE(succeeds(c.run()));
    c.writeControl("endTime 0.02;");
    const fileName file = "0.01/lagrangian/grains/position";
    const std::string text = c.contents(file);
    const std::size_t begin = text.find("\n(\n(") + 3, end = text.find('\n', begin);
    const auto put = [&](const std::string& position) { std::ofstream(c.path(file)) << std::string(text).replace(begin, end - begin, position); };
    put("(1 1 1)");
    const ProgramRun far = c.run();
    EXPECT_EQ(far.status, 1);
    EXPECT_TRUE(holds(far.log, {"lagrangian/grains/position", "puts a grain outside the mesh", "grain 0 at (1 1 1)"})) << far.log;
    // Behind the outlet, by less than a diameter: gone, as one that has just left.
    put("(0.05 0.05 0.2001)");
    ASSERT_TRUE(succeeds(c.run()));
    EXPECT_EQ(c.reported("0.01", "grains").front(), 17);
    EXPECT_EQ(c.reported("0.01", "exited").front(), 1);
}

TEST(Program, goesOnWhenAllGrainsHaveLeft)
{
    for (const char* fluid : {"none", "solved"})
    {
        const ProgramCase c(Files
        {
            {"constant/grainProperties", with(restingGrains, "(0.3 0.1 -0.5)", "(0 0 30)") + "fluid " + fluid + ";"},
            {"constant/transportProperties", "transportModel Newtonian; nu 1e-5; rho 1;"}
        });
        EXPECT_TRUE(succeeds(c.run()));
        EXPECT_EQ(c.reported("0", "grains").front(), 75) << fluid;
        EXPECT_EQ(c.reported("0", "grains").back(), 0) << fluid;
        EXPECT_EQ(c.reported("0", "exited").back(), 75) << fluid;
        c.writeControl("endTime 0.012;");
        EXPECT_TRUE(succeeds(c.run()));
        EXPECT_EQ(c.reported("0.01", "exited").back(), 75) << fluid;
    }
}

TEST(Program, goesOnAsOneThatNeverHadGrainsWhenAllHaveLeft)
{
    const Files start
    {
        {"constant/grainProperties", with(restingGrains, "(0.3 0.1 -0.5)", "(0 0 30)")},
        {"constant/transportProperties", "transportModel Newtonian; nu 1e-5; rho 1;"}
    };
    const std::string binary = "writeFormat binary; writeInterval 10; ";
    const ProgramCase whole(start, binary + "endTime 0.02;"), parts(start, binary), bare(start, binary);
    for (const ProgramRun& run : {whole.run(), parts.run()}) EXPECT_TRUE(succeeds(run));
    EXPECT_EQ(whole.reported("0", "grains").at(8), 0);

    bare.write("constant/grainProperties", "materials { glass { density 2500; } } contacts { default { friction 0.3; } } grains {}");
    mkDir(bare.path("0.01"));
    for (const char* field : {"U", "p_rgh", "phi"}) EXPECT_TRUE(cp(parts.path(fileName("0.01")/field), bare.path(fileName("0.01")/field)));
    for (const ProgramCase* c : {&parts, &bare})
    {
        c->writeControl(binary + "endTime 0.02;");
        EXPECT_TRUE(succeeds(c->run()));
        for (const char* field : {"U", "p_rgh", "phi"})
        {
            EXPECT_FALSE(whole.contents(fileName("0.02")/field).empty());
            EXPECT_EQ(whole.contents(fileName("0.02")/field) == c->contents(fileName("0.02")/field), true) << field << (c == &bare);
        }
    }
    double speed = 0;
    for (const double number : whole.reported("0", "courantMax")) speed = std::max(speed, number);
    EXPECT_GT(speed, 1e-3);   // there is a flow to compare
}

TEST(Program, theCloudIsReadByOpenFOAMsOwnTools)
{
    const ProgramCase c(Files{{"constant/grainProperties", restingGrains}});
    EXPECT_TRUE(succeeds(c.run()));
    EXPECT_TRUE(succeeds(c.run("foamToVTK", "-latestTime -ascii")));
    const std::string cloud = c.contents("VTK/lagrangian/grains/grains_10.vtp");
    EXPECT_NE(cloud.find("NumberOfPoints='75'"), std::string::npos) << cloud.substr(0, 500);
    for (const char* field : {"fContact", "fFluid", "omega", "'d'"}) EXPECT_NE(cloud.find(field), std::string::npos) << field;
}
