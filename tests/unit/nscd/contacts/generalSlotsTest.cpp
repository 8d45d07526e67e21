// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Delassus operators of general contacts against what a unit impulse does.
#include "nscd/contacts/generalSlots.hpp"
#include "nscd/contacts/general/generalSweep.hpp"
#include "nscd/step/contactStep.hpp"
#include "nscd/step/generalMotion.hpp"
#include "unit/nscd/scenes/clumpScenes.hpp"
#include "unit/nscd/scenes/lists.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3, deadBand = 1e-4*memberRadius;

/// A pebble that touches a dumbbell, a single grain and the floor, somewhat turned.
Scene touchingClumps()
{
    Scene scene(3, 0.4, 0.0);
    scene.addPlane(Vec3(0, 0, -1.2*memberRadius), Vec3::UnitZ());
    addClump(scene, addShape(scene, pebble()), Vec3::Zero(), Quaternion(1, 0.3, -0.2, 0.1).normalized());
    addClump(scene, addShape(scene, dumbbell()), Vec3(0.2, 0.1, 2.2)*memberRadius, Quaternion(1, 0.1, 0.4, 0.7).normalized());
    scene.addGrain(Vec3(-2.0, 0.4, 0.3)*memberRadius, memberRadius);
    return scene;
}

/// A list with the bodies of a step without forces, whose general contacts are not yet prepared.
nscd::ContactList freeList(const Scene& scene)
{
    nscd::ContactList list = listContacts(scene, 0.5*memberRadius);
    nscd::setFreeVelocities(list, scene.grains, nscd::ExternalForces(), deltaT, nscd::GrainSleep());
    nscd::setFreeGeneral(list, scene.grains, nscd::ExternalForces(), deltaT, nscd::GrainSleep());
    return list;
}

void start(nscd::ContactList& list)
{
    nscd::setGeneralLaws(list, deltaT, deadBand, nscd::unreachable);
    nscd::startGeneralSlots(list, 1.0);
}

std::vector<std::size_t> generalSlots(const nscd::ContactList& list)
{
    std::vector<std::size_t> slots;
    for (std::size_t slot : usedSlots(list))
    {
        if (nscd::isGeneral(&list.general, slot)) slots.push_back(slot);
    }
    return slots;
}

/// Velocity of the material point of a side at a contact.
Vec3 velocityAt(const nscd::ContactList& list, int owner, const Vec3& arm, int body, const Vec3& fromCenter)
{
    if (owner >= 0) return list.general.bodies[owner].v + list.general.bodies[owner].omega.cross(arm);
    const nscd::Body& single = list.bodies[body];
    return Vec3(single.v) + Vec3(single.s).cross(fromCenter);
}

} // namespace

TEST(GeneralSlots, operatorsTellWhatAnImpulseDoesToTheVelocityInTheContact)
{
    const Scene scene = touchingClumps();
    nscd::ContactList list = freeList(scene);
    start(list);
    int tested = 0;
    for (std::size_t slot : generalSlots(list))
    {
        const nscd::GeneralSlot& contact = list.general.slots[slot - list.general.firstBlock*nscd::blockLanes];
        const auto [a, b] = bodiesOf(list, slot);
        const Vec3 n = nscd::normal(list, slot);
        const auto velocity = [&, a = a, b = b]
        {
            return Vec3(velocityAt(list, contact.ownerA, contact.armA, a, -n) - velocityAt(list, contact.ownerB, contact.armB, b, n));
        };
        for (int axis = 0; axis < 3; ++axis)
        {
            const Vec3 before = velocity(), unit = Vec3::Unit(axis);
            nscd::applyGeneralChange(list.bodies.data(), list.blocks.data(), list.general, slot, unit);
            const Vec3 change = velocity() - before;
            nscd::applyGeneralChange(list.bodies.data(), list.blocks.data(), list.general, slot, -unit);
            EXPECT_LT((change - contact.w.col(axis)).norm(), 1e-10*contact.w.norm()) << slot << ' ' << axis;
            ++tested;
        }
        const nscd::ContactBlock& block = list.blocks[slot/nscd::blockLanes];
        EXPECT_NEAR(block.invWn[slot % nscd::blockLanes]*n.dot(contact.w*n), 1.0, 1e-12);
        EXPECT_LT((contact.w*contact.inverse - Eigen::Matrix3d::Identity()).norm(), 1e-9);
    }
    EXPECT_GT(tested, 8);
}

TEST(GeneralSlots, armsLeadFromTheMassCenterToTheSurfacesThatTouch)
{
    const Scene scene = touchingClumps();
    nscd::ContactList list = freeList(scene);
    start(list);
    const std::vector<int> clumpOf = nscd::clumpOfGrains(scene.grains);
    int arms[2] = {0, 0};
    for (std::size_t slot : generalSlots(list))
    {
        const nscd::GeneralSlot& contact = list.general.slots[slot - list.general.firstBlock*nscd::blockLanes];
        const auto [a, b] = bodiesOf(list, slot);
        const Vec3 n = nscd::normal(list, slot);
        const auto expectArm = [&](int side, int body, int owner, const Vec3& arm, const Vec3& toContact)
        {
            ASSERT_EQ(owner, body < list.owned() ? clumpOf[list.grainOf[body]] : -1);
            if (owner < 0) return;
            const Vec3 surface = list.position[body] + list.radius[body]*toContact;
            EXPECT_LT((scene.grains.clumps.position[owner] + arm - surface).norm(), 1e-15) << slot;
            ++arms[side];
        };
        expectArm(0, a, contact.ownerA, contact.armA, -n);
        expectArm(1, b, contact.ownerB, contact.armB, n);
    }
    EXPECT_GT(arms[0], 0);
    EXPECT_GT(arms[1], 0);
}

TEST(GeneralSlots, biasIsTheSpeedThatClosesAGapBeyondTheDeadBand)
{
    nscd::ContactList list = freeList(touchingClumps());
    start(list);
    int open = 0, closed = 0;
    for (std::size_t slot : generalSlots(list))
    {
        const double bias = list.blocks[slot/nscd::blockLanes].bias[slot % nscd::blockLanes];
        const bool isOpen = list.gap[slot] > deadBand;
        EXPECT_DOUBLE_EQ(bias, isOpen ? list.gap[slot]/deltaT : 0.0);
        ++(isOpen ? open : closed);
    }
    EXPECT_GT(open, 0);
    EXPECT_GT(closed, 0);
}
