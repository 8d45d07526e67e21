// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The persistent list of candidate contacts: pairs that could touch before the list is built again, in the order they are solved.
#pragma once

#include "nscd/base/periodicBox.hpp"
#include "nscd/contacts/general/generalBodies.hpp"
#include "nscd/contacts/listLaws.hpp"
#include "nscd/kernels/contactBlock.hpp"
#include "nscd/kernels/halo.hpp"
#include "nscd/scene/grains.hpp"
#include "nscd/scene/materials.hpp"
#include "nscd/search/pairSearch.hpp"
#include "nscd/search/wallSearch.hpp"

#include <array>
#include <vector>

namespace nscd
{

/// What a list allows a moving wall patch to move before it is stale.
struct WallReach
{
    double distance = 0.0;                  ///< [m]; 0 where the patch does not move
    Eigen::AlignedBox3d box;                ///< around the part of the patch that grains can meet, at the identity pose
    WallPose poseAtBuild = WallPose::Identity();
};

/// Bodies are numbered as Halo says; own ones are the grains sorted along a space-filling curve; behind them one for each contact
/// with a wall that moves, which carries the wall's velocity at the contact; one static body for all other walls comes last. A slot is a lane of a block; unused slots join the static body to itself.
struct ContactList
{
    // Per own body.
    std::vector<int> grainOf;
    std::vector<Vec3> positionAtBuild;      ///< of a stray, where its path would have begun then [m]
    std::vector<double> reach;              ///< distance a body may travel from positionAtBuild before the list is stale [m]
    std::vector<Vec3> path;                 ///< displacement expected of each within pathTime [m]; empty: none is expected
    std::vector<double> slack;              ///< how far it may be from where its path expects it: reach less path [m]
    std::vector<int> strays;                ///< bodies that went otherwise, and have had another path since; see strays.hpp
    Vec3 meanPath = Vec3::Zero();           ///< about what grains of all ranks had of it when the list was built [m]
    double pathTime = 0.0;                  ///< [s]
    double age = 0.0;                       ///< time that bodies have moved since the list was built [s]

    // Per own body, ghost and copy.
    std::vector<Vec3> position;             ///< not wrapped since the list was built; it is where walls are concerned [m]
    std::vector<double> radius;
    std::vector<double> inverseMass;        ///< 0 where held; without drag, and not split among ranks [1/kg]
    std::vector<std::int64_t> id;
    std::vector<Body> bodies;               ///< further ones: at walls that move, and the static body

    std::vector<GhostGrain> ghosts;         ///< those that contacts here need
    std::vector<GhostGrain> solvedElsewhere;  ///< others nearby
    Halo halo;

    // Per slot.
    std::vector<ContactBlock> blocks;
    bool areStraysFollowed = false;         ///< so that blocks are kept free for their pairs
    std::size_t freeBlock = 0;              ///< the first that is free; those up to interfaceBlock are
    std::size_t interfaceBlock = 0;         ///< from this block on contacts join grains of two ranks
    std::vector<double> gap;                ///< [m]
    std::vector<int> wall;                  ///< wall region, or -1 for a pair of grains
    std::vector<std::array<signed char, 3>> image;  ///< periodic shift of body B, in periods
    std::vector<double> restitution;        ///< empty if no pair of materials has any
    std::vector<Vec3> trialChange;          ///< what the last trial of forces made of the impulses [N s]; empty before the first one
    ListLaws laws;                          ///< beside Coulomb's; none in plain scenes

    GeneralBodies general;                  ///< empty in scenes without

    std::vector<std::uint32_t> awake;       ///< blocks that can matter in this step, ascending; set by prepareSlots

    std::size_t candidates = 0;             ///< on this rank
    std::vector<std::uint32_t> slotsOfWalls;  ///< all contacts with walls, ascending
    std::vector<std::size_t> fastPairs;     ///< slots of pairs that may move by much of their size in a step; see aimFastPairs()
    std::vector<std::size_t> aimedPairs;    ///< of these, those aimed since the geometry was new
    std::vector<int> wallSlots;             ///< slots of outlined walls, grouped by body, for the suppression of ghost contacts
    std::vector<std::size_t> movingSlots;   ///< slot of each body at a wall that moves
    std::vector<WallReach> wallReach;       ///< per patch; empty if none moves
    std::vector<int> wallSlotStart;         ///< group k is wallSlots[wallSlotStart[k] .. wallSlotStart[k+1])
    PairSearch search;                      ///< its memory serves list after list

    int owned() const { return static_cast<int>(grainOf.size()); }
    int firstWallBody() const { return static_cast<int>(position.size()); }
    int staticBody() const { return static_cast<int>(bodies.size()) - 1; }
    std::size_t slots() const { return gap.size(); }
    bool isUsed(std::size_t slot) const { return blocks[slot/blockLanes].a[slot % blockLanes] != staticBody(); }

    /// Index of a body's grain; of ghost g: the number of own grains + g.
    int grain(int body) const { return body < owned() ? grainOf[body] : body < halo.firstCopy() ? body : grainOf[ownBody(body)]; }
    /// How far a body may be from where its path expects it, and this path; of ghosts and copies too [m].
    double slackOf(int body) const;
    Vec3 pathOf(int body) const;
    /// The body itself, of a copy the own one.
    int ownBody(int body) const { return body < owned() || body < halo.firstCopy() ? body : halo.copied()[body - halo.firstCopy()]; }
};

inline double ContactList::slackOf(int body) const
{
    const int own = ownBody(body);
    return own < owned() ? slack[own] : ghosts[own - owned()].slack;
}

inline Vec3 ContactList::pathOf(int body) const
{
    const int own = ownBody(body);
    if (own >= owned()) return ghosts[own - owned()].path;
    return path.empty() ? Vec3(Vec3::Zero()) : path[own];
}

/// Impulse of the slot, on A, without attraction [N s].
inline Vec3 impulse(const ContactList& list, std::size_t slot)
{
    const ContactBlock& block = list.blocks[slot/blockLanes];
    const std::size_t lane = slot % blockLanes;
    return Vec3(block.r[0][lane], block.r[1][lane], block.r[2][lane]);
}

inline void setImpulse(ContactList& list, std::size_t slot, const Vec3& r)
{
    ContactBlock& block = list.blocks[slot/blockLanes];
    for (int k = 0; k < 3; ++k) block.r[k][slot % blockLanes] = r[k];
}

inline Vec3 normal(const ContactList& list, std::size_t slot)
{
    const ContactBlock& block = list.blocks[slot/blockLanes];
    const std::size_t lane = slot % blockLanes;
    return Vec3(block.n[0][lane], block.n[1][lane], block.n[2][lane]);
}

/// Whether a contact is loaded, or nearer than the dead band.
inline bool isClosed(const ContactList& list, std::size_t slot, double deadBand)
{
    return list.gap[slot] <= deadBand || impulse(list, slot).dot(normal(list, slot)) > 0.0;
}

/// Slots of the blocks that can matter in this step: all contacts that are closed, may close, or carry an impulse. visit(slot)
template<class Visit>
void forEachAwakeSlot(const ContactList& list, const Visit& visit)
{
    for (std::size_t k : list.awake)
    for (std::size_t slot = k*blockLanes; slot < (k + 1)*blockLanes; ++slot) visit(slot);
}

/// What the search needs to know of the scene.
struct Scene
{
    const Grains& grains;
    const Materials& materials;
    const Walls& walls;
    const PeriodicBox& box;
};

/// How grains are expected to move until the list is built again.
struct ExpectedMotion
{
    std::vector<Vec3> velocity;   ///< of each grain, or empty [m/s]
    Vec3 meanVelocity = Vec3::Zero();   ///< of the grains of all ranks, about [m/s]
    double time = 0.0;            ///< [s]
    bool areStraysFollowed = false;   ///< see strays.hpp
    bool mayBeStopped = false;    ///< any grain, anywhere on its path, by a wall, or by one that a wall stopped: of interest on several ranks
    /// Of each grain, how far away walls of many regions are listed, if not as far as its reach and the walls' (infinite) [m]; empty: all are.
    std::vector<double> reachToMany;
};

/// Lists all pairs whose surfaces are nearer than the sum of their reaches; impulses are zero afterwards. `diameter`: mean, [m].
/// A reach is how far a grain may travel before the list is stale, and the range of laws that act across gaps. Where motion is expected, pairs that do
/// not come near one another in it are left out; where grains may be stopped, those of other ranks may be anywhere within their reaches. A grain that
/// moves otherwise, by more than its reach less its path, makes the list stale. `old`: a list whose memory is used again.
/// Errors: std::invalid_argument if a period is shorter than the largest grain
ContactList buildContactList
(
    const Scene& scene, const WallSearch& wallSearch, const std::vector<double>& reach, std::vector<WallReach> wallReach,
    double diameter, Exchange& exchange, ContactList old = ContactList(), const ExpectedMotion& expected = ExpectedMotion()
);

} // namespace nscd
