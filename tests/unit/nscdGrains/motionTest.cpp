// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Functions of time, moving walls, belts, surfaces from files and driven grains: as read, and in runs.
#include "nscd/tools/sceneCheckpoint.hpp"
#include "sceneFiles.hpp"
#include "sceneRun.hpp"

#include <cmath>
#include <functional>
#include <sstream>

using nscd::Vec3;
using sceneFiles::bytesOf;
using sceneFiles::changed;
using sceneFiles::goodScene;

namespace
{

/// The walls of the good scene and a lid, at a time.
nscd::WallPatch lidAt(const std::string& more, double time)
{
    const std::string lid = "planes { lid { point (0 0 1); normal (0 0 -1); " + more + " } }\nwalls ";
    nscd::Walls walls = nscdGrains::parseScene(changed(goodScene(), "walls ", lid), "scene").walls;
    nscd::moveWalls(walls, time);
    EXPECT_EQ(walls.patches[0].name, "lid");
    return walls.patches[0];
}

const char* const twoFacets =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 120 0 0\nvertex 0 120 0\nendloop\nendfacet\n"
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 1\nvertex 2 2 2\nendloop\nendfacet\nendsolid a\n";

class Motions : public sceneFiles::InFolder
{
protected:
    void run(const std::string& name, const std::string& text, bool goesOn = false) const
    {
        write(name, text + "results " + name + ".out;\n");
        std::ostringstream log;
        nscdGrains::runScene({folder/name, goesOn, false}, log);
    }

    std::string result(const std::string& scene, const std::string& file) const { return bytesOf(folder/(scene + ".out")/file); }

    /// The last row of walls.csv: time, then force and torque of each wall.
    std::vector<double> lastWallRow(const std::string& scene) const
    {
        std::istringstream text(result(scene, "walls.csv"));
        std::string line, last;
        while (std::getline(text, line)) last = line;
        std::vector<double> row;
        std::istringstream cells(last);
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
        return row;
    }
};

/// A sphere of 0.01 m on a floor.
std::string onFloor(const std::string& motion, const std::string& more = "")
{
    return "materials { glass { density 2500; } } contacts { default { friction 0.5; spinningFriction 0.05; } }\n"
        "grains { type lattice; box (-1 -1 0) (1 1 0.01); count (1 1 1); diameter 0.01; }\n"
        "planes { floor { point (0 0 0); normal (0 0 1); " + motion + " } }\n"
        "solver { tolerance 1e-10; displacementTolerance 1e-10; } deltaT 1e-3; endTime 0.05;\n" + more;
}

const double mass = 2500*M_PI/6*1e-6;

} // namespace

TEST(MovingWalls, areThoseOfNscdDEMFoam)
{
    EXPECT_NEAR(lidAt("motion { type translation; velocity table ((0 (0 0 0)) (2 (0 0 -1))); }", 2).pose.translation()[2], -1, 1e-11);
    EXPECT_NEAR(lidAt("motion { type translation; velocity table ((0 (0 0 0)) (2 (0 0 -1))); }", 3).pose.translation()[2], -2, 1e-11);
    EXPECT_NEAR(lidAt("motion { type translation; displacement table ((0 (0 0 0)) (2 (0 0 -1))); }", 1).pose.translation()[2], -0.5, 1e-14);
    EXPECT_NEAR(lidAt("motion { type oscillation; amplitude (0 0 0.1); frequency 5; phase 0.3; }", 0.07).pose.translation()[2],
                0.1*std::sin(2*M_PI*5*0.07 + 0.3), 1e-14);
    const nscd::WallPatch turned = lidAt
    (
        "motion { type rotation; origin (1 0 0); axis (0 0 2); omega { type sine; frequency 1; amplitude 2; scale 1; level 0; } }", 0.4
    );
    const double angle = 2*(1 - std::cos(2*M_PI*0.4))/(2*M_PI);
    EXPECT_NEAR((turned.pose*Vec3(2, 0, 0) - Vec3(1 + std::cos(angle), std::sin(angle), 0)).norm(), 0, 1e-11);
    EXPECT_EQ(turned.torquePoint, Vec3(1, 0, 0));
    const std::string byAngle = "motion { type rotation; origin (1 0 0); axis (0 0 1); angle 0.5; } torquePoint (0 0 2);";
    EXPECT_NEAR((lidAt(byAngle, 0).pose*Vec3(2, 0, 0) - Vec3(1 + std::cos(0.5), std::sin(0.5), 0)).norm(), 0, 1e-14);
    EXPECT_EQ(lidAt(byAngle, 0).torquePoint, Vec3(0, 0, 2));
    EXPECT_EQ(lidAt("surfaceVelocity (1 2 3);", 0).surfaceMotion(7).at(Vec3::Zero()), Vec3(1, 2, 3));
    EXPECT_EQ(lidAt("surfaceRotation { origin (0 0 0); axis (0 0 3); omega 2; }", 0).surfaceMotion(0).at(Vec3(1, 0, 0)), Vec3(0, 2, 0));
    EXPECT_FALSE(lidAt("", 0).hasVelocity());
}

TEST_F(Motions, surfacesComeFromFiles)
{
    write("two.stl", twoFacets);
    const auto read = [&](const std::string& more)
    {
        return nscdGrains::parseScene(changed(goodScene(), "walls     { ", "walls     { s { type stl; file two.stl; " + more + " } "), folder/"scene");
    };
    const nscdGrains::SceneSettings scene = read("scale 0.001; sides one;");
    ASSERT_EQ(scene.walls.regions.size(), 7u);
    EXPECT_EQ(scene.walls.regions[0].edges[0].end, Vec3(0.12, 0, 0));
    EXPECT_FALSE(scene.walls.regions[0].isTwoSided);
    EXPECT_TRUE(read("").walls.regions[0].isTwoSided);
    ASSERT_EQ(scene.notes.size(), 1u);
    EXPECT_NE(scene.notes[0].find("wall s: 1 triangles without area"), std::string::npos);
}

/// A floor that rises carries weight and inertia: m (g + a).
TEST_F(Motions, aLiftCarriesWeightAndInertia)
{
    run("lift", onFloor("motion { type translation; velocity table ((0 (0 0 0)) (1 (0 0 5))); }"));
    const nscd::SceneState state = nscd::readCheckpoint(folder/"lift.out/state/state.000000050");
    EXPECT_NEAR(state.grains.position[0][2], 0.005 + 0.5*5*0.05*0.05, 1e-6);
    EXPECT_NEAR(lastWallRow("lift")[3], -mass*(9.81 + 5), 1e-6*mass*9.81);
}

/// A turntable takes a sphere along by spinning friction, kappa m R^2 domega/dt = mu_s R m g, and feels the opposite torque.
TEST_F(Motions, aTurntableTakesASphereAlong)
{
    for (const char* motion : {"motion { type rotation; origin (0 0 0); axis (0 0 1); omega 20; }",
                               "surfaceRotation { origin (0 0 0); axis (0 0 1); omega constant 20; }"})
    {
        run("table", onFloor(motion));
        const nscd::SceneState state = nscd::readCheckpoint(folder/"table.out/state/state.000000050");
        EXPECT_NEAR(state.grains.omega[0][2], 0.05*0.05*9.81/(0.4*0.005), 1e-9*20);
        EXPECT_NEAR(lastWallRow("table")[6], -0.05*0.005*mass*9.81, 1e-8*0.05*0.005*mass*9.81);
        std::filesystem::remove_all(folder/"table.out");
    }
}

TEST_F(Motions, drivenGrainsGoWhereTheirVelocityLeads)
{
    run("driven", onFloor("", "driven { probe { ids (0); velocity { type sine; frequency 10; amplitude 1; scale (1 0 2); level (0 0 0); } omega (0 0 7); } }"));
    const nscd::SceneState state = nscd::readCheckpoint(folder/"driven.out/state/state.000000050");
    const double way = (1 - std::cos(2*M_PI*10*0.05))/(2*M_PI*10);
    EXPECT_NEAR((state.grains.position[0] - Vec3(way, 0, 0.005 + 2*way)).norm(), 0, 1e-9);
    EXPECT_NEAR((state.grains.omega[0] - Vec3(0, 0, 7)).norm(), 0, 1e-13);
    EXPECT_EQ(state.grains.isFixed[0], 1);
}

/// All that moves at once, stopped in the middle.
TEST_F(Motions, goOnToTheBit)
{
    write("two.stl", twoFacets);
    std::string text = changed(goodScene(), "friction 0.3;", "friction 0.3; rollingFriction 0.05; spinningFriction 0.02; cohesion 1e-4;");
    text = changed(text, "box (0 0 0) (0.06 0.06 0.2)", "box (0 0 -0.01) (0.06 0.06 0.2)");
    text = changed(text, "walls     { ",
        "walls     { paddle { type stl; file two.stl; scale 0.001; motion { type rotation; origin (0.03 0.03 0.1); axis (1 0 0);"
        " omega table ((0 2) (1 9)); } } ");
    text += "planes { belt { point (0 0 0); normal (0 0 1); surfaceVelocity { type sine; frequency 7; amplitude 1; scale (1 0 0); level (0.1 0 0); }"
        " motion { type oscillation; amplitude (0 0 1e-3); frequency 20; } } }\n"
        "driven { a { ids (3 40); velocity table ((0 (0 0 0)) (0.05 (0.1 0 0))); omega (0 3 0); } }\n";
    run("whole", text);
    run("parts", changed(text, "endTime   0.09", "endTime   0.03"));
    run("parts", text, true);
    for (const char* const file : {"report.csv", "walls.csv", "grains/grains.000000090.vtp", "contacts/contacts.000000090.vtp", "state/state.000000090"})
    {
        EXPECT_EQ(result("parts", file), result("whole", file)) << file;
    }
    EXPECT_NE(result("whole", "walls.csv").find("\ntime,belt.forceX,belt.forceY,belt.forceZ,belt.torqueX"), std::string::npos);
    const std::vector<double> row = lastWallRow("whole");
    ASSERT_EQ(row.size(), 19u);   // belt, paddle, tray
    EXPECT_EQ(row[0], 0.09);
    EXPECT_GT(std::abs(row[1]), 0);
    EXPECT_GT(std::abs(row[10]), 0);
}

TEST_F(Motions, goOnWithOtherWallsOnceTheirTableIsMovedAway)
{
    const std::string text = goodScene(), longer = changed(text, "endTime   0.09", "endTime   0.12");
    const std::string other = changed(longer, "walls ", "planes { lid { point (0 0 0.2); normal (0 0 -1); } }\nwalls ");
    run("scene", text);
    const std::string before = result("scene", "walls.csv");
    try
    {
        run("scene", other, true);
        ADD_FAILURE() << "rows of other walls were appended";
    }
    catch (const std::runtime_error& error)
    {
        EXPECT_NE(std::string(error.what()).find("walls.csv has other columns"), std::string::npos) << error.what();
    }
    EXPECT_EQ(result("scene", "walls.csv"), before);
    std::filesystem::remove(folder/"scene.out/walls.csv");
    run("scene", other, true);
    EXPECT_EQ(lastWallRow("scene").size(), 13u);
}
