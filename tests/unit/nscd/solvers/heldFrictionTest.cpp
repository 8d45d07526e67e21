// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of steps that Coulomb's law gives no solution, or none that sweeps find: jams on belts, light grains wedged between heavy ones.
#include "unit/nscd/scenes/randomProblem.hpp"
#include "unit/nscd/scenes/clumpScenes.hpp"

#include "nscd/base/formattedText.hpp"
#include "nscd/scene/stepWarnings.hpp"
#include "nscd/solvers/heldFriction.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

using namespace scenes;

namespace
{

double energyOf(const nscd::Grains& grains)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const double spin2 = (grains.radius[i]*grains.omega[i]).squaredNorm();
        sum += 0.5*grains.mass[i]*(grains.velocity[i].squaredNorm() + grains.shape.inertiaFactor()*spin2);
    }
    return sum;
}

double weightOf(const nscd::Grains& grains)
{
    double sum = 0.0;
    for (double mass : grains.mass) sum += mass*gravity;
    return sum;
}

/// What came of a run.
struct Outcome
{
    int atCap = 0, held = 0, unnamed = 0;   ///< steps; the last: not converged, and without a word
    double overlap = 0.0;                   ///< largest before its correction [d]
    double wallForce = 0.0;                 ///< largest on any patch, in weights of all grains
    double energy = 0.0;                    ///< largest kinetic energy [J]
    double lastEnergy = 0.0;
    std::vector<Vec3> position;
};

Outcome run(const Scene& scene, double deltaT, int steps)
{
    auto dynamics = scene.build(nscd::ContactSettings());
    Outcome outcome;
    for (int k = 0; k < steps; ++k)
    {
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        outcome.atCap += report.solve.atCap;
        outcome.held += report.solve.isHeld;
        outcome.unnamed += !report.solve.converged && !report.solve.atCap && nscd::warnings(report.solve).empty();
        outcome.overlap = std::max(outcome.overlap, report.overlapUncorrected);
        for (const Vec3& force : dynamics.wallForce()) outcome.wallForce = std::max(outcome.wallForce, force.norm()/weightOf(scene.grains));
        outcome.lastEnergy = energyOf(dynamics.grains());
        outcome.energy = std::max(outcome.energy, outcome.lastEnergy);
    }
    outcome.position = dynamics.grains().position;
    return outcome;
}

const Vec3 tray(0.0056, 0.0112, 0.011);

/// 54 spheres in a closed tray, whose floor is a belt.
Scene tossedGrains(double friction, double beltSpeed)
{
    Scene scene(3, friction, 0.3);
    nscd::addLattice(scene.grains, {{0, 0, 0}, {tray[0], tray[1], 0.0056}, {3, 6, 3}, 0.85e-3, 0.333, 1.0}, 2500.0, 0);
    for (int axis = 0; axis < 3; ++axis) scene.addPlane(tray, -Vec3::Unit(axis));
    for (int axis = 0; axis < 3; ++axis) scene.addPlane(Vec3::Zero(), Vec3::Unit(axis));
    if (beltSpeed > 0.0) scene.walls.setSurfaceMotion(5, nscd::belt(Vec3(beltSpeed, 0, 0)));
    return scene;
}

int outside(const Outcome& outcome)
{
    int count = 0;
    for (const Vec3& x : outcome.position) count += !((x.array() > 0.0).all() && (x.array() < tray.array()).all());
    return count;
}

/// A sphere in the corner between a belt that runs to the wall and the wall: N (1 - mu^2) = m g has no N > 0 for mu >= 1.
Scene cornered(double friction)
{
    Scene scene(3, friction, 0.0);
    scene.addGrain(Vec3(0.01, 0, 0.01), 0.01);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.addPlane(Vec3::Zero(), Vec3::UnitX());
    scene.walls.setSurfaceMotion(0, nscd::belt(Vec3(-0.1, 0, 0)));
    return scene;
}

/// A ball of 10 mm, a little off the middle of four of 0.5 mm.
Scene ballOnFour(double aside)
{
    const double small = 0.25e-3, large = 5e-3, apart = 1.5*small;
    Scene scene(3, 0.5, 0.0);
    for (int k = 0; k < 4; ++k) scene.addGrain(Vec3(k % 2 ? apart : -apart, k/2 ? apart : -apart, small), small);
    scene.addGrain(Vec3(aside, 0, small + 1.0001*std::sqrt(std::pow(large + small, 2) - std::pow(apart - aside, 2) - apart*apart)), large);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    return scene;
}

/// Spheres of 0.5 to 10 mm, as many of each size as make about equal volumes, at random places in a box: masses 1:8000.
Scene mixedSizes(int count)
{
    const double smallest = 0.5e-3, largest = 10e-3, width = 2.2*largest, height = 1.5*largest;
    Scene scene(3, 0.5, 0.0);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<double> radii;
    for (int k = 0; k < count; ++k)
    {
        const double ofSmallest = std::pow(smallest, -2), ofLargest = std::pow(largest, -2);
        radii.push_back(0.5/std::sqrt(ofLargest + unit(random)*(ofSmallest - ofLargest)));
    }
    std::sort(radii.begin(), radii.end(), std::greater<double>());
    scene.scatter(radii, Vec3(width, width, height), random);
    scene.addOpenBox(width);
    return scene;
}

} // namespace

TEST(HeldFriction, bringsNoEnergyOntoABelt)
{
    for (double friction : {1.0, 1.5, 2.0, 1e6})
    {
        const Outcome outcome = run(tossedGrains(friction, 0.04), 2.5e-3, 200);
        EXPECT_LE(outcome.atCap, 2) << friction;
        EXPECT_GT(outcome.held, 0) << friction;
        EXPECT_EQ(outcome.unnamed, 0) << friction;
        EXPECT_EQ(outside(outcome), 0) << friction;
        EXPECT_LT(outcome.lastEnergy, 1e-7) << friction;
        EXPECT_LT(outcome.energy, 1e-6) << friction;   // that of the fall
        EXPECT_LT(outcome.wallForce, 20.0) << friction;
    }
}

// Clumps and spheres in a tray on a belt.
TEST(HeldFriction, holdsClumps)
{
    Scene scene(3, 2.0, 0.0);
    const Vec3 size(0.13, 0.09, 0.11);
    const int shapes[2] = {addShape(scene, pebble()), addShape(scene, dumbbell(1.6))};
    for (int k = 0; k < 12; ++k)
    {
        const Vec3 x(0.023 + 0.042*(k % 3), 0.023 + 0.042*(k/3 % 2), 0.023 + 0.042*(k/6));
        addClump(scene, shapes[k % 2], x, Quaternion(1.0, 0.3*std::sin(k), 0.4*std::cos(2*k), 0.2*std::sin(3*k)).normalized());
        scene.addGrain(x + Vec3(0.02, 0.02, 0.021), 0.004);
    }
    for (int axis = 0; axis < 3; ++axis) scene.addPlane(size, -Vec3::Unit(axis));
    for (int axis = 0; axis < 3; ++axis) scene.addPlane(Vec3::Zero(), Vec3::Unit(axis));
    scene.walls.setSurfaceMotion(5, nscd::belt(Vec3(0.4, 0, 0)));
    const Outcome outcome = run(scene, 2.5e-3, 80);
    EXPECT_LE(outcome.atCap, 2);
    EXPECT_GT(outcome.held, 20);
    EXPECT_EQ(outcome.unnamed, 0);
    EXPECT_LT(outcome.energy, 0.1);
    for (const Vec3& x : outcome.position) EXPECT_TRUE((x.array() > 0.0).all() && (x.array() < size.array()).all());
}

// Where friction is not held the same scene creates energy, and says so.
TEST(HeldFriction, andEnergyFromNowhereIsNamed)
{
    const Scene scene = tossedGrains(2.0, 0.04);
    nscd::ContactSettings settings;
    settings.strategy.held.isOn = false;
    auto dynamics = scene.build(settings);
    bool isNamed = false;
    for (int k = 0; k < 100 && !isNamed; ++k)
    {
        const nscd::SolveReport report = step(dynamics, scene.g, 2.5e-3).solve;
        isNamed = report.createdEnergy > 0.0 && nscd::warning(report).find("created") != std::string::npos;
    }
    EXPECT_TRUE(isNamed);
}

TEST(HeldFriction, isRareWhereNothingDrives)
{
    for (double friction : {1.0, 1.5, 2.0})
    {
        const Outcome outcome = run(tossedGrains(friction, 0.0), 2.5e-3, 200);
        EXPECT_LE(outcome.atCap, 2) << friction;
        EXPECT_LE(outcome.held, 20) << friction;   // 1 to 7, where grains fall on one another
        EXPECT_EQ(outside(outcome), 0) << friction;
        EXPECT_LT(outcome.lastEnergy, 1e-8) << friction;
    }
}

TEST(HeldFriction, boundsTheForcesOfAJam)
{
    for (double friction : {1.0, 1.2, 3.0})
    {
        const Outcome outcome = run(cornered(friction), 1e-3, 50);
        EXPECT_EQ(outcome.atCap, 0) << friction;
        // Round-off decides when it climbs the wall or leaves it: with friction 1.2, 27 held steps in one build and over 40 in others, 44 weights at most.
        EXPECT_GE(outcome.held, friction > 1.0 ? 15 : 1) << friction;
        EXPECT_EQ(outcome.unnamed, 0) << friction;
        EXPECT_LT(outcome.wallForce, 100.0) << friction;
        EXPECT_LT(outcome.overlap, 1e-3) << friction;
    }
    EXPECT_EQ(run(cornered(0.7), 1e-3, 50).held, 0);
}

TEST(HeldFriction, solvesAHeavyBallOnLightOnes)
{
    for (double aside : {0.0, 1e-6, 1e-5, 1e-4})
    {
        const Outcome outcome = run(ballOnFour(aside), 1e-3, 50);
        EXPECT_EQ(outcome.atCap, 0) << aside;
        EXPECT_LT(outcome.overlap, 1e-3) << aside;
    }
}

TEST(HeldFriction, solvesMixesOfUnlikeSizes)
{
    const Outcome outcome = run(mixedSizes(300), 1e-3, 100);
    EXPECT_LE(outcome.atCap, 5);
    EXPECT_EQ(outcome.unnamed, 0);
    EXPECT_LT(outcome.overlap, 2e-3);
    EXPECT_LT(outcome.lastEnergy, 0.1*outcome.energy);
}

// What Coulomb's law has a solution for is solved by it.
TEST(HeldFriction, becomesCoulombsWhereThatHasASolution)
{
    RandomProblem random(6);
    for (nscd::ContactBlock& block : random.blocks)
    {
        for (int lane = 0; lane < nscd::blockLanes; ++lane)
        {
            for (int k = 0; k < 3; ++k) block.r[k][lane] = 0.0;
            block.friction[lane] = 0.3;
        }
    }
    nscd::ContactProblem problem = random.problem();
    nscd::ContactSettings settings;
    settings.tolerance = 1e-6;
    settings.displacementTolerance = 1e-9;
    settings.strategy.held.pressure = 1e3;
    settings.strategy.held.sweeps = 1000;
    const nscd::SolveReport report = nscd::solveHeld(problem, settings);
    EXPECT_TRUE(report.converged);
    EXPECT_FALSE(report.isHeld);
    EXPECT_LE(report.residualRms, 1e-6);
    for (const nscd::ContactBlock& block : random.blocks) EXPECT_EQ(block.friction[0], 0.3);
}

// |r_t| is the bound itself where a contact slides, whatever presses; by every vector path.
TEST(HeldFriction, isBoundByANumber)
{
    for (const char* path : {"portable", "AVX2", "AVX512"})
    {
        if (!isAvailable(path)) continue;
        RandomProblem random(1);
        random.kernels = nscd::held(nscd::chooseKernels(path));
        for (double& tau : random.blocks[0].friction) tau = 1e-3;
        random.kernels.sweep(random.bodies.data(), random.blocks.data(), random.all());
        const nscd::ContactBlock& block = random.blocks[0];
        for (int lane = 0; lane < nscd::blockLanes; ++lane)
        {
            const Vec3 n(block.n[0][lane], block.n[1][lane], block.n[2][lane]), r(block.r[0][lane], block.r[1][lane], block.r[2][lane]);
            EXPECT_NEAR((r - r.dot(n)*n).norm(), 1e-3, 1e-14) << path;
        }
        EXPECT_LT(random.kernels.evaluate(random.bodies.data(), random.blocks.data(), random.all()).maxSquare, 1e-24) << path;
    }
}

TEST(FrictionBounds, giveCoefficientsBack)
{
    RandomProblem random(2);
    nscd::ContactProblem problem = random.problem();
    {
        nscd::FrictionBounds bounds(problem);
        EXPECT_EQ(random.blocks[1].friction[3], 0.0);
        bounds.limit(0.25);
        bounds.follow(1.0, true);
        // r_n is 0.1 everywhere, a quarter of which and of the weight is less.
        const double mobility = std::min(random.bodies[random.blocks[1].a[3]].invMass, random.bodies[random.blocks[1].b[3]].invMass);
        EXPECT_NEAR(random.blocks[1].friction[3], 0.5*std::min(0.1, 0.25*(0.1 + 1.0/mobility)), 1e-15);
        bounds.fade(0.5);
        bounds.follow(1.0, false);
        EXPECT_NEAR(random.blocks[1].friction[3], 0.25*std::min(0.1, 0.25*(0.1 + 1.0/mobility)), 1e-15);
    }
    EXPECT_EQ(random.blocks[1].friction[3], 0.5);
}

namespace
{

/// What came of grains under a lid that comes down on them by a tenth of a diameter a step.
struct Pressed
{
    int squeezed = 0, unnamed = 0;   ///< steps; the last: squeezed, and without a word
    double fastest = 0.0;            ///< of any grain at any time, over the lid's speed
    double overlap = 0.0, overlapAtEnd = 0.0;   ///< [d]
    int squeezedAtEnd = 0;           ///< of the last 50 steps
};

/// 288 grains, periodic sideways, until they fill 0.68 of what is below the lid, more than spheres at random can; then the lid waits for 200 steps.
Pressed pressBed(double friction, double restitution)
{
    const double d = 1e-3, side = 6*d, top = 12*d, dt = 1e-3, low = 288*d*d*d*0.5236/(0.68*side*side);
    Scene scene(3, friction, restitution);
    scene.box.length = Vec3(side, side, 0);
    nscd::addLattice(scene.grains, {{0, 0, 0}, {side, side, 10*d}, {6, 6, 8}, d, 0.0, 0.5}, 2650.0, 0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    const int lid = scene.walls.addPatch("lid", 1);
    scene.walls.addPlane(lid, Vec3(0, 0, top), -Vec3::UnitZ());
    const double speed = 0.1*d/dt;
    scene.walls.setMotion(lid, nscd::translationBy([=](double t) { return Vec3(0, 0, std::max(low - top, -speed*t)); }));
    auto dynamics = scene.build(nscd::ContactSettings());
    const int steps = static_cast<int>((top - low)/(speed*dt)) + 200;
    Pressed pressed;
    for (int k = 0; k < steps; ++k)
    {
        const nscd::StepReport report = step(dynamics, scene.g, dt);
        const auto warnings = nscd::warnings(report.solve);
        const bool isNamed = std::any_of(warnings.begin(), warnings.end(), [](const nscd::Warning& w) { return w.kind == "squeezed"; });
        pressed.squeezed += report.solve.isSqueezed;
        pressed.unnamed += report.solve.isSqueezed && !isNamed;
        pressed.squeezedAtEnd += k >= steps - 50 && report.solve.isSqueezed;
        pressed.overlap = std::max(pressed.overlap, report.overlapMax);
        pressed.overlapAtEnd = report.overlapMax;
        for (const Vec3& v : dynamics.grains().velocity) pressed.fastest = std::max(pressed.fastest, v.norm()/speed);
    }
    return pressed;
}

} // namespace

/// Nothing keeps all apart: grains overlap by what the lid takes, none flies off (9.5 times as fast as the lid where such steps are left as they end), the log
/// says so, and it ends once the lid waits.
TEST(Squeezed, grainsWithoutRoomStayWhereTheyAre)
{
    for (const auto& [friction, restitution] : {std::pair(0.0, 0.0), std::pair(0.3, 0.0), std::pair(0.3, 0.5), std::pair(1.0, 0.0)})
    {
        SCOPED_TRACE(nscd::formatted("friction %g, restitution %g", friction, restitution));
        const Pressed pressed = pressBed(friction, restitution);
        EXPECT_GT(pressed.squeezed, 0);
        EXPECT_EQ(pressed.unnamed, 0);
        EXPECT_LT(pressed.fastest, 5.0);
        EXPECT_LT(pressed.overlap, 0.3);
        EXPECT_EQ(pressed.squeezedAtEnd, 0);
        EXPECT_LT(pressed.overlapAtEnd, 0.1);
    }
}
