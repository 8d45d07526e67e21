// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Periodic directions of a scene, aligned with the coordinate axes.
#pragma once

#include "nscd/base/vec3.hpp"

#include <array>

namespace nscd
{

/// Axis k is periodic if length[k] > 0; positions are kept in [lower, lower + length).
struct PeriodicBox
{
    Vec3 lower = Vec3::Zero();
    Vec3 length = Vec3::Zero();

    bool isPeriodic(int axis) const { return length[axis] > 0.0; }
    bool any() const { return isPeriodic(0) || isPeriodic(1) || isPeriodic(2); }

    /// Moves a position back into the box along its periodic axes.
    Vec3 wrap(Vec3 x) const;
    /// The shortest periodic image of a difference of two positions.
    Vec3 nearestImage(Vec3 dx) const;
};

} // namespace nscd
