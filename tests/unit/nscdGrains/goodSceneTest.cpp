// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Scenes that are right: what a short one means, and that every keyword does what it says.
#include "sceneFiles.hpp"

#include <cmath>

using sceneFiles::goodScene;
using sceneFiles::readAndPlace;

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
        "contacts { default { friction 0.3; cohesion 2; cohesionRange 1e-3; }"
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

TEST(GoodScene, rollingAndSpinningFrictionArrive)
{
    const std::string text = sceneFiles::changed(goodScene(), "friction 0.3;", "friction 0.3; rollingFriction 0.02; spinningFriction 0.01;");
    const nscdGrains::SceneSettings scene = nscdGrains::parseScene(text, "scene");
    EXPECT_EQ(scene.materials.table.pair(1, 1).rollingFriction, 0.02);
    EXPECT_EQ(scene.materials.table.pair(0, 1).spinningFriction, 0.01);
    // The other solvers know none of it.
    EXPECT_THROW(nscdGrains::parseScene(sceneFiles::changed(text, "type NLGS", "type queue"), "scene"), input::InputError);
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
