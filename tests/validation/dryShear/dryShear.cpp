// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A19: a layer of discs sheared between two plates, periodic along them: a belt on top, a plate at rest below, no gravity. In the
// mean both plates feel the same force; friction against inertial number is reported. Walls have no mass here: where the catalog has a
// plate with mass under a load, the belt comes down to a given height, and the pressure is what comes of it.
#include "../../unit/nscd/scenes.hpp"
#include "../resources/bars.hpp"
#include "../resources/csvFile.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

using namespace scenes;
using bars::require;

namespace
{

constexpr double density = 1000, smallest = 0.8e-3, largest = 1e-3, meanDiameter = smallest + largest, pi = 3.14159265358979323846;
constexpr double closingShear = 3.0;  ///< in which the belt comes down

struct Means
{
    Vec3 bottom = Vec3::Zero();   ///< force on the plate below [N]
    Vec3 top = Vec3::Zero();
    Vec3 gained = Vec3::Zero();   ///< momentum of the layer over the time of the means, as a force [N]
    double overlap = 0.0;
    int steps = 0;
    int capped = 0;
};

Scene layer(double width, double height, double solidFraction, double rate)
{
    Scene scene(2, 0.1, 0.0);
    scene.materials.setPair(0, 1, {0.5, 0.0});
    scene.box.length = Vec3(width, 0, 0);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(0, 1);
    const double pitch = 2.1*largest;
    const int perRow = static_cast<int>(width/pitch);
    double filled = 0.0;
    for (int k = 0; filled < solidFraction*width*height; ++k)
    {
        const double r = smallest + (largest - smallest)*unit(random);
        scene.addGrain(Vec3(width*(k % perRow + 0.5)/perRow, 0, pitch*(k/perRow + 0.5)), r, density);
        scene.grains.velocity.back() = Vec3(rate*scene.grains.position.back()[2], 0, 0.2*rate*largest*(unit(random) - 0.5));
        filled += pi*r*r;
    }
    const double start = scene.grains.position.back()[2] + 1.1*largest, speed = (start - height)*rate/closingShear;
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.addPlane(Vec3::Zero(), -Vec3::UnitZ());
    scene.walls.setMotion(1, [=](double time) { return nscd::WallPose(Eigen::Translation3d(0, 0, std::max(height, start - speed*time))); });
    scene.walls.setSurfaceMotion(1, nscd::belt(Vec3(rate*height, 0, 0)));
    return scene;
}

Vec3 momentum(const nscd::Grains& grains)
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < grains.size(); ++i) sum += grains.mass[i]*grains.velocity[i];
    return sum;
}

/// Shears for a while, and takes means over the second half.
Means shear(const Scene& scene, double rate, double shear, double deltaT)
{
    auto dynamics = scene.build(nscd::ContactSettings());
    const int steps = static_cast<int>(std::lround(shear/rate/deltaT));
    Means means;
    for (int k = 0; k < steps; ++k)
    {
        if (k == steps/2) means.gained = -momentum(dynamics.grains());
        dynamics.beginStep(deltaT);
        nscd::ExternalForces none;
        none.speedScale = 1e-2*rate*meanDiameter;
        const nscd::StepReport report = dynamics.advance(none);
        if (k < steps/2) continue;
        means.capped += !report.solve.converged;
        means.overlap = std::max(means.overlap, report.overlapMax);
        means.bottom += dynamics.wallForce()[0];
        means.top += dynamics.wallForce()[1];
        ++means.steps;
    }
    means.gained = (means.gained + momentum(dynamics.grains()))/(means.steps*deltaT);
    means.bottom /= means.steps;
    means.top /= means.steps;
    return means;
}

void judge(bars::CsvFile& csv, double width, double height, double solidFraction, double rate, double shearOfAll, double deltaT, bool isSteady)
{
    const Scene scene = layer(width, height, solidFraction, rate);
    const Means means = shear(scene, rate, shearOfAll, deltaT);
    const double pressure = -means.bottom[2]/width, inertial = rate*meanDiameter*std::sqrt(density/pressure);
    const double friction = std::abs(means.bottom[0]/means.bottom[2]);
    std::printf("A19: %zu discs at %.2f, %g 1/s for a shear of %g: pressure %.0f Pa, I %.4f (belt speed over height), mu_eff %.4f; %d of %d steps at the cap\n",
        scene.grains.size(), solidFraction, rate, shearOfAll, pressure, inertial, friction, means.capped, means.steps);
    csv.row({rate, deltaT, double(scene.grains.size()), solidFraction, pressure, inertial, friction, means.top[0], means.top[2], means.bottom[0], means.bottom[2], means.overlap});
    const double size = std::abs(means.bottom[0]), apart = std::abs(means.top[0] + means.bottom[0])/size;
    const Vec3 unexplained = means.top + means.bottom + means.gained;
    require("normal forces of the plates, difference in the mean, share", std::abs(means.top[2] + means.bottom[2])/std::abs(means.bottom[2]), 0.02);
    require("forces of the plates and momentum gained by the layer, share", unexplained.norm()/size, 1e-10);
    if (isSteady) require("shear forces of the plates, difference in the mean, share", apart, 0.02);
    else std::printf("  shear forces of the plates differ by %.1f %% in the mean: the layer slides along the plates, and still speeds up or slows down\n", 100*apart);
    require("largest overlap, d", means.overlap, 0.01);
    std::fflush(stdout);
}

} // namespace

int main(int count, char** arguments)
{
    bars::CsvFile csv(arguments[0], "shear", "rate,deltaT,discs,solidFraction,pressure,I,muEff,topX,topZ,bottomX,bottomZ,overlapMax");
    const bool isFull = count > 1 && std::strcmp(arguments[1], "full") == 0;
    if (isFull) judge(csv, 0.2, 0.1, 0.82, 100, 50, 2.5e-5, true);
    else
    {
        judge(csv, 0.05, 0.025, 0.80, 100, 100, 1e-4, false);
        judge(csv, 0.05, 0.025, 0.815, 100, 100, 1e-4, false);
    }
    return bars::status();
}
