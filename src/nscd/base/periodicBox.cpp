// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Wrapping of positions along periodic axes.
#include "nscd/base/periodicBox.hpp"

#include <cmath>

namespace nscd
{

Vec3 PeriodicBox::wrap(Vec3 x) const
{
    for (int k = 0; k < 3; ++k)
    {
        if (!isPeriodic(k)) continue;
        x[k] -= length[k]*std::floor((x[k] - lower[k])/length[k]);
        // Rounding can leave a coordinate just below `lower` at the upper end.
        if (x[k] >= lower[k] + length[k]) x[k] = lower[k];
    }
    return x;
}

Vec3 PeriodicBox::nearestImage(Vec3 dx) const
{
    for (int k = 0; k < 3; ++k)
    {
        if (isPeriodic(k)) dx[k] -= length[k]*std::round(dx[k]/length[k]);
    }
    return dx;
}

} // namespace nscd
