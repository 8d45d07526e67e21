// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A judge of rolling and spinning moments that shares no code with the solvers, in angular velocities and moments.
#pragma once

#include "naturalMap.hpp"

namespace scenes
{

/// Root of the sum of squares of R' |domega|, domega = W |M - Proj(M - omega/W)| with W = 1/J_A + 1/J_B and the reduced radius R', over
/// the contacts that carry an impulse, at the positions `before` a step and the velocities after it [m/s].
inline double rollingNorm(const Scene& scene, const nscd::Grains& before, const nscd::GrainDynamics& dynamics)
{
    const nscd::Grains& after = dynamics.grains();
    double sum = 0.0;
    for (const nscd::LoadedContact& c : dynamics.contacts())
    {
        const bool isWall = c.b < 0;
        const nscd::WallRegion* wall = isWall ? &scene.walls.regions[-1 - c.b] : nullptr;
        const Vec3 n = isWall ? wall->normal : Vec3(scene.box.nearestImage(before.position[c.a] - before.position[c.b]).normalized());
        const nscd::ContactPair& pair = scene.materials.pair(before.material[c.a], isWall ? 1 : before.material[c.b]);
        const double ra = before.radius[c.a], reduced = isWall ? ra : ra*before.radius[c.b]/(ra + before.radius[c.b]);
        const auto inverseInertia = [&](int i)
        {
            return before.isFixed[i] ? 0.0 : 1.0/(before.shape.inertiaFactor()*before.mass[i]*before.radius[i]*before.radius[i]);
        };
        const double w = inverseInertia(c.a) + (isWall ? 0.0 : inverseInertia(c.b));
        const Vec3 omega = after.omega[c.a] - (isWall ? Vec3(Vec3::Zero()) : after.omega[c.b]);
        const double rn = (c.impulse - c.attraction).dot(n);

        const double normal = c.moment.dot(n), spin = omega.dot(n);
        const double limit = pair.spinningFriction*reduced*rn;
        const double spinning = std::min(limit, std::max(-limit, normal - spin/w)) - normal;
        const Vec3 tangential = c.moment - normal*n;
        Vec3 target = tangential - (omega - spin*n)/w;
        const double disc = pair.rollingFriction*reduced*rn;
        if (target.norm() > disc) target *= disc/target.norm();
        sum += std::pow(reduced*w, 2)*(spinning*spinning + (target - tangential).squaredNorm());
    }
    return std::sqrt(sum);
}

} // namespace scenes
