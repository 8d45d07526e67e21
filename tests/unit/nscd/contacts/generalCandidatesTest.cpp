// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Clumps in a contact list: who is a member of which, and what never meets.
#include "nscd/contacts/generalCandidates.hpp"
#include "unit/nscd/scenes/clumpScenes.hpp"
#include "unit/nscd/scenes/lists.hpp"

#include <gtest/gtest.h>

#include <numeric>

using namespace scenes;

namespace
{

/// A single grain, a clump of three, one of two, another single grain: grains 0, 1 to 3, 4 and 5, 6; all near one another.
Scene mixed()
{
    Scene scene(3, 0.3, 0.0);
    scene.addGrain(Vec3(0, 0, -0.03), memberRadius);
    addClump(scene, addShape(scene, pebble()), Vec3(0, 0, 0));
    addClump(scene, addShape(scene, dumbbell()), Vec3(0, 0, 0.03));
    scene.addGrain(Vec3(0, 0, 0.055), memberRadius);
    return scene;
}

int clumpOf(int grain) { return grain >= 1 && grain <= 3 ? 0 : grain == 4 || grain == 5 ? 1 : -1; }

} // namespace

TEST(GeneralCandidates, membersAreFoundAmongBodiesInAnyOrder)
{
    const Scene scene = mixed();
    const std::vector<int> grainOf = {5, 2, 0, 6, 3, 1, 4};
    const nscd::GeneralBodies general = nscd::listGeneralBodies(scene.grains.clumps, grainOf);
    ASSERT_EQ(general.bodies.size(), 2u);
    ASSERT_EQ(general.members.size(), 5u);
    for (int body = 0; body < 7; ++body)
    {
        const int clump = clumpOf(grainOf[body]), member = general.memberOf[body];
        ASSERT_EQ(member >= 0, clump >= 0) << body;
        if (clump < 0)
        {
            EXPECT_EQ(general.representative(body), body);
            continue;
        }
        EXPECT_EQ(general.members[member].owner, clump);
        EXPECT_EQ(general.members[member].body, body);
        const int first = scene.grains.clumps.firstMember[clump];
        EXPECT_EQ(general.members[member].center, scene.grains.clumps.shapeOf(clump).members[grainOf[body] - first].center);
        EXPECT_EQ(grainOf[general.representative(body)], first);
    }
    EXPECT_TRUE(nscd::listGeneralBodies(nscd::Clumps(), {0, 1}).empty());
}

TEST(GeneralCandidates, pairsOfOneBodyGoAllOthersStay)
{
    const Scene scene = mixed();
    std::vector<int> grainOf(7);
    std::iota(grainOf.begin(), grainOf.end(), 0);
    const nscd::GeneralBodies general = nscd::listGeneralBodies(scene.grains.clumps, grainOf);
    std::vector<nscd::Candidate> candidates;
    for (int a = 0; a < 7; ++a)
    {
        for (int b = a + 1; b < 7; ++b) candidates.push_back({a, b, -1, {0, 0, 0}});
        candidates.push_back({a, 7, 0, {0, 0, 0}});
    }
    nscd::removeWithinBodies(candidates, general);
    EXPECT_EQ(candidates.size(), 28u - 4u);
    for (const nscd::Candidate& c : candidates) EXPECT_TRUE(c.wall >= 0 || clumpOf(c.a) < 0 || clumpOf(c.a) != clumpOf(c.b)) << c.a << ' ' << c.b;
}

TEST(GeneralCandidates, theirContactsStandBehindAllOthers)
{
    Scene scene = mixed();
    scene.addGrain(Vec3(0, 0, -0.05), memberRadius);
    const nscd::ContactList list = listContacts(scene, 0.02);
    EXPECT_EQ(list.general.slots.size(), (list.blocks.size() - list.general.firstBlock)*nscd::blockLanes);
    int general = 0, single = 0;
    for (std::size_t slot : usedSlots(list))
    {
        const auto [a, b] = bodiesOf(list, slot);
        const bool isGeneral = clumpOf(list.grainOf[a]) >= 0 || clumpOf(list.grainOf[b]) >= 0;
        EXPECT_EQ(slot >= list.general.firstBlock*nscd::blockLanes, isGeneral);
        ++(isGeneral ? general : single);
    }
    EXPECT_GT(general, 2);
    EXPECT_EQ(single, 1);
}
