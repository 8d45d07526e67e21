// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Our side of the comparisons of `run`: a settled bed as a table of x y z d, and the motions that start from it.
//     dryPeers settle TABLE
//     dryPeers impact TABLE CSV      z(t) of a steel sphere
//     dryPeers silo TABLE CSV STL    number of grains that are still above the floor
#include "../../unit/nscd/heaps.hpp"
#include "../resources/bars.hpp"

#include "stlFile.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>

using namespace scenes;

namespace
{

constexpr double diameter = 4e-3, width = 64e-3, deltaT = 5e-4;
constexpr double ballRadius = 6e-3, ballDensity = 7200, ballSpeed = 2.0, fallTime = 0.03, impactTime = 0.06, siloTime = 1.0;

/// Material M1 of the benchmark: grains mu 0.3, e 0.5; walls mu 0.2, e 0.4. The floor is a plane, or what `floor` adds.
template<class Floor>
Scene boxScene(const Floor& floor)
{
    Scene scene(3, 0.3, 0.5);
    scene.materials.setPair(0, 1, {0.2, 0.4});
    floor(scene);
    for (int axis = 0; axis < 2; ++axis)
    {
        scene.addPlane(Vec3::Zero(), Vec3::Unit(axis));
        scene.addPlane(width*Vec3::Unit(axis), -Vec3::Unit(axis));
    }
    return scene;
}

void planeFloor(Scene& scene) { scene.addPlane(Vec3::Zero(), Vec3::UnitZ()); }

void readTable(Scene& scene, const char* name)
{
    std::ifstream file(name);
    double x, y, z, d;
    while (file >> x >> y >> z >> d) scene.addGrain(Vec3(x, y, z), 0.5*d);
    if (scene.grains.size() == 0) throw std::runtime_error(std::string("no grains in ") + name);
}

void settle(const char* table)
{
    Scene scene = boxScene(planeFloor);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> unit(-1, 1);
    constexpr int perSide = 15, layers = 12;
    for (int n = 0; n < perSide*perSide*layers; ++n)
    {
        const Vec3 place((n % perSide + 0.5)*width/perSide, (n/perSide % perSide + 0.5)*width/perSide, 1.05*diameter*(n/(perSide*perSide) + 0.5));
        scene.addGrain(place + 0.02*diameter*Vec3(unit(random), unit(random), 0), 0.5*diameter);
    }
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < 300; ++k) step(dynamics, scene.g, 1e-3);
    for (int k = 0; k < 100; ++k) stepDamped(dynamics, scene.g, 1e-3);
    std::FILE* file = std::fopen(table, "w");
    for (std::size_t i = 0; i < dynamics.grains().size(); ++i)
    {
        const Vec3& x = dynamics.grains().position[i];
        std::fprintf(file, "%.9g %.9g %.9g %.9g\n", x[0], x[1], x[2], 2*dynamics.grains().radius[i]);
    }
    std::fclose(file);
}

/// The ball comes down on the middle of the bed after fallTime: soft grains find their overlaps meanwhile.
void impact(const char* table, const char* csv)
{
    Scene scene = boxScene(planeFloor);
    readTable(scene, table);
    double top = 0.0;
    for (const Vec3& x : scene.grains.position) top = std::max(top, x[2] + 0.5*diameter);
    const double drop = ballSpeed*fallTime + 0.5*gravity*fallTime*fallTime;
    scene.addGrain(Vec3(0.5*width, 0.5*width, top + ballRadius + drop), ballRadius, ballDensity);
    scene.grains.velocity.back() = Vec3(0, 0, -ballSpeed);
    auto dynamics = scene.build(nscd::ContactSettings());
    std::FILE* file = std::fopen(csv, "w");
    constexpr double fine = 0.2*deltaT;
    for (int k = 1; k*fine <= fallTime + impactTime + 0.5*fine; ++k)
    {
        step(dynamics, scene.g, fine);
        if (k % 5 == 0) std::fprintf(file, "%.6g %.8g\n", k*fine, dynamics.grains().position.back()[2]);
    }
    std::fclose(file);
}

void silo(const char* table, const char* csv, const char* stl)
{
    Scene scene = boxScene([&](Scene& s) { s.walls.addTriangles(s.walls.addPatch("floor", 1), nscd::readStl(stl, 1.0)); });
    readTable(scene, table);
    auto dynamics = scene.build(nscd::ContactSettings());
    std::FILE* file = std::fopen(csv, "w");
    for (int k = 1; k*deltaT <= siloTime + 0.5*deltaT; ++k)
    {
        step(dynamics, scene.g, deltaT);
        if (k % 20 != 0) continue;
        nscd::Grains grains = dynamics.grains();
        int retained = 0;
        bool isAnyFar = false;
        for (std::size_t i = 0; i < grains.size(); ++i)
        {
            retained += grains.position[i][2] > 0.0;
            // What has left is held far below, each at its own place.
            if (grains.isFixed[i] || grains.position[i][2] > -0.02) continue;
            grains.position[i] = Vec3(-1.0 - 0.01*(i % 100), -1.0, -1.0 - 0.01*(i/100));
            grains.velocity[i] = grains.omega[i] = Vec3::Zero();
            grains.isFixed[i] = 1;
            isAnyFar = true;
        }
        std::fprintf(file, "%.6g %d\n", k*deltaT, retained);
        std::fflush(file);
        if (isAnyFar) dynamics.setGrains(grains);
    }
    std::fclose(file);
}

} // namespace

int main(int count, char** arguments)
{
    const auto is = [&](const char* word, int words) { return count == words && std::strcmp(arguments[1], word) == 0; };
    if (is("settle", 3)) settle(arguments[2]);
    else if (is("impact", 4)) impact(arguments[2], arguments[3]);
    else if (is("silo", 5)) silo(arguments[2], arguments[3], arguments[4]);
    else
    {
        std::printf("dryPeers settle TABLE | impact TABLE CSV | silo TABLE CSV STL\n");
        return 1;
    }
    return 0;
}
