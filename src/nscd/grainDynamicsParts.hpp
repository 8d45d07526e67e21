// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a GrainDynamics holds; seen by its own source files only.
#pragma once

#include "contactList.hpp"
#include "contactSolver.hpp"
#include "contactStep.hpp"
#include "grainDynamics.hpp"
#include "storedImpulses.hpp"

namespace nscd
{

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
    bool isFrictional;
    double diameter = 1.0;

    ContactList list;
    bool isListStale = true;
    double deltaT = 0.0;          // of the step begun
    double impulseDeltaT = 0.0;   // of the step the stored impulses belong to
    ImpulseRecord restored;
    ContactForces forces;
    StepTimes times;

    Scene scene() const { return {grains, materials, walls, box}; }
    ContactProblem makeProblem(double speedScale)
    {
        return {list.bodies, list.blocks, list.awake, list.interfaceBlock, list.halo, kernels, isFrictional, deltaT, speedScale, diameter, list.position};
    }
    double deadBand() const { return settings.deadBand*diameter; }

    void measureDiameter();
    void clearForces();
    void rebuildList(const std::vector<Vec3>& velocity);
    SolveReport solveVelocities(const ExternalForces& external);
    double measureMotion(double speedScale) const;
    SolveReport solveOnce(const ExternalForces& external);
    void rebound(const ExternalForces& external, SolveReport& report);
    void correctPositions(StepReport& report);
};

} // namespace nscd
