// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A step of grains that may meet outlined walls anywhere on their way.
// Tested by tests/unit/nscd/step/sweptWallsTest.cpp
#include "nscd/step/grainDynamicsParts.hpp"

namespace nscd
{

/// A grain that one wall throws on may meet the next one in the same step.
SolveReport GrainDynamics::Implementation::solveAndFollow(const ExternalForces& external)
{
    constexpr int mostWallsFurther = 2;
    areWaysKnown = false;
    SolveReport report = solveAndWake(external);
    for (int k = 0; k < mostWallsFurther && list.isAnySwept; ++k)
    {
        if (!list.halo.any(aimFurther(list, wallsOfStep(), deltaT))) break;
        areWaysKnown = true;
        report = together(report, solveAndWake(external));
    }
    areWaysKnown = false;
    return report;
}

double GrainDynamics::Implementation::moveBodies(StepReport& report)
{
    if (!list.isAnySwept) return moveGrains(list, grains, box, deltaT, isFrictional);
    const std::vector<HeldBody> held = findHeld(list, wallsOfStep(), deltaT);
    const double displacement = moveGrains(list, grains, box, deltaT, isFrictional);
    for (const HeldBody& h : held)
    {
        list.position[h.body] += h.way - deltaT*Vec3(list.bodies[h.body].v);
        grains.position[list.grainOf[h.body]] = box.wrap(list.position[h.body]);
    }
    list.halo.give(list.position);
    report.heldOnWay = static_cast<std::size_t>(list.halo.sum(static_cast<double>(held.size())));
    return displacement;
}

} // namespace nscd
