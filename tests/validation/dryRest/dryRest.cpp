// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Ten thousand steps at rest: column height, kinetic energy and impulse on floor and walls of a bed 20 layers deep, none asleep, at
// tolerance 1e-3, in one run; and the same bed under a cap of sweeps that is too small for it, which the library must raise.
#include "unit/nscd/scenes/heaps.hpp"
#include "../resources/bars.hpp"

#include "nscd/scene/stepWarnings.hpp"

using namespace scenes;
using bars::require;

namespace
{

nscd::ContactSettings awake()
{
    nscd::ContactSettings settings;
    settings.sleep = false;
    return settings;
}

constexpr double radius = 0.01, deltaT = 1e-3;

/// Lets the grains land, and a viscous medium stop the last ones that roll. One in a shallow hollow swings with a period of seconds: in a medium that
/// stops others sooner (30/s) it creeps there for tens of thousands of steps.
void comeToRest(const Scene& scene, nscd::GrainDynamics& dynamics)
{
    for (int k = 0; k < 1000; ++k) step(dynamics, scene.g, deltaT);
    for (int k = 0; k < 20000; ++k) stepDamped(dynamics, scene.g, deltaT, 2.0);
}

/// What the steps of a run at rest are judged by.
class RestRecord
{
public:
    explicit RestRecord(const nscd::Grains& grains)
    {
        for (double m : grains.mass) weight_ += m*gravity;
    }

    void add(const nscd::GrainDynamics& dynamics, const nscd::StepReport& report)
    {
        energy = std::max(energy, nscd::kineticEnergy(dynamics.grains())/(weight_*2.0*radius));
        baseError = std::max(baseError, (onWalls(dynamics)/weight_ + Vec3::UnitZ()).norm());
        capped += !report.solve.converged;
        sweeps += report.solve.sweeps;
    }

    double energy = 0.0;      ///< largest kinetic energy per grain [m g d]
    double baseError = 0.0;   ///< largest error of a step's impulse on the floor, of the weight's
    int capped = 0;
    int sweeps = 0;

private:
    static Vec3 onWalls(const nscd::GrainDynamics& dynamics)
    {
        Vec3 sum = Vec3::Zero();
        for (const Vec3& force : dynamics.wallForce()) sum += force;
        return sum;
    }

    double weight_ = 0.0;
};

double columnHeight(const nscd::GrainDynamics& dynamics)
{
    double top = 0.0;
    for (const Vec3& x : dynamics.grains().position) top = std::max(top, x[2] + radius);
    return top/(2.0*radius);
}

double massCenterHeight(const nscd::GrainDynamics& dynamics) { return nscd::massCenter(dynamics.grains())[2]/(2.0*radius); }

/// The first steps, in which the bed comes to rest after the medium is gone, apart.
void tenThousandSteps(const Scene& scene, nscd::GrainDynamics& dynamics)
{
    constexpr int toRest = 200, steps = 10000;
    for (int k = 0; k < toRest; ++k) step(dynamics, scene.g, deltaT);
    RestRecord record(scene.grains);
    const double top = columnHeight(dynamics), center = massCenterHeight(dynamics);
    double halfway = center;
    for (int k = 0; k < steps; ++k)
    {
        record.add(dynamics, step(dynamics, scene.g, deltaT));
        if (k == steps/2) halfway = massCenterHeight(dynamics);
    }
    std::printf("Bed of %zu spheres, 20 layers, %d steps at rest, nothing asleep: %.2f sweeps a step\n", scene.grains.size(), steps,
        static_cast<double>(record.sweeps)/steps);
    require("impulse on floor and walls against the weight's, worst step", record.baseError, 1e-4);
    require("kinetic energy, m g d a grain, worst step", record.energy, 1e-12);
    require("change of the column's height, d", std::abs(columnHeight(dynamics) - top), 1e-6);
    require("change of the mass center's height, d", std::abs(massCenterHeight(dynamics) - center), 1e-6);
    require("of which in the second half", std::abs(massCenterHeight(dynamics) - halfway), 1e-7);
    require("steps at the cap", record.capped, 0);
}

/// The bed from cold under a cap of 5 sweeps: part of its weight is not carried, step after step, and the report says so.
void cappedBed(Scene scene, const nscd::GrainDynamics& resting)
{
    constexpr int cap = 5, steps = 100;
    scene.grains = resting.grains();
    nscd::ContactSettings settings = awake();
    settings.maxSweeps = cap;
    auto dynamics = scene.build(settings);
    const double center = massCenterHeight(dynamics);
    int silent = 0;
    RestRecord record(scene.grains);
    for (int k = 0; k < steps; ++k)
    {
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        record.add(dynamics, report);
        silent += k >= 4 && report.solve.stepsAtCap >= 5 && nscd::warning(report.solve).empty();
    }
    std::printf("The same bed from cold under a cap of %d sweeps: %d of %d steps at the cap, base force off by %.2g, sunk by %.2g d\n", cap,
        record.capped, steps, record.baseError, std::abs(massCenterHeight(dynamics) - center));
    require("steps in a row at the cap without a warning", silent, 0);
    require("steps that met the rule", steps - record.capped, 0.5*steps);
}

} // namespace

int main()
{
    const Scene scene = heap(3, 6, 20, radius, 0.8, 0.4);
    // At the default tolerance, ten times as much, a sphere that can roll freely inside the bed keeps 1e-11 m g d a grain.
    nscd::ContactSettings fine = awake();
    fine.tolerance = 1e-3;
    auto dynamics = scene.build(fine);
    comeToRest(scene, dynamics);
    cappedBed(scene, dynamics);
    tenThousandSteps(scene, dynamics);
    return bars::status();
}
