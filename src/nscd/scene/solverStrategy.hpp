// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What shortens a contact solve beyond plain sweeps from a warm start, with every number that tunes it and the measurement behind it.
#pragma once

#include <cstddef>

namespace nscd
{

/// Helps of a solve by sweeps. No dictionary reads these numbers. What each help is worth is measured by `tests/benchmark/run ablation`, which switches them off one
/// by one; the table is in src/nscd/measured.md. A flow: most grains move. Cold: no contact carries an impulse at the start. Limits: those of the stop rule.
struct SolverStrategy
{
    /// A bed that hardly moves is solved on beyond its tolerance: what a solve leaves keeps grains moving, and those leave the dead band.
    struct Polish
    {
        double perMotion = 10.0;    ///< limits of a polished solution per unit of motion [-]: a step then takes about a decade off the noise
        double finest = 3e-3;       ///< of both limits, the least that is asked for [-]
        double loneDefect = 10.0;   ///< largest defect over the rms limit [-]: a grain that can roll is driven by what a single contact is off by
    } polish;

    /// In a flow, or where a wall drives, forces are given so many more sweeps once velocities are met; then the step says by how much they are off. Plugs between a belt and a plate that
    /// presses on it may have no solution at all: to the cap, a layer of 395 discs sheared so takes six times as long, and is not right either.
    struct Forces
    {
        int leastSweeps = 20;
        int sweepsBetween = 10;     ///< elsewhere, looks at forces that were off
        double share = 2.0;         ///< of the sweeps that velocities took
    } forces;

    /// After a sweep of a flow the residual is looked at where it may meet the rule though what the sweep met did not. A look costs most of a sweep.
    struct Looks
    {
        bool isOn = true;
        int sweepsBetween = 2;
        double nearly = 1.02;       ///< expected residual over the limit up to which a look is worth it [-]
        double share = 0.6;         ///< of the rms that a sweep meets, what it leaves, until a look tells [-]: so with momentum, a little more without
    } looks;

    /// Blocks without a loaded or closing contact are left out of sweeps. Whether any of them should carry an impulse by now is asked after 1, 2, 4, 8, ... sweeps,
    /// in flows after 1, 4, 16, ...: each block that wakes ends the history that momentum lives on (a collapse takes 81 sweeps a step so, 96 with every power of two).
    struct Waking
    {
        int mostBetween = 64;       ///< sweeps
        int firstPacked = 8;        ///< sweeps, of a packed problem, then after 16, 32, ...: in a collapse 588 000 visits of blocks a step; after 1, 4, 8, 16, 24, 32: 608 000
    } waking;

    /// The contacts that matter are packed into full blocks for a long solve of a flow: three lanes in ten of active blocks carry nothing, in shocks two in three.
    /// Costs as much as five sweeps, saves a fifth of each and more.
    struct Packing
    {
        bool isOn = true;
        int longSolve = 15, longShock = 10;   ///< sweeps of the last solve of its kind
        std::size_t largeProblem = 256;    ///< active blocks
        /// Gaps that stay nearer than this are packed too [d]: what comes in later disturbs what is solved. In a collapse 0.005, 0.008 and 0.012 take 589 000, 588 000 and
        /// 610 000 visits of blocks a step, 0 takes 950 000.
        double nearlyClosing = 0.008;
    } packing;

    /// When a solve is so slow that momentum or mixing is worth it. Both overshoot, and where friction makes impulses indeterminate an overshoot stays as self-stress: small
    /// scenes are better off without.
    struct Slowness
    {
        int patience = 10, coldPatience = 5, flowPatience = 3;       ///< sweeps before it is judged, the last one the least
        double fastContraction = 0.93, fastFlowContraction = 0.85;   ///< of the rms in a sweep [-], quicker ones need no help; first sweeps of flows tell of a steep beginning
        double growthAllowed = 4.0;    ///< of the sum of squared defects [-]: a help after which it grows by more is taken back
        int probation = 60;            ///< sweeps in which the sum of squared defects must fall below `leastProgress`
        double leastProgress = 0.9;    ///< of what it was [-], else the help pauses: high friction can trap it
        double slowShock = 0.3;        ///< of what it was in `probation` sweeps [-]: above, forces of a shock that are off are brought down as weight is
        int pause = 30;                ///< sweeps, twice as many each time but where weight comes down: there the rms is no sign of failure
    } slowness;

    /// Momentum of sweeps: in cold solves, in flows, and where forces are off (sweepMomentum.hpp).
    struct Momentum
    {
        bool isOn = true;
        /// Cold: theta <= 1 - limitPerDepth/depth [d], within these. With 1 and 1.2 beds 10 to 75 d deep take about as many sweeps (to 1e-3), with 0.5 or 3 up to twice as many.
        double limitPerDepth = 1.2, leastLimit = 0.9, mostLimit = 0.99;
        /// theta in flows, and near the solution [-]. Frozen problems of a collapse, rms to 1e-2 vs: 110, 80, 72, 78 sweeps with 0.7, 0.8, 0.85, 0.88 throughout; 67 with 0.9, then
        /// 0.8; 66 with 0.92, then 0.8; 69 with 0.9, then 0.7. Much momentum brings far changes and keeps a defect of its own.
        double flowing = 0.9, near = 0.8;
        double nearRule = 6.0;         ///< near: an rms below this many limits
    } momentum;

    /// Anderson mixing of sweeps: in warm solves where grains hardly move and forces are right (andersonAcceleration.hpp).
    struct Mixing
    {
        bool isOn = true;
        /// Mixed every sweep, a bed near rest keeps speeds of 4e-5 g dt in place of 1e-5, and its wall forces err by 1e-6 of the weight in place of 1e-7.
        int sweepsBetween = 3;
    } mixing;

    /// When single contacts alone are off they are worked off one by one: clusters that wedge or slip take hundreds of visits (contactQueue.hpp).
    struct Queue
    {
        bool isOn = true;
        int sweepsBetween = 10;
        double shareOfLimit = 0.5, shareInFlow = 0.7;   ///< of the largest defect allowed, what it leaves [-]; 0.7 takes half the visits in flows
        std::size_t mostSweeps = 20;                    ///< visits over contacts, at most
        /// Share of the contacts that may be off [-]. With 0.06 the queue takes 6 sweeps, from 0.1 on it ends at mostSweeps and leaves many: a bed of
        /// 9240 spheres that lands in steps of 2e-3 s spent three quarters of its time there.
        double mostOff = 0.05;
        double fewOff = 50.0;                           ///< contacts that may be off anyway
    } queue;

    /// Where masses differ much: light bodies that stick between heavy ones are solved with their contacts at once (stiffClusters.hpp). 2000 spheres of 0.5 to 10 mm that
    /// land: of 150 steps 3 at the cap of sweeps, without 67; with 10 rounds 16.
    struct Clusters
    {
        bool isOn = true;
        double leastMassRatio = 20.0;    ///< of all grains, heaviest to lightest [-]
        int sweepsBetween = 50;
        int rounds = 40;
        int mostInRound = 200;           ///< clusters, the worst ones
        std::size_t contacts = 6;        ///< of a cluster, at least, if there are so many
        /// The same where contacts bear moments, which double the unknowns. 1000 spheres of 1 to 5 mm that land and come to rest, seconds with 2, 4, 6: 7.2, 10.1, 12.1.
        std::size_t contactsWithMoments = 3;
        double shareOfLimit = 0.7;       ///< of the smaller limit, above which a contact has a cluster made around it [-]
        double fineness = 0.1;           ///< of that, to which clusters are solved [-]
    } clusters;

    /// A solution that is polished but for some contacts is swept around these alone (loneDefects.hpp).
    struct LoneDefects
    {
        bool isOn = true;
        int contactsAway = 3;          ///< farther away the defects that a few sweeps carry there are below the limit
        double mostSweeps = 100.0;
        double mostWork = 5.0;         ///< in sweeps over all contacts
    } loneDefects;

    /// A step that ends at the cap is solved again with friction that is held (heldFriction.hpp).
    struct Held
    {
        bool isOn = true;
        double overlap = 1e-2;              ///< that the largest defect of a step at the cap makes within it, from which friction is held [mean diameters]
        double jam = 1e4;                   ///< impulse of a contact over the sum of what contacts give the grains [-], from which friction is held whatever the residual
        double energy = 10.0;               ///< most that the tolerance may have of energy made, over that of the free motion [-]
        double frictionToJam = 1.0;         ///< of any pair, from which impulses may grow within few sweeps [-]: they are looked at after every solve then, and a step at the cap counts as one without solution
        int sweepsToJam = 100;              ///< else after solves as long as this
        double jamAtCap = 1.0;              ///< the same of a step at the cap; a bed from cold stays below 1
        int following = 20, falling = 10;   ///< rounds in which bounds of friction follow what presses, then may only fall
        int fading = 4;                     ///< rounds in which all bounds become smaller, in the last one zero, where those that stay take too many sweeps
        int sweeps = 30;                    ///< of a round that follows or falls, at most
        double share = 0.5;                 ///< of the way to mu r_n in the later half of the rounds that follow; of a bound in a round that fades [-]
        double pressure = 4.0;              ///< largest pressure that friction follows, over what presses on a body without friction [-]
    } held;

    /// When Newton's method takes over (directHelp.hpp).
    struct Direct
    {
        bool isOn = true;
        double harmlessMassRatio = 50.0;   ///< across a loaded contact. Base force of a stack of 19 under a body 100 times as heavy, by sweeps alone: off by 0.1; 1e4 times: by 0.7
        int firstLook = 500;               ///< sweeps before which its price is not worth asking for
        double mostPerCap = 10.0;          ///< sweeps up to the cap, what it may cost at rest; in a flow, where impulses change from step to step, one
        double restMotion = 0.1;           ///< motion below which grains count as at rest [-]
    } direct;
};

} // namespace nscd
