// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// From forces to free velocities, from impulses to forces, from velocities to places: each against its formula.
#include "nscd/step/contactStep.hpp"
#include "nscd/kernels/sweepKernels.hpp"
#include "unit/nscd/scenes/lists.hpp"

#include <gtest/gtest.h>

#include <numeric>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-2, radius = 0.1;

/// Two grains that move and turn, and a held one.
Scene three()
{
    Scene scene(3, 0.3, 0.5);
    for (int i = 0; i < 3; ++i)
    {
        scene.addGrain(Vec3(0.21*i, 0, 0), radius);
        scene.grains.velocity[i] = Vec3(1 + i, -2, 0.5*i);
        scene.grains.omega[i] = Vec3(0, 3, 1 + i);
    }
    scene.grains.isFixed[2] = 1;
    return scene;
}

nscd::ContactList freeList(const Scene& scene, const nscd::ExternalForces& forces)
{
    nscd::ContactList list = listContacts(scene, 0.02);
    nscd::setFreeVelocities(list, scene.grains, forces, deltaT, nscd::GrainSleep());
    return list;
}

/// Impulses of any direction in all contacts.
void loadContacts(nscd::ContactList& list)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (std::size_t slot : usedSlots(list))
    {
        const double x = unit(random), y = unit(random), z = unit(random);
        nscd::setImpulse(list, slot, Vec3(x, y, z));
    }
}

} // namespace

TEST(ContactStep, freeVelocitiesTakeDragInTheirOwnNewVelocity)
{
    const Scene scene = three();
    const double mass = scene.grains.mass[0], inertia = 0.4*mass*radius*radius;
    nscd::ExternalForces forces;
    forces.force.assign(3, mass*Vec3(0, 0, -9.81));
    forces.torque.assign(3, Vec3(0.2, 0, 0));
    forces.implicitDrag.assign(3, 50*mass);
    forces.implicitSpinDrag.assign(3, 20*inertia);
    const nscd::ContactList list = freeList(scene, forces);
    for (int i = 0; i < 2; ++i)
    {
        const nscd::Body& body = list.bodies[bodyOf(list, i)];
        const Vec3 v = (scene.grains.velocity[i] + deltaT*Vec3(0, 0, -9.81))/(1 + 50*deltaT);
        const Vec3 omega = (scene.grains.omega[i] + deltaT*Vec3(0.2, 0, 0)/inertia)/(1 + 20*deltaT);
        EXPECT_LT((Vec3(body.v) - v).norm(), 1e-14);
        EXPECT_LT((Vec3(body.s) - radius*omega).norm(), 1e-14);
        EXPECT_NEAR(body.invMass*mass*(1 + 50*deltaT), 1.0, 1e-14);
        EXPECT_NEAR(body.invSpin*0.4*mass*(1 + 20*deltaT), 1.0, 1e-14);
    }
    const nscd::Body& held = list.bodies[bodyOf(list, 2)];
    EXPECT_EQ(Vec3(held.v), scene.grains.velocity[2]);
    EXPECT_EQ(held.invMass, 0.0);
    EXPECT_EQ(held.invSpin, 0.0);
}

TEST(ContactStep, whatRestsDoesNotFallWhatIsHitDoesByItsForces)
{
    Scene scene = three();
    scene.grains.isFixed[2] = 0;
    const Vec3 fall(0, 0, -9.81*deltaT);
    const Vec3 changes[] = {1e-6*fall, fall, Vec3(5, 0, 0)};   // at rest, falling, hit
    nscd::ContactList list = freeList(scene, nscd::ExternalForces());
    std::vector<Vec3> freeVelocity(list.owned());
    for (int body = 0; body < list.owned(); ++body)
    {
        const int grain = list.grainOf[body];
        freeVelocity[body] = scene.grains.velocity[grain] + fall;
        setVelocity(list, grain, scene.grains.velocity[grain] + changes[grain]);
    }
    std::vector<double> falls;
    nscd::setFalls(list, scene.grains.velocity, freeVelocity, falls);
    const double expected[] = {1e-6*fall.norm(), fall.norm(), fall.norm()};
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(falls[i], expected[i], 1e-12*fall.norm()) << i;
}

TEST(ContactStep, forcesThatAreNoNumberAreRefused)
{
    nscd::ExternalForces forces;
    forces.force.assign(3, Vec3::Zero());
    forces.force[1][2] = NAN;
    EXPECT_THROW(freeList(three(), forces), std::invalid_argument);
}

TEST(ContactStep, forcesAndTorquesAreSumsOverContacts)
{
    const Scene scene = cloud(150);
    nscd::ContactList list = listContacts(scene, 0.01);
    loadContacts(list);
    std::vector<Vec3> force(list.owned(), Vec3::Zero()), torque = force;
    Vec3 onFloor = Vec3::Zero(), torqueOnFloor = Vec3::Zero();
    for (std::size_t slot : usedSlots(list))
    {
        const auto [a, b] = bodiesOf(list, slot);
        const Vec3 f = nscd::impulse(list, slot)/deltaT, n = nscd::normal(list, slot);
        force[a] += f;
        torque[a] += (-list.radius[a]*n).cross(f);
        if (list.wall[slot] >= 0)
        {
            onFloor -= f;
            torqueOnFloor += Vec3(list.position[a][0], list.position[a][1], 0).cross(-f);
            continue;
        }
        force[b] -= f;
        torque[b] += (list.radius[b]*n).cross(-f);
    }
    nscd::ContactForceSum sum(nscd::chooseKernels("auto"));
    const nscd::ContactForces& found = sum(list, {nullptr, list.blocks.size()}, partsOf(scene), deltaT);
    for (int body = 0; body < list.owned(); ++body)
    {
        EXPECT_LT((found.force[body] - force[body]).norm(), 1e-10);
        EXPECT_LT((found.torque[body] - torque[body]).norm(), 1e-11);
    }
    EXPECT_GT(onFloor.norm(), 1.0);
    EXPECT_LT((found.wall[0] - onFloor).norm(), 1e-10);
    EXPECT_LT((found.wallTorque[0] - torqueOnFloor).norm(), 1e-10);

    nscd::ContactForces onGrains = {std::vector<Vec3>(150), std::vector<Vec3>(150), {}, {}};
    nscd::giveToGrains(found, list.grainOf, onGrains);
    for (int body = 0; body < list.owned(); ++body) EXPECT_EQ(onGrains.force[list.grainOf[body]], found.force[body]);
    EXPECT_EQ(onGrains.wall, found.wall);
}

TEST(ContactStep, grainsMoveStraightAndTurnByTheirSpin)
{
    Scene scene = three();
    scene.box.length = Vec3(0.63, 0, 0);
    nscd::ContactList list = freeList(scene, nscd::ExternalForces());
    nscd::Grains grains = scene.grains;
    const double largest = nscd::moveGrains(list, grains, scene.box, deltaT, true);
    EXPECT_NEAR(largest, deltaT*scene.grains.velocity[2].norm(), 1e-15);
    for (int i = 0; i < 3; ++i)
    {
        const Vec3 x = scene.grains.position[i] + deltaT*scene.grains.velocity[i];
        EXPECT_LT((grains.position[i] - scene.box.wrap(x)).norm(), 1e-15);
        EXPECT_LT((list.position[bodyOf(list, i)] - x).norm(), 1e-15);   // not wrapped
        const Vec3 omega = scene.grains.omega[i];
        const nscd::Quaternion turned(Eigen::AngleAxisd(deltaT*omega.norm(), omega.normalized()));
        EXPECT_LT(grains.orientation[i].angularDistance(turned), 1e-7);
    }
    EXPECT_EQ(list.age, deltaT);
    nscd::Grains copied = scene.grains;
    setVelocity(list, 1, Vec3(7, 8, 9));
    nscd::copyVelocities(list, copied);
    EXPECT_EQ(copied.velocity[1], Vec3(7, 8, 9));
    EXPECT_LT((copied.omega[0] - scene.grains.omega[0]).norm(), 1e-14);
}

TEST(ContactStep, overlapsAreMeasuredOfAllAndOfLoadedContacts)
{
    Scene scene(3, 0.3, 0.0);
    for (double x : {0.0, 0.19, 0.36, 0.57}) scene.addGrain(Vec3(x, 0, 0), radius);   // overlaps of 0.01 and 0.03, and a gap
    nscd::ContactList list = listContacts(scene, 0.02);
    for (std::size_t slot : usedSlots(list))
    {
        if (list.gap[slot] > -0.02) nscd::setImpulse(list, slot, nscd::normal(list, slot));
    }
    const nscd::OverlapStatistics overlap = nscd::measureOverlap(list);
    EXPECT_NEAR(overlap.deepest, 0.03, 1e-15);
    EXPECT_NEAR(overlap.max, 0.01, 1e-15);
    EXPECT_NEAR(overlap.mean, 0.005, 1e-15);   // one of the two that carry has a gap
}

TEST(ContactStep, closedContactsReboundWithNewtonsShareOfTheirApproach)
{
    Scene scene(3, 0.0, 0.6);
    for (int i = 0; i < 3; ++i) scene.addGrain(Vec3((i == 2 ? 0.205 : 0.2)*i, 0, 0), radius);
    nscd::ContactList list = listContacts(scene, 0.02);
    setVelocity(list, 0, Vec3(2, 0, 0));
    setVelocity(list, 2, Vec3(-1, 0, 0));
    for (std::size_t k = 0; k < list.blocks.size(); ++k) list.awake.push_back(static_cast<std::uint32_t>(k));
    for (double threshold : {1.0, 3.0})
    {
        EXPECT_EQ(nscd::setRestitutionBias(list, list.bodies, threshold, 1e-3), threshold < 2.0);
        for (std::size_t slot : usedSlots(list))
        {
            const double closed = threshold < 2.0 ? -0.6*2 : 0.0, bias = list.blocks[slot/nscd::blockLanes].bias[slot % nscd::blockLanes];
            EXPECT_NEAR(bias, list.gap[slot] > 1e-3 ? nscd::unreachable : closed, 1e-15*std::abs(bias) + 1e-15);
        }
    }
}

/// Friction that is held may load a contact along its surface alone.
TEST(ContactStep, blocksAreIdleWithoutAnyContactInReachOrImpulse)
{
    Scene scene(3, 0.0, 0.6);
    for (double x : {0.0, 0.2, 0.55}) scene.addGrain(Vec3(x, 0, 0), radius);   // one pair touches, one is far apart
    nscd::ContactList list = listContacts(scene, 0.3);
    std::size_t touching = 0, apart = 0;
    for (std::size_t slot : usedSlots(list)) (list.gap[slot] < 1e-3 ? touching : apart) = slot;
    ASSERT_NE(touching/nscd::blockLanes, apart/nscd::blockLanes);
    const auto awakeWith = [&](const Vec3& impulse)
    {
        nscd::setImpulse(list, apart, impulse);
        list.awake.resize(list.blocks.size());
        std::iota(list.awake.begin(), list.awake.end(), 0u);
        nscd::setRestitutionBias(list, list.bodies, 1.0, 1e-3);
        nscd::leaveOutIdle(list);
        return list.awake;
    };
    const std::uint32_t near = static_cast<std::uint32_t>(touching/nscd::blockLanes), far = static_cast<std::uint32_t>(apart/nscd::blockLanes);
    EXPECT_EQ(awakeWith(Vec3::Zero()), std::vector<std::uint32_t>{near});
    EXPECT_EQ(awakeWith(Vec3::UnitZ()), (std::vector<std::uint32_t>{std::min(near, far), std::max(near, far)}));
}

TEST(ContactStep, aSceneIsInPlaneIfNothingLeavesItToTheBit)
{
    Scene scene(2, 0.3, 0.0);
    for (int i = 0; i < 2; ++i) scene.addGrain(Vec3(0.21*i, 5, 0), radius);
    scene.grains.velocity[1] = Vec3(1, 0, 1);
    scene.grains.omega[1] = Vec3(0, 1, 0);
    EXPECT_TRUE(nscd::isInPlane(freeList(scene, nscd::ExternalForces()), 1));
    EXPECT_FALSE(nscd::isInPlane(freeList(scene, nscd::ExternalForces()), 0));
    scene.grains.velocity[0][1] = 1e-300;
    EXPECT_FALSE(nscd::isInPlane(freeList(scene, nscd::ExternalForces()), 1));
    scene.grains.velocity[0][1] = 0.0;
    scene.grains.position[0][1] = std::nextafter(5.0, 6.0);
    EXPECT_FALSE(nscd::isInPlane(freeList(scene, nscd::ExternalForces()), 1));
}
