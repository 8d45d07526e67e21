// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Sides of a plane at both ends of a way.
#include "functionObjects/planeCrossing.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

int straightCrossing(const Plane& plane, const Vec3& from, const Vec3& to)
{
    return int(plane.hasInFront(to)) - int(plane.hasInFront(from));
}

} // namespace


int crossing(const Plane& plane, const Vec3& from, const Vec3& to, const ::nscd::PeriodicBox& box)
{
    const Vec3 direct = to - from, way = box.nearestImage(direct);
    // Where nothing was wrapped, the sides are those of the positions themselves: a step ends on the side that the next one begins on.
    if (way == direct) return straightCrossing(plane, from, to);
    const int begun = straightCrossing(plane, from, from + way);
    return begun != 0 ? begun : straightCrossing(plane, to - way, to);
}

} // namespace nscdCoupling
} // namespace Foam
