// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Two stacks of clumps that come to rest, for tests of clumps that sleep.
#pragma once

#include "unit/nscd/scenes/clumpScenes.hpp"
#include "unit/nscd/scenes/sleepSteps.hpp"

namespace scenes
{

constexpr int stackedGrains = 19;   ///< of both stacks
constexpr int firstStack = 10;      ///< grains of the first one
constexpr int dumbbellBall = 8;     ///< the first ball of the dumbbell in it
constexpr int stackRoller = stackedGrains;

/// A dumbbell in the furrow of a cube of balls, and far from there a sphere in the hollow of another cube; where asked for, behind them in the list, a
/// sphere that rolls on the floor for ever and meets nobody.
inline Scene clumpStacks(bool withRoller)
{
    const double r = memberRadius;
    Scene scene(3, 0.5, 0.0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    const int ofCube = addShape(scene, cube()), ofDumbbell = addShape(scene, dumbbell());
    addClump(scene, ofCube, Vec3(0, 0, 2*r));
    addClump(scene, ofDumbbell, Vec3(0, 0, (3 + std::sqrt(3.0))*r));
    addClump(scene, ofCube, Vec3(0.3, 0, 2*r));
    scene.addGrain(Vec3(0.3, 0, (3 + std::sqrt(2.0))*r), r);
    if (!withRoller) return scene;
    scene.addGrain(Vec3(0, 1, r), r);
    scene.grains.velocity.back() = Vec3(0.2, 0, 0);
    scene.grains.omega.back() = Vec3(0, 0.2/r, 0);
    return scene;
}

} // namespace scenes
