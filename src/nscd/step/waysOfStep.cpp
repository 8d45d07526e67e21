// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Touches on the way.
#include "nscd/step/waysOfStep.hpp"

#include "nscd/search/wallHit.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

double timeOfTouch(const Vec3& start, const Vec3& way, double from, double to, const Touch& touch)
{
    if (!(from < to)) return never;
    const double radii = touch.radii - touch.margin;
    if (start.squaredNorm() <= radii*radii) return start.dot(way) < 0.0 ? from : never;
    const double share = timeToOrigin(start, (to - from)*way, radii);
    if (share > 1.0) return never;
    const double along = share*(to - from), back = touch.margin/std::abs((start + along*way).normalized().dot(way));
    return std::max(from, from + along - back);
}

bool fliesAlone(const ContactList& list, int body)
{
    return list.inverseMass[body] != 0.0 && list.general.member(body) < 0;
}

} // namespace nscd
