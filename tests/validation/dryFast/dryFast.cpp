// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// S18: a grain that moves 50 diameters in a time step, at walls of every kind, at a grain, and at a packed bed: nothing is
// passed through, and no energy is created.
#include "unit/nscd/scenes/heaps.hpp"
#include "../resources/bars.hpp"

#include <algorithm>
#include <cstdio>

using namespace scenes;
using bars::require;

namespace
{

constexpr double radius = 0.01, deltaT = 1e-3, diameter = 2*radius, speed = 50*diameter/deltaT;

enum class Floor { plane, polygon, sheet };

void addFloor(Scene& scene, Floor floor)
{
    const double near = 5*diameter, far = 250*diameter;
    const int patch = scene.walls.addPatch("floor", 1);
    if (floor == Floor::plane) scene.walls.addPlane(patch, Vec3::Zero(), Vec3::UnitZ());
    const std::vector<Vec3> corners = {Vec3(-near, -near, 0), Vec3(far, -near, 0), Vec3(far, near, 0), Vec3(-near, near, 0)};
    if (floor == Floor::polygon) scene.walls.addPolygon(patch, corners);
    if (floor == Floor::sheet) scene.walls.addTriangles(patch, {{corners[0], corners[1], corners[2]}, {corners[0], corners[2], corners[3]}});
}

/// Steps of one flight at a floor: how far the grain got below it, in d, and the largest gain of energy in a step.
void flyAtFloor(Floor floor, double degrees, double gap, double e, double& below, double& gain)
{
    Scene scene(3, 0.3, e);
    scene.addGrain(Vec3(0.3*radius, 0.2*radius, radius + gap*diameter), radius);
    const double angle = degrees*3.14159265358979323846/180;
    scene.grains.velocity[0] = speed*Vec3(std::sin(angle), 0, -std::cos(angle));
    addFloor(scene, floor);
    auto dynamics = scene.build();
    double before = nscd::kineticEnergy(dynamics.grains());
    const double start = before;
    for (int k = 0; k < 4; ++k)
    {
        step(dynamics, Vec3::Zero(), deltaT);
        const double now = nscd::kineticEnergy(dynamics.grains());
        below = std::max(below, (radius - dynamics.grains().position[0][2])/diameter);
        gain = std::max(gain, (now - before)/start);
        before = now;
    }
}

void walls()
{
    double below = 0.0, gain = 0.0;
    int flights = 0;
    for (Floor floor : {Floor::plane, Floor::polygon, Floor::sheet})
    for (double degrees : {0.0, 30.0, 60.0, 85.0})
    for (double gap : {0.0, 0.3, 0.77, 1.9, 11.3, 24.9, 49.99, 50.0, 73.1})
    for (double e : {0.0, 0.5, 1.0})
    {
        flyAtFloor(floor, degrees, gap, e, below, gain);
        ++flights;
    }
    std::printf("S18: %d flights of 50 d a step at planes, polygons and sheets of triangles\n", flights);
    require("depth below the wall, d", below, 3e-4);
    require("gain of energy in a step, share of the start", gain, 1e-12);
}

/// One flight at a grain at rest with impact parameter `aside` (in d): whether it passed through, and what the energy did.
bool passesThrough(double aside, double distance, double e, double friction, double& gain, double& overlap)
{
    Scene scene(3, friction, e);
    scene.addGrain(Vec3::Zero(), radius);
    scene.addGrain(diameter*Vec3(distance, aside, 0), radius);
    scene.grains.velocity[1] = Vec3(-speed, 0, 0);
    auto dynamics = scene.build();
    double before = nscd::kineticEnergy(dynamics.grains());
    const double start = before;
    for (int k = 0; k < 3; ++k)
    {
        overlap = std::max(overlap, step(dynamics, Vec3::Zero(), deltaT).overlapMax);
        const double now = nscd::kineticEnergy(dynamics.grains());
        gain = std::max(gain, (now - before)/start);
        before = now;
    }
    return dynamics.grains().velocity[0].norm() < 1e-6*speed;  // hit by nothing, though it was in the way
}

void grains()
{
    double gain = 0.0, overlap = 0.0;
    int passed = 0, flights = 0, blocked = 0, misses = 0;
    for (double distance : {1.1, 1.6, 7.3, 25.0, 50.4, 51.0, 88.8})
    for (double e : {0.0, 0.5, 1.0})
    for (double friction : {0.0, 0.5})
    {
        for (double aside : {0.0, 0.1, 0.5, 0.9, 0.99})
        {
            passed += passesThrough(aside, distance, e, friction, gain, overlap);
            ++flights;
        }
        for (double aside : {1.1, 2.0, 4.0})
        {
            double ignored = 0.0;
            blocked += !passesThrough(aside, distance, e, friction, ignored, ignored);
            ++misses;
        }
    }
    std::printf("S18: %d flights at a grain\n", flights);
    require("grains passed through", passed, 0);
    require("overlap, d", overlap, 3e-4);
    require("gain of energy in a step, share of the start", gain, 1e-12);
    std::printf("  and %d that miss it by 0.1, 1 or 3 d\n", misses);
    require("grains that stop at what is not in their way", blocked, 0);
}

/// Without gravity, whose work a step of 50 d knows to first order only.
void bed(const Scene& heap, double degrees, double e)
{
    Scene scene = heap;
    for (int a : {0, 1}) for (int b : {0, 1}) scene.materials.setPair(a, b, {0.4, e});
    const double angle = degrees*3.14159265358979323846/180;
    const Vec3 direction(std::sin(angle), 0, -std::cos(angle));
    scene.addGrain(Vec3(6.9, 6.9, 12)*radius - 30*radius*direction, radius);
    const std::size_t bullet = scene.grains.size() - 1;
    scene.grains.velocity[bullet] = speed*direction;
    auto dynamics = scene.build(nscd::ContactSettings());
    const auto energy = [&] { return nscd::kineticEnergy(dynamics.grains()); };
    const double start = energy(), width = scene.walls.regions[2].point[0];
    double before = start, gain = 0.0, overlap = 0.0;
    int outside = 0;
    for (int k = 0; k < 20; ++k)
    {
        const nscd::StepReport report = step(dynamics, Vec3::Zero(), deltaT);
        overlap = std::max(overlap, report.overlapMax);
        gain = std::max(gain, (energy() - before - report.solve.shockResidualWork)/start);
        before = energy();
        for (std::size_t i = 0; i < dynamics.grains().size(); ++i)
        {
            const Vec3& x = dynamics.grains().position[i];
            const double room = 0.99*dynamics.grains().radius[i];
            const bool isInside = x[2] > room && x[0] > room && x[0] < width - room && x[1] > room && x[1] < width - room;
            outside += !isInside && i != bullet;
            outside += i == bullet && x[2] < room;
        }
    }
    std::printf("S18: at a packed bed, %g degrees, e %g: energy left %.3f\n", degrees, e, energy()/start);
    require("grains behind a wall", outside, 0);
    require("overlap, d", overlap, 5e-3);
    require("gain of energy beyond the residual's work, share of the start", gain, 1e-12);
}

} // namespace

int main()
{
    walls();
    grains();
    Scene scene = heap(3, 6, 8, radius, 0.8, 0.4);
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < 300; ++k) step(dynamics, scene.g, deltaT);
    scene.grains = dynamics.grains();
    for (double degrees : {0.0, 20.0}) for (double e : {0.0, 0.5, 1.0}) bed(scene, degrees, e);
    return bars::status();
}
