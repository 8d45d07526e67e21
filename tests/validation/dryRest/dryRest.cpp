// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Ten thousand steps at rest: column height, kinetic energy and base impulse of a bed 20 layers deep, none asleep, at the default settings;
// and a bed 50 layers deep under a cap of sweeps that is too small for it, which the library must raise.
#include "../../benchmark/coldSolve/frozenBed.hpp"
#include "../resources/bars.hpp"

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

/// Lattice between periodic sides, landed and at rest.
Scene settledBed(int perSide, int layers, int steps)
{
    Scene scene = emptyPeriodicBed(2.2*bedRadius*perSide, 2.2*bedRadius*perSide);
    addLattice(scene, perSide, layers);
    auto dynamics = scene.build(awake());
    for (int k = 0; k < steps; ++k) stepDamped(dynamics, scene.g, bedDeltaT);
    scene.grains = dynamics.grains();
    return scene;
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
        energy = std::max(energy, nscd::kineticEnergy(dynamics.grains())/(weight_*2.0*bedRadius));
        baseError = std::max(baseError, std::abs(-dynamics.wallForce()[0][2]/weight_ - 1.0));
        capped += !report.solve.converged;
        sweeps += report.solve.sweeps;
    }

    double energy = 0.0;      ///< largest kinetic energy per grain [m g d]
    double baseError = 0.0;   ///< largest error of a step's impulse on the floor, of the weight's
    int capped = 0;
    int sweeps = 0;

private:
    double weight_ = 0.0;
};

double columnHeight(const nscd::GrainDynamics& dynamics)
{
    double top = 0.0;
    for (const Vec3& x : dynamics.grains().position) top = std::max(top, x[2] + bedRadius);
    return top/(2.0*bedRadius);
}

double massCenterHeight(const nscd::GrainDynamics& dynamics) { return nscd::massCenter(dynamics.grains())[2]/(2.0*bedRadius); }

/// Base impulse, kinetic energy and height in one run; the first steps, in which the bed comes to rest after the medium is gone, apart.
void tenThousandSteps()
{
    constexpr int toRest = 200, steps = 10000;
    const Scene scene = settledBed(5, 20, 1000);
    auto dynamics = scene.build(awake());
    for (int k = 0; k < toRest; ++k) step(dynamics, scene.g, bedDeltaT);
    RestRecord record(scene.grains), lastTenth(scene.grains);
    const double top = columnHeight(dynamics), center = massCenterHeight(dynamics);
    double halfway = center;
    for (int k = 0; k < steps; ++k)
    {
        const nscd::StepReport report = step(dynamics, scene.g, bedDeltaT);
        record.add(dynamics, report);
        if (k >= steps - steps/10) lastTenth.add(dynamics, report);
        if (k == steps/2) halfway = massCenterHeight(dynamics);
    }
    std::printf("Bed of %zu spheres, 20 layers, %d steps at rest, nothing asleep: %.2f sweeps a step\n", scene.grains.size(), steps,
        static_cast<double>(record.sweeps)/steps);
    require("impulse on the floor against the weight's, worst step", record.baseError, 1e-4);
    require("kinetic energy, m g d a grain, worst step", record.energy, 1e-10);
    require("the same in the last tenth", lastTenth.energy, 1e-12);
    require("change of the column's height, d", std::abs(columnHeight(dynamics) - top), 1e-5);
    require("change of the mass center's height, d", std::abs(massCenterHeight(dynamics) - center), 1e-6);
    require("of which in the second half", std::abs(massCenterHeight(dynamics) - halfway), 1e-7);
    require("steps at the cap", record.capped, 0);
}

/// From cold under a cap of 5 sweeps.
void cappedDeepBed()
{
    constexpr int cap = 5, steps = 600;
    const Scene scene = settledBed(5, 50, 1000);
    nscd::ContactSettings settings = awake();
    settings.maxSweeps = cap;
    auto dynamics = scene.build(settings);
    const double center = massCenterHeight(dynamics);
    int raised = 0;
    RestRecord end(scene.grains);
    for (int k = 0; k < steps; ++k)
    {
        const nscd::StepReport report = step(dynamics, scene.g, bedDeltaT);
        raised = std::max(raised, report.solve.raisedCap);
        if (k >= steps - 100) end.add(dynamics, report);
    }
    std::printf("Bed of 50 layers from cold under a cap of %d sweeps: raised to %d\n", cap, raised);
    require("impulse on the floor against the weight's, worst of the last 100 steps", end.baseError, 1e-2);
    require("kinetic energy, m g d a grain, the same steps", end.energy, 1e-8);
    require("change of the mass center's height, d", std::abs(massCenterHeight(dynamics) - center), 2e-2);
}

} // namespace

int main()
{
    tenThousandSteps();
    cappedDeepBed();
    return bars::status();
}
