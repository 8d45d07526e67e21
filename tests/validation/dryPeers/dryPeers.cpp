// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Our side of the comparisons of `run`: a settled bed as a table of x y z d, and the motions that start from it.
//     dryPeers settle TABLE
//     dryPeers impact TABLE CSV      z(t) of a steel sphere
//     dryPeers silo TABLE CSV STL    number of grains that are still above the floor
//     dryPeers settleDrum TABLE
//     dryPeers drum TABLE CSV        places of grains that began on the left
#include "unit/nscd/scenes/heaps.hpp"
#include "../resources/bars.hpp"

#include "nscd/scene/stlFile.hpp"

#include <algorithm>
#include <cmath>
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

void writeTable(const nscd::Grains& grains, const char* name)
{
    std::FILE* file = std::fopen(name, "w");
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const Vec3& x = grains.position[i];
        std::fprintf(file, "%.9g %.9g %.9g %.9g\n", x[0], x[1], x[2], 2*grains.radius[i]);
    }
    std::fclose(file);
}

/// The grains of a scene once they have come to rest.
void writeSettled(const Scene& scene, const char* table)
{
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < 300; ++k) step(dynamics, scene.g, 1e-3);
    for (int k = 0; k < 100; ++k) stepDamped(dynamics, scene.g, 1e-3);
    writeTable(dynamics.grains(), table);
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
    writeSettled(scene, table);
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

constexpr double drumRadius = 40e-3, drumLength = 32e-3, drumOmega = 2.0, drumTime = 5.0;

/// A drum about y, periodic along it, of 96 flats that turn with `omega`. (Flats that stay, with a surface that moves, hold the bed back: it slides on
/// the drum, over the edges between flats, and comes round in 4.5 s, not 4.)
Scene drumScene(double omega)
{
    constexpr int flats = 96;
    Scene scene(3, 0.3, 0.5);
    scene.materials.setPair(0, 1, {0.2, 0.4});
    scene.box.length = Vec3(0, drumLength, 0);
    const int patch = scene.walls.addPatch("drum", 1);
    std::vector<nscd::Triangle> triangles;
    const auto at = [](int i, double y)
    {
        const double angle = 2*3.14159265358979323846*i/flats;
        return Vec3(drumRadius*std::cos(angle), y, drumRadius*std::sin(angle));
    };
    for (int i = 0; i < flats; ++i)
    {
        triangles.push_back({at(i, -2*diameter), at(i + 1, -2*diameter), at(i + 1, drumLength + 2*diameter)});
        triangles.push_back({at(i, -2*diameter), at(i + 1, drumLength + 2*diameter), at(i, drumLength + 2*diameter)});
    }
    scene.walls.addTriangles(patch, triangles);
    scene.walls.setMotion(patch, nscd::rotation(Vec3::Zero(), Vec3::UnitY(), omega));
    return scene;
}

void settleDrum(const char* table)
{
    Scene scene = drumScene(0.0);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double pitch = 1.06*diameter;
    for (int k = -9; k <= 9; ++k) for (int j = 0; j < 7; ++j) for (int i = -9; i <= 9; ++i)
    {
        const Vec3 x(pitch*i, drumLength*(j + 0.5)/7, pitch*k);
        if (std::hypot(x[0], x[2]) > drumRadius - 0.55*diameter || k > 3) continue;
        scene.addGrain(x + 0.02*diameter*Vec3(unit(random), unit(random), unit(random)), 0.5*diameter);
    }
    writeSettled(scene, table);
}

/// How many of the grains that began at x < 0 are at x < 0, and how many in the lower quarter of the drum's height; mass center's x.
void drum(const char* table, const char* csv)
{
    Scene scene = drumScene(drumOmega);
    readTable(scene, table);
    auto dynamics = scene.build(nscd::ContactSettings());
    std::FILE* file = std::fopen(csv, "w");
    for (int k = 1; k*1e-3 <= drumTime + 5e-4; ++k)
    {
        step(dynamics, scene.g, 1e-3);
        if (k % 50 != 0) continue;
        int left = 0, low = 0;
        for (std::size_t i = 0; i < scene.grains.size(); ++i)
        {
            if (scene.grains.position[i][0] >= 0.0) continue;
            left += dynamics.grains().position[i][0] < 0.0;
            low += dynamics.grains().position[i][2] < -0.5*drumRadius;
        }
        std::fprintf(file, "%.6g %d %d %.6g\n", k*1e-3, left, low, nscd::massCenter(dynamics.grains())[0]);
        std::fflush(file);
    }
    std::fclose(file);
}

} // namespace

int main(int count, char** arguments)
{
    const auto is = [&](const char* word, int words) { return count == words && std::strcmp(arguments[1], word) == 0; };
    if (is("settle", 3)) settle(arguments[2]);
    else if (is("impact", 4)) impact(arguments[2], arguments[3]);
    else if (is("settleDrum", 3)) settleDrum(arguments[2]);
    else if (is("drum", 4)) drum(arguments[2], arguments[3]);
    else if (is("silo", 5)) silo(arguments[2], arguments[3], arguments[4]);
    else
    {
        std::printf("dryPeers settle TABLE | impact TABLE CSV | silo TABLE CSV STL | settleDrum TABLE | drum TABLE CSV\n");
        return 1;
    }
    return 0;
}
