// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a contact's impulse is kept as between two runs.
// Tested by tests/unit/nscd/contacts/storedImpulsesTest.cpp, tests/unit/nscd/tools/sceneCheckpointTest.cpp
#pragma once

#include "nscd/base/vec3.hpp"

#include <array>
#include <cstdint>

namespace nscd
{

/// Impulses that laws beside Coulomb's keep of a contact, on A, in the order of their rows (contactLaw.hpp); zero for what acts in no scene.
/// A law more that keeps one needs a place more here.
constexpr std::size_t lawImpulses = 1;
using LawImpulses = std::array<Vec3, lawImpulses>;

inline LawImpulses noLawImpulses()
{
    LawImpulses none;
    none.fill(Vec3::Zero());
    return none;
}

inline LawImpulses operator-(LawImpulses impulses)
{
    for (Vec3& impulse : impulses) impulse = -impulse;
    return impulses;
}

/// A contact's impulse under the identity of its partners, for restart. idB < 0: wall region -1 - idB.
struct StoredImpulse
{
    std::int64_t idA;
    std::int64_t idB;
    Vec3 impulse;                            ///< on A [N s], over the last step; without the attraction of laws
    LawImpulses ofLaws = noLawImpulses();    ///< [N s]
};

} // namespace nscd
