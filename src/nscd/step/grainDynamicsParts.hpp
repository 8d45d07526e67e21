// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a GrainDynamics holds; seen by its own source files only.
// Tested by tests/unit/nscd/step/grainDynamicsTest.cpp
#pragma once

#include "nscd/base/stepTimes.hpp"
#include "nscd/contacts/contactGeometry.hpp"
#include "nscd/contacts/contactList.hpp"
#include "nscd/contacts/movingWalls.hpp"
#include "nscd/contacts/storedImpulses.hpp"
#include "nscd/solvers/contactSolver.hpp"
#include "nscd/solvers/help/packedContacts.hpp"
#include "nscd/step/awakePart.hpp"
#include "nscd/step/contactStep.hpp"
#include "nscd/step/generalMotion.hpp"
#include "nscd/step/grainDynamics.hpp"
#include "nscd/step/listPlan.hpp"
#include "nscd/step/missedWalls.hpp"
#include "nscd/step/shockImpulses.hpp"
#include "nscd/step/shockWork.hpp"
#include "nscd/step/stopsOnWay.hpp"

namespace nscd
{

/// Steps of unchanged motion a list should last at least.
constexpr double fewestStepsPerList = 2.0;

struct GrainDynamics::Implementation
{
    Grains grains;
    Materials materials;
    Walls walls;
    PeriodicBox box;
    ContactSettings settings;
    std::shared_ptr<Exchange> exchange;

    ContactSolver solve;
    SweepKernels kernels;
    SweepKernels kernelsOfStep;   // of those for discs, where nothing leaves the plane
    bool isFrictional;
    double diameter = 1.0;
    double massRatio = 1.0;       // of the grains that move, heaviest to lightest

    MovingWalls movingWalls{walls};
    std::unique_ptr<WallSearch> wallSearch;
    bool areWallsOutlined = false;     // any
    bool areSomeStopped = false;       // on their way in this step, on any rank
    bool isPressed = false;            // the motion, by plain sweeps: see isFlung()
    bool isAnyFast = false;            // of grains, on any rank: outlined walls on their ways are looked for
    std::vector<int> atMissedWalls;    // own bodies that have come to walls which the list lacks
    std::vector<double> reachToMany;   // of the list
    bool areManyLeftOut = false;       // by it, on any rank

    ContactList list;             // while grains sleep: the part of it that is awake
    bool isListStale = true;
    bool isListNew = false;       // built since the last step
    double stepsPerList = fewestStepsPerList;
    bool areListsLong = false;    // see OffPaths
    double deltaT = 0.0;          // of the step begun
    double impulseDeltaT = 0.0;   // of the step the stored impulses belong to
    ImpulseRecord restored;
    GrainSleep sleep;
    AwakePart awakePart;          // holds the list of all while grains sleep
    double overlapAsleep = 0.0;   // largest of contacts when grains fell asleep last [m]
    int stepsAtCap = 0;           // in a row
    int stepsOfManyImpacts = 0;   // in a row
    PackedContacts packing;
    std::vector<Vec3> freeVelocity;   // of the list's own bodies in the present solve [m/s]
    std::vector<double> fall;         // of grains, in the last step: see setFalls [m/s]
    StepReport lastReport;
    bool isStepBegun = false;
    bool isAnyDrivenAnew = false;    // of the held grains here, since the last step began
    ImpulseRecord beforeStep;     // kept where laws act by it
    ShockImpulses shockImpulses;  // of the last step
    ContactForces forces;
    ContactForceSum sumForces;
    StepTimes times;

    Scene scene() const { return {grains, materials, walls, box}; }
    ContactProblem makeProblem(double speedScale);
    /// Blocks that may carry impulses.
    BlockRange loaded() const { return {list.awake.data(), list.awake.size()}; }
    /// On the bodies of the list and on walls; until the next call.
    const ContactForces& forcesOnBodies()
    {
        return sleep.any() ? awakePart.forcesOn(list, loaded(), sumForces, scene(), deltaT) : sumForces(list, loaded(), scene(), deltaT);
    }
    const ContactList& wholeList() const { return sleep.any() ? awakePart.whole() : list; }
    ContactList& wholeList() { return sleep.any() ? awakePart.whole() : list; }
    static std::vector<LoadedContact> contactsOf(const ContactList& list);
    bool isEverybodyAsleep() const { return sleep.any() && awakePart.isEmpty(); }
    bool maySleep() const { return settings.sleep && !materials.anyRoughness(); }
    double deadBand() const { return settings.deadBand*diameter; }

    void measureGrains();
    void makeWallSearch();
    /// What a list needs for a step: nothing more; with candidates that were added, the contacts of these solved too; or to be built anew.
    enum class Coverage { whole, mended, none };   // the worse the larger
    Coverage coverOrMend();
    Coverage coverHere();
    bool mayFollowStrays() const;
    bool coversStep() const { return coversMotion(list, deltaT, movingWalls.areCovered(list) && atMissedWalls.empty()); }
    double skinOfGrain() const { return 0.5*settings.skin*diameter; }
    double reachAtRest() const { return rangeOfLaws(materials) + skinOfGrain(); }
    WallsOfStep wallsOfStep() const;
    void lookForFast(const ListPlan& plan, const std::vector<double>& reach, const std::vector<WallReach>& wallReach);
    double moveBodies(StepReport& report);
    double deepestOfRanks(const std::vector<WallGap>& missed) const { return isAnyFast ? list.halo.max(deepestOf(missed)) : 0.0; }
    void clearForces();
    /// `margin`: 1 where grains can be expected to move with these velocities, else what they may exceed them by.
    void rebuildList(const std::vector<Vec3>& velocity, double margin);
    void refuseBeyondPeriods(const std::vector<Vec3>& velocity, const Vec3& mean) const;
    ListPlan planList(const std::vector<Vec3>& velocity, double margin) const;
    std::vector<double> fallsBeyondSkin() const;
    std::vector<char> areNearOthers() const;
    void fitStepsPerList();
    void chooseKernelsOfStep();
    SolveReport solveVelocities(const ExternalForces& external);
    Prediction predicted(SolveReport solve);
    Prediction predictedRest() const;
    double measureMotion(double speedScale) const;
    bool areWallsDriving(double speedScale) const;
    void prepareSolve(const ExternalForces& external);
    ContactProblem prepareProblem(const ExternalForces& external);
    SolveReport solveBy(ContactSolver solver, ContactProblem& problem, const ContactSettings& asked, const ExternalForces& external);
    SolveReport solveOnce(const ExternalForces& external, const ContactSettings& asked);
    bool mayHoldFriction() const { return isFrictional && settings.strategy.held.isOn; }
    /// Where friction is that large, Coulomb's law may have none.
    bool mayHaveNoSolution() const { return materials.largestFriction() >= settings.strategy.held.frictionToJam; }
    bool isHarmful(const SolveReport& report) const;
    bool isJammed(const SolveReport& report, const ContactProblem& problem) const;
    bool leavesOverlap(const SolveReport& report) const;
    bool mayBeSqueezed(const SolveReport& report) const;
    bool isFlung(const SolveReport& report) const;
    double fastestDriven2() const;
    SolveReport solveAnew(ContactSolver solver, const ExternalForces& external, const ContactSettings& asked);
    ContactSettings ofTrial() const;
    double translationalEnergy() const;
    double createdEnergy(const ExternalForces& external, const SolveReport& report);
    SolveReport solveAndWake(const ExternalForces& external);
    void holdWholeList();
    void cutAwakePart();
    void wake(const std::vector<int>& sleepers);
    void wakeDisturbed(const ExternalForces& external);
    void wakeWithinSolve(const std::vector<int>& sleepers);
    void wakeAll();
    bool haveDrivenChanged();
    void giveUpSleep();
    void letSleep(const ExternalForces& external, StepReport& report);
    void beginAwakeStep(bool haveWallsJumped);
    void checkReady(const ExternalForces& external) const;
    StepReport restingReport() const;
    /// Returns whether there was any, whose forces grains have then.
    bool rebound(const ExternalForces& external, SolveReport& report);
    /// The motion at the normals that a shock has, and those that it had itself; none where these stay.
    struct TurnedMotion
    {
        Shock motion;
        std::vector<KeptNormal> before;

        bool isAny() const { return !motion.bodies.empty(); }
    };
    TurnedMotion turnMotion(const std::vector<Body>& freeBodies, const Shock& inelastic, double band);
    SolveReport judgedRebound(const std::vector<Body>& freeBodies, const Shock& inelastic, const TurnedMotion& there, SolveReport shock);
    OverlapStatistics placeContacts();
    void correctPositions(StepReport& report);
};

} // namespace nscd
