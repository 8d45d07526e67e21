// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of grainProperties as text: what a short one means, and what is said about bad ones.
#include "caseTools.H"

#include "coupling/case/input/dictionaryCheck.H"
#include "coupling/case/input/grainProperties.H"

#include "dimensionSets.H"

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
    EXPECT_EQ(p.sources[0].lattice.count, Vector<label>(2, 3, 4));
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
        "fluid none; feedback off; meanFlow (0 0 0.5); timeStep { maxGrainDisplacement 0.2; subCycles 3; }"
    );
    EXPECT_EQ(p.materials.table.pair(1, 0).friction, 0.2);
    EXPECT_EQ(p.materials.table.pair(0, 1).restitution, 0.9);
    EXPECT_EQ(p.materials.table.pair(0, 0).restitution, 0.1);
    EXPECT_EQ(p.sources[0].velocity, vector(1, 2, 3));
    EXPECT_TRUE(p.sources[0].isFixed);
    EXPECT_FALSE(p.sources[1].isFixed);
    EXPECT_EQ(p.sources[1].omega, vector(0, 0, 4));
    EXPECT_EQ(p.sources[1].diameter, 2e-3);
    EXPECT_EQ(p.maxInitialOverlap, 0.5);
    EXPECT_EQ(p.wallMaterial, 1);
    ASSERT_EQ(p.patchRules.size(), 1u);
    EXPECT_TRUE(p.patchRules[0].isExit);
    EXPECT_EQ(p.planes.at(0).normal, vector(0, 0, 2));
    EXPECT_EQ(p.planes.at(0).material, 0);
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
    EXPECT_EQ(p.voidFraction.forMapping(0.5).get<scalar>("diffusionLength"), 1.5);
    EXPECT_EQ(p.voidFraction.forMapping(0.5).get<scalar>("minFluidFraction"), 0.3);
    EXPECT_EQ(p.forces.dragLaw, "DiFelice");
    EXPECT_EQ(p.forces.dragWeight, "backwardEuler");
    EXPECT_FALSE(p.forces.isOn("pressureGradient") || p.forces.isOn("viscous") || p.solvesFluid || p.hasFeedback);
    EXPECT_TRUE(p.forces.isOn("spinDrag"));
    EXPECT_EQ(p.forces.switches.at("viscous").place.keyword, "forces.viscous");
    EXPECT_FALSE(read(first + "forces { drag { law none; } }").forces.isOn("drag"));
    EXPECT_EQ(p.meanFlowDict().get<vector>("target"), vector(0, 0, 0.5));
    EXPECT_EQ(p.time.maxGrainDisplacement, 0.2);
    EXPECT_EQ(p.time.subCycles, 3);
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
    const dictionary dict = dictionaryOf("a [1 -3 0 0 0 0 0] 7; b b [0 1 0 0 0 0 0] 2; c 3; d [0 1 -1 0 0 0 0] (1 2 3);");
    const CheckedDict given(dict);
    EXPECT_EQ(given.number("a", above(0), dimDensity), 7);
    EXPECT_EQ(given.number("b", above(0), dimLength), 2);
    EXPECT_EQ(given.number("c", above(0), dimLength), 3);
    EXPECT_EQ(given.vec("d", dimVelocity), vector(1, 2, 3));
    EXPECT_NO_THROW(given.finish());
}

TEST(GrainProperties, latticeSpacingFillsTheBox)
{
    const GrainProperties p = read
    (
        glass + contacts + "grains { type lattice; box (0 0 0) (0.3 0.1 0.25); spacing 0.1; diameter 0.01; }"
    );
    EXPECT_EQ(p.sources.at(0).lattice.count, Vector<label>(3, 1, 2));
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

const std::string start = glass + contacts;
const std::string pair = "contacts { default { friction 0.3; restitution ";

const std::vector<Bad> bad =
{
    {first + "feedbak off;", {"feedbak", "nearest: feedback", "line 4"}},
    {first + "solver { tolerence 1; }", {"solver.tolerence", "nearest: tolerance", "maxSweeps", "line 4"}},
    {contacts + lattice, {"materials", "is missing"}},
    {"materials {}" + contacts + lattice, {"materials", "names no material"}},
    {"materials { glass { density 2500; } steel { density two; } }" + contacts + lattice, {"steel.density", "value:   two", "number"}},
    {"materials { glass { density 0; } }" + contacts + lattice, {"density", "> 0"}},
    {glass + lattice, {"contacts", "is missing"}},
    {start, {"grains", "is missing"}},
    {start + "grains { type lattice; box (0 0 0) (1 1 1); count (1 1 1); }", {"grains.diameter", "is missing", "line 3"}},
    {"materials { glass { density [0 1 0 0 0 0 0] 2500; } }" + contacts + lattice,
        {"materials.glass.density", "wrong dimensions", "[1 -3 0 0 0 0 0]"}},
    {"materials { glass { density -2500; } }" + contacts + lattice, {"density", "value:   -2500", "> 0", "line 1"}},
    {"materials { glass { density nan; } }" + contacts + lattice, {"density", "value:   nan", "finite", "line 1"}},
    {"materials { glass { density 1 2; } }" + contacts + lattice, {"density", "value:   1 2", "single number"}},
    {"materials { glass { density; } }" + contacts + lattice, {"density", "has no value"}},
    {"materials { glass 2500; }" + contacts + lattice, {"glass", "is not a sub-dictionary"}},
    {glass + pair + "1.5; } }" + lattice, {"contacts.default.restitution", "value:   1.5", ">= 0 and <= 1"}},
    {glass + pair + "-0.1; } }" + lattice, {"restitution", "value:   -0.1"}},
    {glass + "contacts { default { friction -0.3; } }" + lattice, {"friction", "value:   -0.3", ">= 0"}},
    {glass + "contacts { default { friction nan; } }" + lattice, {"friction", "value:   nan", "finite"}},
    {glass + "contacts { default { restitution 0; } }" + lattice, {"contacts.default.friction", "is missing"}},
    {glass + "contacts { glass-stel { friction 1; } }" + lattice, {"glass-stel", "nearest: glass-steel", "default"}},
    {glass + "contacts { glass-steel { friction 1; } steel-glass { friction 1; } }" + lattice, {"steel-glass", "repeats"}},
    {glass + "contacts { default { friction 1; rollingFriction -0.1; } }" + lattice, {"contacts.default.rollingFriction", ">= 0"}},
    {glass + "contacts { default { friction 1; rolingFriction 0.1; } }" + lattice, {"nearest: rollingFriction"}},
    {glass + "contacts { default { friction 1; cohesion -1; } }" + lattice, {"contacts.default.cohesion", ">= 0"}},
    {glass + "contacts { default { friction 1; cohesion [0 1 0 0 0 0 0] 1; } }" + lattice, {"contacts.default.cohesion", "dimensions"}},
    {glass + "contacts { default { friction 1; rollingFriction 0.1; } }" + lattice + "solver { type queue; }",
        {"solver.type", "rolling", "NLGS"}},
    {first + "driven { a { velocity (0 0 1); } }", {"driven.a", "ids", "is missing"}},
    {first + "driven { a { ids (1 1); velocity (0 0 1); } }", {"driven.a", "ids", "twice"}},
    {first + "driven { a { ids (1); } }", {"driven.a", "velocity", "is missing"}},
    {first + "driven { a { ids (1); velocty (0 0 1); } }", {"driven.a"}},
    {first + "driven { a { ids (1); velocity (0 0 1); omga (0 0 1); } }", {"nearest: omega"}},
    {first + "driven { a { ids (1); velocity (0 0 1); } b { ids (1); velocity (0 0 1); } }", {"driven.b", "another group"}},
    {start + "grains { type latice; }", {"grains.type", "value:   latice", "nearest: lattice", "positionsFile"}},
    {start + "grains { a { type table; file x; material glas; } }", {"grains.a.material", "nearest: glass"}},
    {start + "grains { a { type table; file x; material steel; } }", {"materials.steel", "no density"}},
    {start + "grains { type table; }", {"grains.file", "is missing"}},
    {start + "grains { type positionsFile; file x; }", {"grains.diameter", "is missing"}},
    {start + "grains { type positionsFile; file x; diameter -1e-3; }", {"grains.diameter", "value:   -0.001", "> 0"}},
    {start + "grains { type positionsFile; file x; diameter nan; }", {"grains.diameter", "value:   nan", "finite"}},
    {start + "grains { type positionsFile; file x; diameter [0 0 1 0 0 0 0] 1; }", {"grains.diameter", "dimensions", "[0 1 0 0 0 0 0]"}},
    {start + "grains { type positionsFile; file 3; diameter 1; }", {"grains.file", "word or a quoted string"}},
    {start + "grains { type table; file x; velocity 3; }", {"grains.velocity", "value:   3", "not a vector"}},
    {start + "grains { file x; }", {"grains.file", "sub-dictionary"}},
    {start + "grains { type lattice; box (0 0 0) (1 1 1); diameter 1; }", {"grains", "spacing", "is missing"}},
    {start + "grains { type lattice; box (0 0 0) (1 1 1); count (1 1 1); spacing 1; diameter 1; }", {"spacing", "beside count"}},
    {start + "grains { type lattice; box (0 0 0) (1 1 1); count (a b c); diameter 1; }", {"count", "number"}},
    {start + "grains { type lattice; box (0 0 0) (1 1 1); count (1 1 1); diameter 1; spread 1.2; }", {"spread", "< 1"}},
    {first + "maxInitialOverlap -1;", {"maxInitialOverlap", ">= 0"}},
    {first + "motion fixd;", {"motion", "nearest: fixed"}},
    {first + "shape disk;", {"shape", "nearest: disc"}},
    {first + "wallMaterial stel;", {"wallMaterial", "nearest: steel"}},
    {first + "voidFraction { minFluidFraction 1; }", {"minFluidFraction", "< 1"}},
    {start + "grains { type lattice; box (0 0 0) (1 0 1); count (1 1 1); diameter 1; }", {"grains.box", "is empty"}},
    {start + "grains { type lattice; box (0 0 0) (1 1 1); count (1 1.5 1); diameter 1; }", {"count", "whole"}},
    {start + "grains { type lattice; box (0 0 0) (1 1 1); count (1 1 1); diameter -1; }", {"diameter", "> 0"}},
    {start + "grains { type lattice; box (0 0 0) (1 1); count (1 1 1); diameter 1; }", {"box", "vectors"}},
    {first + "forces { drag { law Gidaspov; } }", {"forces.drag.law", "value:   Gidaspov", "nearest: Gidaspow", "Ergun"}},
    {first + "voidFraction { method exakt; }", {"voidFraction.method", "nearest: exact", "centroid"}},
    {first + "solver { type NGLS; }", {"solver.type", "nearest: NLGS", "queue"}},
    {first + "solver { maxSweeps 2.5; }", {"maxSweeps", "whole number"}},
    {first + "solver { skin -1; }", {"solver.skin", ">= 0"}},
    {first + "fluid non;", {"fluid", "nearest: none", "solved"}},
    {first + "feedback of;", {"feedback", "nearest: off"}},
    {first + "meanFlow (0 0);", {"meanFlow", "not a vector"}},
    {first + "meanFlow (0 0 nan);", {"meanFlow", "finite"}},
    {first + "planes { p { point (0 0 0); normal (0 0 0); material glass; } }", {"planes.p.normal", "no length"}},
    {first + "patches { outlet { type exite; } }", {"patches.outlet.type", "nearest: exit", "wall"}},
    {first + "patches { outlet { type wall; material steele; } }", {"patches.outlet.material", "nearest: steel"}},
    {first + "timeStep { subCycles 0; }", {"timeStep.subCycles", ">= 1"}}
};

} // namespace

TEST(BadGrainProperties, saysWhatIsWrongAndWhatWouldBeRight)
{
    for (const Bad& b : bad)
    {
        const std::string text = complaintAbout(b.text);
        EXPECT_TRUE(holds(text, b.pieces)) << "for: " << b.text;
        EXPECT_TRUE(holds(text, {"file: constant/grainProperties"})) << "for: " << b.text;
    }
}
