// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What users should know of a step, in words and counts.
#include "nscd/scene/stepWarnings.hpp"

#include "nscd/base/formattedText.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

constexpr int patience = 5;   // steps in a row: a few are what an impact costs

/// A warning whose text has its measure in the place of a %.3g.
__attribute__((format(printf, 2, 0))) Warning measured(const char* kind, const char* text, double measure, const char* unit)
{
    return {kind, formatted(text, measure), measure, unit};
}

Warning unlikeMasses(const SolveReport& report)
{
    return measured
    (
        "unlike masses",
        "masses in contact differ by up to 1:%.3g, and the direct method is too dear for this scene or not to be had on several ranks: "
        "velocities have the accuracy asked for, forces under the heavy bodies may not; ask for a finer tolerance where they matter",
        report.hiddenMassRatio, "times as heavy"
    );
}

Warning scaledRebounds(const SolveReport& report)
{
    const std::string text = formatted
    (
        "restitution and friction at once would have created %.3g J in a step (Newton's law of impact may): all its rebounds were "
        "multiplied by %.3g, so that none was",
        report.shockWork, report.reboundShare
    );
    return {"scaled rebounds", text, report.shockWork, "J that were not created"};
}

Warning reboundOfMotion(const SolveReport& report)
{
    return measured
    (
        "rebound of the motion",
        "no impacts were found that obey Coulomb's and Newton's laws at all contacts: grains rebound by (1 + restitution) times the impulses that stop them, which "
        "takes energy, but what sticks rebounds along the surface too (laws are off by %.3g m/s in the solve that was given up); less friction or a smaller time step would do",
        report.residualRms, "m/s rms"
    );
}

Warning mergedImpacts(const SolveReport& report)
{
    return measured
    (
        "merged impacts",
        "grains meet others %.3g times a step, step after step, all at once and each once: impacts take less energy than they should, friction above all (a tenth at 0.25, a half at 1), "
        "and beds in a gas come out too even; smaller steps of the grains would do (in a fluid: timeStep { maxGrainImpacts 0.1; })",
        report.impacts, "of a grain in a step"
    );
}

Warning alwaysAtCap(const SolveReport& report)
{
    return
    {
        "at the cap in a row",
        "step after step ends at the cap of sweeps, after which part of the weight is not carried: grains at rest sink so, and bounce without "
        "end; a larger maxSweeps, a smaller time step or a coarser tolerance would do",
        double(report.stepsAtCap), "in a row"
    };
}

Warning frictionHeld(const SolveReport& report)
{
    return measured
    (
        "friction held",
        "no forces were found that obey Coulomb's law at all contacts (a grain in a corner between belt and wall has none where friction is 1 or more; grains wedged "
        "between much heavier ones may have none that sweeps find): friction was held, and is off by %.3g of its limits in the sum; nothing overlaps for it, and no "
        "energy is created; less friction or a smaller time step would do",
        report.frictionOff, "of friction's limits"
    );
}

Warning squeezed(const SolveReport& report)
{
    return measured
    (
        "squeezed",
        "walls or driven grains that move seem to leave the others no room: no velocities were found that keep all apart, and some still close by %.3g m/s; "
        "grains overlap for as long as that lasts, and forces of such steps mean nothing; a wall that stops earlier or moves more slowly would do",
        report.residualMax, "m/s"
    );
}

Warning energyFromNowhere(const SolveReport& report)
{
    return measured
    (
        "energy from nowhere",
        "a step whose contact solve has not converged created %.3g J, which grains carry on: what they do from here on is not to be trusted; a larger maxSweeps, "
        "a smaller time step or less friction would do",
        report.createdEnergy, "J in a step"
    );
}

Warning forcesOff(const SolveReport& report)
{
    return measured
    (
        "forces off",
        "velocities have converged, forces not: the mean grain's velocity, weighted by force, is still off by %.3g of what the tolerance multiplies; in a "
        "flow only so many sweeps are spent on that; a smaller tolerance makes velocities and forces finer",
        report.forceError, "of the forces"
    );
}

} // namespace

std::vector<Warning> warnings(const SolveReport& report)
{
    std::vector<Warning> all;
    if (report.hiddenMassRatio > 0.0) all.push_back(unlikeMasses(report));
    if (report.hasGainedEnergy()) all.push_back(scaledRebounds(report));
    if (report.isHeld) all.push_back(frictionHeld(report));
    if (report.isSqueezed) all.push_back(squeezed(report));
    if (report.isReboundOfMotion) all.push_back(reboundOfMotion(report));
    if (report.createdEnergy > 0.0) all.push_back(energyFromNowhere(report));
    if (!report.converged && !report.atCap && !report.isHeld && !report.isReboundOfMotion) all.push_back(forcesOff(report));
    if (report.stepsAtCap >= patience) all.push_back(alwaysAtCap(report));
    if (report.stepsOfManyImpacts >= patience) all.push_back(mergedImpacts(report));
    return all;
}

std::string warning(const SolveReport& report)
{
    std::string text;
    for (const Warning& one : warnings(report)) text += (text.empty() ? "" : "; and ") + one.text;
    return text;
}

bool WarningCounts::count(const Warning& warning, double time)
{
    const auto known = std::find_if(kinds_.begin(), kinds_.end(), [&](const Kind& k) { return k.worst.kind == warning.kind; });
    if (known == kinds_.end())
    {
        kinds_.push_back({warning, 1, time});
        return true;
    }
    ++known->steps;
    if (warning.measure > known->worst.measure) known->worst = warning;
    return false;
}

std::string WarningCounts::lines() const
{
    std::string all;
    for (const Kind& kind : kinds_)
    {
        all += formatted
        (
            "  %-22s %ld steps, first at %.9g s, worst %.3g %s\n",
            kind.worst.kind.c_str(), kind.steps, kind.first, kind.worst.measure, kind.worst.unit.c_str()
        );
    }
    return all;
}

} // namespace nscd
