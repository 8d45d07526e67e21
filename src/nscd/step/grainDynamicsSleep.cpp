// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Falling asleep and waking: which list a step works on.
// Tested by tests/unit/nscd/step/grainSleepTest.cpp, tests/unit/nscd/step/awakePartTest.cpp
#include "nscd/step/grainDynamicsParts.hpp"

#include <algorithm>

namespace nscd
{

void GrainDynamics::Implementation::holdWholeList()
{
    overlapAsleep = measureOverlap(list).max;
    awakePart.hold(std::move(list), sumForces, scene(), deltaT);
}

void GrainDynamics::Implementation::cutAwakePart()
{
    sleep.wake(awakePart.sleepersBesideDriven(grains, sleep), awakePart.whole().halo);
    if (sleep.isWorthwhile()) list = awakePart.cut(sumForces, scene(), sleep, diameter, deltaT);
    else giveUpSleep();
}

void GrainDynamics::Implementation::giveUpSleep()
{
    list = awakePart.release();
    sleep = GrainSleep();
    // As at the start of the step.
    if (list.laws.areOfStart()) beforeStep = collectImpulses(list);
}

void GrainDynamics::Implementation::wake(const std::vector<int>& sleepers)
{
    if (!list.halo.any(!sleepers.empty())) return;
    sleep.wake(sleepers, list.halo);
    cutAwakePart();
}

void GrainDynamics::Implementation::wakeDisturbed(const ExternalForces& external)
{
    if (!sleep.any()) return;
    const auto timer = times.time(GrainPart::sleep);
    wake(sleep.disturbedBy(grains, external, deltaT));
}

/// The next solve starts from what the last one found.
void GrainDynamics::Implementation::wakeWithinSolve(const std::vector<int>& sleepers)
{
    const std::vector<AwakePart::Impulse> found = awakePart.impulses(list);
    wake(sleepers);
    awakePart.setImpulses(found, sleep.any(), list);
}

SolveReport GrainDynamics::Implementation::solveAndWake(const ExternalForces& external)
{
    SolveReport report = solveOnce(external, settings);
    // After some solves whole rings of grains are woken, more and more of them: an impact reaches far.
    constexpr int withoutRings = 5;
    for (int round = 0; sleep.any(); ++round)
    {
        const auto timer = times.time(GrainPart::sleep);
        const std::vector<int> disturbed = sleep.disturbedBy(grains, list, forcesOnBodies(), deltaT);
        if (!list.halo.any(!disturbed.empty())) break;
        wakeWithinSolve(awakePart.sleepersAround(disturbed, std::max(0, round - withoutRings), sleep, deadBand()));
        report = together(report, solveOnce(external, settings));
    }
    setFalls(list, grains.velocity, freeVelocity, fall);
    return report;
}

/// Whether held grains of any rank have been driven otherwise since the last step began.
bool GrainDynamics::Implementation::haveDrivenChanged()
{
    const bool haveHere = isAnyDrivenAnew;
    isAnyDrivenAnew = false;
    return maySleep() && list.halo.any(haveHere);
}

void GrainDynamics::Implementation::wakeAll()
{
    if (sleep.any()) giveUpSleep();
    else sleep = GrainSleep();
}

void GrainDynamics::Implementation::letSleep(const ExternalForces& external, StepReport& report)
{
    const auto timer = times.time(GrainPart::sleep);
    if (sleep.any())
    {
        awakePart.giveBack(list, forcesOnBodies());
        // The overlap correction moves no sleeping grain.
        wake(sleep.pressed(grains, list, settings.overlapTolerance*diameter));
    }
    const bool isListWhole = !sleep.any();
    const RestingStep step{list, external, forces, deltaT, report.solve.speedScale, deadBand()};
    if (sleep.fallAsleep(step, grains))
    {
        if (isListWhole) holdWholeList();
        else overlapAsleep = std::max(overlapAsleep, measureOverlap(list).max);
        cutAwakePart();
    }
    report.asleep = sleep.count();
}

} // namespace nscd
