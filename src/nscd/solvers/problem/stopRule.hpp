// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// When a contact problem counts as solved.
#pragma once

#include "nscd/scene/contactSettings.hpp"
#include "nscd/scene/stepReport.hpp"
#include "nscd/solvers/problem/contactProblem.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

/// Stop rule, absolute (src/nscd/method.md): rms defect <= tolerance vs and largest defect dt <= displacementTolerance d, with
/// vs = max(speed scale of the forces, 1e-3 rms defect of the first pass, 1e-3 dead band/dt).
/// What the rule leaves of defects is the noise of a bed at rest: grains keep moving by it, contacts leave the dead band, and the
/// bed creeps. So a bed that hardly moves is polished: limits shrink with its motion, down to 3e-3 of themselves, for some more sweeps;
/// and no defect may exceed ten times the rms limit then: a grain that can roll freely is driven by what a single contact is off by.
/// Forces, too: velocities of a deep bed that falls as one are off at its floor alone, where no mean shows it. By parts, the work of the impulses on the
/// defects is that of the forces on what the velocities of the grains are off by: sum over contacts of r.e = sum over bodies of J.dv, J what the contacts of a
/// body give it together. So |sum r.e| <= forceTolerance vs sum |J| holds the mean of dv, weighted by force, below forceTolerance vs: in a bed at rest, where
/// J = m g dt and vs = g dt, that is the share of its weight that has not come down to what carries it.
struct StopRule
{
    double rmsLimit;     ///< [m/s]
    double maxLimit;     ///< [m/s]
    double speedScale;
    double polishedRms;  ///< the same limits for a polished solution
    double polishedMax;
    double forceLimit;   ///< [-]
    double polishedForce;
    bool wereForcesOff = false;   ///< beyond their limit when a solution met the velocities: weight had not come down

    bool isMet(const DefectSums& sums) const { return isWithin(sums, rmsLimit, maxLimit); }
    bool isPolished(const DefectSums& sums) const { return isWithin(sums, polishedRms, polishedMax); }
    /// Share of the forces that has not come down, of an evaluation with this net impulse [N s].
    double forceError(const DefectSums& sums, double netImpulse) const
    {
        return netImpulse > 0.0 ? std::abs(sums.work)/(speedScale*netImpulse) : 0.0;
    }
    /// Asks for finer velocities where they were met and the force error exceeds what it may be by a factor: the error of a soft mode falls with its velocities.
    void tighten(const DefectSums& sums, double excess)
    {
        constexpr double least = 0.5, most = 0.8;
        rmsLimit = std::clamp(1.0/excess, least, most)*std::min(rmsLimit, rms(sums));
    }
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

/// Share of the forces that has not come down in the present solution; 0 where forces are not judged.
double forceErrorNow(const StopRule& rule, const ContactProblem& problem, const DefectSums& residual);

/// Completes a report with the residual of the solution that a problem has reached, and returns it.
DefectSums reportResidual(SolveReport& report, const StopRule& rule, ContactProblem& problem);

} // namespace nscd
