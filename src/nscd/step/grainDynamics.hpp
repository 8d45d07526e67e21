// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The grains' time step (Henry 2025, Algorithms 1 to 3): free velocities, pairs, contacts, solve, move.
#pragma once

#include "nscd/base/periodicBox.hpp"
#include "nscd/base/stepTimes.hpp"
#include "nscd/scene/contactSettings.hpp"
#include "nscd/scene/exchange.hpp"
#include "nscd/scene/externalForces.hpp"
#include "nscd/scene/grains.hpp"
#include "nscd/scene/materials.hpp"
#include "nscd/scene/stepReport.hpp"
#include "nscd/scene/storedImpulse.hpp"
#include "nscd/scene/walls.hpp"

#include <memory>

namespace nscd
{

/// Result of a contact solve that moves nothing.
struct Prediction
{
    std::vector<Vec3> velocity;      ///< [m/s]
    std::vector<Vec3> contactForce;  ///< net contact force on each grain [N]
    SolveReport solve;
};

/// A contact that carries an impulse or attracts, after a step. b < 0: wall region -1 - b.
struct LoadedContact
{
    int a;         ///< index of a grain
    int b;         ///< index of a grain; from the number of own grains on: of GrainDynamics::ghostsInContacts()
    std::int64_t idA;
    std::int64_t idB;
    Vec3 normal;   ///< unit, from b to a, at the present positions
    double gap;    ///< [m], at the present positions; negative: overlap
    Vec3 impulse;  ///< on a [N s], over the whole of the last step: rebound and attraction included
    Vec3 attraction = Vec3::Zero();  ///< what laws that are known beforehand have in it [N s]
    Vec3 moment = Vec3::Zero();      ///< of laws beside Coulomb's on a [N m s]; that of `impulse` comes on top
    double radiusB = 0.0;            ///< of b [m]; 0 for a wall
    double friction = 0.0;           ///< coefficient of the pair
};

/// Rigid grains with unilateral frictional contact, advanced one step at a time.
/// Use per step: beginStep(dt); optionally predict(forces); advance(forces).
/// With an Exchange of several ranks each holds its own grains, every call is collective, and figures are of all ranks.
class GrainDynamics
{
public:
    /// Errors: std::invalid_argument for a scene or settings that cannot run (sceneCheck.hpp), unknown solvers and vector paths
    GrainDynamics
    (
        Grains grains, Materials materials, Walls walls, PeriodicBox box,
        ContactSettings settings, std::shared_ptr<Exchange> exchange = std::make_shared<Exchange>()
    );
    ~GrainDynamics();

    const Grains& grains() const;
    /// Replaces the grains, for whoever adds, removes or moves some; impulses follow the identities that are still there.
    /// Errors: std::invalid_argument as the constructor
    void setGrains(Grains grains);
    /// Velocity [m/s] and spin [rad/s] of a held grain (Grains::isFixed, infinite mass), which moves and turns with them whatever
    /// touches it, until they are given anew. To be called before beginStep; contactForce() and contactTorque() tell what it takes.
    /// Errors: std::invalid_argument for a grain that is not held, or values that are not finite
    void drive(std::size_t grain, const Vec3& velocity, const Vec3& omega);
    /// Load of each grain on contact search and solve: the candidates it has a share in, and one for itself.
    std::vector<double> loads() const;
    /// Number of grains of other ranks that are near enough to those here to be looked at; 0 before the first beginStep() after grains were set.
    std::size_t ghosts() const;

    /// Finds pairs and builds the contacts at the present positions for a step of length dt [s]; again before advance(): for another dt.
    /// Errors: std::invalid_argument for dt <= 0, coincident centers
    void beginStep(double dt);

    /// Whether any contact could become active in this step; without, predict() need not be called.
    bool hasContacts() const;

    /// Velocities and contact forces that the step would end with under `forces`, moving nothing. Wakes whom the step would wake.
    /// Errors: as advance()
    Prediction predict(const ExternalForces& forces);

    /// As predict(), for forces that are not to come, on the contacts listed: the next solve starts from the impulses before this one, the
    /// next trial from what this one found. Wakes nobody: who sleeps is held.
    Prediction tryForces(const ExternalForces& forces);

    /// Completes the step begun: free velocities, contact solve, motion, restitution, overlap correction.
    /// Errors: std::invalid_argument for forces that are not finite or not one for each grain, std::logic_error without beginStep()
    /// Ensures: no contact's gap falls below -(dead band + displacement tolerance) if the report says converged
    StepReport advance(const ExternalForces& forces);

    /// Net contact force on each grain over the last step [N].
    const std::vector<Vec3>& contactForce() const;
    /// Net contact torque on each grain over the last step, of forces and of moments that laws beside Coulomb's give [N m].
    const std::vector<Vec3>& contactTorque() const;
    /// Force of the grains on each wall patch over the last step [N].
    const std::vector<Vec3>& wallForce() const;

    /// Torque of the grains on each wall patch about the patch's torquePoint over the last step [N m].
    const std::vector<Vec3>& wallTorque() const;

    /// The walls where they are now.
    const Walls& walls() const;
    /// The time that the motions of walls are functions of, at the end of the last step [s]; steps move it on from 0. A restart sets
    /// it before its first step; who has a clock of his own may set it before every step, lest sums of steps drift apart.
    double time() const;
    void setTime(double time);

    /// All contacts solved on this rank that carried an impulse or attracted in the last step; empty before the first one and after checkpoint().
    /// To be called before the next beginStep(), which may list contacts anew and then knows of the motion's impulses alone.
    /// Equation: sum of impulses on a grain = m dv - dt (f - gamma v)
    std::vector<LoadedContact> contacts() const;
    /// Grains of other ranks that contacts() may touch; until the next beginStep(), too. Each contact between two ranks is solved on one of them.
    const std::vector<GhostGrain>& ghostsInContacts() const;

    /// Impulses of all contacts solved on this rank that carry one. After this call the next step searches anew, as a restarted run does,
    /// so that a run that continues and one that restarts do the same to the bit.
    std::vector<StoredImpulse> checkpoint(double& lastDeltaT);
    /// Each impulse on a rank that owns one of its grains; which one does not matter.
    void restore(const std::vector<StoredImpulse>& impulses, double lastDeltaT);

    /// Seconds spent in the parts of the step since construction.
    const StepTimes& times() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

} // namespace nscd
