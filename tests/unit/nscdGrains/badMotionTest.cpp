// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Motions that are wrong in one place: of walls, belts and driven grains, and walls from files.
#include "badScenes.hpp"

using sceneFiles::BadScene;
using sceneFiles::changed;
using sceneFiles::goodScene;

namespace
{

class BadMotions : public testing::TestWithParam<BadScene> {};

/// A plane beside the walls of the good scene, with a motion.
BadScene ofPlane(const char* name, const std::string& motion, const std::vector<std::string>& mentions)
{
    return {name, "walls     { ", "walls     { p { type plane; point (0 0 0); normal (0 0 1); " + motion + " } ", 5, mentions};
}

/// A group of driven grains.
BadScene ofDriven(const char* name, const std::string& group, const std::vector<std::string>& mentions)
{
    return {name, "gravity ", "driven { " + group + " } gravity ", 11, mentions};
}

BadScene ofDrivenDiscs(const char* name, const std::string& group, const std::vector<std::string>& mentions)
{
    return {name, "gravity   (0 0 -9.81)", "dimensions 2; driven { " + group + " }", 11, mentions};
}

const BadScene badMotions[] =
{
    ofPlane("motionOfUnknownType", "motion { type rotaton; }", {"keyword walls.p.motion.type", "nearest: rotation"}),
    ofPlane("motionWithoutType", "motion { velocity (0 0 1); }", {"keyword walls.p.motion.type is missing"}),
    ofPlane("motionThatIsAValue", "motion rotation;", {"keyword walls.p.motion is not a dictionary"}),
    ofPlane("rotationWithoutAxis", "motion { type rotation; origin (0 0 0); omega 1; }", {"keyword walls.p.motion.axis is missing"}),
    ofPlane("axisWithoutLength", "motion { type rotation; origin (0 0 0); axis (0 0 0); omega 1; }", {"keyword walls.p.motion.axis has no length"}),
    ofPlane("rotationWithoutSpeed", "motion { type rotation; origin (0 0 0); axis (0 0 1); }", {"keyword walls.p.motion.omega is missing", "table"}),
    ofPlane("speedAndAngle", "motion { type rotation; origin (0 0 0); axis (0 0 1); omega 1; angle 2; }",
        {"keyword walls.p.motion.angle stands beside omega"}),
    ofPlane("vectorForSpeed", "motion { type rotation; origin (0 0 0); axis (0 0 1); omega (0 0 1); }",
        {"keyword walls.p.motion.omega is not a single value"}),
    ofPlane("numberForVelocity", "motion { type translation; velocity 1; }", {"keyword walls.p.motion.velocity is not a single value"}),
    ofPlane("nanVelocity", "motion { type translation; velocity (0 0 nan); }", {"keyword walls.p.motion.velocity is not a finite number"}),
    ofPlane("misspeltKeywordOfMotion", "motion { type translation; velocty (0 0 1); }",
        {"keyword walls.p.motion.velocty", "velocity is missing", "nearest: velocity"}),
    ofPlane("misspeltTable", "motion { type translation; velocity tabel ((0 (0 0 1))); }",
        {"keyword walls.p.motion.velocity is no function of time", "value:   tabel", "nearest: table"}),
    ofPlane("tableOfNothing", "motion { type translation; velocity table (); }", {"keyword walls.p.motion.velocity is not a table"}),
    ofPlane("tableOfNumbers", "motion { type translation; velocity table ((0 1) (1 2)); }", {"keyword walls.p.motion.velocity is not a"}),
    ofPlane("tableOutOfOrder", "motion { type translation; velocity table ((1 (0 0 1)) (0 (0 0 2))); }",
        {"keyword walls.p.motion.velocity has rows out of order"}),
    ofPlane("tableWithATimeTwice", "motion { type rotation; origin (0 0 0); axis (0 0 1); omega table ((0 1) (0 2)); }",
        {"keyword walls.p.motion.omega has rows out of order"}),
    ofPlane("functionOfUnknownType", "motion { type translation; velocity { type sin; } }",
        {"keyword walls.p.motion.velocity.type", "nearest: sine"}),
    ofPlane("sineWithoutLevel", "motion { type rotation; origin (0 0 0); axis (0 0 1); omega { type sine; frequency 1; amplitude 1; scale 1; } }",
        {"keyword walls.p.motion.omega.level is missing"}),
    ofPlane("sineOfUnknownKeyword", "motion { type rotation; origin (0 0 0); axis (0 0 1); omega { type sine; frequency 1; amplitude 1; scale 1; level 0; phas 1; } }",
        {"keyword walls.p.motion.omega.phas is not a keyword here"}),
    ofPlane("negativeFrequency", "motion { type oscillation; amplitude (0 0 1); frequency -1; }",
        {"keyword walls.p.motion.frequency is out of range"}),
    ofPlane("oscillationWithoutAmplitude", "motion { type oscillation; frequency 1; }", {"keyword walls.p.motion.amplitude is missing"}),
    ofPlane("twoBelts", "surfaceVelocity (1 0 0); surfaceRotation { origin (0 0 0); axis (0 0 1); omega 1; }",
        {"keyword walls.p.surfaceRotation stands beside surfaceVelocity"}),
    ofPlane("misspeltBelt", "surfaceVelocty (1 0 0);", {"keyword walls.p.surfaceVelocty", "nearest: surfaceVelocity"}),
    ofPlane("sidesOfAPlane", "sides three;", {"keyword walls.p.sides", "allowed: one, both"}),
    ofPlane("torquePointThatIsNone", "torquePoint 1;", {"keyword walls.p.torquePoint is not a vector"}),
    {"surfaceWithoutFile", "walls     { ", "walls     { s { type stl; } ", 5, {"keyword walls.s.file is missing"}},
    {"surfaceThatIsNotThere", "walls     { ", "walls     { s { type stl; file none.stl; } ", 5, {"keyword walls.s.file names a file that does not exist", "folder/none.stl"}},
    {"surfaceOfNoSize", "walls     { ", "walls     { s { type stl; file none.stl; scale 0; } ", 5, {"keyword walls.s.scale is out of range"}},
    {"planeTurnsTowardsAPeriod", "periodic  { }", "periodic  { y (0 1); } planes { p { point (0 0 0); normal (0 0 1); motion { type rotation; origin (0 0 0);"
        " axis (1 0 0); omega 1; } } }", 6, {"keyword planes.p.motion.axis turns a plane towards a periodic axis"}},
    ofDriven("drivenWithoutIds", "a { velocity (0 0 1); }", {"keyword driven.a.ids is missing"}),
    ofDriven("drivenWithoutVelocity", "a { ids (1); }", {"keyword driven.a.velocity is missing"}),
    ofDriven("drivenTwice", "a { ids (1 2 1); velocity (0 0 1); }", {"keyword driven.a.ids names grain 1 twice"}),
    ofDriven("drivenByTwo", "a { ids (1 2); velocity (0 0 1); } b { ids (2); velocity (0 0 1); }",
        {"keyword driven.b drives grain 2, which another group drives too"}),
    ofDriven("drivenThatIsNotThere", "a { ids (1 125 126); velocity (0 0 1); }",
        {"keyword driven.a names grains by ids that are not there", "2 of its ids", "0 to 124"}),
    ofDriven("negativeId", "a { ids (-1); velocity (0 0 1); }", {"keyword driven.a.ids is out of range"}),
    ofDriven("halfAnId", "a { ids (1.5); velocity (0 0 1); }", {"keyword driven.a.ids is not a whole number"}),
    ofDriven("idWithoutBrackets", "a { ids 1; velocity (0 0 1); }", {"keyword driven.a.ids is not a list of numbers"}),
    ofDriven("noIds", "a { ids (); velocity (0 0 1); }", {"keyword driven.a.ids is not a list of numbers"}),
    ofDriven("drivenKeyword", "a { ids (1); velocity (0 0 1); spin (0 0 1); }", {"keyword driven.a.spin is not a keyword here"}),
    ofDrivenDiscs("drivenOutOfPlane", "a { ids (1); velocity (0 0 1); }", {"keyword driven.a.velocity leaves the plane of discs"}),
    ofDrivenDiscs("spinOutOfPlane", "a { ids (1); velocity (0 1 0); omega table ((0 (0 0 1)) (1 (1 0 0))); }",
        {"keyword driven.a.omega turns out of the plane of discs"})
};

/// What a wall in a scene of discs must not do.
std::string complaintInPlane(const std::string& motion)
{
    try
    {
        nscdGrains::parseScene
        (
            "dimensions 2; deltaT 1e-3; endTime 1; materials { glass { density 2500; } } contacts { default { friction 0.3; } }\n"
            "grains { type lattice; box (0 0 0) (1 1 1); spacing 0.5; diameter 0.1; }\n"
            "planes { p { point (0 -1 0); normal (0 1 0); " + motion + " } }", "scene"
        );
    }
    catch (const nscdGrains::SceneError& error)
    {
        return error.what();
    }
    return "";
}

} // namespace

INSTANTIATE_TEST_SUITE_P(Scene, BadMotions, testing::ValuesIn(badMotions), [](const auto& info) { return info.param.name; });

TEST_P(BadMotions, areRefusedInWords)
{
    expectRefused(GetParam());
}

TEST(BadMotionsOfDiscs, areRefusedInWords)
{
    const auto expect = [](const std::string& motion, const std::string& words)
    {
        EXPECT_NE(complaintInPlane(motion).find(words), std::string::npos) << motion << '\n' << complaintInPlane(motion);
    };
    expect("motion { type rotation; origin (0 0 0); axis (1 0 0); omega 1; }", "scene, line 3: keyword planes.p.motion.axis turns out of the plane");
    expect("motion { type translation; velocity table ((0 (0 0 0)) (1 (0 0 1))); }", "planes.p.motion.velocity leaves the plane of discs");
    expect("motion { type oscillation; amplitude (0 0 1); frequency 1; }", "planes.p.motion.amplitude leaves the plane of discs");
    expect("surfaceVelocity (0 0 1);", "planes.p.surfaceVelocity leaves the plane of discs");
    expect("surfaceRotation { origin (0 0 0); axis (0 1 0); omega 1; }", "planes.p.surfaceRotation.axis turns out of the plane");
    EXPECT_EQ(complaintInPlane("motion { type rotation; origin (0 0 0); axis (0 0 -1); omega 1; } surfaceVelocity (1 0 0);"), "");
}

class BadSurfaces : public sceneFiles::InFolder
{
protected:
    std::string complaint(const std::string& stl) const
    {
        write("bad.stl", stl);
        try
        {
            nscdGrains::parseScene(changed(goodScene(), "walls     { ", "walls     { s { type stl; file bad.stl; } "), folder/"scene");
        }
        catch (const nscdGrains::SceneError& error)
        {
            return error.what();
        }
        return "";
    }
};

TEST_F(BadSurfaces, areRefusedInWords)
{
    const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    EXPECT_EQ(complaint("solid a\n" + facet + "endsolid a\n"), "");
    for (const std::string& stl : {std::string(), std::string("no surface"), std::string("solid a\nendsolid a\n"), "solid a\n" + facet.substr(0, 60),
                                   "solid a\n" + changed(facet, "vertex 1 0 0", "vertex 1 0 nan") + "endsolid a\n",
                                   "solid a\n" + changed(facet, "vertex 1 0 0", "vertex 0 2 0") + "endsolid a\n"})
    {
        const std::string said = complaint(stl);
        EXPECT_NE(said.find("scene, line 5: keyword walls.s.file cannot be used: "), std::string::npos) << stl << '\n' << said;
    }
}
