// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What the contact sweep works on: bodies of one cache line, and contacts in blocks of eight lanes.
// Included by translation units built for wider instruction sets: no functions, no standard library.
// Tested by tests/unit/nscd/kernels/sweepKernelsTest.cpp
#pragma once

#include <cstddef>
#include <cstdint>

namespace nscd
{

/// Velocity of one body and its two mobilities. The spin variable is s = R omega, so that an impulse p along a contact with
/// normal n changes v by p/m and s by -(1/(kappa m)) n x p whatever the radius. Walls and fixed grains have mobility zero.
struct alignas(64) Body
{
    double v[3];      ///< [m/s]
    double invMass;   ///< 1/(m + gamma dt) [1/kg]
    double s[3];      ///< [m/s]
    double invSpin;   ///< 1/(kappa m) [1/kg]
};

constexpr int blockLanes = 8;

/// Eight contacts with no movable body in common, so that they can be solved at once and the sweep is still Gauss-Seidel.
/// Unused lanes join the static body to itself and carry zeros.
struct alignas(64) ContactBlock
{
    double n[3][blockLanes];       ///< unit normal from B to A
    double bias[blockLanes];       ///< velocity added to u_n in the contact law [m/s]
    double r[3][blockLanes];       ///< impulse on A, world frame [N s]
    double invWn[blockLanes];      ///< 1/W_nn [kg]
    double invWt[blockLanes];      ///< 1/W_tt [kg]
    double friction[blockLanes];
    std::int32_t a[blockLanes];
    std::int32_t b[blockLanes];
};

/// What a law that is solved within the sweeps gives the contacts of a block besides: an impulse `q` on A, world frame, and the law's coefficients, which
/// it numbers itself (see `momentLaw` and `filmLaw`). Unused lanes carry zeros.
struct alignas(64) LawBlock
{
    double q[3][blockLanes];     ///< [N s]
    double of[4][blockLanes];
};

/// Coefficients of contacts that bear moments. A moment impulse M on A, -M on B [N m s], is kept as q = M/R', R' the reduced radius, and changes the
/// spin variables by a q/(kappa m_A) and -b q/(kappa m_B).
namespace momentLaw
{
enum Coefficient
{
    across,   ///< most of the part in the tangent plane, over the normal impulse
    along,    ///< most of the part along the normal, likewise
    shareA,   ///< a = R'/R_A
    shareB    ///< b = R'/R_B: 1 - a, or 1 at a wall, as a is
};
}

/// Coefficients of contacts with a film of fluid between them: see lubrication.hpp. The impulse q is along the normal.
namespace filmLaw
{
enum Coefficient
{
    strength,    ///< k [N s]; 0: no film in this step
    thickness,   ///< h/dt at the start of the step [m/s]
    edge,        ///< the thickness from which on a film acts, over dt [m/s]
    untilClosed  ///< impulse of the film where the step closes the contact [N s]
};
}

/// A bias that no velocity reaches: keeps far contacts out without an infinity [m/s].
constexpr double unreachable = 1e30;

/// Velocity defects of one pass over the contacts, e = W (p - Proj(p - u/W)) [m/s].
struct DefectSums
{
    double sumSquares;   ///< over active contacts
    double maxSquare;
    double active;       ///< number of contacts that carry an impulse before or after
    double work = 0.0;   ///< sum of r.e over contacts, of evaluations alone [J]: see StopRule
};

/// Blocks in the order they are visited: `count` indices, or the first `count` blocks if there is no list.
struct BlockRange
{
    const std::uint32_t* index;
    std::size_t count;

    std::size_t operator[](std::size_t k) const { return index ? index[k] : k; }
};

/// One pass over blocks. A sweep updates impulses and velocities in place, an evaluation changes nothing.
using SweepFunction = DefectSums (*)(Body* bodies, ContactBlock* blocks, BlockRange range);

/// A sweep that moves the impulses of each block on first, by theta of what they changed since `before` (numbered as in ReplaceFunction), which receives
/// them as they were; velocities are those of impulses moved on.
using MomentumSweepFunction = DefectSums (*)(Body* bodies, ContactBlock* blocks, BlockRange range, double* before, double theta);

/// The same passes where a law is solved with the impulses; block k of the law's belongs to block k of contacts. An evaluation is that of the law's
/// impulses alone, and counts no contact that carries an impulse.
using LawSweepFunction = DefectSums (*)(Body* bodies, ContactBlock* blocks, LawBlock* ofLaw, BlockRange range);
using LawSweepOnFunction = DefectSums (*)(Body* bodies, ContactBlock* blocks, LawBlock* ofLaw, BlockRange range, double* before, double* lawBefore, double theta);
using LawEvaluateFunction = DefectSums (*)(const Body* bodies, const ContactBlock* blocks, const LawBlock* ofLaw, BlockRange range);

/// Replaces the impulses of blocks by `target` (24 numbers a block of the range: x, y, z of eight lanes each), made admissible by
/// cutting attraction off and scaling the tangential part into the friction disc, and moves the velocities along; `target`
/// receives what was set.
using ReplaceFunction = void (*)(Body* bodies, ContactBlock* blocks, BlockRange range, double* target);

/// Differences an Anderson mixing keeps: more cost more and converge no faster.
constexpr int mixingDepth = 3;

/// What a mixing remembers of earlier iterates, 24 numbers a block of the range, as in ReplaceFunction.
struct MixingHistory
{
    double* image;                           ///< F(r) of the last mixing [N s]
    float* defect;                           ///< f = F(r) - r of the last mixing
    float* imageDifference[mixingDepth];     ///< between mixings, of F(r)
    float* defectDifference[mixingDepth];    ///< of f
    int newest;                              ///< column to be written
    int stored;                              ///< columns in use, the newest included
};

/// Inner products of the newest differences df and of f with all columns, each weighted with W_nn.
struct MixingSums
{
    double values[2*mixingDepth];   ///< products with df, then with f: summed over ranks together

    double& gram(int column) { return values[column]; }
    double& projection(int column) { return values[mixingDepth + column]; }
};

/// Moves a history on to what the blocks hold now, which sweeps made of `start`.
using DifferenceFunction = MixingSums (*)(const ContactBlock* blocks, BlockRange range, const double* start, const MixingHistory& history);

/// Moves the impulses of blocks on by theta of what they changed since `before` (numbered as in ReplaceFunction), which receives them as they were.
using ExtrapolateFunction = void (*)(ContactBlock* blocks, BlockRange range, double* before, double theta);
/// The same for velocities of bodies with the same mobilities as before.
using ExtrapolateBodiesFunction = void (*)(Body* bodies, Body* before, std::size_t count, double theta);

/// The law of a step: b = g/dt where g > deadBand, else 0, and never more than a bias that no velocity reaches.
struct LawOfStep
{
    double deltaT;        ///< [s]
    double deadBand;      ///< [m]
    double unreachable;   ///< [m/s]
};

/// Sets W and bias of a block from the gaps of its lanes. Returns whether a lane is closed, closes in the present motion, or is loaded.
using LawFunction = bool (*)(const Body* bodies, ContactBlock& block, const double* gap, const LawOfStep& law);

/// Scales the impulses of blocks, makes them admissible in the present tangent planes, and gives them to the bodies, which held none.
using StartFunction = void (*)(Body* bodies, ContactBlock* blocks, BlockRange range, double scale);

/// Gives the impulses of blocks to bodies, as they are: for sums over the contacts of each body.
using GiveFunction = void (*)(Body* bodies, const ContactBlock* blocks, BlockRange range);

struct SweepKernels
{
    const char* name;
    int lanes;
    SweepFunction sweep;
    SweepFunction sweepFrictionless;
    MomentumSweepFunction sweepOn;
    MomentumSweepFunction sweepOnFrictionless;
    SweepFunction evaluate;
    SweepFunction evaluateFrictionless;
    ReplaceFunction replaceImpulses;
    ReplaceFunction replaceFrictionless;
    DifferenceFunction addDifferences;
    ExtrapolateFunction extrapolate;
    ExtrapolateBodiesFunction extrapolateBodies;
    LawFunction setLaws;
    StartFunction startWarm;
    StartFunction startWarmFrictionless;
    GiveFunction giveImpulses;
    SweepFunction sweepDiscs[3];      ///< by the axis that nothing moves along
    MomentumSweepFunction sweepOnDiscs[3];
    SweepFunction evaluateDiscs[3];
    SweepFunction sweepHeld;          ///< friction[] of the blocks is the bound of friction itself [N s]
    MomentumSweepFunction sweepOnHeld;
    SweepFunction evaluateHeld;
    LawSweepFunction sweepLaw;        ///< of moments, unless the law in use brings its own
    LawSweepOnFunction sweepLawOn;
    LawEvaluateFunction evaluateLaw;
};

} // namespace nscd
