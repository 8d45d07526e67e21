// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Scenes, settings and calls that cannot be: each is refused in words, and what is small or empty runs.
#include "unit/nscd/scenes/scenes.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

using namespace scenes;

namespace
{

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

Scene goodScene()
{
    Scene scene(3, 0.3, 0.1);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    for (int i = 0; i < 3; ++i) scene.addGrain(Vec3(0.03*i, 0, 0.01), 0.01);
    return scene;
}

/// The message a call is refused with; empty where it is not.
std::string refusal(const std::function<void()>& call)
{
    try
    {
        call();
    }
    catch (const std::invalid_argument& error)
    {
        return error.what();
    }
    return "";
}

struct BadChange
{
    const char* name;
    std::function<void(Scene&, nscd::ContactSettings&)> make;
    const char* says;
};

void PrintTo(const BadChange& bad, std::ostream* os) { *os << bad.name; }

using Settings = nscd::ContactSettings;

const BadChange badChanges[] =
{
    {"nanPosition", [](Scene& s, Settings&) { s.grains.position[1][2] = notANumber; }, "position of grain 1"},
    {"infiniteVelocity", [](Scene& s, Settings&) { s.grains.velocity[2][0] = infinity; }, "velocity of grain 2"},
    {"nanSpin", [](Scene& s, Settings&) { s.grains.omega[0][0] = notANumber; }, "omega of grain 0"},
    {"noOrientation", [](Scene& s, Settings&) { s.grains.orientation[0].coeffs().setZero(); }, "orientation of grain 0"},
    {"zeroRadius", [](Scene& s, Settings&) { s.grains.radius[0] = 0; }, "radius of grain 0 is 0"},
    {"negativeRadius", [](Scene& s, Settings&) { s.grains.radius[0] = -1; }, "radius of grain 0 is -1"},
    {"zeroMass", [](Scene& s, Settings&) { s.grains.mass[0] = 0; }, "mass of grain 0"},
    {"infiniteMass", [](Scene& s, Settings&) { s.grains.mass[0] = infinity; }, "mass of grain 0"},
    {"unknownMaterial", [](Scene& s, Settings&) { s.grains.material[1] = 2; }, "material of grain 1 is 2"},
    {"arrayTooShort", [](Scene& s, Settings&) { s.grains.velocity.pop_back(); }, "length of an array of grains is 2"},
    {"arrayTooLong", [](Scene& s, Settings&) { s.grains.isFixed.push_back(0); }, "length of an array of grains is 4"},
    {"fourDimensions", [](Scene& s, Settings&) { s.grains.shape.dimensions = 4; }, "dimensions of grains is 4"},
    {"flatDiscs", [](Scene& s, Settings&) { s.grains.shape = {2, 0.0}; }, "thickness of discs"},
    {"emptyAxisOfNone", [](Scene& s, Settings&) { s.grains.shape.emptyAxis = 3; }, "empty axis is 3"},
    {"wallOfNoMaterial", [](Scene& s, Settings&) { s.walls.patches[0].material = -1; }, "material of wall wall0 is -1"},
    {"regionOfNoPatch", [](Scene& s, Settings&) { s.walls.regions[0].patch = 1; }, "patch of a wall region is 1"},
    {"nanWall", [](Scene& s, Settings&) { s.walls.regions[0].point[0] = notANumber; }, "point of wall wall0"},
    {"longNormal", [](Scene& s, Settings&) { s.walls.regions[0].normal *= 2; }, "normal of wall wall0"},
    {"pairThatIsMissing", [](Scene& s, Settings&) { s.grains.material[0] = s.materials.add("new"); }, "pair of materials"},
    {"negativePeriod", [](Scene& s, Settings&) { s.box.length[1] = -1; }, "period [m] is -1"},
    {"nanPeriod", [](Scene& s, Settings&) { s.box.length[1] = notANumber; }, "period [m]"},
    {"zeroTolerance", [](Scene&, Settings& c) { c.tolerance = 0; }, "tolerance is 0"},
    {"nanTolerance", [](Scene&, Settings& c) { c.displacementTolerance = notANumber; }, "displacementTolerance"},
    {"noSweeps", [](Scene&, Settings& c) { c.maxSweeps = 0; }, "maxSweeps is 0"},
    {"negativePolish", [](Scene&, Settings& c) { c.polishSweeps = -1; }, "polishSweeps is -1"},
    {"negativeSkin", [](Scene&, Settings& c) { c.skin = -0.1; }, "skin is -0.1"},
    {"negativeDeadBand", [](Scene&, Settings& c) { c.deadBand = -1e-4; }, "deadBand"},
    {"zeroOverlapTolerance", [](Scene&, Settings& c) { c.overlapTolerance = 0; }, "overlapTolerance is 0"},
    {"unknownSolver", [](Scene&, Settings& c) { c.solver = "none"; }, "contact solver is none"},
    {"unknownVectorPath", [](Scene&, Settings& c) { c.vectorPath = "SSE"; }, "vectorPath is SSE"}
};

class BadChanges : public testing::TestWithParam<BadChange> {};

} // namespace

INSTANTIATE_TEST_SUITE_P(Scene, BadChanges, testing::ValuesIn(badChanges), [](const auto& info) { return info.param.name; });

TEST_P(BadChanges, areRefusedInWords)
{
    Scene scene = goodScene();
    Settings settings;
    GetParam().make(scene, settings);
    const std::string said = refusal([&] { scene.build(settings); });
    EXPECT_NE(said.find(GetParam().says), std::string::npos) << said;
    EXPECT_NE(said.find("allowed: "), std::string::npos) << said;
}

TEST(BadCalls, areRefusedInWords)
{
    Scene scene = goodScene();
    nscd::Walls& walls = scene.walls;
    EXPECT_NE(refusal([&] { walls.addPlane(1, Vec3::Zero(), Vec3::UnitX()); }), "");
    EXPECT_NE(refusal([&] { walls.addPlane(0, Vec3(notANumber, 0, 0), Vec3::UnitX()); }), "");
    EXPECT_NE(refusal([&] { walls.addPlane(0, Vec3::Zero(), Vec3(infinity, 0, 0)); }), "");
    EXPECT_NE(refusal([&] { walls.addPolygon(0, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(notANumber, 1, 0)}); }), "");
    EXPECT_NE(refusal([&] { nscd::GrainDynamics(scene.grains, scene.materials, walls, scene.box, Settings(), nullptr); }), "");

    auto dynamics = scene.build();
    for (double deltaT : {0.0, -1e-3, notANumber, infinity}) EXPECT_NE(refusal([&] { dynamics.beginStep(deltaT); }), "") << deltaT;
    EXPECT_THROW(dynamics.advance(weight(scene.grains, scene.g, 1e-3)), std::logic_error);
    EXPECT_THROW(dynamics.predict(weight(scene.grains, scene.g, 1e-3)), std::logic_error);
    dynamics.beginStep(1e-3);
    nscd::ExternalForces forces = weight(scene.grains, scene.g, 1e-3);
    forces.force.pop_back();
    EXPECT_NE(refusal([&] { dynamics.advance(forces); }).find("number of forces is 2"), std::string::npos);
    forces = weight(scene.grains, scene.g, 1e-3);
    forces.implicitDrag = {1.0};
    EXPECT_NE(refusal([&] { dynamics.predict(forces); }).find("number of implicit drags is 1"), std::string::npos);
    forces = weight(scene.grains, scene.g, 1e-3);
    forces.speedScale = notANumber;
    EXPECT_NE(refusal([&] { dynamics.advance(forces); }).find("speed scale"), std::string::npos);
    forces = weight(scene.grains, scene.g, 1e-3);
    forces.force[1][0] = notANumber;
    EXPECT_NE(refusal([&] { dynamics.advance(forces); }).find("force on grain 1"), std::string::npos);
    nscd::Grains bad = scene.grains;
    bad.radius[0] = notANumber;
    EXPECT_NE(refusal([&] { dynamics.setGrains(bad); }).find("radius of grain 0"), std::string::npos);
    EXPECT_NE(refusal([&] { dynamics.restore({{0, -1, Vec3(0, notANumber, 0)}}, 1e-3); }).find("stored impulse of grain 0"), std::string::npos);
    for (double deltaT : {-1e-3, notANumber}) EXPECT_NE(refusal([&] { dynamics.restore({}, deltaT); }), "") << deltaT;
    EXPECT_TRUE(step(dynamics, scene.g, 1e-3).solve.converged);
}

TEST(BadCalls, aSurfaceOfNoVelocityIsRefused)
{
    Scene scene = goodScene();
    scene.walls.setSurfaceMotion(0, nscd::belt(Vec3(notANumber, 0, 0)));
    auto dynamics = scene.build();
    EXPECT_NE(refusal([&] { dynamics.beginStep(1e-3); }).find("surface motion of wall wall0"), std::string::npos);
}

TEST(BadCalls, whatOverflowsIsRefused)
{
    Scene scene = goodScene();
    scene.grains.velocity[1] = Vec3(1e200, 0, 0);
    auto fast = scene.build();
    EXPECT_NE(refusal([&] { fast.beginStep(1e-3); }).find("rms speed of grains"), std::string::npos);

    for (double speed : {1e308, notANumber})
    {
        scene = goodScene();
        scene.walls.setMotion(0, nscd::translationBy(nscd::integralOf([=](double) { return Vec3(0, 0, speed); })));
        EXPECT_NE(refusal([&] { scene.build().beginStep(1e-3); }).find("motion of wall wall0"), std::string::npos) << speed;
    }
}

TEST(SmallScenes, wallsNeedAMaterialWhereGrainsCanMeetThem)
{
    Scene scene(3, 0.3, 0.1);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.walls.patches[0].material = -1;
    auto withoutGrains = scene.build();
    EXPECT_TRUE(step(withoutGrains, scene.g, 1e-3).solve.converged);
    scene.addGrain(Vec3(0, 0, 1), 0.01);
    EXPECT_NE(refusal([&] { withoutGrains.setGrains(scene.grains); }).find("material of wall wall0"), std::string::npos);
    scene.walls.regions.clear();
    auto withoutShape = scene.build();
    EXPECT_TRUE(step(withoutShape, scene.g, 1e-3).solve.converged);
}

TEST(SmallScenes, nothingAndOneGrainRun)
{
    Scene scene(3, 0.3, 0.1);
    auto none = scene.build();
    EXPECT_TRUE(step(none, scene.g, 1e-3).solve.converged);
    EXPECT_EQ(nscd::kineticEnergy(none.grains()), 0);
    scene.addGrain(Vec3::Zero(), 0.01);
    auto alone = scene.build();
    for (int k = 0; k < 10; ++k) EXPECT_TRUE(step(alone, scene.g, 1e-3).solve.converged);
    EXPECT_NEAR(alone.grains().velocity[0][2], -gravity*0.01, 1e-14);
    scene.addPlane(Vec3(0, 0, -0.01), Vec3::UnitZ());
    auto onFloor = scene.build();
    for (int k = 0; k < 10; ++k) EXPECT_TRUE(step(onFloor, scene.g, 1e-3).solve.converged);
    EXPECT_NEAR(onFloor.contactForce()[0][2], scene.grains.mass[0]*gravity, 1e-9*scene.grains.mass[0]*gravity);
}
