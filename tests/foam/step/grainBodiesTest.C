// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Clumps among grains as the bodies that the fluid acts on; their rows of weights, volume and duality; their end at exits.
#include "coupling/case/walls/grainExits.H"
#include "coupling/step/grainBodies.H"
#include "mappingTools.H"

#include "nscd/scene/clumpForm.hpp"

#include <gtest/gtest.h>

#include <numeric>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

const std::vector<::nscd::Ball> pebble = {{Vec3(0, 0, 0), 0.4}, {Vec3(0.5, 0.1, 0), 0.3}, {Vec3(0.2, 0.4, 0.1), 0.35}};
const std::vector<::nscd::Ball> dumbbell = {{Vec3(-0.3, 0, 0), 0.3}, {Vec3(0.3, 0, 0), 0.3}};

/// A sphere, a pebble, a sphere, a dumbbell: 7 grains, 4 bodies.
::nscd::Grains mixed()
{
    ::nscd::Grains grains;
    for (const auto& members : {pebble, dumbbell}) grains.clumps.shapes.push_back(::nscd::makeClumpShape(members, 2500, grains.shape));
    const auto addClump = [&](int shape, const Vec3& x, const ::nscd::Quaternion& turn)
    {
        ::nscd::addClump(grains, {shape, x, turn, Vec3(1, 2, 3), Vec3(0.1, -0.2, 0.3), 0, std::int64_t(grains.size())}, {});
    };
    grains.add(Vec3(1.1, 1.2, 1.3), 0.5, 2500, 0, 0);
    addClump(0, Vec3(2.5, 2.6, 2.4), ::nscd::Quaternion(0.5, 0.3, -0.2, 0.6));
    grains.add(Vec3(1.1, 3.2, 1.3), 0.2, 2500, 0, 4);
    addClump(1, Vec3(1.9, 1.6, 3.4), ::nscd::Quaternion(0.9, 0.1, 0.4, 0.2));
    return grains;
}

scalar sumOf(const std::vector<scalar>& values) { return std::accumulate(values.begin(), values.end(), scalar(0)); }

} // namespace

TEST(GrainBodies, withoutClumpsAreTheGrains)
{
    const ::nscd::Grains grains = makeGrains({Vec3(1, 1, 1), Vec3(2, 2, 2)}, 0.3);
    GrainBodies bodies;
    bodies.update(grains);
    EXPECT_TRUE(bodies.areGrains());
    EXPECT_EQ(&bodies.grains(), &grains);
    EXPECT_EQ(bodies.forms(), nullptr);
    EXPECT_TRUE(bodies.parts().empty());
}

TEST(GrainBodies, areSpheresOfTheClumpsVolumeAtTheirMassCenters)
{
    const ::nscd::Grains grains = mixed();
    GrainBodies bodies;
    bodies.update(grains);
    const ::nscd::Grains& found = bodies.grains();
    ASSERT_EQ(found.size(), 4u);
    EXPECT_EQ(found.id, (std::vector<std::int64_t>{0, 1, 4, 5}));
    EXPECT_EQ(found.position[1], grains.clumps.position[0]);
    EXPECT_EQ(found.velocity[3], Vec3(1, 2, 3));
    EXPECT_EQ(found.mass[1], grains.clumps.shapes[0].mass);
    EXPECT_EQ(found.radius[0], 0.5);
    const scalar volume = ::nscd::unionOfBalls(pebble).volume;
    EXPECT_NEAR(found.volume(1), volume, 1e-14);
    EXPECT_NEAR(found.mass[1], 2500*volume, 1e-10);
    EXPECT_EQ(bodies.parts().bodyOf, (std::vector<label>{0, 1, 1, 1, 2, 3, 3}));
    for (label body = 0; body < 4; ++body)
    {
        scalar sum = 0;
        for (std::size_t i = 0; i < 7; ++i) sum += bodies.parts().bodyOf[i] == body ? bodies.parts().share[i] : 0;
        EXPECT_NEAR(sum, 1, 1e-15);
    }
}

TEST(GrainBodies, giveAndTakeValuesOfGrains)
{
    const ::nscd::Grains grains = mixed();
    GrainBodies bodies;
    bodies.update(grains);
    ::nscd::ExternalForces external;
    external.force = {Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0), Vec3(4, 0, 0)};
    external.implicitDrag = {1, 2, 3, 4};
    const ::nscd::ExternalForces onGrains = bodies.onGrains(external);
    EXPECT_EQ(onGrains.implicitDrag, (std::vector<double>{1, 2, 0, 0, 3, 4, 0}));
    EXPECT_EQ(onGrains.force[5], Vec3(4, 0, 0));
    EXPECT_TRUE(onGrains.torque.empty());
    // What is given to the members comes back as their sum.
    EXPECT_EQ(bodies.sums(onGrains.force), external.force);
    const std::vector<Vec3> all(7, Vec3(1, 1, 1));
    EXPECT_EQ(bodies.sums(all)[1], Vec3(3, 3, 3));
    GrainExtras extras;
    extras.scalars["T"] = {10, 20, 30, 40};
    EXPECT_EQ(bodies.toGrains(extras).scalars.at("T"), (std::vector<scalar>{10, 20, 20, 20, 30, 40, 40}));
    EXPECT_EQ(bodies.ofFirstGrains(bodies.toGrains(extras)).scalars.at("T"), extras.scalars.at("T"));
    EXPECT_EQ(bodies.bodiesOf({1, 2, 3, 4}), (std::vector<std::size_t>{1, 2}));
}

// Sum of the members' rows by their volumes; the cells get the volume of the union, and sample what they spread.
TEST(GrainBodies, areLaidDownMemberByMember)
{
    BoxMeshSettings settings = unitCells(labelVector(5, 5, 5));
    shake(settings, 0.2);
    BoxMesh box(settings);
    const fvMesh& mesh = box.mesh();
    const ::nscd::Grains grains = mixed();
    GrainBodies bodies;
    bodies.update(grains);
    for (const scalar diffusion : {0.0, 1.5})
    {
        dictionary dict;
        dict.add("diffusionLength", diffusion);
        GrainMapping mapping(mesh, dict), ofMembers(mesh, dict);
        mapping.update(grains, {}, bodies.parts());
        ofMembers.update(grains, {});
        EXPECT_TRUE(mapping.hasBodies());
        const scalar volume = grains.volume(0) + grains.volume(4) + ::nscd::unionOfBalls(pebble).volume + ::nscd::unionOfBalls(dumbbell).volume;
        EXPECT_NEAR(sumOf(mapping.volumes()), volume, 1e-13*volume);
        EXPECT_NEAR(mapping.report().volumeDeposited, volume, 1e-12*volume);
        EXPECT_LT(mapping.report().volumeDeposited, ofMembers.report().volumeDeposited - 0.01);

        const scalarField field = randomField(mesh.nCells(), 5);
        std::vector<scalar> found, members;
        mapping.sample(field, found);
        ofMembers.sample(field, members);
        ASSERT_EQ(found.size(), 4u);
        const scalar total = 0.4*0.4*0.4 + 0.3*0.3*0.3 + 0.35*0.35*0.35;
        EXPECT_NEAR(found[1], (0.064*members[1] + 0.027*members[2] + 0.042875*members[3])/total, 1e-13);
        EXPECT_NEAR(found[3], 0.5*(members[5] + members[6]), 1e-13);

        const std::vector<scalar> amounts = {1, -2, 3, 5};
        scalarField spread;
        mapping.spread(amounts, spread);
        scalar sampled = 0;
        for (std::size_t i = 0; i < 4; ++i) sampled += amounts[i]*found[i];
        EXPECT_NEAR(sum(mesh.V().field()*spread*field), sampled, 1e-9);
        EXPECT_NEAR(sum(mesh.V().field()*spread), sumOf(amounts), 1e-12);
    }
}

TEST(GrainBodies, leaveAsWholes)
{
    ::nscd::Grains grains = mixed();
    const ExitedGrains exited = withWholeClumps(grains, {{0, 2}, labelList({5, 4})});
    EXPECT_EQ(exited.grains, (std::vector<std::size_t>{0, 1, 2, 3}));
    EXPECT_EQ(exited.patches, labelList({5, 4, 4, 4}));
    eraseGrains(grains, exited.grains);
    ASSERT_EQ(grains.size(), 3u);
    ASSERT_EQ(grains.clumps.size(), 1u);
    EXPECT_EQ(grains.clumps.firstMember[0], 1);
    EXPECT_NO_THROW(::nscd::checkClumps(grains, {}));
    GrainBodies bodies;
    bodies.update(grains);
    EXPECT_EQ(bodies.grains().id, (std::vector<std::int64_t>{4, 5}));
    eraseGrains(grains, {1, 2});
    bodies.update(grains);
    EXPECT_TRUE(bodies.areGrains());
}
