// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Scenes that are wrong in one place: each is refused with file, line, keyword, value, and what is allowed.
#include "badScenes.hpp"

using sceneFiles::BadScene;
using sceneFiles::goodScene;
using sceneFiles::readAndPlace;

namespace
{

class BadScenes : public testing::TestWithParam<BadScene> {};

const BadScene badScenes[] =
{
    {"misspeltTopKeyword", "writeInterval 0.03", "writeInteval 0.03", 10, {"keyword writeInteval is not a keyword here", "nearest: writeInterval"}},
    {"misspeltNeededKeyword", "deltaT ", "deltat ", 8, {"keyword deltat", "deltaT is missing", "nearest: deltaT"}},
    {"misspeltKeywordInside", "jitter 0.5", "jiter 0.5", 3, {"keyword grains.jiter", "nearest: jitter"}},
    {"keywordOfAnotherPlace", "type NLGS;", "type NLGS; friction 1;", 7, {"keyword solver.friction is not a keyword here"}},
    {"missingKeyword", "endTime   0.09;", "", 0, {"keyword endTime is missing", "allowed: endTime value;"}},
    {"missingDictionary", "contacts  { default { friction 0.3; restitution 0.2; } }", "", 0, {"keyword contacts is missing"}},
    {"dictionaryForValue", "deltaT    1e-3;", "deltaT    { }", 8, {"keyword deltaT is a dictionary where a value belongs"}},
    {"valueForDictionary", "solver    { type NLGS; }", "solver NLGS;", 7, {"keyword solver is not a dictionary", "value:   NLGS"}},
    {"wordForNumber", "diameter 0.01", "diameter small", 3, {"keyword grains.diameter is not a finite number", "value:   small"}},
    {"unitBehindNumber", "diameter 0.01", "diameter 10mm", 3, {"grains.diameter is not a finite number", "value:   10mm"}},
    {"nanTime", "endTime   0.09", "endTime   nan", 9, {"keyword endTime is not a finite number", "value:   nan"}},
    {"infiniteTime", "endTime   0.09", "endTime   inf", 9, {"keyword endTime is not a finite number", "value:   inf"}},
    {"overflowingNumber", "endTime   0.09", "endTime   1e999", 9, {"keyword endTime is not a finite number"}},
    {"hexadecimalNumber", "endTime   0.09", "endTime   0x10", 9, {"keyword endTime is not a finite number"}},
    {"quotedNumber", "endTime   0.09", "endTime   \"0.09\"", 9, {"keyword endTime is not a finite number"}},
    {"negativeStep", "deltaT    1e-3", "deltaT    -1e-3", 8, {"keyword deltaT is out of range", "value:   -1e-3", "> 0"}},
    {"zeroStep", "deltaT    1e-3", "deltaT    0", 8, {"keyword deltaT is out of range"}},
    {"endBeforeFirstStep", "endTime   0.09", "endTime   1e-5", 9, {"keyword endTime is shorter than a step"}},
    {"endlessRun", "endTime   0.09", "endTime   1e12", 9, {"keyword endTime makes too many steps", "value:   1e12"}},
    {"zeroWriteInterval", "writeInterval 0.03", "writeInterval 0", 10, {"keyword writeInterval is out of range"}},
    {"fractionOfStates", "gravity ", "purgeWrite 1.5; gravity ", 11, {"keyword purgeWrite is not a whole number", "value:   1.5"}},
    {"twoNumbers", "deltaT    1e-3;", "deltaT    1e-3 2e-3;", 8, {"keyword deltaT is not a single number", "value:   1e-3 2e-3"}},
    {"missingSemicolon", "deltaT    1e-3;", "deltaT    1e-3", 8, {"keyword deltaT is not a single number (a missing semicolon?)"}},
    {"missingLastSemicolon", "gravity   (0 0 -9.81);", "gravity   (0 0 -9.81)", 11, {"keyword gravity has no semicolon"}},
    {"missingValue", "deltaT    1e-3;", "deltaT;", 8, {"keyword deltaT has no value"}},
    {"unclosedDictionary", "solver    { type NLGS; }", "solver    { type NLGS;", 7, {"keyword solver begins a dictionary that does not end"}},
    {"closingBraceTooMany", "solver    { type NLGS; }", "solver    { type NLGS; } }", 7, {"has no keyword here", "value:   }"}},
    {"unclosedString", "type NLGS;", "type \"NLGS;", 7, {"begins a string that does not end"}},
    {"unclosedComment", "gravity ", "/* gravity ", 11, {"begins a comment that does not end"}},
    {"keywordTwice", "endTime   0.09;", "deltaT 2;", 9, {"keyword deltaT is given twice, first in line 8"}},
    {"macro", "deltaT    1e-3", "deltaT    $dt", 8, {"holds $"}},
    {"include", "gravity ", "#include \"other\"\ngravity ", 11, {"holds #"}},
    {"binaryFile", "gravity ", "\x01\x02", 11, {"holds a character that is no text"}},
    {"shortVector", "gravity   (0 0 -9.81)", "gravity   (0 -9.81)", 11, {"keyword gravity is not a vector", "value:   ( 0 -9.81 )"}},
    {"vectorWithAWord", "gravity   (0 0 -9.81)", "gravity   (0 0 down)", 11, {"keyword gravity is not a finite number"}},
    {"unknownSolver", "type NLGS", "type NGLS", 7, {"keyword solver.type is not one of the words allowed", "value:   NGLS", "nearest: NLGS"}},
    {"negativeTolerance", "type NLGS;", "type NLGS; tolerance -1;", 7, {"keyword solver.tolerance is out of range"}},
    {"zeroSweeps", "type NLGS;", "type NLGS; maxSweeps 0;", 7, {"keyword solver.maxSweeps is out of range"}},
    {"switchThatIsNone", "type NLGS;", "type NLGS; accelerate maybe;", 7, {"keyword solver.accelerate is not one of the words allowed"}},
    {"unknownVectorPath", "type NLGS;", "type NLGS; vectorPath AVX;", 7, {"keyword solver.vectorPath", "allowed: auto, portable, AVX2, AVX512"}},
    {"unknownMaterial", "wallMaterial steel", "wallMaterial stel", 4, {"keyword wallMaterial", "value:   stel", "nearest: steel"}},
    {"noMaterial", "{ glass { density 2500; } steel {} }", "{ }", 1, {"keyword materials names no material"}},
    {"negativeDensity", "density 2500", "density -2500", 1, {"keyword materials.glass.density is out of range"}},
    {"grainsWithoutDensity", "type lattice;", "type lattice; material steel;", 1, {"keyword materials.steel has no density"}},
    {"negativeFriction", "friction 0.3", "friction -0.3", 2, {"keyword contacts.default.friction is out of range", ">= 0"}},
    {"restitutionAboveOne", "restitution 0.2", "restitution 1.2", 2, {"keyword contacts.default.restitution is out of range", "<= 1"}},
    {"pairOfUnknownMaterial", "contacts  { ", "contacts  { glass-wood { friction 1; } ", 2, {"keyword contacts.glass-wood is not a keyword here"}},
    {"pairTwice", "contacts  { ", "contacts  { glass-steel { friction 1; } steel-glass { friction 1; } ", 2, {"repeats a pair"}},
    {"pairThatIsMissing", "default {", "glass-glass {", 2, {"keyword contacts lacks the pair glass-steel, which can meet"}},
    {"noGrains", "grains    { type lattice; box (0 0 0) (0.06 0.06 0.08); count (5 5 5); diameter 0.01; spread 0.2; jitter 0.5; }",
        "grains { }", 3, {"keyword grains names no source of grains"}},
    {"sourceOfUnknownType", "type lattice", "type latice", 3, {"keyword grains.type", "nearest: lattice"}},
    {"grainsWithoutType", "type lattice; ", "", 3, {"stands in grains without a type"}},
    {"negativeDiameter", "diameter 0.01", "diameter -0.01", 3, {"keyword grains.diameter is out of range", "value:   -0.01"}},
    {"emptyLattice", "box (0 0 0) (0.06", "box (0.1 0 0) (0.06", 3, {"keyword grains.box is empty"}},
    {"oneCorner", "box (0 0 0) (0.06 0.06 0.08)", "box (0 0 0)", 3, {"keyword grains.box does not hold two vectors"}},
    {"halfAGrain", "count (5 5 5)", "count (5 5 2.5)", 3, {"keyword grains.count is not three whole numbers"}},
    {"noCount", "count (5 5 5); ", "", 3, {"keyword grains.count is missing", "spacing"}},
    {"countAndSpacing", "count (5 5 5);", "count (5 5 5); spacing 0.02;", 3, {"keyword grains.spacing stands beside count"}},
    {"tooManyGrains", "count (5 5 5)", "count (50000 50000 50000)", 3, {"keyword grains.count makes too many grains"}},
    {"spreadOfOne", "spread 0.2", "spread 1", 3, {"keyword grains.spread is out of range"}},
    {"missingFile", "type lattice; box (0 0 0) (0.06 0.06 0.08); count (5 5 5); diameter 0.01; spread 0.2; jitter 0.5;",
        "type table; file none.txt;", 3, {"keyword grains.file names a file that does not exist", "none.txt"}},
    {"overlappingGrains", "diameter 0.01", "diameter 0.03", 0, {"keyword maxInitialOverlap is exceeded by", "overlap by"}},
    {"grainsBehindAWall", "walls     { tray { type box; box (0 0 0)", "walls     { tray { type box; box (0.03 0 0)", 0, {"and the wall tray overlap"}},
    {"wallOfUnknownType", "type box", "type bocks", 5, {"keyword walls.tray.type", "allowed: plane, polygon, box, stl"}},
    {"emptyBoxOfWalls", "(0.06 0.06 0.2)", "(0.06 0.06 -0.2)", 5, {"keyword walls.tray.box is empty"}},
    {"unknownSide", "(0.06 0.06 0.2);", "(0.06 0.06 0.2); sides (xMin xMix);", 5, {"keyword walls.tray.sides", "value:   xMix", "nearest: xMin"}},
    {"wallsOfOneName", "walls ", "planes { tray { point (0 0 0); normal (0 0 1); } } walls ", 5, {"keyword walls.tray is the name of another wall"}},
    {"wallNameWithAComma", "walls     { ", "walls     { \"a,b\" { type plane; point (0 0 0); normal (0 0 1); } ", 5, {"keyword walls.a,b is no name for a column"}},
    {"planeWithoutNormal", "walls ", "planes { lid { point (0 0 1); } } walls ", 5, {"keyword planes.lid.normal is missing"}},
    {"normalWithoutLength", "walls ", "planes { lid { point (0 0 1); normal (0 0 0); } } walls ", 5, {"keyword planes.lid.normal has no length"}},
    {"polygonOfTwo", "walls     { ", "walls     { p { type polygon; vertices ((0 0 0) (1 0 0)); } ", 5, {"keyword walls.p.vertices has too few vertices"}},
    {"polygonNotFlat", "walls     { ", "walls     { p { type polygon; vertices ((0 0 0) (1 0 0) (1 1 0.1) (0 1 0)); } ", 5, {"keyword walls.p.vertices does not lie in one plane"}},
    {"polygonWithoutArea", "walls     { ", "walls     { p { type polygon; vertices ((0 0 0) (1 0 0) (2 0 0)); } ", 5, {"keyword walls.p.vertices has no area"}},
    {"periodTooShort", "periodic  { }", "periodic  { y (0 0.008); }", 6, {"keyword periodic makes a period shorter than a grain", "value:   0.008 along y"}},
    {"emptyPeriod", "periodic  { }", "periodic  { y (1 0); }", 6, {"keyword periodic.y is empty"}},
    {"unknownAxis", "periodic  { }", "periodic  { w (0 1); }", 6, {"keyword periodic.w is not a keyword here", "allowed: x, y, z"}},
    {"planeAcrossAPeriod", "periodic  { }", "periodic  { y (0 1); } planes { p { point (0 0 0); normal (0 1 0); } }", 6, {"points along a periodic axis"}},
    {"oneDimension", "gravity ", "dimensions 1; gravity ", 11, {"keyword dimensions is out of range"}},
    {"thicknessOfSpheres", "gravity ", "thickness 1; gravity ", 11, {"keyword thickness is for discs"}},
    {"gravityOutOfPlane", "gravity ", "dimensions 2; gravity ", 11, {"keyword gravity points out of the plane of discs"}},
};

} // namespace

INSTANTIATE_TEST_SUITE_P(Scene, BadScenes, testing::ValuesIn(badScenes), [](const auto& info) { return info.param.name; });

TEST_P(BadScenes, areRefusedInWords)
{
    expectRefused(GetParam());
}

TEST(GoodScene, isAccepted)
{
    EXPECT_NO_THROW(readAndPlace(goodScene()));
}

TEST(GoodScene, defaultsMakeAFirstSceneShort)
{
    const nscdGrains::SceneSettings scene = nscdGrains::parseScene
    (
        "materials { glass { density 2500; } }  contacts { default { friction 0.3; } }\n"
        "grains { type lattice; box (0 0 0) (1 1 1); spacing 0.25; diameter 0.1; }  deltaT 1e-3;  endTime 2;", "scene"
    );
    EXPECT_EQ(scene.shape.dimensions, 3);
    EXPECT_EQ(scene.gravity, nscd::Vec3(0, 0, -9.81));
    EXPECT_EQ(scene.run.writeInterval, 2.0);
    EXPECT_EQ(scene.run.results, "results");
    EXPECT_TRUE(scene.walls.regions.empty());
    EXPECT_FALSE(scene.box.any());
    EXPECT_EQ(nscdGrains::placeGrains(scene).size(), 64u);
}

TEST(GoodScene, everyKeywordDoesWhatItSays)
{
    const nscdGrains::SceneSettings scene = nscdGrains::parseScene
    (
        "FoamFile { version 2.0; } // as OpenFOAM's\n"
        "dimensions 2; thickness 0.5; gravity (1 -2 0); deltaT 0.01; endTime 3; writeInterval 0.5; purgeWrite 0; results out;\n"
        "materials { \"glass\" { density 2500; } steel { density 7800; } } /* two */\n"
        "contacts { default { friction 0.3; rollingFriction 0.02; spinningFriction 0.01; cohesion 2; cohesionRange 1e-3; }"
        " steel-glass { friction 0.1; restitution 0.9; } }\n"
        "wallMaterial glass; maxInitialOverlap 0.2; motion fixed;\n"
        "grains { a { type lattice; box (0 0 7) (1 1 7); count (2 2 9); diameter 0.1; material steel; velocity (1 2 0); omega (0 0 3); motion free; }\n"
        "         b { type lattice; box (0 2 0) (1 3 0); count (1 1 1); diameter 0.2; material glass; } }\n"
        "planes { floor { point (0 -1 0); normal (0 2 0); material steel; } }\n"
        "walls { left { type plane; point (-1 0 0); normal (1 0 0); } ramp { type polygon; vertices ((2 0 0) (3 1 0)); }\n"
        "        tray { type box; box (-5 -5 0) (5 5 0); sides (xMax yMin); } }\n"
        "solver { type queue; tolerance 1e-3; displacementTolerance 1e-5; maxSweeps 7; deadBand 1e-6; overlapTolerance 1e-3; skin 0.1;"
        " accelerate off; sleep off; vectorPath portable; }", "scene"
    );
    EXPECT_EQ(scene.gravity, nscd::Vec3(1, -2, 0));
    EXPECT_EQ(scene.run.purgeWrite, 0);
    EXPECT_EQ(scene.run.results, "out");
    EXPECT_EQ(scene.contact.solver, "queue");
    EXPECT_EQ(scene.contact.tolerance, 1e-3);
    EXPECT_EQ(scene.contact.displacementTolerance, 1e-5);
    EXPECT_EQ(scene.contact.maxSweeps, 7);
    EXPECT_EQ(scene.contact.deadBand, 1e-6);
    EXPECT_EQ(scene.contact.overlapTolerance, 1e-3);
    EXPECT_EQ(scene.contact.skin, 0.1);
    EXPECT_FALSE(scene.contact.accelerate);
    EXPECT_FALSE(scene.contact.sleep);
    EXPECT_EQ(scene.contact.vectorPath, "portable");
    EXPECT_EQ(scene.materials.table.pair(0, 1).restitution, 0.9);
    EXPECT_EQ(scene.materials.table.pair(1, 1).friction, 0.3);
    EXPECT_EQ(scene.materials.table.pair(1, 1).rollingFriction, 0.02);
    EXPECT_EQ(scene.materials.table.pair(1, 1).spinningFriction, 0.01);
    EXPECT_EQ(scene.materials.table.pair(0, 0).cohesion, 2.0);
    EXPECT_EQ(scene.materials.table.pair(0, 0).cohesionRange, 1e-3);
    EXPECT_EQ(scene.maxInitialOverlap, 0.2);

    const nscd::Grains grains = nscdGrains::placeGrains(scene);
    ASSERT_EQ(grains.size(), 5u);
    EXPECT_EQ(grains.position[1], nscd::Vec3(0.75, 0.25, 0));
    EXPECT_EQ(grains.velocity[1], nscd::Vec3(1, 2, 0));
    EXPECT_EQ(grains.omega[1], nscd::Vec3(0, 0, 3));
    EXPECT_NEAR(grains.mass[1], 7800*0.5*3.14159265358979*0.05*0.05, 1e-9);
    EXPECT_EQ(grains.isFixed[1], 0);
    EXPECT_EQ(grains.isFixed[4], 1);
    EXPECT_EQ(grains.material[4], 0);

    ASSERT_EQ(scene.walls.patches.size(), 4u);
    EXPECT_EQ(scene.walls.patches[0].material, 1);
    EXPECT_EQ(scene.walls.patches[2].material, 0);
    ASSERT_EQ(scene.walls.regions.size(), 5u);
    EXPECT_EQ(scene.walls.regions[0].normal, nscd::Vec3(0, 1, 0));
    // Grains are to the left of a wall in 2D.
    EXPECT_NEAR(scene.walls.regions[2].normal.dot(nscd::Vec3(-1, 1, 0).normalized()), 1.0, 1e-12);
    EXPECT_NEAR(nscd::nearestPoint(scene.walls.regions[2], nscd::Vec3(2.5, 0.6, 0)).distance, 0.1/std::sqrt(2.0), 1e-12);
    EXPECT_EQ(scene.walls.regions[3].normal, nscd::Vec3(-1, 0, 0));
    EXPECT_EQ(scene.walls.regions[4].normal, nscd::Vec3(0, 1, 0));
}

/// The file that shows every keyword runs, and the values it calls defaults are those of a scene that leaves them out.
TEST(GoodScene, theExampleShowsDefaults)
{
    const nscdGrains::SceneSettings shown = nscdGrains::readScene(SCENE_EXAMPLE);
    EXPECT_NO_THROW(nscdGrains::checkGrains(shown, nscdGrains::placeGrains(shown)));
    const nscdGrains::SceneSettings bare = nscdGrains::parseScene
    (
        "materials { glass { density 2500; } } contacts { default { friction 0.3; } } deltaT 1e-3; endTime 2;\n"
        "grains { type lattice; box (0 0 0) (0.1 0.2 0.1); count (8 16 8); diameter 0.01; }", "scene"
    );
    EXPECT_EQ(shown.run.purgeWrite, bare.run.purgeWrite);
    EXPECT_EQ(shown.run.results, bare.run.results);
    EXPECT_EQ(shown.gravity, bare.gravity);
    EXPECT_EQ(shown.shape.dimensions, bare.shape.dimensions);
    EXPECT_EQ(shown.maxInitialOverlap, bare.maxInitialOverlap);
    EXPECT_EQ(shown.materials.table.pair(0, 0).restitution, bare.materials.table.pair(0, 0).restitution);
    EXPECT_EQ(shown.sources[0].lattice.seed, bare.sources[0].lattice.seed);
    EXPECT_EQ(shown.sources[0].lattice.spread, bare.sources[0].lattice.spread);
    EXPECT_EQ(shown.sources[0].lattice.jitter, bare.sources[0].lattice.jitter);
    EXPECT_EQ(shown.sources[0].isFixed, bare.sources[0].isFixed);
    EXPECT_EQ(shown.contact.solver, bare.contact.solver);
    EXPECT_EQ(shown.contact.tolerance, bare.contact.tolerance);
    EXPECT_EQ(shown.contact.displacementTolerance, bare.contact.displacementTolerance);
    EXPECT_EQ(shown.contact.maxSweeps, bare.contact.maxSweeps);
    EXPECT_EQ(shown.contact.deadBand, bare.contact.deadBand);
    EXPECT_EQ(shown.contact.overlapTolerance, bare.contact.overlapTolerance);
    EXPECT_EQ(shown.contact.skin, bare.contact.skin);
    EXPECT_EQ(shown.contact.accelerate, bare.contact.accelerate);
    EXPECT_EQ(shown.contact.sleep, bare.contact.sleep);
    EXPECT_EQ(shown.contact.vectorPath, bare.contact.vectorPath);
}
