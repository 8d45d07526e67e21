// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The frictional contact problem of one step, and the solvers that share one signature and one residual.
#pragma once

#include "nscd/contacts/clumps/clumpContacts.hpp"
#include "nscd/contacts/laws/rollingFriction.hpp"
#include "nscd/kernels/contactBlock.hpp"
#include "nscd/kernels/halo.hpp"
#include "nscd/scene/contactSettings.hpp"
#include "nscd/scene/stepReport.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace nscd
{

class PackedContacts;

/// Bodies carry velocities that already contain the impulses in the blocks: v = v_free + M^-1 H r.
/// A solver changes r and v together and keeps that relation.
struct ContactProblem
{
    std::vector<Body>& bodies;
    std::vector<ContactBlock>& blocks;
    /// Blocks worth sweeping, ascending; the others carry no impulse, and a solver adds those that turn out to.
    std::vector<std::uint32_t>& awake;
    /// Blocks from this one on join grains of two ranks; the halo makes their bodies' velocities one.
    std::size_t interfaceBlock;
    Halo& halo;
    const SweepKernels& kernels;
    bool isFrictional;
    double deltaT;        ///< [s]
    double speedScale;    ///< from the forces of the step [m/s]
    double diameter;      ///< mean d [m]
    const std::vector<Vec3>& position;  ///< of all bodies but the static one [m]
    /// Mean over the grains of min(1, speed/speedScale) before the step: 1 in a flow, small in a bed at rest.
    double motion = 1.0;
    /// Rolling and spinning friction, slot by slot; none in scenes without.
    RollingSlots* rolling = nullptr;
    /// Of all bodies that move, heaviest to lightest.
    double massRatio = 1.0;
    /// Blocks before this one are none of a solver's business: isolatedPairs.hpp.
    std::size_t firstBlock = 0;
    /// Contacts of clumps, in blocks behind all others; none in scenes without.
    ClumpList* clumps = nullptr;
    /// Room in which a solver may pack contacts, or none; in a packed problem, what holds the contacts that are not.
    PackedContacts* packing = nullptr;
    bool isPacked = false;
    /// What the next sweep moves the impulses of the active blocks on by (see MomentumSweepFunction); velocities have been moved already.
    double* before = nullptr;   ///< none: by nothing
    double theta = 0.0;

    /// Whether most grains move: what a solve leaves is then soon forgotten, where in a bed that comes to rest it decides on how.
    bool isFlowing() const { return motion >= 0.5; }

    /// All blocks but those of clumps.
    BlockRange all() const { return {nullptr, clumps ? clumps->firstBlock : blocks.size()}; }
    BlockRange active() const { return {awake.data(), awake.size()}; }
    /// The active blocks whose bodies no other rank moves meanwhile.
    BlockRange inner() const;
    BlockRange interface() const;
    /// The active blocks of clumps.
    BlockRange activeClumps() const;
};

/// One pass over blocks that changes impulses and velocities in place, on this rank alone; with momentum where there is what impulses were `before`.
DefectSums sweepBlocks(ContactProblem& problem, BlockRange range, double* before = nullptr);

/// Sweeps over the inner active blocks of all ranks side by side, then over those between ranks. Returns sums over all ranks.
DefectSums sweepActive(ContactProblem& problem);

/// Replaces the impulses of the active blocks (see ReplaceFunction) and moves the velocities along, on all ranks.
void replaceImpulses(ContactProblem& problem, std::vector<double>& target);

/// Stop rule, absolute (grains.md sections 2 and 9): rms defect <= tolerance vs and largest defect dt <= displacementTolerance d, with
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

/// The residual every solver is judged by: natural map in velocity units,
/// e_n = W_nn |r_n - max(0, r_n - (u_n + b)/W_nn)|, e_t = W_tt |r_t - Proj_{mu r_n}(r_t - u_t/W_tt)|; rms over active contacts, and max.
/// Rolling and spinning friction add their own (rollingFriction.hpp) to the sum, and to the maximum as contacts of their own.
/// Where n ranks move a body, W is taken n times, which can only make e larger.
DefectSums residual(ContactProblem& problem);
/// The same of the active blocks alone, which is less.
DefectSums residualOfActive(ContactProblem& problem);

/// Wakes sleeping blocks in which a contact should carry an impulse at the present velocities. Returns whether there were any, on any rank.
bool wakeBlocks(ContactProblem& problem);

/// Root mean square over the active contacts [m/s].
double rms(const DefectSums& sums);

using ContactSolver = SolveReport (*)(ContactProblem&, const ContactSettings&);

struct ContactSolverRow
{
    const char* name;
    ContactSolver solve;
    const char* description;
    bool worksOnRanks;
};

/// All solvers by name.
const std::vector<ContactSolverRow>& contactSolvers();

/// Errors: std::invalid_argument listing the names there are
const ContactSolverRow& findContactSolver(const std::string& name);

SolveReport solveNlgs(ContactProblem& problem, const ContactSettings& settings);
SolveReport solveQueue(ContactProblem& problem, const ContactSettings& settings);
SolveReport solveDirect(ContactProblem& problem, const ContactSettings& settings);
SolveReport solveNncg(ContactProblem& problem, const ContactSettings& settings);
SolveReport solveProjectedGradient(ContactProblem& problem, const ContactSettings& settings);

/// Completes a report with the residual of the solution reached.
void reportResidual(SolveReport& report, const StopRule& rule, const DefectSums& sums);

} // namespace nscd
