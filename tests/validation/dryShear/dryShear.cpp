// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A19: a layer of discs sheared between two plates, periodic along them: on top a belt with mass, pressed down by a load, below a plate
// at rest, no gravity. In the mean both plates feel the same force, its normal part that of the load; friction against inertial number is reported.
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

constexpr double density = 1000, smallest = 0.8e-3, largest = 1e-3, meanDiameter = smallest + largest, pi = 3.14159265358979323846;
constexpr double plateMass = 100, solidFraction = 0.8;  // of the plate, a square meter [kg/m2]; of the layer before it is sheared

/// A plate that goes up and down as load and grains let it: each step as fast as the forces up to the one before have made it.
struct LoadedPlate
{
    double mass;     ///< [kg]
    double load;     ///< downwards [N]
    double height;   ///< at `time` [m]
    double speed = 0.0, time = 0.0;

    double at(double t) const { return height + speed*(t - time); }

    void advance(double deltaT, double force)
    {
        height += speed*deltaT;
        time += deltaT;
        speed += deltaT*(force - load)/mass;
    }
};

struct Means
{
    Vec3 bottom = Vec3::Zero();   ///< force on the plate below [N]
    Vec3 top = Vec3::Zero();
    Vec3 gained = Vec3::Zero();   ///< momentum of the layer over the time of the means, as a force [N]
    double height = 0.0;
    double overlap = 0.0;
    int steps = 0;
    int capped = 0;
    int held = 0;
};

/// Patch 1, the belt, goes with `plate`, which is set on the highest grain.
Scene layer(double width, double height, double rate, double friction, LoadedPlate& plate)
{
    Scene scene(2, friction, 0.0);
    scene.materials.setPair(0, 1, {std::max(0.5, friction), 0.0});
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
    plate.height = scene.grains.position.back()[2] + 1.1*largest;
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.addPlane(Vec3::Zero(), -Vec3::UnitZ());
    scene.walls.setMotion(1, [&plate](double time) { return nscd::WallPose(Eigen::Translation3d(0, 0, plate.at(time))); });
    scene.walls.setSurfaceMotion(1, nscd::belt(Vec3(rate*height, 0, 0)));
    return scene;
}

Vec3 momentum(const nscd::Grains& grains)
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < grains.size(); ++i) sum += grains.mass[i]*grains.velocity[i];
    return sum;
}

/// Friction at the plate below in windows of 100 units of shear: a layer that orders itself reads otherwise from then on.
class Windows
{
public:
    explicit Windows(int steps) : steps_(steps) {}

    void add(const Vec3& force, double height)
    {
        force_ += force;
        height_ += height;
        if (++count_ % steps_) return;
        std::printf("  shear %5d: mu_eff %.3f, height %.2f mm\n", 100*count_/steps_, std::abs(force_[0]/force_[2]), 1e3*height_/steps_);
        force_.setZero();
        height_ = 0.0;
    }

private:
    int steps_, count_ = 0;
    Vec3 force_ = Vec3::Zero();
    double height_ = 0.0;
};

/// Shears for a while, and takes means over the second half.
Means shear(const Scene& scene, LoadedPlate& plate, double rate, double shear, double deltaT)
{
    auto dynamics = scene.build(nscd::ContactSettings());
    const int steps = static_cast<int>(std::lround(shear/rate/deltaT));
    Means means;
    Windows windows(static_cast<int>(std::lround(100/rate/deltaT)));
    nscd::ExternalForces none;
    none.speedScale = 0.1*rate*meanDiameter;
    for (int k = 0; k < steps; ++k)
    {
        if (k == steps/2) means.gained = -momentum(dynamics.grains());
        dynamics.beginStep(deltaT);
        const nscd::StepReport report = dynamics.advance(none);
        plate.advance(deltaT, dynamics.wallForce()[1][2]);
        windows.add(dynamics.wallForce()[0], plate.height);
        if (k < steps/2) continue;
        means.capped += report.solve.atCap;
        means.held += report.solve.isHeld;
        means.overlap = std::max(means.overlap, report.overlapMax);
        means.bottom += dynamics.wallForce()[0];
        means.top += dynamics.wallForce()[1];
        means.height += plate.height;
        ++means.steps;
    }
    means.gained = (means.gained + momentum(dynamics.grains()))/(means.steps*deltaT);
    means.height /= means.steps;
    means.bottom /= means.steps;
    means.top /= means.steps;
    return means;
}

double area(const nscd::Grains& grains)
{
    double sum = 0.0;
    for (double r : grains.radius) sum += pi*r*r;
    return sum;
}

/// `height`: of the layer at the solid fraction above; the belt's speed is `rate` times that.
void judge(bars::CsvFile& csv, double width, double height, double pressure, double rate, double shearOfAll, double deltaT, double frictionOfDiscs = 0.1)
{
    LoadedPlate plate{plateMass*width, pressure*width, 0.0};
    const Scene scene = layer(width, height, rate, frictionOfDiscs, plate);
    const Means means = shear(scene, plate, rate, shearOfAll, deltaT);
    const double actual = rate*height/means.height, inertial = actual*meanDiameter*std::sqrt(density/pressure), fraction = area(scene.grains)/(width*means.height);
    const double friction = std::abs(means.bottom[0]/means.bottom[2]);
    bars::scene(nscd::formatted("A19 %zu discs of friction %g under %g Pa, belt at %g m/s for %g s", scene.grains.size(), frictionOfDiscs, pressure, rate*height, shearOfAll/rate));
    std::printf("  solid fraction %.4f, I %.4f (belt speed over height), mu_eff %.4f; of %d steps %d at the cap, %d with friction held\n", fraction, inertial,
        friction, means.steps, means.capped, means.held);
    csv.row({rate, deltaT, double(scene.grains.size()), fraction, pressure, inertial, friction, means.top[0], means.top[2], means.bottom[0], means.bottom[2], means.overlap});
    const double size = std::abs(means.bottom[0]);
    const Vec3 unexplained = means.top + means.bottom + means.gained;
    require("normal force of the upper plate against the load, in the mean, share", std::abs(means.top[2]/plate.load - 1), 0.02);
    require("normal forces of the plates, difference in the mean, share", std::abs(means.top[2] + means.bottom[2])/std::abs(means.bottom[2]), 0.02);
    require("shear forces of the plates, difference in the mean, share", std::abs(means.top[0] + means.bottom[0])/size, 0.02);
    require("forces of the plates and momentum gained by the layer, share", unexplained.norm()/size, 1e-10);
    require("largest overlap, d", means.overlap, 0.01);
    require("steps at the cap, share", double(means.capped)/means.steps, 0.01);
    std::fflush(stdout);
}

} // namespace

int main(int count, char** arguments)
{
    bars::CsvFile csv(arguments[0], "shear", "rate,deltaT,discs,solidFraction,pressure,I,muEff,topX,topZ,bottomX,bottomZ,overlapMax");
    const auto isAsked = [&](const char* size) { return count > 1 && std::strcmp(arguments[1], size) == 0; };
    if (isAsked("full")) judge(csv, 0.2, 0.1, 2500, 100, 400, 2.5e-5);
    else if (isAsked("rough")) judge(csv, 0.05, 0.025, 2500, 100, 100, 1e-4, count > 2 ? std::atof(arguments[2]) : 10.0);
    else judge(csv, 0.05, 0.025, isAsked("light") ? 250 : 2500, 100, isAsked("light") ? 3200 : 1600, 1e-4);
    return bars::status();
}
