// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a contact's impulse is kept as between two runs.
#pragma once

#include "nscd/base/vec3.hpp"

#include <cstdint>

namespace nscd
{

/// A contact's impulse under the identity of its partners, for restart. idB < 0: wall region -1 - idB.
struct StoredImpulse
{
    std::int64_t idA;
    std::int64_t idB;
    Vec3 impulse;                  ///< on A [N s], over the last step; without the attraction of cohesion
    Vec3 rolling = Vec3::Zero();   ///< rolling and spinning moment on A over the reduced radius [N s] (rollingFriction.hpp)
};

} // namespace nscd
