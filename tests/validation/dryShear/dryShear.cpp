// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A19: a layer of discs sheared between two plates, periodic along them: a belt on top held at a load, a plate at rest below, no
// gravity. In the mean both plates feel the same force; friction against inertial number is reported. Walls have no mass here, so
// the belt is moved up and down by a controller, slowly beside the shear, instead of by its inertia.
#include "../../unit/nscd/scenes.hpp"
#include "../resources/bars.hpp"
#include "../resources/csvFile.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <random>

using namespace scenes;
using bars::require;

namespace
{

constexpr double density = 1000, pressure = 2500, smallest = 0.8e-3, largest = 1e-3;  // load per length of plate
constexpr double meanDiameter = smallest + largest, pi = 3.14159265358979323846;

/// The belt's height, and the load it carries, smoothed over a shear of 0.05.
struct Lid
{
    double height;
    double load = 0.0;

    void follow(double force, double width, double rate, double deltaT)
    {
        const double share = std::min(1.0, 20.0*rate*deltaT);
        load += share*(force/width - load);
        const double missing = 1.0 - load/pressure, fastest = missing > 0.9 ? 0.2 : 0.01;
        height -= deltaT*rate*height*fastest*std::max(-1.0, std::min(1.0, missing));
    }
};

struct Means
{
    Vec3 bottom = Vec3::Zero();   ///< force on the plate below [N per m of depth]
    Vec3 top = Vec3::Zero();
    double height = 0.0;
    double overlap = 0.0;
    int steps = 0;
    int capped = 0;
};

Scene layer(double width, double height, const std::shared_ptr<Lid>& lid, double rate)
{
    Scene scene(2, 0.1, 0.0);
    scene.materials.setPair(0, 1, {0.5, 0.0});
    scene.box.length = Vec3(width, 0, 0);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(0, 1);
    const double pitch = 2.1*largest;
    const int perRow = static_cast<int>(width/pitch);
    const double area = 0.83*width*height;
    double filled = 0.0;
    for (int k = 0; filled < area; ++k)
    {
        const double r = smallest + (largest - smallest)*unit(random);
        scene.addGrain(Vec3(width*(k % perRow + 0.5)/perRow, 0, pitch*(k/perRow + 0.5)), r, density);
        scene.grains.velocity.back() = Vec3(rate*scene.grains.position.back()[2], 0, 0.2*rate*largest*(unit(random) - 0.5));
        filled += pi*r*r;
    }
    lid->height = scene.grains.position.back()[2] + 1.1*largest;
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.addPlane(Vec3::Zero(), -Vec3::UnitZ());
    scene.walls.setMotion(1, [lid](double) { return nscd::WallPose(Eigen::Translation3d(0, 0, lid->height)); });
    scene.walls.setSurfaceMotion(1, nscd::belt(Vec3(rate*height, 0, 0)));
    return scene;
}

/// Shears for a while, and takes means over the second half.
Means shear(double width, double height, double rate, double time, double deltaT, std::size_t& grains)
{
    const auto lid = std::make_shared<Lid>();
    const Scene scene = layer(width, height, lid, rate);
    grains = scene.grains.size();
    auto dynamics = scene.build(nscd::ContactSettings());
    const int steps = static_cast<int>(std::lround(time/deltaT));
    Means means;
    double force = 0.0;
    for (int k = 0; k < steps; ++k)
    {
        lid->follow(force, width, rate, deltaT);  // to where the belt is to be at the end of the step
        dynamics.beginStep(deltaT);
        nscd::ExternalForces none;
        none.speedScale = deltaT*pressure/(density*meanDiameter);
        const nscd::StepReport report = dynamics.advance(none);
        force = dynamics.wallForce()[1][2];
        means.capped += !report.solve.converged;
        means.overlap = std::max(means.overlap, report.overlapMax);
        if (2*k < steps) continue;
        means.bottom += dynamics.wallForce()[0];
        means.top += dynamics.wallForce()[1];
        means.height += lid->height;
        ++means.steps;
    }
    means.bottom /= means.steps;
    means.top /= means.steps;
    means.height /= means.steps;
    return means;
}

void judge(bars::CsvFile& csv, double width, double height, double rate, double time, double deltaT)
{
    std::size_t grains = 0;
    const Means means = shear(width, height, rate, time, deltaT, grains);
    const double actual = rate*height/means.height, normal = -means.bottom[2]/width;
    const double inertial = actual*meanDiameter*std::sqrt(density/normal), friction = std::abs(means.bottom[0]/means.bottom[2]);
    std::printf("A19: %zu discs, belt %g m/s, time step %g s: height %.4f m, pressure %.0f Pa, I %.4f (belt speed over height), mu_eff %.4f; %d steps at the cap\n",
        grains, rate*height, deltaT, means.height, normal, inertial, friction, means.capped);
    csv.row({rate, deltaT, double(grains), means.height, normal, inertial, friction, means.top[0], means.top[2], means.bottom[0], means.bottom[2], means.overlap});
    require("normal forces of the plates, difference in the mean, share", std::abs(means.top[2] + means.bottom[2])/std::abs(means.bottom[2]), 0.02);
    require("shear forces of the plates, difference in the mean, share", std::abs(means.top[0] + means.bottom[0])/std::abs(means.bottom[0]), 0.02);
    require("load against the lower plate's force, share", std::abs(normal/pressure - 1), 0.02);
    require("largest overlap, d", means.overlap, 0.01);
    std::fflush(stdout);
}

} // namespace

int main(int count, char** arguments)
{
    bars::CsvFile csv(arguments[0], "shear", "rate,deltaT,discs,height,pressure,I,muEff,topX,topZ,bottomX,bottomZ,overlapMax");
    const bool isFull = count > 1 && std::strcmp(arguments[1], "full") == 0;
    if (isFull) judge(csv, 0.2, 0.1, 100, 0.5, 2.5e-5);
    else for (double rate : {30.0, 100.0, 300.0}) judge(csv, 0.05, 0.025, rate, 50.0/rate, 1e-2/rate);
    return bars::status();
}
