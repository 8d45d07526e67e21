// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Hash of a serial run, with and without a stop in the middle, and checkpoint files that are not what they should be.
#include "unit/fileSizeLimit.hpp"
#include "unit/nscd/scenes/heaps.hpp"
#include "unit/nscd/scenes/sceneHash.hpp"
#include "nscd/tools/sceneCheckpoint.hpp"
#include "nscd/tools/sceneParts.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3;
constexpr int nSteps = 250, nBefore = 100;

/// Polydisperse spheres that fall against a tilted corner, with friction and restitution, periodic along y.
Scene collapse()
{
    Scene scene(3, 0.4, 0.5);
    nscd::addLattice(scene.grains, {{0, 0, 0}, {0.1, 0.08, 0.12}, {5, 4, 6}, 0.016, 0.2, 0.6, 3}, 2500.0, 0);
    for (std::size_t i = 0; i < scene.grains.size(); i += 3) scene.grains.omega[i] = Vec3(1, -2, 30);
    scene.grains.isFixed[5] = 1;
    scene.box.length[1] = 0.08;
    scene.g = gravity*Vec3(-0.4, 0.1, -0.9).normalized();
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.addPlane(Vec3::Zero(), Vec3::UnitX());
    return scene;
}

struct Outcome
{
    std::uint64_t grains;
    std::uint64_t contacts;
    std::size_t nContacts;
};

void run(nscd::GrainDynamics& dynamics, const Scene& scene, int first, int last)
{
    for (int k = first; k < last; ++k) step(dynamics, scene.g, deltaT);
}

Outcome outcome(const nscd::GrainDynamics& dynamics)
{
    const std::vector<nscd::LoadedContact> contacts = dynamics.contacts();
    return {hash(dynamics.grains()), hash(contacts), contacts.size()};
}

/// A run that writes a checkpoint in its middle and goes on.
Outcome runThrough(const Scene& scene, const std::string& path)
{
    auto dynamics = scene.build(nscd::ContactSettings());
    run(dynamics, scene, 0, nBefore);
    nscd::writeCheckpoint(path, nscd::takeState(dynamics, nBefore*deltaT, nBefore));
    run(dynamics, scene, nBefore, nSteps);
    return outcome(dynamics);
}

/// A run from a checkpoint, in a library of its own.
Outcome runOn(Scene scene, const nscd::SceneState& state)
{
    scene.grains = state.grains;
    auto dynamics = scene.build(nscd::ContactSettings());
    dynamics.restore(state.impulses, state.lastDeltaT);
    run(dynamics, scene, nBefore, nSteps);
    return outcome(dynamics);
}

class Checkpoint : public testing::Test
{
protected:
    void SetUp() override
    {
        const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
        folder = std::filesystem::temp_directory_path()/("nscdCheckpoint." + name + std::to_string(::getpid()));
        std::filesystem::create_directory(folder);
        path = folder/"state";
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    nscd::SceneState smallState() const
    {
        nscd::SceneState state;
        nscd::addLattice(state.grains, {{0, 0, 0}, {1, 1, 1}, {2, 2, 3}, 0.1}, 2500.0, 0);
        state.impulses.push_back({0, -1, Vec3(1, 2, 3)});
        state.materials = {"glass", "steel"};
        return state;
    }

    std::string bytes() const
    {
        std::ifstream file(path, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    }

    void expectRefused(const std::string& content, const std::string& problem) const
    {
        std::ofstream(path, std::ios::binary) << content;
        try
        {
            nscd::readCheckpoint(path);
            ADD_FAILURE() << "was read: " << problem;
        }
        catch (const std::invalid_argument& error)
        {
            EXPECT_NE(std::string(error.what()).find(problem), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
        }
    }

    std::filesystem::path folder;
    std::string path;
};

} // namespace

TEST_F(Checkpoint, aRunRepeatsToTheBitAndGoesOnToTheBit)
{
    const Scene scene = collapse();
    const Outcome first = runThrough(scene, path);
    const Outcome second = runThrough(scene, path);
    EXPECT_GT(first.nContacts, 80u);
    EXPECT_EQ(second.grains, first.grains);
    EXPECT_EQ(second.contacts, first.contacts);

    const nscd::SceneState state = nscd::readCheckpoint(path);
    EXPECT_EQ(state.step, nBefore);
    EXPECT_EQ(state.time, nBefore*deltaT);
    EXPECT_GT(state.impulses.size(), 30u);
    const Outcome continued = runOn(scene, state);
    EXPECT_EQ(continued.grains, first.grains);
    EXPECT_EQ(continued.contacts, first.contacts);

    // What the hash must notice: the last bit of one coordinate, and impulses that were lost.
    nscd::SceneState changed = state;
    double& x = changed.grains.position[50].x();
    x = std::nextafter(x, 1.0);
    EXPECT_NE(runOn(scene, changed).grains, first.grains);
    changed = state;
    changed.impulses.clear();
    EXPECT_NE(runOn(scene, changed).contacts, first.contacts);
}

TEST_F(Checkpoint, holdsEveryBit)
{
    nscd::SceneState state = smallState();
    state.grains.shape = {2, 0.25};
    state.grains.orientation[3] = nscd::Quaternion(0.5, -0.5, 0.5, -0.0);
    state.grains.velocity[2] = Vec3(-0.0, 5e-324, 1.0/3.0);
    state.grains.isFixed[7] = 1;
    state.grains.material[1] = 1;
    state.grains.id[4] = 1234567890123456789LL;
    state.time = 1.0/3.0;
    state.step = 9876543210LL;
    state.lastDeltaT = 1e-3;
    state.nextId = 77;
    state.entryNames = {"pour"};
    state.entries = {{5, 3, 42, 1.0/3.0, 0.1}};
    nscd::writeCheckpoint(path, state);
    const nscd::SceneState back = nscd::readCheckpoint(path);
    EXPECT_EQ(hash(back.grains), hash(state.grains));
    EXPECT_EQ(back.grains.radius, state.grains.radius);
    EXPECT_EQ(back.grains.mass, state.grains.mass);
    EXPECT_EQ(back.grains.material, state.grains.material);
    EXPECT_EQ(back.grains.id, state.grains.id);
    EXPECT_EQ(back.grains.isFixed, state.grains.isFixed);
    EXPECT_EQ(back.grains.nOwned, state.grains.size());
    EXPECT_EQ(back.grains.shape.dimensions, 2);
    EXPECT_EQ(back.grains.shape.thickness, 0.25);
    EXPECT_EQ(back.time, state.time);
    EXPECT_EQ(back.step, state.step);
    EXPECT_EQ(back.lastDeltaT, state.lastDeltaT);
    EXPECT_EQ(back.materials, state.materials);
    EXPECT_EQ(back.nextId, 77);
    EXPECT_EQ(back.entryNames, state.entryNames);
    ASSERT_EQ(back.entries.size(), 1u);
    EXPECT_EQ(back.entries[0].due, 5);
    EXPECT_EQ(back.entries[0].entered, 3);
    EXPECT_EQ(back.entries[0].tried, 42);
    EXPECT_EQ(back.entries[0].dueMass, 1.0/3.0);
    EXPECT_EQ(back.entries[0].enteredMass, 0.1);
    ASSERT_EQ(back.impulses.size(), 1u);
    EXPECT_EQ(back.impulses[0].idB, -1);
    EXPECT_EQ(back.impulses[0].impulse, Vec3(1, 2, 3));
    EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST_F(Checkpoint, refusesWhatIsMissingOrForeign)
{
    EXPECT_THROW(nscd::readCheckpoint(folder/"none"), std::invalid_argument);
    EXPECT_THROW(nscd::readCheckpoint(folder), std::invalid_argument);
    expectRefused("", "another kind of file");
    expectRefused("nscd", "another kind of file");
    expectRefused("FoamFile { version 2.0; }", "another kind of file");
    nscd::writeCheckpoint(path, smallState());
    std::string file = bytes();
    std::swap(file[8], file[15]);
    expectRefused(file, "byte order");
    std::swap(file[8], file[15]);
    file[16] = 9;
    expectRefused(file, "version 9");
}

TEST_F(Checkpoint, refusesCutsAndChangedBytes)
{
    nscd::writeCheckpoint(path, smallState());
    const std::string whole = bytes();
    for (std::size_t length = 0; length < whole.size(); length += length < 32 ? 1 : 101)
    {
        std::ofstream(path, std::ios::binary) << whole.substr(0, length);
        EXPECT_THROW(nscd::readCheckpoint(path), std::invalid_argument) << length;
    }
    expectRefused(whole.substr(0, whole.size() - 1), "cut short");
    expectRefused(whole + "x", "longer");
    for (std::size_t k = 0; k < whole.size(); k += k < 32 ? 1 : 29)
    {
        std::string changed = whole;
        changed[k] = static_cast<char>(changed[k] ^ (k % 2 ? 0x80 : 0x01));
        std::ofstream(path, std::ios::binary) << changed;
        EXPECT_THROW(nscd::readCheckpoint(path), std::invalid_argument) << "byte " << k;
    }
    // Two signs at once: a sum that loses its top bits would not notice.
    std::string changed = whole;
    changed[whole.size() - 9] = static_cast<char>(changed[whole.size() - 9] ^ 0x80);
    changed[whole.size() - 17] = static_cast<char>(changed[whole.size() - 17] ^ 0x80);
    expectRefused(changed, "checksum");
}

TEST_F(Checkpoint, aFullDiskIsAnErrorAndLeavesTheOldFile)
{
    nscd::writeCheckpoint(path, smallState());
    const std::string before = bytes();
    nscd::SceneState large = smallState();
    nscd::addLattice(large.grains, {{0, 0, 1}, {1, 1, 2}, {30, 30, 30}, 0.01}, 2500.0, 0);

    std::string message;
    try
    {
        const FileSizeLimit limit(100000);
        ASSERT_TRUE(limit.isSet());
        nscd::writeCheckpoint(path, large);
    }
    catch (const std::runtime_error& error)
    {
        message = error.what();
    }
    EXPECT_NE(message.find("cannot write " + path), std::string::npos) << message;
    EXPECT_NE(message.find("too large"), std::string::npos) << message;
    EXPECT_EQ(bytes(), before);
    EXPECT_FALSE(std::filesystem::exists(path + ".part"));
    EXPECT_THROW(nscd::writeCheckpoint(folder/"none"/"state", large), std::runtime_error);
}
