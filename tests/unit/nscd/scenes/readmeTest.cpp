// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The code of src/nscd/README.md as it stands there: from an empty scene to a settled box; a stop and its continuation.
#include "nscd/tools/sceneCheckpoint.hpp"
#include "unit/nscd/scenes/sceneHash.hpp"
#include "nscd/tools/sceneParts.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>

TEST(Readme, fiveLinesSettleABox)
{
#include "readme1.inc"
    const nscd::Grains& settled = dynamics.grains();
    ASSERT_EQ(settled.size(), 512u);
    double mass = 0.0, moment = 0.0;
    for (std::size_t i = 0; i < settled.size(); ++i)
    {
        mass += settled.mass[i];
        moment += settled.mass[i]*settled.position[i].z();
        EXPECT_TRUE((settled.position[i].array() > 0.0).all() && (settled.position[i].array() < 0.1).all()) << i;
    }
    const double weight = 9.81*mass;
    // Without rolling resistance single grains roll, and spin about their contacts' normals, for long.
    std::size_t moving = 0;
    for (std::size_t i = 0; i < settled.size(); ++i) moving += settled.velocity[i].norm() > 1e-4 || settled.omega[i].norm() > 1e-2;
    EXPECT_LE(moving, 10u);
    EXPECT_NEAR(dynamics.wallForce()[0].z(), -weight, 1e-3*weight);
    // It fell from a lattice 0.1 m high at a solid fraction of 0.27 to a packing at 0.55 to 0.64 in its middle, looser at the walls.
    const double height = 2.0*moment/mass;
    const double solid = nscd::totalVolume(settled)/(0.1*0.1*height);
    EXPECT_GT(solid, 0.48);
    EXPECT_LT(solid, 0.64);

    const std::filesystem::path before = std::filesystem::current_path();
    const std::filesystem::path folder = std::filesystem::temp_directory_path()/("nscdReadme" + std::to_string(::getpid()));
    std::filesystem::create_directory(folder);
    std::filesystem::current_path(folder);
    const double time = 2.0;
    const int step = 2000;
#include "readme2.inc"
    std::filesystem::current_path(before);
    std::filesystem::remove_all(folder);
    for (nscd::GrainDynamics* each : {&dynamics, &later})
    {
        each->beginStep(1e-3);
        each->advance(nscd::gravityForces(grains, {0, 0, -9.81}, 1e-3));
    }
    EXPECT_EQ(scenes::hash(later.grains()), scenes::hash(dynamics.grains()));
}
