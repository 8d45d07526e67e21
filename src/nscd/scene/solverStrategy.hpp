// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What shortens a contact solve beyond plain sweeps from a warm start, with every number that tunes it.
#pragma once

#include <cstddef>

namespace nscd
{

/// Helps of a solve by sweeps. No dictionary reads these numbers: the benchmark `ablation` measures what each help is worth, and src/nscd/measured.md
/// keeps the figures. "Flow": most grains move; "cold": no contact carries an impulse at the start.
struct SolverStrategy
{
    /// A bed that hardly moves is solved on beyond its tolerance: what a solve leaves keeps it moving, and moving grains leave the dead band.
    struct Polish
    {
        double perMotion = 10.0;    ///< limits of a polished solution per unit of motion [-]: a step takes about a decade off the noise
        double finest = 3e-3;       ///< of both limits, the least that is asked for [-]
        double loneDefect = 10.0;   ///< largest defect over the rms limit [-]: a grain that can roll is driven by what one contact is off by
    } polish;

    /// In flows the residual after a sweep is looked at where it may meet the rule though what the sweep met did not. Costs most of a sweep.
    struct Looks
    {
        bool isOn = true;
        int sweepsBetween = 2;
        double nearly = 1.02;       ///< of the rms limit, what a sweep is expected to leave [-]
        double share = 0.6;         ///< of the rms that it meets, what a sweep leaves, until it is known: with momentum; a little more without [-]
    } looks;

    /// Contacts that no other contact shares a grain with are solved exactly, once.
    bool isolatedPairs = true;

    /// Contacts that matter are packed into full blocks for a long solve of a flow on one rank: three lanes in ten carry nothing. Costs five sweeps, saves a fifth of each.
    struct Packing
    {
        bool isOn = true;
        int longSolve = 30;                ///< sweeps of the last solve
        std::size_t largeProblem = 256;    ///< active blocks
        double nearlyClosing = 0.008;      ///< gaps that stay nearer than this are packed too [d]
    } packing;

    /// When a solve is slow enough for momentum or mixing.
    struct Slowness
    {
        int patience = 10, coldPatience = 5, flowPatience = 3;   ///< sweeps before it is judged
        double fastContraction = 0.93, fastFlowContraction = 0.85;   ///< of the rms in a sweep [-]: quicker ones need no help
        double growthAllowed = 4.0;    ///< of the sum of squared defects [-]: a step after which it grows by more is taken back
        int probation = 60;            ///< sweeps in which the sum of squared defects must fall below
        double leastProgress = 0.9;    ///< this share of what it was [-], else help pauses
        int pause = 30;                ///< sweeps; doubled each time
    } slowness;

    /// Momentum of sweeps: in cold solves, and in flows.
    struct Momentum
    {
        bool isOn = true;
        double limitPerDepth = 1.2, leastLimit = 0.9, mostLimit = 0.99;   ///< cold: theta <= 1 - limitPerDepth/depth [d], within these
        double flowing = 0.9, near = 0.8;    ///< theta in flows, and near the solution [-]
        double nearRule = 6.0;               ///< near: rms below this many limits
    } momentum;

    /// Anderson mixing of sweeps: in warm solves of what hardly moves.
    struct Mixing
    {
        bool isOn = true;
        int sweepsBetween = 3;
    } mixing;

    /// When only single contacts are off they are worked off one by one.
    struct Queue
    {
        bool isOn = true;
        int sweepsBetween = 10;
        double shareOfLimit = 0.5, shareInFlow = 0.7;   ///< of the largest defect allowed, what it leaves [-]
        std::size_t mostSweeps = 20;                    ///< visits over contacts
    } queue;

    /// A polished solution but for some contacts is swept around these alone.
    struct LoneDefects
    {
        bool isOn = true;
        int contactsAway = 3;
        double mostSweeps = 100.0;
        double mostWork = 5.0;         ///< in sweeps over all contacts
    } loneDefects;

    /// When Newton's method takes over.
    struct Direct
    {
        bool isOn = true;
        double harmlessMassRatio = 50.0;
        int firstLook = 500;           ///< sweeps
        double mostPerCap = 10.0;      ///< sweeps up to the cap, what it may cost at rest; in a flow one
        double restMotion = 0.1;       ///< motion below which a bed counts as at rest [-]
    } direct;

    /// A cap of sweeps that step after step ends at is doubled.
    struct Cap
    {
        int patience = 5;              ///< steps in a row
        int enough = 1000;             ///< sweeps: the default cap, which is not raised
    } cap;
};

} // namespace nscd
