// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Settings of contact search and contact solve, with defaults for flowing beds.
// Tested by tests/unit/nscd/scene/sceneCheckTest.cpp, tests/unit/nscdGrains/goodSceneTest.cpp
#pragma once

#include "nscd/scene/solverStrategy.hpp"

#include <string>

namespace nscd
{

/// Lengths in units of the mean grain diameter d where they say so.
struct ContactSettings
{
    /// Solver by name: see contactSolvers().
    std::string solver = "NLGS";
    /// rms velocity defect allowed, in units of the step's speed scale.
    double tolerance = 1e-2;
    /// Largest velocity defect times dt allowed, in d.
    double displacementTolerance = 3e-4;
    /// Share of the forces on grains that may not have come down to what carries them: see StopRule.
    double forceTolerance = 1e-2;
    /// Sweeps after which a solve gives up, counted and reported.
    int maxSweeps = 1000;
    /// Sweeps a step may add, once its tolerance is met, to come nearer to rest where the grains hardly move; 0: none.
    int polishSweeps = 20;
    /// Gaps within +-deadBand d count as closed, so that the set of active contacts keeps still.
    double deadBand = 1e-4;
    /// Overlap in d above which grains are pushed apart without gaining velocity.
    double overlapTolerance = 5e-4;
    /// Distance in d beyond contact within which pairs are listed.
    double skin = 0.06;
    /// Anderson acceleration of slow solves.
    bool accelerate = true;
    /// Whether grains at rest are left alone until something changes.
    bool sleep = true;
    /// Vector path of the sweep: auto, portable, AVX2, AVX512.
    std::string vectorPath = "auto";
    /// What shortens slow solves.
    SolverStrategy strategy;
};

} // namespace nscd
