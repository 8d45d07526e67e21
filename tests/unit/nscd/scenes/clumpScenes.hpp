// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Clumps for tests: dumbbells, tetrapods, cubes.
#pragma once

#include "unit/nscd/scenes/scenes.hpp"

namespace scenes
{

using nscd::Quaternion;

constexpr double memberRadius = 0.01;

/// Two balls along x, touching or overlapping: centers `distance` radii apart.
inline std::vector<nscd::Ball> dumbbell(double distance = 2.0)
{
    const double c = 0.5*distance*memberRadius;
    return {{Vec3(-c, 0, 0), memberRadius}, {Vec3(c, 0, 0), memberRadius}};
}

/// Four balls that touch, on a tetrahedron of edge 2 R: three below, one above.
inline std::vector<nscd::Ball> tetrapod()
{
    const double r = memberRadius, in = r/std::sqrt(3.0);
    return {{Vec3(-r, -in, 0), r}, {Vec3(r, -in, 0), r}, {Vec3(0, 2*in, 0), r}, {Vec3(0, 0, 2*r*std::sqrt(2.0/3.0)), r}};
}

/// Eight balls on the corners of a cube of edge 2 R.
inline std::vector<nscd::Ball> cube()
{
    std::vector<nscd::Ball> balls;
    for (int k = 0; k < 8; ++k)
    {
        balls.push_back({memberRadius*Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1), memberRadius});
    }
    return balls;
}

/// Three overlapping balls of different size: an asymmetric body.
inline std::vector<nscd::Ball> pebble()
{
    const double r = memberRadius;
    return {{Vec3(0, 0, 0), r}, {Vec3(1.2*r, 0.1*r, 0), 0.8*r}, {Vec3(0.3*r, 0.8*r, 0.2*r), 0.7*r}};
}

inline int addShape(Scene& scene, const std::vector<nscd::Ball>& members, double density = 2500.0)
{
    scene.grains.clumps.shapes.push_back(nscd::makeClumpShape(members, density, scene.grains.shape));
    return static_cast<int>(scene.grains.clumps.shapes.size()) - 1;
}

inline std::size_t addClump
(
    Scene& scene, int shape, const Vec3& position, const Quaternion& orientation = Quaternion::Identity(),
    const Vec3& velocity = Vec3::Zero(), const Vec3& omega = Vec3::Zero()
)
{
    const auto id = static_cast<std::int64_t>(scene.grains.size());
    return nscd::addClump(scene.grains, {shape, position, orientation, velocity, omega, 0, id}, scene.box);
}

/// Weight of clumps and single grains: members of a clump share its mass.
inline double totalMass(const nscd::Grains& grains)
{
    double sum = 0.0;
    for (double mass : grains.mass) sum += mass;
    return sum;
}

inline Vec3 momentum(const nscd::Grains& grains)
{
    const std::vector<int> clumpOf = nscd::clumpOfGrains(grains);
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        if (clumpOf.empty() || clumpOf[i] < 0) sum += grains.mass[i]*grains.velocity[i];
    }
    for (std::size_t c = 0; c < grains.clumps.size(); ++c) sum += grains.clumps.shapeOf(c).mass*grains.clumps.velocity[c];
    return sum;
}

} // namespace scenes
