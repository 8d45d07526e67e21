// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of grainProperties as text: what a short one means, and what is said about bad ones.
#include "caseTools.H"

#include "coupling/case/input/foamDictionary.H"
#include "coupling/case/input/grainProperties.H"
#include "coupling/case/walls/patchRoles.H"

#include "input/dictionary/checkedEntries.hpp"
#include "input/dictionary/withoutTraps.hpp"

#include <fstream>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

const std::string glass = "materials { glass { density 2500; } steel {} }\n";
const std::string contacts = "contacts { default { friction 0.3; } }\n";
const std::string lattice =
    "grains { type lattice; box (0 0 0) (0.1 0.1 0.1); count (2 3 4); diameter 0.01; material glass; }\n";
const std::string first = glass + contacts + lattice;

GrainProperties read(const std::string& text)
{
    return readGrainProperties(dictionaryOf(text));
}

std::string complaintAbout(const std::string& text)
{
    return complaint([&] { read(text); });
}

} // namespace

TEST(GrainProperties, aShortFileGetsDefaults)
{
    const GrainProperties p = read(first);
    ASSERT_EQ(p.sources.size(), 1u);
    EXPECT_EQ(p.materials.density[p.sources[0].material], 2500);
    EXPECT_EQ(p.materials.table.pair(0, 1).friction, 0.3);
    EXPECT_EQ(p.materials.table.pair(0, 1).restitution, 0);
    EXPECT_EQ(p.sources[0].lattice.count, (std::array<int, 3>{2, 3, 4}));
    EXPECT_EQ(p.contact.solver, nscd::ContactSettings().solver);
    EXPECT_EQ(p.contact.tolerance, nscd::ContactSettings().tolerance);
    EXPECT_EQ(p.voidFraction.method, "exact");
    EXPECT_TRUE(p.solvesFluid && p.hasFeedback && p.forces.isOn("drag"));
    for (const char* force : {"pressureGradient", "viscous", "spinDrag"}) EXPECT_TRUE(p.forces.isOn(force)) << force;
    EXPECT_FALSE(p.holdsMeanFlow);
}

TEST(GrainProperties, everyValueArrivesWhereItBelongs)
{
    const GrainProperties p = read
    (
        glass + "contacts { default { friction 0.3; restitution 0.1; } steel-glass { friction 0.2; restitution 0.9; } }"
        "grains { a { type table; file \"a.txt\"; material glass; velocity (1 2 3); }"
        "         b { type positionsFile; file b; diameter 2e-3; material glass; motion free; omega (0 0 4); } }"
        "motion fixed; maxInitialOverlap 0.5; shape disc; wallMaterial steel; patches { outlet { type exit; } }"
        "planes { floor { point (0 0 -1); normal (0 0 2); material glass; } }"
        "solver { type queue; tolerance 1e-3; displacementTolerance 2e-3; maxSweeps 7; deadBand 3e-3;"
        "         overlapTolerance 4e-3; skin 5e-3; accelerate no; vectorPath portable; }"
        "voidFraction { method satellite; diffusion 3; minFluidFraction 0.3; }"
        "forces { drag { law DiFelice; weight backwardEuler; } pressureGradient off; viscous off; }"
        "fluid none; feedback off; meanFlow (0 0 0.5); timeStep { maxGrainDisplacement 0.2; maxGrainImpacts 0.4; subCycles 3; }"
    );
    EXPECT_EQ(p.materials.table.pair(1, 0).friction, 0.2);
    EXPECT_EQ(p.materials.table.pair(0, 1).restitution, 0.9);
    EXPECT_EQ(p.materials.table.pair(0, 0).restitution, 0.1);
    EXPECT_EQ(p.sources[0].velocity, nscd::Vec3(1, 2, 3));
    EXPECT_TRUE(p.sources[0].isFixed);
    EXPECT_FALSE(p.sources[1].isFixed);
    EXPECT_EQ(p.sources[1].omega, nscd::Vec3(0, 0, 4));
    EXPECT_EQ(p.sources[1].diameter, 2e-3);
    EXPECT_EQ(p.maxInitialOverlap, 0.5);
    EXPECT_EQ(p.wallMaterial, 1);
    ASSERT_EQ(p.patchRules.size(), 1u);
    EXPECT_TRUE(p.patchRules[0].isExit);
    EXPECT_EQ(p.walls.regions.at(0).normal, nscd::Vec3(0, 0, 1));
    EXPECT_EQ(p.walls.patches.at(0).name, "floor");
    EXPECT_EQ(p.walls.patches.at(0).material, 0);
    EXPECT_EQ(p.contact.solver, "queue");
    EXPECT_EQ(p.contact.tolerance, 1e-3);
    EXPECT_EQ(p.contact.displacementTolerance, 2e-3);
    EXPECT_EQ(p.contact.maxSweeps, 7);
    EXPECT_EQ(p.contact.deadBand, 3e-3);
    EXPECT_EQ(p.contact.overlapTolerance, 4e-3);
    EXPECT_EQ(p.contact.skin, 5e-3);
    EXPECT_FALSE(p.contact.accelerate);
    EXPECT_EQ(p.contact.vectorPath, "portable");
    EXPECT_EQ(p.voidFraction.method, "satellite");
    EXPECT_EQ(p.voidFraction.forMapping(0.5, 1).get<scalar>("diffusionLength"), 1.5);
    EXPECT_EQ(p.voidFraction.forMapping(0.5, 1).get<scalar>("minFluidFraction"), 0.3);
    EXPECT_EQ(p.forces.drag.law, "DiFelice");
    EXPECT_EQ(p.forces.drag.weight, "backwardEuler");
    EXPECT_FALSE(p.forces.isOn("pressureGradient") || p.forces.isOn("viscous") || p.solvesFluid || p.hasFeedback);
    EXPECT_TRUE(p.forces.isOn("spinDrag"));
    EXPECT_EQ(p.forces.switches.at("viscous").place.keyword, "forces.viscous");
    EXPECT_FALSE(read(first + "forces { drag { law none; } }").forces.isOn("drag"));
    EXPECT_EQ(p.meanFlowDict().get<vector>("target"), vector(0, 0, 0.5));
    EXPECT_EQ(p.time.maxGrainDisplacement, 0.2);
    EXPECT_EQ(p.time.maxGrainImpacts, 0.4);
    EXPECT_EQ(p.time.subCycles, 3);
}

/// A bed of discs leaves less between them than one of spheres does; what a case gives counts.
TEST(GrainProperties, discsMayLeaveLessFluidInACell)
{
    input::Surroundings flat;
    flat.shape.dimensions = 2;
    flat.shape.emptyAxis = 2;
    const auto least = [&](const input::Surroundings& around, const std::string& more)
    {
        return readGrainProperties(dictionaryOf(first + more), around).voidFraction.minFluidFraction;
    };
    EXPECT_EQ(least(flat, ""), 0.1);
    EXPECT_EQ(least(flat, "shape sphere;"), 0.2);
    EXPECT_EQ(least(flat, "voidFraction { minFluidFraction 0.25; }"), 0.25);
    EXPECT_EQ(least(input::Surroundings(), ""), 0.2);
}

// Not where a case says how much to smooth, nor where nothing is read of the solid fraction.
TEST(GrainProperties, smallAndThinCellsAreWidenedUnlessACaseSaysHowMuch)
{
    const scalar d = 1e-3;
    const auto given = [&](const std::string& more, scalar cellSize = 3)
    {
        const dictionary dict = read(first + more).voidFraction.forMapping(d, cellSize*d);
        return scalarList{dict.getOrDefault<scalar>("filterWidth", 0)/d, dict.getOrDefault<scalar>("diffusionLength", 0)/d,
            dict.getOrDefault<scalar>("thinCell", -d)/d};
    };
    EXPECT_EQ(given(""), (scalarList{2, 0, 0.5}));
    EXPECT_EQ(given("", 1.75*(1 - 1e-9)), (scalarList{2, 0, 0.5}));
    EXPECT_EQ(given("", 1.74), (scalarList{2, 0, -1}));
    EXPECT_EQ(given("voidFraction { filterWidth 3; }"), (scalarList{3, 0, -1}));
    EXPECT_EQ(given("voidFraction { filterWidth 0; }"), (scalarList{0, 0, -1}));
    EXPECT_EQ(given("voidFraction { diffusion 3; }"), (scalarList{0, 3, -1}));
    EXPECT_EQ(given("feedback off;"), (scalarList{0, 0, -1}));
    EXPECT_TRUE(holds(complaintAbout(first + "voidFraction { diffusion 3; filterWidth 2; }"), {"filterWidth", "diffusion", "0 for one"}));
}

TEST(GrainProperties, optionalLawsAndDrivenGrains)
{
    const GrainProperties p = read
    (
        glass + "contacts { default { friction 0.3; rollingFriction 0.05; spinningFriction 0.02; }"
        " glass-steel { friction 0.2; cohesion [1 1 -2 0 0 0 0] 1e-4; cohesionRange 1e-5; } }" + lattice
      + "driven { piston { ids (0 7); velocity table ((0 (0 0 0)) (1 (0 0 2))); } wheel { ids (3); velocity (0 0 0); omega (0 5 0); } }"
    );
    EXPECT_EQ(p.materials.table.pair(0, 0).rollingFriction, 0.05);
    EXPECT_EQ(p.materials.table.pair(0, 0).spinningFriction, 0.02);
    EXPECT_EQ(p.materials.table.pair(0, 0).cohesion, 0);
    EXPECT_EQ(p.materials.table.pair(0, 1).rollingFriction, 0);
    EXPECT_EQ(p.materials.table.pair(1, 0).cohesion, 1e-4);
    EXPECT_EQ(p.materials.table.pair(1, 0).cohesionRange, 1e-5);
    ASSERT_EQ(p.driven.size(), 2u);
    EXPECT_EQ(p.driven[0].grains.ids, (std::vector<std::int64_t>{0, 7}));
    EXPECT_NEAR(p.driven[0].grains.velocity(0.25).z(), 0.5, 1e-15);
    EXPECT_EQ(p.driven[0].grains.omega, nullptr);
    EXPECT_EQ(p.driven[1].grains.omega(3), nscd::Vec3(0, 5, 0));
}

TEST(GrainProperties, dimensionsMayBeGivenAndAreConverted)
{
    const dictionary dict = dictionaryOf
    (
        "a [1 -3 0 0 0 0 0] 7; b b [0 1 0 0 0 0 0] 2; c 3; d [0 1 -1 0 0 0 0] (1 2 3); e [kg m^-3] 7; f [mm] 5; g [km s^-1] (1 2 3); h [N] 4;"
    );
    const input::Dictionary entries = fromFoam(dict);
    const input::CheckedEntries given(entries);
    EXPECT_EQ(given.number("a", input::above(0, input::unit::density)), 7);
    EXPECT_EQ(given.number("b", input::above(0, input::unit::length)), 2);
    EXPECT_EQ(given.number("c", input::above(0, input::unit::length)), 3);
    EXPECT_EQ(given.vec("d", input::unit::velocity), nscd::Vec3(1, 2, 3));
    EXPECT_EQ(given.number("e", input::above(0, input::unit::density)), 7);
    EXPECT_EQ(given.number("f", input::above(0, input::unit::length)), 5*1e-3);
    EXPECT_EQ(given.vec("g", input::unit::velocity), nscd::Vec3(1000, 2000, 3000));
    EXPECT_EQ(given.number("h", input::above(0, input::unit::force)), 4);
    EXPECT_NO_THROW(given.finish());
}

TEST(GrainProperties, macrosListsAndPatternsArrive)
{
    const dictionary dict = dictionaryOf("size 2; a $size; b { c $..size; } ids List<label> 3(4 5 6); \"out.*\" { d 3; } f { $b; }");
    const input::Dictionary entries = fromFoam(dict);
    const input::CheckedEntries given(entries);
    EXPECT_EQ(given.number("a", input::anyNumber()), 2);
    EXPECT_EQ(input::CheckedEntries(given.sub("b")).number("c", input::anyNumber()), 2);
    EXPECT_EQ(input::CheckedEntries(given.sub("f")).number("c", input::anyNumber()), 2);
    EXPECT_EQ(given.integers("ids", 0), (std::vector<long>{4, 5, 6}));
    EXPECT_TRUE(entries.find("out.*")->isQuoted);
    EXPECT_FALSE(entries.find("b")->isQuoted);
    EXPECT_EQ(given.place("out.*").keyword, "out.*");
}

/// Kinds of functions that the readers do not know are OpenFOAM's own.
TEST(GrainProperties, functionsOfTimeAreOpenFOAMs)
{
    const auto speedAt = [](const std::string& function, double time)
    {
        return read(first + "driven { a { ids (0); velocity " + function + " } }").driven.at(0).grains.velocity(time);
    };
    EXPECT_EQ(speedAt("polynomial (((1 0 0) (2 0 0)));", 3), nscd::Vec3(9, 0, 0));
    EXPECT_NEAR(speedAt("sine; velocityCoeffs { frequency table ((0 1)); amplitude 2; scale (1 0 0); level (0 3 0); }", 0.25).x(), 2, 1e-15);
    EXPECT_NEAR(speedAt("{ type sine; frequency table ((0 1)); amplitude 2; scale (1 0 0); level (0 3 0); }", 0.25).x(), 2, 1e-15);
    EXPECT_TRUE(holds(complaintAbout(first + "driven { a { ids (0); velocity polynomal (((1 0 0) (2 0 0))); } }"),
        {"keyword driven.a.velocity is no function of time", "nearest: polynomial"}));
}

/// Versions later than v1912 find what stands behind some of them by themselves.
TEST(GrainProperties, nothingFollowsAFunctionOfTime)
{
    const std::string apart = "velocityCoeffs { frequency table ((0 1)); amplitude 2; scale (1 0 0); level (0 3 0); }";
    for (const std::string& function : {std::string("polynomial (((1 0 0) (2 0 0))) 7;"), "sine 7; " + apart})
    {
        const std::string said = complaintAbout(first + "driven { a { ids (0); velocity " + function + " } }");
        const bool isFoams = said.find("Entry 'velocity' has 1 excess tokens") != std::string::npos;
        EXPECT_TRUE(holds(said, {isFoams ? " 7)" : "keyword driven.a.velocity goes on after its function of time\n  value:   7"}));
    }
}

/// OpenFOAM's programs stop at an overflow, as of a number in their text.
TEST(GrainProperties, anOverflowIsToldInWords)
{
    BoxMesh box;
    const auto about = [&](const std::string& text, const std::string& included = "")
    {
        box.writeFile("constant/included", included);
        box.writeFile("constant/grainProperties", text);
        const input::WithoutTraps restoresThem;
        feenableexcept(FE_OVERFLOW | FE_INVALID | FE_DIVBYZERO);
        const std::string said = complaint([&] { readGrainProperties(box.time(), surroundingsIn(box.mesh())); });
        EXPECT_NE(fegetexcept() & FE_OVERFLOW, 0);
        return said;
    };
    EXPECT_EQ(about(first), "");
    EXPECT_TRUE(holds(about("maxInitialOverlap 1e999;" + first), {"keyword maxInitialOverlap is not a finite number", "value:   1e999"}));
    EXPECT_TRUE(holds(about("maxInitialOverlap 1e300;" + first), {"keyword maxInitialOverlap is too large"}));
    EXPECT_TRUE(holds(about("#include \"included\"\n" + first, "maxInitialOverlap 1e999;"), {"maxInitialOverlap"}));
}

/// What is included may be said otherwise; what a file itself says twice is a mistake.
TEST(GrainProperties, keywordsMayReplaceThoseIncluded)
{
    BoxMesh box;
    box.writeFile("constant/included", "maxInitialOverlap 0.1; solver { tolerance 1e-3; skin 0.1; }");
    box.writeFile("constant/grainProperties", "#include \"included\"\nmaxInitialOverlap 0.2; solver { tolerance 1e-4; }" + first);
    const GrainProperties p = readGrainProperties(box.time(), surroundingsIn(box.mesh()));
    EXPECT_EQ(p.maxInitialOverlap, 0.2);
    EXPECT_EQ(p.contact.tolerance, 1e-4);
    EXPECT_EQ(p.contact.skin, 0.1);
    box.writeFile("constant/grainProperties", "maxInitialOverlap 0.2; maxInitialOverlap 0.3;" + first);
    EXPECT_TRUE(holds(complaint([&] { readGrainProperties(box.time(), surroundingsIn(box.mesh())); }), {"keyword maxInitialOverlap is given twice"}));
}

TEST(GrainProperties, grainsSleepWhereItIsAskedFor)
{
    EXPECT_FALSE(read(first).contact.sleep);
    EXPECT_FALSE(read(first + "fluid none;").contact.sleep);
    EXPECT_TRUE(read(first + "fluid none; solver { sleep on; }").contact.sleep);
    EXPECT_TRUE(read(first + "solver { sleep on; }").contact.sleep);
    const GrainProperties cycled = read(first + "solver { sleep on; } timeStep { subCycles 2; }");
    EXPECT_FALSE(cycled.contact.sleep);
    ASSERT_EQ(cycled.notes.size(), 1u);
    EXPECT_TRUE(holds(cycled.notes[0], {"stay awake", "subCycles"}));
    EXPECT_FALSE(read(first + "solver { sleep on; } timeStep { maxGrainImpacts 0.3; }").contact.sleep);
    EXPECT_TRUE(read(first + "fluid none; solver { sleep on; } timeStep { subCycles 2; }").contact.sleep);
}

TEST(GrainProperties, latticeSpacingFillsTheBox)
{
    const GrainProperties p = read
    (
        glass + contacts + "grains { type lattice; box (0 0 0) (0.3 0.1 0.25); spacing 0.1; diameter 0.01; }"
    );
    EXPECT_EQ(p.sources.at(0).lattice.count, (std::array<int, 3>{3, 1, 2}));
}

TEST(BadGrainProperties, aMisspeltKeywordIsFoundInEverySubDictionary)
{
    // What stands before and behind the misspelt keyword, the keyword, and the one that was meant.
    struct Row { std::string before, keyword, meant, after; };
    const std::string grain = glass + contacts + "grains { type ";
    const std::vector<Row> rows =
    {
        {"materials { glass { density 1; ", "densty", "density", " 2; } }" + contacts + lattice},
        {glass + "contacts { default { friction 1; ", "restituton", "restitution", " 2; } }" + lattice},
        {glass + "contacts { default { friction 1; } ", "glas-glass", "glass-glass", " { friction 1; } }" + lattice},
        {grain + "table; file x; ", "velocty", "velocity", " (0 0 0); }"},
        {grain + "positionsFile; file x; diameter 1; ", "materal", "material", " glass; }"},
        {grain + "lattice; box (0 0 0) (1 1 1); count (1 1 1); diameter 1; ", "jiter", "jitter", " 1; }"},
        {first + "patches { a { type exit; ", "materiel", "type", " glass; } }"},
        {first + "patches { a { type wall; material glass; ", "materiel", "material", " glass; } }"},
        {first + "planes { a { point (0 0 0); normal (0 0 1); material glass; ", "pont", "point", " (0 0 0); } }"},
        {first + "solver { ", "maxSweep", "maxSweeps", " 3; }"},
        {first + "voidFraction { ", "difusion", "diffusion", " 3; }"},
        {first + "voidFraction { ", "filterWith", "filterWidth", " 2; }"},
        {first + "forces { ", "viscuous", "viscous", " on; }"},
        {first + "forces { ", "safmanLift", "saffmanLift", " on; }"},
        {first + "forces { drag { ", "lav", "law", " Ergun; } }"},
        {first + "timeStep { ", "subCycle", "subCycles", " 3; }"},
        {first, "feedbck", "feedback", " on;"}
    };
    for (const Row& row : rows)
    {
        const std::string text = complaintAbout(row.before + row.keyword + row.after);
        EXPECT_TRUE(holds(text, {row.keyword + " is not a keyword here", "value:   " + row.keyword})) << row.before;
        EXPECT_TRUE(holds(text, {row.meant})) << row.before;
        if (row.keyword != "materiel" || row.meant == "material")
        {
            EXPECT_TRUE(holds(text, {"nearest: " + row.meant})) << row.before;
        }
    }
}

namespace
{

/// A bad text, and what the complaint must hold beside the file's name.
struct Bad
{
    std::string text;
    std::vector<std::string> pieces;
};

/// What nscdGrains refuses too is in sharedInputTest.C.
const std::vector<Bad> bad =
{
    {first + "feedbak off;", {"feedbak", "nearest: feedback", "line 4"}},
    {"materials {}" + contacts + lattice, {"materials", "names no material"}},
    {first + "shape disk;", {"shape", "nearest: disc"}},
    {first + "voidFraction { minFluidFraction 1; }", {"minFluidFraction", "< 1"}},
    {first + "forces { drag { law Gidaspov; } }", {"forces.drag.law", "value:   Gidaspov", "nearest: Gidaspow", "Ergun"}},
    {first + "forces { drag { law KochHil; } }", {"forces.drag.law", "nearest: KochHill", "Beetstra", "Tenneti", "table"}},
    {first + "forces { drag { law table; } }", {"forces.drag", "table"}},
    {first + "forces { drag { law table; table \"none.txt\"; } }", {"forces.drag.table", "none.txt"}},
    {first + "forces { drag { law Rong; table \"cd.txt\"; } }", {"forces.drag.table"}},
    {first + "forces { drag { polydisperse maybe; } }", {"forces.drag.polydisperse", "on"}},
    {first + "voidFraction { method exakt; }", {"voidFraction.method", "nearest: exact", "centroid"}},
    {first + "fluid non;", {"fluid", "nearest: none", "solved"}},
    {first + "feedback of;", {"feedback", "nearest: off"}},
    {first + "meanFlow (0 0);", {"meanFlow", "not a vector"}},
    {first + "meanFlow (0 0 nan);", {"meanFlow", "finite"}},
    {first + "meanFlow [0 1 0 0 0 0 0] (0 0 1);", {"meanFlow", "wrong dimensions", "[0 1 -1 0 0 0 0]"}},
    {first + "patches { outlet { type exite; } }", {"patches.outlet.type", "nearest: exit", "wall"}},
    {first + "patches { outlet { type wall; material steele; } }", {"patches.outlet.material", "nearest: steel"}},
    {first + "patches { \"out.*\" { type wall; material glass; surfaceVelocity 1; } }", {"patches.out.*.surfaceVelocity", "single value"}},
    {first + "timeStep { subCycles 0; }", {"timeStep.subCycles", ">= 1"}},
    {first + "timeStep { maxGrainImpacts -1; }", {"timeStep.maxGrainImpacts", ">= 0"}},
    {first + "parallel { maxLoadImbalance 1; }", {"parallel.maxLoadImbalance", "> 1"}}
};

} // namespace

// Files of drag coefficients, named by their path from the root.
TEST(GrainProperties, aTableOfDragCoefficients)
{
    BoxMesh box;
    box.writeFile("constant/grainProperties", "");
    const std::string path = box.casePath()/"constant/cd.txt", law = "forces { drag { law table; table \"" + path + "\"; } }";
    const auto written = [&](const std::string& text) { std::ofstream(path) << text; };
    written("# Re alpha Cd\n1, 0.4, 200\n100 0.4 20\n1 0.8 50\n100 0.8 2\n");
    const GrainProperties p = read(first + law);
    ASSERT_TRUE(p.forces.drag.table.has_value());
    EXPECT_TRUE(p.forces.isOn("drag"));
    EXPECT_NEAR(p.forces.drag.table->cdRe(100, 0.8), 200, 1e-10);
    const struct { const char* text; std::vector<std::string> pieces; } wrong[] =
    {
        {"1 0.4\n", {"cd.txt", "without 3 finite numbers", "rows of Re alpha Cd"}},
        {"", {"forces.drag.table", "without rows"}},
        {"1 0.4 200\n100 0.4 20\n1 0.8 50\n", {"forces.drag.table", "alpha 0.8 has fewer Re"}},
        {"1 0.4 200\n100 0.4 0.01\n", {"forces.drag.table", "does not grow"}}
    };
    for (const auto& one : wrong)
    {
        written(one.text);
        EXPECT_TRUE(holds(complaintAbout(first + law), one.pieces)) << one.text;
    }
}

TEST(BadGrainProperties, saysWhatIsWrongAndWhatWouldBeRight)
{
    for (const Bad& b : bad)
    {
        const std::string text = complaintAbout(b.text);
        EXPECT_TRUE(holds(text, b.pieces)) << "for: " << b.text;
        EXPECT_TRUE(holds(text, {"file: constant/grainProperties"})) << "for: " << b.text;
    }
}
