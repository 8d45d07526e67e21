// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Spheres that fall into a box and come to rest with rolling friction and without, step by step in turn in one process: steps at the cap, and what it costs.
#include "unit/nscd/scenes/lawScenes.hpp"
#include "../resources/bars.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <memory>
#include <random>
#include <string>

using namespace scenes;
using bars::require;

namespace
{

constexpr double deltaT = 1e-3, friction = 0.5;

/// What became of some steps of a run.
struct Sums
{
    int steps = 0, atCap = 0, off = 0;   ///< off: not converged, at the cap or not
    double seconds = 0.0, sweeps = 0.0, newton = 0.0, worked = 0.0;   ///< worked: contacts times sweeps
};

/// A way of rolling.
struct Law
{
    const char* name;
    double rolling, spinning;
};

const Law laws[] = {{"neither", 0.0, 0.0}, {"rolling 0.05", 0.05, 0.0}, {"rolling 0.05, spinning 0.02", 0.05, 0.02}};

void addBox(Scene& scene, double width)
{
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    for (int axis = 0; axis < 2; ++axis)
    {
        scene.addPlane(Vec3::Zero(), Vec3::Unit(axis));
        scene.addPlane(width*Vec3::Unit(axis), -Vec3::Unit(axis));
    }
}

/// Spheres of nearly one size on a loose lattice with random shifts.
Scene lattice()
{
    Scene scene(3, friction, 0.0);
    nscd::addLattice(scene.grains, {{0, 0, 0}, {0.078, 0.078, 0.13}, {12, 12, 20}, 0.005, 0.1, 1.0}, 2500.0, 0);
    addBox(scene, 0.078);
    return scene;
}

/// Spheres of 1 to 5 mm, each size with the same share of the volume, at random places of a box without overlap, the largest first.
Scene mix(int count)
{
    Scene scene(3, friction, 0.0);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<double> radii;
    double volume = 0.0;
    for (int k = 0; k < count; ++k) radii.push_back(0.5e-3/std::sqrt(0.04 + 0.96*unit(random)));
    std::sort(radii.begin(), radii.end(), std::greater<double>());
    for (double r : radii) volume += 4.19*r*r*r;
    const double width = std::cbrt(volume/0.25), height = volume/0.2/width/width;
    const nscd::Grains& placed = scene.grains;
    while (placed.size() < radii.size())
    {
        const double r = radii[placed.size()], room = 1.01*r;
        const Vec3 x(room + (width - 2*room)*unit(random), room + (width - 2*room)*unit(random), room + (height - 2*room)*unit(random));
        bool isFree = true;
        for (std::size_t i = 0; i < placed.size() && isFree; ++i) isFree = (x - placed.position[i]).norm() > 1.01*(r + placed.radius[i]);
        if (isFree) scene.addGrain(x, r);
    }
    addBox(scene, width);
    return scene;
}

void advance(nscd::GrainDynamics& dynamics, Sums& sums)
{
    const std::clock_t begun = std::clock();
    const nscd::StepReport report = step(dynamics, Vec3(0, 0, -gravity), deltaT);
    sums.seconds += static_cast<double>(std::clock() - begun)/CLOCKS_PER_SEC;
    ++sums.steps;
    sums.atCap += report.solve.atCap;
    sums.off += !report.solve.converged;
    sums.sweeps += report.solve.sweeps;
    sums.newton += report.solve.newtonSteps;
    sums.worked += static_cast<double>(report.solve.contacts)*report.solve.sweeps;
}

void print(const Law& law, const Sums& sums, double secondsWithout)
{
    std::printf("    %-28s %6.2f s, %4.2f of without, %5.1f sweeps and %5.0f Newton steps a step, %4.0f ns a contact and sweep, %d at the cap, %d not converged\n",
        law.name, sums.seconds, sums.seconds/secondsWithout, sums.sweeps/sums.steps, sums.newton/sums.steps, 1e9*sums.seconds/std::max(1.0, sums.worked),
        sums.atCap, sums.off);
}

/// Runs side by side, so that all laws meet the same noise of the machine; times are printed, not judged.
class Comparison
{
public:
    explicit Comparison(Scene scene)
    {
        for (const Law& law : laws)
        {
            setAll(scene, rollingPair(friction, law.rolling, law.spinning));
            runs_.emplace_back(new nscd::GrainDynamics(scene.build(nscd::ContactSettings())));
        }
    }

    void part(const char* name, int steps)
    {
        std::printf("  %d steps %s\n", steps, name);
        Sums sums[3];
        for (int k = 0; k < steps; ++k)
        {
            for (int m = 0; m < 3; ++m) advance(*runs_[m], sums[m]);
        }
        for (int m = 0; m < 3; ++m)
        {
            print(laws[m], sums[m], sums[0].seconds);
            atCap_[m] += sums[m].atCap;
        }
        steps_ += steps;
    }

    void judge(double mostAtCap) const
    {
        for (int m = 0; m < 3; ++m) require((std::string("steps at the cap, %, ") + laws[m].name).c_str(), 100.0*atCap_[m]/steps_, mostAtCap);
    }

private:
    std::vector<std::unique_ptr<nscd::GrainDynamics>> runs_;
    int atCap_[3] = {0, 0, 0};
    int steps_ = 0;
};

} // namespace

int main()
{
    std::printf("2880 spheres of 5 mm\n");
    Comparison alike(lattice());
    for (const char* name : {"of fall", "of landing", "of coming to rest", "at rest"}) alike.part(name, 75);
    alike.judge(0.0);

    std::printf("1000 spheres of 1 to 5 mm\n");
    Comparison unlike(mix(1000));
    for (const char* name : {"of landing", "of coming to rest"}) unlike.part(name, 60);
    unlike.judge(1.0);
    return bars::status();
}
