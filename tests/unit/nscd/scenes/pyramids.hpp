// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Two pyramids that come to rest, for tests of grains that sleep.
#pragma once

#include "unit/nscd/scenes/sleepSteps.hpp"

namespace scenes
{

constexpr double pyramidRadius = 0.01;   ///< of the grains [m]
constexpr int pyramidTop = 3;            ///< of the first pyramid
constexpr int pyramidRoller = 8;

/// Two pyramids of four spheres, far from each other, and where asked for, behind them in the list, a grain that rolls on the floor for ever
/// and meets nobody.
inline Scene pyramids(bool withRoller)
{
    const double radius = pyramidRadius;
    Scene scene(3, 0.5, 0.0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    for (double x : {0.0, 0.2})
    {
        for (int k = 0; k < 3; ++k)
        {
            const double angle = 2*M_PI*k/3, r = 2*radius/std::sqrt(3.0);
            scene.addGrain(Vec3(x + r*std::cos(angle), r*std::sin(angle), radius), radius);
        }
        scene.addGrain(Vec3(x, 0, radius + 2*radius*std::sqrt(2.0/3.0)), radius);
    }
    if (!withRoller) return scene;
    scene.addGrain(Vec3(0, 1, radius), radius);
    scene.grains.velocity.back() = Vec3(0.2, 0, 0);
    scene.grains.omega.back() = Vec3(0, 0.2/radius, 0);
    return scene;
}

} // namespace scenes
