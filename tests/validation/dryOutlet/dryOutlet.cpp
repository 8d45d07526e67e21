// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A18: flow through the outlet of a silo with a flat bottom, what comes out being put back on top. Beverloo: W ~ (D - k d)^2.5 from a
// round outlet, ^1.5 from a slot, k = 1.5, whatever the head.
#include "unit/nscd/scenes/scenes.hpp"
#include "../resources/bars.hpp"
#include "../resources/csvFile.hpp"

#include "nscd/base/formattedText.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

using namespace scenes;
using bars::require;

namespace
{

constexpr double diameter = 2e-3, radius = 0.5*diameter, spread = 0.1, k = 1.5, deltaT = 1e-3, pi = 3.14159265358979323846;
constexpr int stepsPerRefill = 10;  // grains come from the list of contacts anew each time

/// Sizes in diameters.
struct Silo
{
    int dimensions;
    double width;      ///< of a box; in the plane the only one
    double outlet;     ///< width of a slot, diameter of a round outlet
    int layers;        ///< of the lattice that the silo is filled with
};

/// A floor of triangles with a round hole.
std::vector<nscd::Triangle> floorWithHole(double half, double hole)
{
    constexpr int parts = 48;
    std::vector<nscd::Triangle> triangles;
    const auto at = [&](int i, bool isOuter)
    {
        const double angle = 2*pi*(i + 0.5)/parts;
        const Vec3 direction(std::cos(angle), std::sin(angle), 0);
        const double toSquare = 1.2*half/std::max(std::abs(direction[0]), std::abs(direction[1]));
        return Vec3((isOuter ? toSquare : hole)*direction);
    };
    for (int i = 0; i < parts; ++i)
    {
        triangles.push_back({at(i, false), at(i, true), at(i + 1, true)});
        triangles.push_back({at(i, false), at(i + 1, true), at(i + 1, false)});
    }
    // Corners of the square lie outside of the outline above.
    for (double sx : {-1.0, 1.0}) for (double sy : {-1.0, 1.0})
    {
        const double a = 1.2*half;
        triangles.push_back({Vec3(sx*a, sy*a, 0), Vec3(sx*a, 0.8*sy*a, 0), Vec3(0.8*sx*a, sy*a, 0)});
    }
    return triangles;
}

void addFloor(Scene& scene, const Silo& silo)
{
    const double half = 0.5*silo.width*diameter, hole = 0.5*silo.outlet*diameter;
    const int patch = scene.walls.addPatch("floor", 1);
    if (silo.dimensions == 3)
    {
        scene.walls.addTriangles(patch, floorWithHole(half, hole));
        return;
    }
    scene.grains.shape.emptyAxis = 1;
    for (double side : {-1.0, 1.0})
    {
        const double a = side*hole, b = side*1.2*half, deep = 5*diameter;
        scene.walls.addTriangles(patch, {{Vec3(a, -deep, 0), Vec3(b, -deep, 0), Vec3(b, deep, 0)}, {Vec3(a, -deep, 0), Vec3(b, deep, 0), Vec3(a, deep, 0)}});
    }
}

/// Grains at rest above a floor without a hole, and walls of a scene with one.
Scene lattice(const Silo& silo)
{
    Scene scene(silo.dimensions, 0.3, 0.0);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double pitch = (1 + spread)*1.05*diameter, half = 0.5*silo.width*diameter;
    const int perSide = static_cast<int>(2*half/pitch), deep = silo.dimensions == 3 ? perSide : 1;
    for (int n = 0; n < silo.layers*perSide*deep; ++n)
    {
        const int i = n % perSide, j = (n/perSide) % deep, layer = n/(perSide*deep);
        const double step = 2*half/perSide;
        Vec3 x(-half + step*(i + 0.5), silo.dimensions == 3 ? -half + step*(j + 0.5) : 0.0, pitch*(layer + 0.6));
        scene.addGrain(x + 0.02*diameter*Vec3(unit(random), silo.dimensions == 3 ? unit(random) : 0.0, 0), radius*(1 + spread*unit(random)));
    }
    for (int axis = 0; axis < (silo.dimensions == 3 ? 2 : 1); ++axis)
    {
        scene.addPlane(-half*Vec3::Unit(axis), Vec3::Unit(axis));
        scene.addPlane(half*Vec3::Unit(axis), -Vec3::Unit(axis));
    }
    return scene;
}

/// Lifts x above all grains that are under it or nearly so.
void putOnTop(const nscd::Grains& grains, std::size_t self, Vec3& x)
{
    for (std::size_t j = 0; j < grains.size(); ++j)
    {
        const Vec3 apart = grains.position[j] - x;
        const bool isUnder = j != self && apart[0]*apart[0] + apart[1]*apart[1] < 6.25*diameter*diameter;
        if (isUnder) x[2] = std::max(x[2], grains.position[j][2] + 1.2*diameter);
    }
}

/// Puts what fell through back on the surface, at rest. Of some random places the lowest: grains put on one another would come down as rain.
/// Returns the mass moved.
double refill(nscd::GrainDynamics& dynamics, const Silo& silo, std::mt19937& random)
{
    constexpr int places = 12;
    nscd::Grains grains = dynamics.grains();
    std::uniform_real_distribution<double> place(-0.5*silo.width*diameter + 2*radius, 0.5*silo.width*diameter - 2*radius);
    double mass = 0.0;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        if (grains.position[i][2] > -3*diameter) continue;
        Vec3 lowest(0, 0, 1e3);
        for (int n = 0; n < places; ++n)
        {
            const double along = place(random), across = silo.dimensions == 3 ? place(random) : 0.0;
            Vec3 x(along, across, 0);
            putOnTop(grains, i, x);
            if (x[2] < lowest[2]) lowest = x;
        }
        mass += grains.mass[i];
        grains.position[i] = lowest;
        grains.velocity[i] = grains.omega[i] = Vec3::Zero();
    }
    if (mass > 0.0) dynamics.setGrains(grains);
    return mass;
}

Scene filled(const Silo& silo)
{
    Scene scene = lattice(silo), closed = scene;
    closed.addPlane(Vec3::Zero(), Vec3::UnitZ());
    auto settling = closed.build(nscd::ContactSettings());
    const int steps = static_cast<int>(200 + 30*std::sqrt(silo.layers));
    for (int n = 0; n < steps; ++n) step(settling, closed.g, 1e-3);
    scene.grains = settling.grains();
    addFloor(scene, silo);
    return scene;
}

/// Mass flow [kg/s; of discs kg/s and m] while `fillings` pass, after the first quarter of a filling has.
double flow(const Silo& silo, double fillings)
{
    const Scene scene = filled(silo);
    auto dynamics = scene.build(nscd::ContactSettings());
    std::mt19937 random(8);
    double total = 0.0, passed = 0.0, time = 0.0, from = 0.0, massFrom = 0.0;
    for (double m : scene.grains.mass) total += m;
    while (passed - massFrom < fillings*total && time < 20.0)
    {
        for (int n = 0; n < stepsPerRefill; ++n) step(dynamics, scene.g, deltaT);
        passed += refill(dynamics, silo, random);
        time += stepsPerRefill*deltaT;
        if (passed < 0.25*total) { from = time; massFrom = passed; }
    }
    return (passed - massFrom)/(time - from);
}

double exponent(const std::vector<double>& x, const std::vector<double>& y)
{
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < x.size(); ++i, ++n)
    {
        sx += std::log(x[i]);
        sy += std::log(y[i]);
        sxx += std::log(x[i])*std::log(x[i]);
        sxy += std::log(x[i])*std::log(y[i]);
    }
    return (n*sxy - sx*sy)/(n*sxx - sx*sx);
}

void beverloo(bars::CsvFile& csv, int dimensions, double width, int layers, const std::vector<double>& outlets, double fillings)
{
    bars::scene(nscd::formatted("A18 silo of %g d in %d dimensions, mu 0.3, %d layers", width, dimensions, layers));
    const double power = dimensions == 3 ? 2.5 : 1.5, bulk = 2500*(dimensions == 3 ? 0.58 : 0.82);
    std::vector<double> open, flows;
    for (double outlet : outlets)
    {
        const double found = flow({dimensions, width, outlet, layers}, fillings);
        open.push_back((outlet - k)*diameter);
        flows.push_back(found);
        const double constant = found/(bulk*std::sqrt(gravity)*std::pow(open.back(), power));
        std::printf("  D %.1f d: %.5g kg/s, C %.3f\n", outlet, found, constant);
        std::fflush(stdout);
        csv.row({double(dimensions), width, double(layers), outlet, found, constant});
    }
    const double found = exponent(open, flows);
    std::printf("  W ~ (D - %g d)^%.3f\n", k, found);
    bars::requireNear("exponent against Beverloo's", found, power, 0.2);
}

void head(bars::CsvFile& csv, int dimensions, double width, double outlet, int low, int high, double fillings)
{
    double flows[2];
    int layers[2] = {low, high};
    for (int n : {0, 1})
    {
        flows[n] = flow({dimensions, width, outlet, layers[n]}, fillings*low/layers[n]);
        csv.row({double(dimensions), width, double(layers[n]), outlet, flows[n], 0.0});
    }
    bars::scene(nscd::formatted("A18 head of %d and %d layers, D %g d", low, high, outlet));
    std::printf("  %.5g and %.5g kg/s\n", flows[0], flows[1]);
    require("flow at the higher head against the lower, share", std::abs(flows[1]/flows[0] - 1), 0.03);
}

} // namespace

int main(int count, char** arguments)
{
    const bool isSpatial = count > 1 && std::strcmp(arguments[1], "3d") == 0;
    bars::CsvFile csv(arguments[0], isSpatial ? "spheres" : "discs", "dimensions,width,layers,outlet,flow,C");
    if (isSpatial)
    {
        beverloo(csv, 3, 20, 18, {5, 6, 8, 10}, 1.0);
        head(csv, 3, 20, 8, 18, 36, 1.0);
    }
    else
    {
        beverloo(csv, 2, 40, 40, {5, 7, 9, 12}, 0.75);
        head(csv, 2, 40, 9, 30, 60, 1.5);
    }
    return bars::status();
}
