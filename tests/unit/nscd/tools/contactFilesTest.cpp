// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of contacts as they are shown: states and places that are known beforehand, and what is read back from the files.
#include "nscd/tools/contactFiles.hpp"

#include "nscd/base/vtkPolyData.hpp"
#include "unit/nscd/scenes/lawScenes.hpp"
#include "unit/nscd/tools/vtpFile.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include <unistd.h>

using namespace scenes;
using nscd::ContactState;
using nscd::ShownContact;

namespace
{

constexpr double deltaT = 1e-3, radius = 0.01;

std::string temporary(const std::string& name) { return std::filesystem::temp_directory_path()/("contactFilesTest." + std::to_string(::getpid()) + "." + name); }

std::vector<ShownContact> contactsOf(const nscd::GrainDynamics& dynamics)
{
    std::vector<ShownContact> contacts = nscd::shownContacts(dynamics.grains(), dynamics.contacts(), deltaT);
    nscd::sortByIdentity(contacts);
    return contacts;
}

/// A sphere on a floor, pushed along it by `push` of its weight; a torque keeps it from rolling.
ContactState stateOfPushed(double push, double friction)
{
    Scene scene(3, friction, 0.0);
    scene.addGrain(Vec3(0, 0, radius), radius);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    auto dynamics = scene.build();
    const nscd::Grains& grains = dynamics.grains();
    for (int k = 0; k < 3; ++k)
    {
        nscd::ExternalForces forces = weight(grains, scene.g, deltaT);
        const double along = push*grains.mass[0]*gravity;
        forces.force[0] += along*Vec3::UnitX();
        forces.torque.assign(1, std::min(along, friction*grains.mass[0]*gravity)*radius*-Vec3::UnitY());
        dynamics.beginStep(deltaT);
        dynamics.advance(forces);
    }
    return contactsOf(dynamics).at(0).state;
}

/// Two spheres, the upper one listed first, on a floor.
Scene stack()
{
    Scene scene(3, 0.3, 0.0);
    scene.grains.add(Vec3(0, 0, 3*radius), radius, 2500, 0, 9);
    scene.grains.add(Vec3(0, 0, radius), radius, 2500, 0, 4);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    return scene;
}

/// It at rest.
struct SettledStack
{
    Scene scene = stack();
    nscd::GrainDynamics dynamics = scene.build();
    std::vector<ShownContact> contacts;

    SettledStack()
    {
        for (int k = 0; k < 5; ++k) step(dynamics, scene.g, deltaT);
        contacts = contactsOf(dynamics);
    }
};

} // namespace

TEST(ShownContacts, stickUpToTheFrictionAndSlipBeyond)
{
    EXPECT_EQ(stateOfPushed(0.29, 0.3), ContactState::stick);
    EXPECT_EQ(stateOfPushed(0.31, 0.3), ContactState::slip);
    EXPECT_EQ(stateOfPushed(0.0, 0.3), ContactState::stick);
    EXPECT_EQ(stateOfPushed(0.0, 0.0), ContactState::slip);
}

TEST(ShownContacts, thatAttractAcrossAGapAreOpen)
{
    Scene scene(3, 0.3, 0.0);
    for (int a = 0; a < 2; ++a)
    {
        for (int b = 0; b < 2; ++b) scene.materials.setPair(a, b, cohesivePair(0.3, 0.0, 1e-4, radius));
    }
    scene.g = Vec3::Zero();
    scene.addGrain(Vec3(0, 0, 0), radius);
    scene.addGrain(Vec3(0, 0, 2.4*radius), radius);
    auto dynamics = scene.build();
    step(dynamics, scene.g, deltaT);
    const std::vector<ShownContact> contacts = contactsOf(dynamics);
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_EQ(contacts[0].state, ContactState::open);
    EXPECT_NEAR(contacts[0].gap, 0.4*radius, 0.01*radius);
    EXPECT_GT(contacts[0].force[2], 0);
}

TEST(ShownContacts, areOnTheLowerIdentityAndBetweenTheSurfaces)
{
    const SettledStack settled;
    const std::vector<ShownContact>& contacts = settled.contacts;
    ASSERT_EQ(contacts.size(), 2u);
    const double weight = settled.dynamics.grains().mass[0]*gravity;
    const ShownContact& floor = contacts[0];
    const ShownContact& pair = contacts[1];
    EXPECT_EQ(floor.idA, 4);
    EXPECT_EQ(floor.idB, -1);
    EXPECT_LT((floor.point - Vec3::Zero()).norm(), 1e-3*radius);
    EXPECT_NEAR(floor.force[2], 2*weight, 1e-6*weight);
    EXPECT_NEAR(floor.impulse[2], 2*weight*deltaT, 1e-6*weight*deltaT);
    EXPECT_EQ(pair.idA, 4);
    EXPECT_EQ(pair.idB, 9);
    EXPECT_NEAR(pair.force[2], -weight, 1e-6*weight);
    EXPECT_NEAR(pair.normal[2], -1, 1e-12);
    EXPECT_LT((pair.centerA - Vec3(0, 0, radius)).norm(), 1e-3*radius);
    EXPECT_LT((pair.centerB - Vec3(0, 0, 3*radius)).norm(), 1e-3*radius);
    EXPECT_LT((pair.point - 0.5*(pair.centerA + pair.centerB)).norm(), 1e-12*radius);
}

TEST(ShownContacts, throughAPeriodicSideReachTheImage)
{
    Scene scene(3, 0.3, 0.0);
    scene.box = nscd::PeriodicBox{Vec3(0, 0, 0), Vec3(0.1, 0, 0)};
    scene.g = Vec3::Zero();
    scene.addGrain(Vec3(0.995, 0, 0)*0.1, radius);
    scene.addGrain(Vec3(0.195, 0, 0)*0.1, radius);
    scene.grains.velocity[0] = Vec3(0.1, 0, 0);
    auto dynamics = scene.build();
    step(dynamics, scene.g, deltaT);
    const std::vector<ShownContact> contacts = contactsOf(dynamics);
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_NEAR((contacts[0].centerA - contacts[0].centerB).norm(), 2*radius + contacts[0].gap, 1e-12);
    EXPECT_LT(std::abs(contacts[0].centerB[0] - contacts[0].centerA[0] - 2*radius), 1e-3*radius);
}

TEST(ContactFiles, holdWhatIsShown)
{
    const SettledStack settled;
    const std::vector<ShownContact>& contacts = settled.contacts;
    const std::string path = temporary("vtp");
    nscd::writeContactPoints(path, 0.005, contacts);
    const vtp::VtpFile points(path);
    EXPECT_EQ(points.number("NumberOfPoints"), 2);
    EXPECT_EQ(points.number("NumberOfVerts"), 2);
    EXPECT_EQ(points.array<double>("position")[5], contacts[1].point[2]);
    EXPECT_EQ(points.array<double>("normal")[5], contacts[1].normal[2]);
    EXPECT_EQ(points.array<double>("force")[2], contacts[0].force[2]);
    EXPECT_EQ(points.array<double>("impulse")[2], contacts[0].impulse[2]);
    EXPECT_EQ(points.array<std::int64_t>("idB"), (std::vector<std::int64_t>{-1, 9}));
    EXPECT_EQ(points.array<int>("kind"), (std::vector<int>{1, 0}));
    EXPECT_EQ(points.array<int>("state"), (std::vector<int>{1, 1}));
    nscd::writeForceChains(path, 0.005, contacts);
    const vtp::VtpFile lines(path);
    EXPECT_EQ(lines.number("NumberOfPoints"), 4);
    EXPECT_EQ(lines.number("NumberOfLines"), 2);
    EXPECT_EQ(lines.array<std::int64_t>("offsets"), (std::vector<std::int64_t>{2, 4}));
    EXPECT_EQ(lines.array<double>("position")[8], contacts[1].centerA[2]);
    EXPECT_EQ(lines.array<double>("position")[11], contacts[1].centerB[2]);
    EXPECT_EQ(lines.array<double>("forceMagnitude")[1], contacts[1].force.norm());
    std::filesystem::remove(path);
}

TEST(ContactFiles, ofNoContactsAreWholeToo)
{
    const std::string path = temporary("none.vtp");
    nscd::writeContactPoints(path, 0, {});
    EXPECT_EQ(vtp::VtpFile(path).number("NumberOfPoints"), 0);
    EXPECT_TRUE(vtp::VtpFile(path).array<double>("force").empty());
    std::filesystem::remove(path);
}
