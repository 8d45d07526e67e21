// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Scenes whose pairs of materials all have the same optional laws.
#pragma once

#include "unit/nscd/scenes/heaps.hpp"

namespace scenes
{

/// All pairs alike.
inline void setAll(Scene& scene, const nscd::ContactPair& pair)
{
    for (int a = 0; a < 2; ++a)
    {
        for (int b = a; b < 2; ++b) scene.materials.setPair(a, b, pair);
    }
}

inline nscd::ContactPair rollingPair(double friction, double rolling, double spinning = 0.0, double cohesion = 0.0)
{
    nscd::ContactPair pair{friction, 0.0};
    pair.rollingFriction = rolling;
    pair.spinningFriction = spinning;
    pair.cohesion = cohesion;
    return pair;
}

inline nscd::ContactPair cohesivePair(double friction, double restitution, double cohesion, double range = 0.0)
{
    nscd::ContactPair pair{friction, restitution};
    pair.cohesion = cohesion;
    pair.cohesionRange = range;
    return pair;
}

inline double meanDiameter(const nscd::Grains& grains)
{
    double sum = 0.0;
    for (double r : grains.radius) sum += 2.0*r;
    return sum/static_cast<double>(grains.size());
}

} // namespace scenes
