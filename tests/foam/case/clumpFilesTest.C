// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Clumps through time directories: to the bit in binary; another density makes another mass; damaged ones are refused.
#include "boxMesh.H"
#include "caseTools.H"
#include "coupling/case/files/grainCloud.H"

#include "OSspecific.H"

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

using nscd::Vec3;

input::MaterialTable glassOf(double density)
{
    input::MaterialTable materials;
    materials.table.add("glass");
    materials.table.setPair(0, 0, {});
    materials.density = {density};
    materials.place = {{}};
    return materials;
}

/// A single grain between pebbles of two kinds in the unit box.
GrainState pebbles()
{
    GrainState state;
    nscd::Grains& grains = state.grains;
    const std::vector<nscd::Ball> three = {{Vec3(0, 0, 0), 0.04}, {Vec3(0.05, 0.01, 0), 0.03}, {Vec3(0.02, 0.04, 0.01), 0.035}};
    const std::vector<nscd::Ball> two = {{Vec3(0, 0, 0), 0.04}, {Vec3(0, 0.07, 0.01), 0.03}};
    for (const auto& balls : {three, two}) grains.clumps.shapes.push_back(nscd::makeClumpShape(balls, 2500, grains.shape));
    const auto add = [&](int shape, const Vec3& x)
    {
        nscd::addClump(grains, {shape, x, nscd::Quaternion(0.3, x[0], -x[1], 0.4), x/7, x/3, 0, std::int64_t(3*grains.size())}, {});
    };
    add(0, Vec3(0.2, 0.3, 0.4));
    grains.add(Vec3(0.1, 0.1, 0.9), 0.05, 2500, 0, 1000);
    add(1, Vec3(0.6, 0.3, 0.7));
    add(0, Vec3(0.6, 0.8, 0.2));
    // As a run leaves them: identities of members in a row, and values of a step.
    for (std::size_t i = 0; i < grains.size(); ++i) grains.id[i] = std::int64_t(10 + i);
    state.numbers = {{"lastDeltaT", 1e-4}};
    return state;
}

BoxMeshSettings binary()
{
    BoxMeshSettings settings;
    settings.control.add("writeFormat", word("binary"));
    return settings;
}

void write(BoxMesh& box, const GrainState& state)
{
    ++box.time();
    writeGrainState(box.mesh(), state, glassOf(2500).table, labelList(label(state.grains.size()), -1));
}

GrainState readBack(BoxMesh& box, double density = 2500)
{
    return readGrainState(box.mesh(), glassOf(density), nscd::GrainShape(), {wordList(), wordList(), {"lastDeltaT"}, 0});
}

} // namespace

TEST(ClumpFiles, giveBackEveryBit)
{
    const GrainState written = pebbles();
    BoxMesh box(binary());
    write(box, written);
    const nscd::Grains read = readBack(box).grains;
    const nscd::Clumps& found = read.clumps;
    const nscd::Clumps& expected = written.grains.clumps;
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found.shapes.size(), 2u);
    EXPECT_EQ(read.mass, written.grains.mass);
    EXPECT_EQ(found.firstMember, expected.firstMember);
    EXPECT_EQ(found.position, expected.position);
    EXPECT_EQ(found.velocity, expected.velocity);
    EXPECT_EQ(found.angularMomentum, expected.angularMomentum);
    for (std::size_t c = 0; c < 3; ++c)
    {
        EXPECT_EQ(found.orientation[c].coeffs(), expected.orientation[c].coeffs());
        EXPECT_EQ(found.shapeOf(c).mass, expected.shapeOf(c).mass);
        EXPECT_EQ(found.shapeOf(c).inertia, expected.shapeOf(c).inertia);
        ASSERT_EQ(found.shapeOf(c).members.size(), expected.shapeOf(c).members.size());
        for (std::size_t k = 0; k < found.shapeOf(c).members.size(); ++k)
        {
            EXPECT_EQ(found.shapeOf(c).members[k].center, expected.shapeOf(c).members[k].center);
        }
    }
    EXPECT_NO_THROW(nscd::checkClumps(read, {}));
}

TEST(ClumpFiles, massAndInertiaFollowThePresentDensity)
{
    const GrainState written = pebbles();
    BoxMesh box(binary());
    write(box, written);
    const nscd::Grains read = readBack(box, 5000).grains;
    EXPECT_NEAR(read.clumps.shapeOf(0).mass, 2*written.grains.clumps.shapeOf(0).mass, 1e-9);
    EXPECT_NEAR(read.clumps.shapeOf(1).inertia(0, 0), 2*written.grains.clumps.shapeOf(1).inertia(0, 0), 1e-9);
    for (std::size_t i = 0; i < read.size(); ++i) EXPECT_NEAR(read.mass[i], 2*written.grains.mass[i], 1e-9*read.mass[i]);
}

TEST(ClumpFiles, damagedOnesAreRefused)
{
    GrainState scattered = pebbles();
    scattered.grains.clumps.firstMember[1] = 5;   // in the place of the third
    BoxMesh box(binary());
    write(box, scattered);
    EXPECT_TRUE(holds(complaint([&] { readBack(box); }), {"lagrangian/clumps/origId", "names a clump"}));
    BoxMesh other(binary());
    write(other, pebbles());
    rm(other.time().timePath()/"lagrangian/clumps/mass");
    EXPECT_TRUE(holds(complaint([&] { readBack(other); }), {"lagrangian/clumps", "mass"}));
}
