// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Which bodies could touch before the list is built again.
// Tested by tests/unit/nscd/contacts/contactListTest.cpp, tests/unit/nscd/scene/wallsTest.cpp,
// tests/parallel/listsByPathsTest.cpp
#pragma once

#include "nscd/contacts/contactBatching.hpp"
#include "nscd/contacts/contactList.hpp"

#include <vector>

namespace nscd
{

/// Candidates among own bodies and between these and walls, ordered by body; and those with ghosts that this rank solves.
struct Candidates
{
    std::vector<Candidate> inner;
    std::vector<Candidate> interface;
};

/// A place in the box, and those where a body that may move by `reach` comes in again across a periodic side.
std::vector<Vec3> placesOf(const Vec3& x, double reach, const PeriodicBox& box);

/// The image of a pair of bodies, from that of spheres whose centers were moved into the box: by `shift` more for b than for a.
std::array<signed char, 3> movedBy(std::array<signed char, 3> image, const Vec3& shift, const PeriodicBox& box);

/// Whether two own bodies may touch on their paths, or attract each other within `range` each, once they have gone a share `from` of these.
bool mayMeet(const ContactList& list, const Candidate& pair, const PeriodicBox& box, double range, double from);

/// The list has its own bodies, their paths and slacks, and the radii of `ghosts` behind those of own bodies; walls have `b` = -1. The list's search is
/// used. `reachToMany`: of ExpectedMotion.
/// Cost: linear in the number of bodies for any size distribution (one grid per octave of radius + reach).
/// Errors: std::invalid_argument if a period is shorter than the largest grain
Candidates findCandidates
(
    ContactList& list, const std::vector<GhostGrain>& ghosts, int rank, const Scene& scene, const WallSearch& wallSearch,
    const std::vector<double>& reachToMany
);

/// Packs candidates into blocks, near ones into blocks of their own, so that blocks of far ones can be left out of sweeps.
Batches batchNearAndFar(const ContactList& list, const Scene& scene, const std::vector<Candidate>& candidates, double diameter);

/// Slots of candidates, in their order.
struct CandidateSlots
{
    std::vector<std::uint32_t> inner;
    std::vector<std::uint32_t> interface;
};

/// Makes the blocks of a list that has its bodies, and the bodies at walls. Candidates of one body with walls stand in a row.
CandidateSlots packCandidates(ContactList& list, const Scene& scene, Candidates& candidates, double diameter);

} // namespace nscd
