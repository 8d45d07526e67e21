// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A judge of rolling and spinning moments that shares no code with the solvers, in angular velocities and moments.
#pragma once

#include "unit/nscd/scenes/naturalMap.hpp"

namespace scenes
{

/// Root of the sum of squares of R' |domega|, domega = W |M - Proj(M - omega/W)| with W = 1/J_A + 1/J_B and the reduced radius R', over
/// the contacts that carry an impulse, at the positions `before` a step and the velocities `after` it [m/s].
/// Contacts by the grains' identities, which are their indices here.
inline double rollingNorm
(
    const Scene& scene, const nscd::Grains& before, const nscd::Grains& after, const std::vector<nscd::LoadedContact>& contacts
)
{
    double sum = 0.0;
    for (const nscd::LoadedContact& c : contacts)
    {
        const int a = static_cast<int>(c.idA), b = static_cast<int>(c.idB);
        const bool isWall = b < 0;
        const Vec3 n = isWall
            ? scene.walls.regions[-1 - b].normal : Vec3(scene.box.nearestImage(before.position[a] - before.position[b]).normalized());
        const nscd::ContactPair& pair = scene.materials.pair(before.material[a], isWall ? 1 : before.material[b]);
        const double ra = before.radius[a], reduced = isWall ? ra : ra*before.radius[b]/(ra + before.radius[b]);
        const auto inverseInertia = [&](int i)
        {
            return before.isFixed[i] ? 0.0 : 1.0/(before.shape.inertiaFactor()*before.mass[i]*before.radius[i]*before.radius[i]);
        };
        const double w = inverseInertia(a) + (isWall ? 0.0 : inverseInertia(b));
        const Vec3 omega = after.omega[a] - (isWall ? Vec3(Vec3::Zero()) : after.omega[b]);
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
