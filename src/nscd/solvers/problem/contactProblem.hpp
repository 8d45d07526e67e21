// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The frictional contact problem of one step: passes over its contacts, and the residual that every solver is judged by.
#pragma once

#include "nscd/base/stepTimes.hpp"
#include "nscd/contacts/general/generalBodies.hpp"
#include "nscd/kernels/contactBlock.hpp"
#include "nscd/kernels/halo.hpp"

#include <vector>

namespace nscd
{

class PackedContacts;
struct ContactProblem;

/// Contacts that are not in a problem, and may come to matter in it.
class ContactsLeftOut
{
public:
    virtual ~ContactsLeftOut() = default;
    /// Their defects at the problem's velocities [m/s].
    virtual DefectSums defects(const ContactProblem& problem) const = 0;
    /// Takes those into the problem that should carry an impulse at its velocities, behind those of their kind (within this rank, with others). Returns whether there
    /// were any, on any rank.
    virtual bool wake(ContactProblem& problem) = 0;
};

/// How far a sweep moves the impulses of each active block on before it solves them (see MomentumSweepFunction); velocities have been moved already.
struct SweepOn
{
    double* before = nullptr;          ///< impulses before the last sweep, as ReplaceFunction numbers them; null: not at all
    double* lawBefore = nullptr;   ///< those of the law that is solved with them, likewise; null: there is none
    double theta = 0.0;
};

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
    /// What a law beside Coulomb's that is solved within the sweeps has of the contacts, a block for each of theirs; null: there is none.
    std::vector<LawBlock>* lawBlocks = nullptr;
    /// Whether that law is of films of fluid, which clusters do not solve, and not of moments.
    bool areFilms = false;
    /// Of all bodies that move, heaviest to lightest.
    double massRatio = 1.0;
    /// Velocities without any contact impulse, of the bodies that this rank owns; null: not known, and forces are not judged.
    const std::vector<Vec3>* freeVelocity = nullptr;
    /// Contacts of general bodies, in blocks behind all others; none in scenes without.
    GeneralBodies* general = nullptr;
    /// Room in which a solver may pack contacts; null: none.
    PackedContacts* packing = nullptr;
    /// In a packed problem what holds the contacts that are not in it; null: all are.
    ContactsLeftOut* leftOut = nullptr;
    /// Whether velocities after the impacts of a step are sought, which go through all of a bed that has landed.
    bool isShock = false;
    /// Where looks at residuals are timed; null: within what is timed around them.
    StepTimes* times = nullptr;

    /// Whether a wall goes along or into grains faster than the speed scale: what slides on it may have no forces that are right (a plug between a belt
    /// and a plate that presses on it), also where most grains rest.
    bool isDriven = false;

    /// Whether nobody asks blocks that are not awake if they should carry an impulse: the law of a shock lets none of them.
    bool isAllAwake() const { return isShock && !leftOut; }
    /// Whether most grains move: what a solve leaves is then soon forgotten, where in a bed that comes to rest it decides on how.
    bool isFlowing() const { return motion >= 0.5; }
    /// Whether only so many sweeps are spent on forces: see SolverStrategy::Forces.
    bool areForcesBounded() const { return isFlowing() || isDriven; }

    /// Before contacts between ranks are looked at, and after they have been solved: see Halo.
    void giveVelocities();
    void takeVelocities();

    /// All blocks but the general ones.
    BlockRange all() const { return {nullptr, general ? general->firstBlock : blocks.size()}; }
    BlockRange active() const { return {awake.data(), awake.size()}; }
    /// The active blocks whose bodies no other rank moves meanwhile.
    BlockRange inner() const;
    BlockRange interface() const;
    BlockRange innerGeneral() const;
    BlockRange interfaceGeneral() const;
    /// The active blocks of this rank's contacts alone, general ones behind the others.
    std::vector<std::uint32_t> withinRank() const;

private:
    /// The active blocks from one to before another.
    BlockRange activeIn(std::size_t first, std::size_t end) const;
};

/// One pass over blocks that changes impulses and velocities in place, on this rank alone.
DefectSums sweepBlocks(ContactProblem& problem, BlockRange range, const SweepOn& on = {});

/// Sweeps over the inner active blocks of all ranks side by side, then over those between ranks. Returns sums over all ranks.
DefectSums sweepActive(ContactProblem& problem, const SweepOn& on = {});

/// Replaces the impulses of the active blocks (see ReplaceFunction) and moves the velocities along, on all ranks.
void replaceImpulses(ContactProblem& problem, std::vector<double>& target);

/// The residual every solver is judged by: natural map in velocity units,
/// e_n = W_nn |r_n - max(0, r_n - (u_n + b)/W_nn)|, e_t = W_tt |r_t - Proj_{mu r_n}(r_t - u_t/W_tt)|; rms over active contacts, and max.
/// A law within the sweeps adds its own to the sum, and to the maximum as contacts of its own.
/// Where n ranks move a body, W is taken n times, which can only make e larger.
DefectSums residual(ContactProblem& problem);
/// The same of the active blocks alone, which is less.
DefectSums residualOfActive(ContactProblem& problem);

/// Wakes sleeping blocks in which a contact should carry an impulse at the present velocities. Returns whether there were any, on any rank.
bool wakeBlocks(ContactProblem& problem);

/// Sum over the bodies of the size of what all contacts of a body give it together, |m (v - v_free)| [N s]; over all ranks.
double netImpulse(const ContactProblem& problem);

/// Root mean square over the active contacts [m/s].
double rms(const DefectSums& sums);

} // namespace nscd
