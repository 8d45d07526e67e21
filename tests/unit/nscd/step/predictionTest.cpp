// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Trials of forces in a bed that is awake: they leave no trace in the steps, and each starts from what the last one found.
#include "unit/nscd/scenes/heaps.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3, radius = 0.01;

/// A heap that has landed; it does not sleep.
struct Bed
{
    Scene scene = heap(3, 6, 5, radius, 0.7, 0.5);
    nscd::GrainDynamics dynamics = scene.build(awake());

    static nscd::ContactSettings awake()
    {
        nscd::ContactSettings settings;
        settings.sleep = false;
        return settings;
    }

    Bed()
    {
        for (int k = 0; k < 400; ++k) stepDamped(dynamics, scene.g, deltaT);
    }

    nscd::ExternalForces still() const { return weight(dynamics.grains(), scene.g, deltaT); }

    /// All grains are pushed up by a twentieth of their weight.
    nscd::Prediction tryPush()
    {
        nscd::ExternalForces forces = still();
        for (Vec3& force : forces.force) force *= 0.95;
        return dynamics.tryForces(forces);
    }

    nscd::Prediction step(bool isTried)
    {
        dynamics.beginStep(deltaT);
        dynamics.predict(still());
        nscd::Prediction trial;
        if (isTried) trial = tryPush();
        dynamics.advance(still());
        return trial;
    }
};

} // namespace

TEST(Prediction, aTrialLeavesNoTrace)
{
    Bed tried, others;
    for (int k = 0; k < 5; ++k)
    {
        tried.step(true);
        others.step(false);
        ASSERT_EQ(tried.dynamics.grains().position, others.dynamics.grains().position) << k;
        ASSERT_EQ(tried.dynamics.contactForce(), others.dynamics.contactForce()) << k;
    }
}

// The same push once more: nothing is left to find.
TEST(Prediction, theNextTrialStartsFromWhatTheLastOneFound)
{
    Bed bed;
    bed.dynamics.beginStep(deltaT);
    bed.dynamics.predict(bed.still());
    const nscd::Prediction first = bed.tryPush(), second = bed.tryPush();
    std::printf("   sweeps of a trial: %d, then %d\n", first.solve.sweeps, second.solve.sweeps);
    EXPECT_TRUE(second.solve.converged);
    EXPECT_LT(2*second.solve.sweeps, first.solve.sweeps);
    double weightOfAll = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < first.contactForce.size(); ++i)
    {
        weightOfAll += gravity*bed.dynamics.grains().mass[i];
        difference += (first.contactForce[i] - second.contactForce[i]).norm();
    }
    EXPECT_LT(difference, 0.02*weightOfAll);
}
