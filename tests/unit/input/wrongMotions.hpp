// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Texts that every front end refuses: walls, their motions and belts, driven grains, functions of time, surfaces.
#pragma once

#include "unit/input/frontEnds.hpp"

namespace frontEnds
{

/// A plane beside the walls of the right text, with more keywords.
inline Wrong ofPlane(const char* name, const std::string& more, const std::vector<std::string>& mentions, Space space = Space::spheres)
{
    const std::string normal = space == Space::discs ? "(0 1 0)" : "(0 0 1)";
    return {name, "walls     { ", "walls     { p { type plane; point (0 0 0); normal " + normal + "; " + more + " } ", 5, mentions, space};
}

inline Wrong ofPolygon(const char* name, const std::string& vertices, const std::vector<std::string>& mentions)
{
    return {name, "walls     { ", "walls     { p { type polygon; vertices " + vertices + "; } ", 5, mentions};
}

/// A group of driven grains.
inline Wrong ofDriven(const char* name, const std::string& group, const std::vector<std::string>& mentions, Space space = Space::spheres)
{
    return {name, "driven    { ", "driven    { " + group + " ", 8, mentions, space};
}

inline const std::string turning = "motion { type rotation; origin (0 0 0); axis (0 0 1); ";

inline std::vector<Wrong> wrongWalls()
{
    return
    {
        {"wallOfUnknownType", "type box", "type bocks", 5, {"keyword walls.tray.type", "allowed: plane, polygon, box, stl"}},
        {"emptyBoxOfWalls", "(0.06 0.06 0.2)", "(0.06 0.06 -0.2)", 5, {"keyword walls.tray.box is empty"}},
        {"unknownSide", "(0.06 0.06 0.2);", "(0.06 0.06 0.2); sides (xMin xMix);", 5, {"keyword walls.tray.sides", "value:   xMix", "nearest: xMin"}},
        {"boxWithoutSides", "(0.06 0.06 0.2);", "(0.06 0.06 0.2); sides ();", 5, {"keyword walls.tray.sides is empty", "allowed: xMin, xMax, yMin"}},
        {"wallsOfOneName", "planes    { ", "planes    { tray { point (0 0 0); normal (0 0 1); } ", 5, {"keyword walls.tray is the name of another wall"}},
        {"wallNameWithAComma", "walls     { ", "walls     { \"a,b\" { type plane; point (0 0 0); normal (0 0 1); } ", 5, {"keyword walls.a,b is no name for a column"}},
        {"planeWithoutNormal", "planes    { ", "planes    { lid { point (0 0 1); } ", 6, {"keyword planes.lid.normal is missing"}},
        {"normalWithoutLength", "planes    { ", "planes    { lid { point (0 0 1); normal (0 0 0); } ", 6, {"keyword planes.lid.normal has no length"}},
        {"planeOfUnknownMaterial", "planes    { ", "planes    { lid { point (0 0 1); normal (0 0 -1); material stel; } ", 6, {"keyword planes.lid.material", "nearest: steel"}},
        {"misspeltPoint", "planes    { ", "planes    { lid { pont (0 0 1); normal (0 0 -1); } ", 6, {"keyword planes.lid.pont", "point is missing", "nearest: point"}},
        {"planeAcrossAPeriod", "planes    { ", "planes    { p { point (0 0 0); normal (0 1 0); } ", 6, {"keyword planes.p.normal points along a periodic axis"}, Space::periodicY},
        {"planeOutOfPlane", "planes    { ", "planes    { p { point (0 0 0); normal (0 0 1); } ", 6, {"keyword planes.p.normal leaves the plane of the grains"}, Space::discs},
        ofPlane("sidesOfAPlane", "sides three;", {"keyword walls.p.sides", "allowed: one, both"}),
        ofPlane("torquePointThatIsNone", "torquePoint 1;", {"keyword walls.p.torquePoint is not a vector"}),
        ofPolygon("polygonOfTwo", "((0 0 0) (1 0 0))", {"keyword walls.p.vertices has too few vertices"}),
        ofPolygon("polygonNotFlat", "((0 0 0) (1 0 0) (1 1 0.1) (0 1 0))", {"keyword walls.p.vertices does not lie in one plane"}),
        ofPolygon("polygonWithoutArea", "((0 0 0) (1 0 0) (2 0 0))", {"keyword walls.p.vertices has no area"}),
        ofPolygon("polygonThatIsNone", "(0 0 0)", {"keyword walls.p.vertices is not a list of vectors"}),
        {"surfaceWithoutFile", "walls     { ", "walls     { s { type stl; } ", 5, {"keyword walls.s.file is missing"}},
        {"surfaceThatIsNotThere", "walls     { ", "walls     { s { type stl; file none.stl; } ", 5, {"keyword walls.s.file names a file that does not exist", "none.stl"}},
        {"surfaceOfNoSize", "walls     { ", "walls     { s { type stl; file none.stl; scale 0; } ", 5, {"keyword walls.s.scale is out of range"}}
    };
}

inline std::vector<Wrong> wrongMotions()
{
    return
    {
        ofPlane("motionOfUnknownType", "motion { type rotaton; }", {"keyword walls.p.motion.type", "nearest: rotation"}),
        ofPlane("motionWithoutType", "motion { velocity (0 0 1); }", {"keyword walls.p.motion.type is missing"}),
        ofPlane("motionThatIsAValue", "motion rotation;", {"keyword walls.p.motion is not a dictionary"}),
        ofPlane("rotationWithoutAxis", "motion { type rotation; origin (0 0 0); omega 1; }", {"keyword walls.p.motion.axis is missing"}),
        ofPlane("axisWithoutLength", "motion { type rotation; origin (0 0 0); axis (0 0 0); omega 1; }", {"keyword walls.p.motion.axis has no length"}),
        ofPlane("rotationWithoutSpeed", "motion { type rotation; origin (0 0 0); axis (0 0 1); }", {"keyword walls.p.motion.omega is missing", "table"}),
        ofPlane("misspeltSpeed", turning + "omeg 1; }", {"keyword walls.p.motion.omeg", "omega is missing", "nearest: omega"}),
        ofPlane("speedAndAngle", turning + "omega 1; angle 2; }", {"keyword walls.p.motion.angle stands beside omega"}),
        ofPlane("vectorForSpeed", turning + "omega (0 0 1); }", {"keyword walls.p.motion.omega is not a single value"}),
        ofPlane("textBehindSpeed", turning + "omega 1 2; }", {"keyword walls.p.motion.omega is not a single value", "value:   1 2"}),
        ofPlane("textBehindVelocity", "motion { type translation; velocity (0 0 1) 5; }", {"keyword walls.p.motion.velocity is not a single value"}),
        ofPlane("textBehindTable", turning + "omega table ((0 1) (1 2)) 5; }", {"keyword walls.p.motion.omega is not a table"}),
        ofPlane("numberForVelocity", "motion { type translation; velocity 1; }", {"keyword walls.p.motion.velocity is not a single value"}),
        ofPlane("nanVelocity", "motion { type translation; velocity (0 0 nan); }", {"keyword walls.p.motion.velocity is not a finite number"}),
        ofPlane("overflowingSpeed", turning + "omega 1e999; }", {"keyword walls.p.motion.omega is not a finite number", "value:   1e999"}),
        ofPlane("hugeSpeed", turning + "omega 1e300; }", {"keyword walls.p.motion.omega is too large"}),
        ofPlane("hugeSpeedInATable", turning + "omega table ((0 -1e300) (1 1e300)); }", {"keyword walls.p.motion.omega is too large"}),
        ofPlane("misspeltKeywordOfMotion", "motion { type translation; velocty (0 0 1); }",
            {"keyword walls.p.motion.velocty", "velocity is missing", "nearest: velocity"}),
        ofPlane("misspeltTable", "motion { type translation; velocity tabel ((0 (0 0 1))); }",
            {"keyword walls.p.motion.velocity is no function of time", "value:   tabel", "nearest: table"}),
        ofPlane("tableOfNothing", "motion { type translation; velocity table (); }", {"keyword walls.p.motion.velocity is not a table"}),
        ofPlane("tableOfNumbers", "motion { type translation; velocity table ((0 1) (1 2)); }", {"keyword walls.p.motion.velocity is not a"}),
        ofPlane("tableOutOfOrder", "motion { type translation; velocity table ((1 (0 0 1)) (0 (0 0 2))); }",
            {"keyword walls.p.motion.velocity has rows out of order"}),
        ofPlane("tableWithATimeTwice", turning + "omega table ((0 1) (0 2)); }", {"keyword walls.p.motion.omega has rows out of order"}),
        ofPlane("functionOfUnknownType", "motion { type translation; velocity { type sin; } }", {"keyword walls.p.motion.velocity.type", "nearest: sine"}),
        ofPlane("sineWithoutLevel", turning + "omega { type sine; frequency 1; amplitude 1; scale 1; } }", {"keyword walls.p.motion.omega.level is missing"}),
        ofPlane("sineOfUnknownKeyword", turning + "omega { type sine; frequency 1; amplitude 1; scale 1; level 0; phas 1; } }",
            {"keyword walls.p.motion.omega.phas is not a keyword here"}),
        ofPlane("sineThatIsTooLarge", turning + "omega { type sine; frequency 1; amplitude 1e300; scale 1; level 0; } }",
            {"keyword walls.p.motion.omega.amplitude is too large"}),
        ofPlane("negativeFrequency", "motion { type oscillation; amplitude (0 0 1); frequency -1; }", {"keyword walls.p.motion.frequency is out of range"}),
        ofPlane("sineTooFastToFollow", turning + "omega { type sine; frequency 1e20; amplitude 1; scale 1; level 0; } }",
            {"keyword walls.p.motion.omega.frequency is out of range", "<= 20000"}),
        ofPlane("oscillationTooFastToFollow", "motion { type oscillation; amplitude (0 0 1); frequency 1e20; }", {"keyword walls.p.motion.frequency is out of range"}),
        ofPlane("oscillationWithoutAmplitude", "motion { type oscillation; frequency 1; }", {"keyword walls.p.motion.amplitude is missing"}),
        ofPlane("twoBelts", "surfaceVelocity (1 0 0); surfaceRotation { origin (0 0 0); axis (0 0 1); omega 1; }",
            {"keyword walls.p.surfaceRotation stands beside surfaceVelocity"}),
        ofPlane("misspeltBelt", "surfaceVelocty (1 0 0);", {"keyword walls.p.surfaceVelocty", "nearest: surfaceVelocity"}),
        {"planeTurnsTowardsAPeriod", "planes    { ", "planes    { p { point (0 0 0); normal (0 0 1); motion { type rotation; origin (0 0 0); axis (1 0 0);"
            " omega 1; } } ", 6, {"keyword planes.p.motion.axis turns a plane towards a periodic axis"}, Space::periodicY},
        ofPlane("discsTurnedOver", "motion { type rotation; origin (0 0 0); axis (1 0 0); omega 1; }", {"keyword walls.p.motion.axis turns out of the plane"}, Space::discs),
        ofPlane("discsLeftBehind", "motion { type translation; velocity table ((0 (0 0 0)) (1 (0 0 1))); }",
            {"keyword walls.p.motion.velocity leaves the plane of the grains"}, Space::discs),
        ofPlane("discsShakenOff", "motion { type oscillation; amplitude (0 0 1); frequency 1; }", {"keyword walls.p.motion.amplitude leaves the plane of the grains"}, Space::discs),
        ofPlane("beltOutOfPlane", "surfaceVelocity (0 0 1);", {"keyword walls.p.surfaceVelocity leaves the plane of the grains"}, Space::discs),
        ofPlane("turntableOutOfPlane", "surfaceRotation { origin (0 0 0); axis (0 1 0); omega 1; }",
            {"keyword walls.p.surfaceRotation.axis turns out of the plane"}, Space::discs),
        ofDriven("drivenWithoutIds", "a { velocity (0 0 1); }", {"keyword driven.a.ids is missing"}),
        ofDriven("drivenWithoutVelocity", "a { ids (1); }", {"keyword driven.a.velocity is missing"}),
        ofDriven("misspeltVelocity", "a { ids (1); velocty (0 0 1); }", {"keyword driven.a.velocty", "velocity is missing", "nearest: velocity"}),
        ofDriven("drivenTwice", "a { ids (1 2 1); velocity (0 0 1); }", {"keyword driven.a.ids names grain 1 twice"}),
        ofDriven("drivenByTwo", "a { ids (1 2); velocity (0 0 1); } b { ids (2); velocity (0 0 1); }",
            {"keyword driven.b drives grain 2, which another group drives too"}),
        ofDriven("drivenThatIsNotThere", "a { ids (1 125 126); velocity (0 0 1); }",
            {"keyword driven.a names grains by ids that are not there", "2 of its ids", "0 to 124"}),
        ofDriven("negativeId", "a { ids (-1); velocity (0 0 1); }", {"keyword driven.a.ids is out of range"}),
        ofDriven("halfAnId", "a { ids (1.5); velocity (0 0 1); }", {"keyword driven.a.ids is not a whole number"}),
        ofDriven("idWithoutBrackets", "a { ids 1; velocity (0 0 1); }", {"keyword driven.a.ids is not a list of numbers"}),
        ofDriven("noIds", "a { ids (); velocity (0 0 1); }", {"keyword driven.a.ids is not a list of numbers"}),
        ofDriven("wrongNumberOfIds", "a { ids 3 (1 2); velocity (0 0 1); }", {"keyword driven.a.ids is not a list of numbers"}),
        ofDriven("drivenKeyword", "a { ids (1); velocity (0 0 1); spin (0 0 1); }", {"keyword driven.a.spin is not a keyword here"}),
        ofDriven("drivenOutOfPlane", "a { ids (1); velocity (0 0 1); }", {"keyword driven.a.velocity leaves the plane of the grains"}, Space::discs),
        ofDriven("drivenSpinOutOfPlane", "a { ids (1); velocity (0 1 0); omega table ((0 (0 0 1)) (1 (1 0 0))); }",
            {"keyword driven.a.omega turns out of the plane of the grains"}, Space::discs)
    };
}

/// Contents of STL files that cannot be used, each with what is said of them.
inline std::vector<std::pair<std::string, std::string>> wrongSurfaces()
{
    const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    const auto solid = [&](const std::string& second) { return "solid a\n" + changed(facet, "vertex 1 0 0", second) + "endsolid a\n"; };
    return
    {
        {"", "cannot be used"},
        {"no surface", "cannot be used"},
        {"solid a\nendsolid a\n", "cannot be used"},
        {"solid a\n" + facet.substr(0, 60), "cannot be used"},
        {solid("vertex 1 0 nan"), "line 5"},
        {solid("vertex 1 0 1e999"), "line 5"},
        {solid("vertex 1 0 1e300"), "holds a vertex too far away"},
        {solid("vertex 0 2 0"), "cannot be used"}
    };
}

} // namespace frontEnds
