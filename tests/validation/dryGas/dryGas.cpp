// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A11: an inelastic gas of smooth spheres cools as Haff's law says, T/T0 = (1 + (1 - e^2) w0 t/6)^-2 with the collision frequency of
// Enskog's theory, w0 = 4 sqrt(pi) n d^2 chi sqrt(T0), chi = (1 - phi/2)/(1 - phi)^3.
// dryGas [deltaT [number]]: judged. dryGas impacts: gases of solid fraction 0.3, without and with friction, in steps of more and more collisions: shown.
#include "unit/nscd/scenes/scenes.hpp"
#include "../resources/bars.hpp"
#include "../resources/csvFile.hpp"

#include "nscd/base/formattedText.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

using namespace scenes;
using bars::require;

namespace
{

constexpr double diameter = 1e-3, temperature = 1e-2, pi = 3.14159265358979323846;

/// Spheres at random places of a periodic box, none nearer than touching, with velocities of a Maxwell distribution.
Scene gas(int number, double solidFraction, double friction, double restitution, unsigned seed)
{
    Scene scene(3, friction, restitution);
    const double side = std::cbrt(number*pi/6*std::pow(diameter, 3)/solidFraction);
    scene.box.length = Vec3::Constant(side);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(0.0, side);
    std::normal_distribution<double> speed(0.0, 1.0);
    std::vector<Vec3>& taken = scene.grains.position;
    while (scene.grains.size() < static_cast<std::size_t>(number))
    {
        const Vec3 x(place(random), place(random), place(random));
        const auto isNear = [&](const Vec3& y) { return scene.box.nearestImage(x - y).squaredNorm() < 1.0001*diameter*diameter; };
        if (std::none_of(taken.begin(), taken.end(), isNear)) scene.addGrain(x, 0.5*diameter);
    }
    Vec3 mean = Vec3::Zero();
    for (Vec3& v : scene.grains.velocity)
    {
        v = Vec3(speed(random), speed(random), speed(random));
        mean += v/number;
    }
    double squares = 0.0;
    for (Vec3& v : scene.grains.velocity) squares += (v -= mean).squaredNorm()/(3.0*number);
    for (Vec3& v : scene.grains.velocity) v *= std::sqrt(temperature/squares);
    return scene;
}

double measured(const nscd::Grains& grains)
{
    double squares = 0.0;
    for (const Vec3& v : grains.velocity) squares += v.squaredNorm();
    return squares/(3.0*static_cast<double>(grains.size()));
}

/// Of a grain at the start [1/s].
double collisionFrequency(double solidFraction)
{
    const double chi = (1 - solidFraction/2)/std::pow(1 - solidFraction, 3);
    return 4*std::sqrt(pi)*solidFraction*6/(pi*diameter)*chi*std::sqrt(temperature);
}

double haff(double restitution, double frequency, double time) { return std::pow(1 + (1 - restitution*restitution)*frequency*time/6, -2); }

/// What impacts take where a step is longer than grains fly, over 20 collisions of a grain: as a share of Haff's law, and of what the finest steps give.
void showImpacts(double friction, double restitution)
{
    constexpr double solidFraction = 0.3, collisions = 20;
    const double frequency = collisionFrequency(solidFraction);
    std::printf("  solid fraction %g, friction %g, e %g\n  collisions in the first step  impacts a step  loss over Haff's  over the first row's\n", solidFraction, friction, restitution);
    double first = 0.0;
    for (const double inStep : {0.05, 0.1, 0.2, 0.4, 1.0, 2.0, 4.0, 10.0})
    {
        auto dynamics = gas(2000, solidFraction, friction, restitution, 5).build(nscd::ContactSettings());
        const int steps = static_cast<int>(std::lround(collisions/inStep));
        double impacts = 0.0;
        for (int k = 0; k < steps; ++k) impacts += step(dynamics, Vec3::Zero(), inStep/frequency).solve.impacts/steps;
        const double lost = std::pow(measured(dynamics.grains())/temperature, -0.5) - 1;
        if (first == 0.0) first = lost;
        const double expected = (1 - restitution*restitution)*collisions/6;
        std::printf("  %-28.2g  %-14.3f  %-16.3f  %.3f\n", inStep, impacts, lost/expected, lost/first);
    }
}

} // namespace

int main(int count, char** arguments)
{
    if (count > 1 && std::string(arguments[1]) == "impacts")
    {
        showImpacts(0.0, 0.9);
        showImpacts(0.1, 0.98);
        return 0;
    }
    constexpr double solidFraction = 0.05, restitution = 0.9;
    const double deltaT = count > 1 ? std::atof(arguments[1]) : 2e-4;
    const int number = count > 2 ? std::atoi(arguments[2]) : 5000;
    auto dynamics = gas(number, solidFraction, 0.0, restitution, 5).build(nscd::ContactSettings());
    bars::CsvFile csv(arguments[0], "haff", "time,temperature,haff,energyLossOfAStep");
    bars::scene(nscd::formatted("A11 %d spheres, e %g, time step %g s", number, restitution, deltaT));
    double worst = 0.0, loss = 0.0, before = temperature;
    const int steps = static_cast<int>(std::lround(1.0/deltaT));
    for (int k = 1; k <= steps; ++k)
    {
        step(dynamics, Vec3::Zero(), deltaT);
        const double now = measured(dynamics.grains()), time = k*deltaT;
        loss = std::max(loss, 1 - now/before);
        before = now;
        if (k % (steps/20) != 0) continue;
        const double expected = haff(restitution, collisionFrequency(solidFraction), time);
        worst = std::max(worst, std::abs(now/temperature/expected - 1));
        csv.row({time, now/temperature, expected, loss});
        if (k % (steps/10) == 0) std::printf("  t %.2f s: T/T0 %.4f, Haff %.4f (%+.1f %%)\n", time, now/temperature, expected, 100*(now/temperature/expected - 1));
        std::fflush(stdout);
    }
    require("temperature against Haff's law, worst of 20 times, share", worst, 0.05);
    require("energy lost in a step, share", loss, 0.1);
    return bars::status();
}
