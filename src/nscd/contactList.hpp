// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The persistent list of candidate contacts: pairs that could touch before the list is built again, in the order they are solved.
#pragma once

#include "contactBlock.hpp"
#include "grains.hpp"
#include "materials.hpp"
#include "periodicBox.hpp"
#include "walls.hpp"

#include <array>
#include <vector>

namespace nscd
{

/// Bodies are the grains sorted along a space-filling curve; one static body for all walls comes last.
/// A slot is a lane of a block; unused slots join the static body to itself.
struct ContactList
{
    // Per body.
    std::vector<int> grainOf;
    std::vector<int> bodyOf;                ///< inverse of grainOf
    std::vector<Vec3> position;             ///< not wrapped since the list was built [m]
    std::vector<Vec3> positionAtBuild;
    std::vector<double> radius;
    std::vector<double> reach;              ///< distance a body may travel from positionAtBuild before the list is stale [m]
    std::vector<Body> bodies;               ///< one more: the static body

    // Per slot.
    std::vector<ContactBlock> blocks;
    std::vector<double> gap;                ///< [m]
    std::vector<int> wall;                  ///< wall region, or -1 for a pair of grains
    std::vector<std::array<signed char, 3>> image;  ///< periodic shift of body B, in periods
    std::vector<double> restitution;        ///< empty if no pair of materials has any

    std::vector<std::uint32_t> awake;       ///< blocks that can matter in this step, ascending; set by prepareSlots

    std::size_t candidates = 0;
    std::vector<int> wallSlots;             ///< slots of outlined walls, grouped by body, for the suppression of ghost contacts
    std::vector<int> wallSlotStart;         ///< group k is wallSlots[wallSlotStart[k] .. wallSlotStart[k+1])

    int staticBody() const { return static_cast<int>(grainOf.size()); }
    std::size_t slots() const { return gap.size(); }
    bool isUsed(std::size_t slot) const { return blocks[slot/blockLanes].a[slot % blockLanes] != staticBody(); }
};

/// Impulse of the slot, on A [N s].
Vec3 impulse(const ContactList& list, std::size_t slot);
void setImpulse(ContactList& list, std::size_t slot, const Vec3& r);
Vec3 normal(const ContactList& list, std::size_t slot);

/// What the search needs to know of the scene.
struct Scene
{
    const Grains& grains;
    const Materials& materials;
    const Walls& walls;
    const PeriodicBox& box;
};

/// A contact's impulse by the grains' indices; `b` < 0 means wall region -1 - b.
struct PairImpulse
{
    int a;
    int b;
    Vec3 impulse;  ///< on a [N s]
};

/// Lists all pairs whose surfaces are nearer than the sum of their reaches; impulses are zero afterwards.
/// Cost: linear in the number of grains for any size distribution (one grid per octave of radius + reach).
/// Errors: std::invalid_argument if a period is shorter than the largest grain
ContactList buildContactList(const Scene& scene, const std::vector<double>& reach);

/// A slot that carries an impulse.
struct SlotImpulse
{
    std::size_t slot;
    PairImpulse pair;
};

/// Impulses that are not zero, keyed by grain index.
std::vector<SlotImpulse> loadedSlots(const ContactList& list);
std::vector<PairImpulse> collectImpulses(const ContactList& list);

/// Gives each candidate the impulse its pair had; of several images of a pair, the one best aligned with the impulse gets it.
void assignImpulses(ContactList& list, const std::vector<PairImpulse>& impulses);

/// Recomputes normals and gaps at the present positions.
/// Errors: std::invalid_argument for coincident centers, naming the grains
void updateGeometry(ContactList& list, const Scene& scene);

} // namespace nscd
