// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Impulses that outlive their list: found again by their grains, whatever order these have.
#include "nscd/contacts/storedImpulses.hpp"
#include "unit/nscd/scenes/lists.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

using namespace scenes;

namespace
{

/// Impulses by the identities of their grains, the lower one first and on it; -1: the wall.
using ById = std::map<std::pair<std::int64_t, std::int64_t>, Vec3>;

ById impulsesById(const Scene& scene, const nscd::ContactList& list)
{
    ById found;
    for (const nscd::StoredImpulse& entry : nscd::byIdentity(nscd::collectImpulses(list), scene.grains))
    {
        const bool isSwapped = entry.idB < entry.idA;
        const bool isNew = found.insert({std::minmax(entry.idA, entry.idB), isSwapped ? Vec3(-entry.impulse) : entry.impulse}).second;
        EXPECT_TRUE(isNew);
    }
    return found;
}

/// Some impulse that pushes, different for each pair, on every other slot.
void loadContacts(nscd::ContactList& list)
{
    for (std::size_t slot : usedSlots(list))
    {
        const Vec3 n = nscd::normal(list, slot);
        if (slot % 2 == 0) nscd::setImpulse(list, slot, (1.0 + static_cast<double>(slot))*(n + 0.2*n.unitOrthogonal()));
    }
}

/// The same grains in another order.
Scene reordered(const Scene& scene)
{
    Scene other(3, 0.3, 0.0);
    other.walls = scene.walls;
    other.box = scene.box;
    std::vector<std::size_t> order(scene.grains.size());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(6));
    for (std::size_t i : order) other.grains.add(scene.grains.position[i], scene.grains.radius[i], 2500.0, 0, scene.grains.id[i]);
    return other;
}

} // namespace

TEST(StoredImpulses, areFoundAgainInAnotherOrder)
{
    const Scene scene = cloud(400);
    nscd::ContactList list = listContacts(scene, 0.01);
    loadContacts(list);
    const ById before = impulsesById(scene, list);
    const std::vector<nscd::StoredImpulse> stored = nscd::byIdentity(nscd::collectImpulses(list), scene.grains);
    ASSERT_GT(before.size(), 150u);

    const Scene other = reordered(scene);
    nscd::ContactList later = listContacts(other, 0.012);
    nscd::Exchange alone;
    nscd::assignImpulses(later, nscd::byIndex(stored, other.grains), alone);
    EXPECT_EQ(impulsesById(other, later), before);
}

TEST(StoredImpulses, thoseOfGrainsThatWentAreNotKept)
{
    Scene scene(3, 0.3, 0.0);
    for (int i = 0; i < 3; ++i) scene.addGrain(Vec3(0.2*i, 0, 0), 0.1);
    nscd::ContactList list = listContacts(scene, 0.01);
    loadContacts(list);
    std::vector<nscd::StoredImpulse> stored = {{0, 1, Vec3(-1, 0, 0)}, {2, 1, Vec3(2, 0, 0)}, {7, 8, Vec3(3, 0, 0)}};
    const nscd::ImpulseRecord record = nscd::byIndex(stored, scene.grains);
    ASSERT_EQ(record.inner.size(), 2u);
    EXPECT_EQ(record.inner[1].a, 2);
    EXPECT_EQ(record.inner[1].b, 1);
    EXPECT_TRUE(record.interface.empty());
}

TEST(StoredImpulses, ofSeveralImagesTheOneAlongTheImpulseGetsIt)
{
    Scene scene(3, 0.3, 0.0);
    scene.box.length = Vec3(0.4, 0, 0);
    for (double x : {0.1, 0.3}) scene.addGrain(Vec3(x, 0, 0), 0.1);
    nscd::ContactList list = listContacts(scene, 0.01);
    ASSERT_EQ(usedSlots(list).size(), 2u);
    nscd::Exchange alone;
    nscd::assignImpulses(list, nscd::byIndex({{0, 1, Vec3(5, 0, 0)}}, scene.grains), alone);
    for (std::size_t slot : usedSlots(list))
    {
        const bool isOnFirst = list.grainOf[bodiesOf(list, slot).first] == 0;
        const Vec3 onFirst = (isOnFirst ? 1 : -1)*nscd::impulse(list, slot), n = (isOnFirst ? 1 : -1)*nscd::normal(list, slot);
        EXPECT_EQ(onFirst, n[0] > 0 ? Vec3(5, 0, 0) : Vec3(0, 0, 0));
    }
}

TEST(StoredImpulses, loadedSlotsAreThoseThatCarryOne)
{
    const Scene scene = cloud(100);
    nscd::ContactList list = listContacts(scene, 0.01);
    EXPECT_TRUE(nscd::loadedSlots(list).empty());
    EXPECT_TRUE(nscd::collectImpulses(list).isEmpty());
    loadContacts(list);
    for (const nscd::SlotImpulse& loaded : nscd::loadedSlots(list))
    {
        EXPECT_EQ(loaded.slot % 2, 0u);
        EXPECT_EQ(loaded.pair.impulse, nscd::impulse(list, loaded.slot));
        EXPECT_EQ(loaded.pair.a, list.grainOf[bodiesOf(list, loaded.slot).first]);
        EXPECT_EQ(loaded.pair.b < 0, list.wall[loaded.slot] >= 0);
    }
    EXPECT_FALSE(nscd::loadedSlots(list).empty());
}
