// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a step of a heap of clumps at rest costs, all awake and asleep. CSV.
// restingClumps [clumps=2000] [settling=1500] [damped=600] [steps=100] [rolling=0]: dumbbells, tetrapods and pebbles, turned at random, fall into a box and come to rest
// at the default settings, for the last `damped` steps in a viscous medium; then the same state goes on with sleep off and on, undamped, until nothing changes any more in the number
// of those that sleep, and `steps` steps are measured. `carried`: by all walls, over the weight; `moved`: how far a member of either has come from where it began, in R.
#include "unit/nscd/scenes/clumpScenes.hpp"
#include "unit/nscd/scenes/heaps.hpp"
#include "unit/nscd/scenes/lawScenes.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Value of an option, a number.
double option(int argc, char** argv, const char* name, double usual)
{
    const std::size_t length = std::strlen(name);
    for (int k = 1; k < argc; ++k)
    {
        if (std::strncmp(argv[k], name, length) == 0 && argv[k][length] == '=') return std::atof(argv[k] + length + 1);
    }
    return usual;
}

Scene heapOfClumps(int clumps, double rolling)
{
    Scene scene(3, 0.0, 0.0);
    setAll(scene, rollingPair(0.5, rolling));
    const int shapes[3] = {addShape(scene, dumbbell()), addShape(scene, tetrapod()), addShape(scene, pebble())};
    const int side = static_cast<int>(std::cbrt(clumps) + 0.5);
    const double cell = 4.6*memberRadius;
    scene.addOpenBox(cell*side);
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (int k = 0; k < clumps; ++k)
    {
        Quaternion turn;
        turn.coeffs() = Eigen::Vector4d(normal(random), normal(random), normal(random), normal(random));
        const Vec3 place(k % side + 0.5, k/side % side + 0.5, k/(side*side) + 0.5);
        addClump(scene, shapes[k % 3], cell*place, turn.normalized());
    }
    return scene;
}

double largestMove(const nscd::Grains& a, const nscd::Grains& b)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a.position[i] - b.position[i]).norm());
    return largest;
}

void measure(const char* name, nscd::GrainDynamics& dynamics, const nscd::Grains& start, int waited, int steps)
{
    const double from = now();
    double sweeps = 0.0;
    nscd::StepReport last;
    for (int k = 0; k < steps; ++k)
    {
        last = step(dynamics, Vec3(0, 0, -gravity), deltaT);
        sweeps += last.solve.sweeps;
    }
    const double milli = 1e3*(now() - from)/steps, all = gravity*totalMass(start);
    double carried = 0.0;
    for (const Vec3& force : dynamics.wallForce()) carried -= force[2];
    std::printf("%s,%zu,%zu,%zu,%d,%zu,%.1f,%.4f,%.4f,%.1e\n", name, start.clumps.size(), start.size(), last.solve.contacts, waited, last.asleep, sweeps/steps, milli,
                carried/all, largestMove(dynamics.grains(), start)/memberRadius);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
    Scene scene = heapOfClumps(static_cast<int>(option(argc, argv, "clumps", 2000)), option(argc, argv, "rolling", 0.0));
    const int settling = static_cast<int>(option(argc, argv, "settling", 1500)), steps = static_cast<int>(option(argc, argv, "steps", 100));
    const int damped = static_cast<int>(option(argc, argv, "damped", 600));
    nscd::ContactSettings settings;
    settings.sleep = false;
    nscd::GrainDynamics fall = scene.build(settings);
    for (int k = 0; k < settling; ++k)
    {
        if (k + damped >= settling) stepDamped(fall, scene.g, deltaT);
        else step(fall, scene.g, deltaT);
    }
    double lastDeltaT = 0.0;
    const std::vector<nscd::StoredImpulse> impulses = fall.checkpoint(lastDeltaT);
    scene.grains = fall.grains();
    std::printf("what,clumps,members,contacts,waited,asleep,sweeps,msPerStep,carried,moved\n");
    for (const bool sleeps : {false, true})
    {
        settings.sleep = sleeps;
        nscd::GrainDynamics dynamics = scene.build(settings);
        dynamics.restore(impulses, lastDeltaT);
        constexpr int longest = 1000;
        int waited = 0;
        std::size_t asleep = 0;
        while (waited < longest && asleep < scene.grains.size())
        {
            asleep = step(dynamics, scene.g, deltaT).asleep;
            ++waited;
            if (!sleeps && waited == 200) break;
        }
        measure(sleeps ? "asleep" : "awake", dynamics, scene.grains, waited, steps);
    }
    return 0;
}
