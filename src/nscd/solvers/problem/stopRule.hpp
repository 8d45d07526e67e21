// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// When a contact problem counts as solved.
#pragma once

#include "nscd/scene/contactSettings.hpp"
#include "nscd/scene/stepReport.hpp"
#include "nscd/solvers/problem/contactProblem.hpp"

#include <algorithm>

namespace nscd
{

/// Stop rule, absolute (src/nscd/method.md): rms defect <= tolerance vs and largest defect dt <= displacementTolerance d, with
/// vs = max(speed scale of the forces, 1e-3 rms defect of the first pass, 1e-3 dead band/dt).
/// What the rule leaves of defects is the noise of a bed at rest: grains keep moving by it, contacts leave the dead band, and the
/// bed creeps. So a bed that hardly moves is polished: limits shrink with its motion, down to 3e-3 of themselves, for some more sweeps;
/// and no defect may exceed ten times the rms limit then: a grain that can roll freely is driven by what a single contact is off by.
struct StopRule
{
    double rmsLimit;     ///< [m/s]
    double maxLimit;     ///< [m/s]
    double speedScale;
    double polishedRms;  ///< the same limits for a polished solution
    double polishedMax;

    bool isMet(const DefectSums& sums) const { return isWithin(sums, rmsLimit, maxLimit); }
    bool isPolished(const DefectSums& sums) const { return isWithin(sums, polishedRms, polishedMax); }
    /// Polished but for some contacts.
    bool hasLoneDefects(const DefectSums& sums) const { return isWithin(sums, polishedRms, maxLimit) && !isPolished(sums); }

private:
    static bool isWithin(const DefectSums& sums, double rms, double max)
    {
        return sums.sumSquares <= rms*rms*std::max(1.0, sums.active) && sums.maxSquare <= max*max;
    }
};

/// `first` are the defects of the first pass: the approach speeds the solve has to deal with.
StopRule makeStopRule(const ContactProblem& problem, const ContactSettings& settings, const DefectSums& first);

/// Completes a report with the residual of the solution reached.
void reportResidual(SolveReport& report, const StopRule& rule, const DefectSums& sums);

} // namespace nscd
