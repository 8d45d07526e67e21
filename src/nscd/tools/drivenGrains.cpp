// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Holding and moving groups of grains.
#include "nscd/tools/drivenGrains.hpp"

#include "nscd/base/invalidValue.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

bool isIn(const DrivenGrains& group, std::int64_t id) { return std::binary_search(group.ids.begin(), group.ids.end(), id); }

Vec3 meanOf(const VectorOfTime& f, double from, double to)
{
    const double middle = 0.5*(from + to), offset = 0.5*(to - from)/std::sqrt(3.0);
    return 0.5*(f(middle - offset) + f(middle + offset));
}

/// On every rank alike, whoever owns the grains.
void checkMotion(const Vec3& velocity, const Vec3& omega, int emptyAxis)
{
    if (!velocity.allFinite()) throw invalidValue("velocity of driven grains", velocity.transpose(), "finite components [m/s]");
    if (!omega.allFinite()) throw invalidValue("omega of driven grains", omega.transpose(), "finite components [rad/s]");
    if (emptyAxis < 0) return;
    Vec3 inPlane = omega;
    inPlane[emptyAxis] = 0.0;
    if (velocity[emptyAxis] != 0.0) throw invalidValue("velocity of driven grains", velocity.transpose(), "no way out of the plane of the grains");
    if (!inPlane.isZero(0.0)) throw invalidValue("omega of driven grains", omega.transpose(), "no turning out of the plane of the grains");
}

} // namespace

std::size_t hold(const DrivenGrains& group, Grains& grains)
{
    std::size_t found = 0;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        if (!isIn(group, grains.id[i])) continue;
        grains.isFixed[i] = 1;
        ++found;
    }
    return found;
}

void drive(const DrivenGrains& group, GrainDynamics& dynamics, double from, double to)
{
    const Vec3 velocity = meanOf(group.velocity, from, to);
    const Vec3 omega = group.omega ? meanOf(group.omega, from, to) : Vec3(Vec3::Zero());
    const Grains& grains = dynamics.grains();
    checkMotion(velocity, omega, grains.shape.emptyAxis);
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        if (grains.isFixed[i] && isIn(group, grains.id[i])) dynamics.drive(i, velocity, omega);
    }
}

} // namespace nscd
