// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Pairs that fast grains close: the normal of the impact, or of the nearest pass.
#include "nscd/step/sweptPairs.hpp"
#include "unit/nscd/scenes/lists.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double radius = 0.1, deltaT = 1e-2;

/// A grain at rest, and one 10 radii away, `aside` of its way.
struct Pair
{
    Scene scene = Scene(3, 0.3, 0.0);
    nscd::ContactList list;
    std::size_t slot;

    explicit Pair(double aside)
    {
        scene.addGrain(Vec3::Zero(), radius);
        scene.addGrain(Vec3(10*radius, aside, 0), radius);
        list = listContacts(scene, 5*radius);
        slot = usedSlots(list)[0];
        nscd::findFastPairs(list);
    }

    void aim(double speed)
    {
        setVelocity(list, 1, Vec3(-speed, 0, 0));
        nscd::aimFastPairs(list, scene.box, deltaT);
    }

    /// From the grain at rest to the other one.
    Vec3 normal() const
    {
        return (list.grainOf[bodiesOf(list, slot).first] == 1 ? 1 : -1)*nscd::normal(list, slot);
    }
};

} // namespace

TEST(SweptPairs, haveTheNormalOfTheImpactAndTheGapAlongIt)
{
    for (double aside : {0.0, 0.05, 0.1, 0.19})
    {
        Pair pair(aside);
        const double speed = 2.0/deltaT;   // twenty radii a step
        pair.aim(speed);
        const Vec3 n(std::sqrt(4*radius*radius - aside*aside)/(2*radius), aside/(2*radius), 0);
        EXPECT_LT((pair.normal() - n).norm(), 1e-13) << aside;
        const double time = (1.0 - 2*radius*n[0])/speed;
        EXPECT_NEAR(pair.list.gap[pair.slot], time*speed*n[0], 1e-13) << aside;
    }
}

TEST(SweptPairs, thatPassHaveTheNormalOfTheirNearestPlacesAndStayOpen)
{
    Pair pair(0.3);
    pair.aim(2.0/deltaT);
    EXPECT_LT((pair.normal() - Vec3::UnitY()).norm(), 1e-13);
    EXPECT_NEAR(pair.list.gap[pair.slot], 0.3 - 2*radius, 1e-13);
}

TEST(SweptPairs, thatAreSlowOrPartKeepTheirPresentNormal)
{
    const Pair present(0.1);
    for (double speed : {0.04/deltaT, -2.0/deltaT})
    {
        Pair pair(0.1);
        pair.aim(2.0/deltaT);
        EXPECT_GT((pair.normal() - present.normal()).norm(), 0.1);
        pair.aim(speed);
        EXPECT_LT((pair.normal() - present.normal()).norm(), 1e-14) << speed;
        EXPECT_NEAR(pair.list.gap[pair.slot], present.list.gap[present.slot], 1e-14) << speed;
    }
}

TEST(SweptPairs, areNoneInScenesWhoseGrainsMayNotGoFar)
{
    Scene scene = cloud(200);
    nscd::ContactList list = listContacts(scene, 0.003);
    nscd::findFastPairs(list);
    EXPECT_TRUE(list.fastPairs.empty());
    nscd::ContactList far = listContacts(scene, 0.05);
    nscd::findFastPairs(far);
    EXPECT_FALSE(far.fastPairs.empty());
    for (std::size_t slot : far.fastPairs) EXPECT_LT(far.wall[slot], 0);
}
