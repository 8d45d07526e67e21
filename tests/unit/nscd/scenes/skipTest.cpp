// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a scene does not need is left out, and nothing else changes by it: solves without contacts, spins
// without friction, the third direction of discs, memory of a list built anew.
#include "unit/nscd/scenes/heaps.hpp"

#include "nscd/contacts/contactGeometry.hpp"
#include "nscd/kernels/sweepKernels.hpp"
#include "nscd/step/contactStep.hpp"

#include <gtest/gtest.h>

#include <cstring>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3, radius = 0.01;

/// The contact problem of a scene's first step, as a step makes it.
struct FirstStep
{
    Scene scene;
    nscd::Exchange alone;
    nscd::SweepKernels kernels;
    nscd::ContactList list;

    FirstStep(Scene made, const nscd::SweepKernels& kernels, nscd::ContactList old = {})
    :
        scene(std::move(made)),
        kernels(kernels)
    {
        const nscd::Scene parts{scene.grains, scene.materials, scene.walls, scene.box};
        const std::vector<double> reach(scene.grains.size(), 0.2*radius);
        list = nscd::buildContactList(parts, nscd::WallSearch(scene.walls, 4*radius), reach, {}, 2*radius, alone, std::move(old));
        nscd::updateGeometry(list, parts);
        nscd::setFreeVelocities(list, scene.grains, weight(scene.grains, scene.g, deltaT), deltaT, nscd::GrainSleep());
        nscd::prepareSlots(list, kernels, deltaT, 2e-4*radius, 1.0);
    }
};

void expectSameBodies(const nscd::ContactList& x, const nscd::ContactList& y, double tolerance)
{
    ASSERT_EQ(x.bodies.size(), y.bodies.size());
    for (std::size_t i = 0; i < x.bodies.size(); ++i)
    {
        for (int k = 0; k < 3; ++k)
        {
            ASSERT_NEAR(x.bodies[i].v[k], y.bodies[i].v[k], tolerance);
            ASSERT_NEAR(x.bodies[i].s[k], y.bodies[i].s[k], tolerance);
        }
    }
}

} // namespace

TEST(Skip, noSolveWithoutContacts)
{
    Scene scene(3, 0.5, 0.0);
    for (int k = 0; k < 8; ++k) scene.addGrain(Vec3(k*0.021, 0, 0), radius);   // listed, but not closing
    auto dynamics = scene.build(nscd::ContactSettings());
    dynamics.beginStep(deltaT);
    EXPECT_TRUE(dynamics.hasContacts());
    const nscd::StepReport report = dynamics.advance(weight(scene.grains, scene.g, deltaT));
    EXPECT_EQ(report.solve.sweeps, 0);
    EXPECT_EQ(report.solve.contacts, 0u);
    EXPECT_TRUE(report.solve.converged);
    for (const Vec3& v : dynamics.grains().velocity) EXPECT_EQ(v, (scene.grains.mass[0]*Vec3::Zero() + deltaT*(scene.grains.mass[0]*scene.g))/scene.grains.mass[0]);
}

TEST(Skip, nothingTurnsWithoutFriction)
{
    const Scene scene = heap(3, 4, 5, radius, 0.7, 0.0);
    auto dynamics = scene.build(nscd::ContactSettings());
    std::size_t contacts = 0;
    for (int k = 0; k < 80; ++k) contacts = std::max(contacts, step(dynamics, scene.g, deltaT).solve.contacts);
    EXPECT_GT(contacts, 50u);
    for (const Vec3& omega : dynamics.grains().omega) ASSERT_EQ(omega, Vec3::Zero());
}

TEST(Skip, discKernelsDoWhatThoseOfSpheresDo)
{
    for (const char* path : {"portable", "AVX2", "AVX512"})
    {
        nscd::SweepKernels kernels{};
        try { kernels = nscd::chooseKernels(path); }
        catch (const std::invalid_argument&) { continue; }
        for (int axis = 0; axis < 3; ++axis)
        {
            // The heap lies in the plane normal to y: turned into the others.
            Scene scene = heap(2, 12, 12, radius, 0.6, 0.4);
            const auto turn = [axis](const Vec3& x) { return axis == 0 ? Vec3(x[1], x[2], x[0]) : axis == 1 ? x : Vec3(x[2], x[0], x[1]); };
            for (std::size_t i = 0; i < scene.grains.size(); ++i)
            {
                Vec3& x = scene.grains.position[i];
                scene.grains.velocity[i] = turn(-500*x);
                scene.grains.omega[i] = turn(Vec3(0, 300*x[0], 0));
                x = turn(0.8*x);
            }
            for (nscd::WallRegion& wall : scene.walls.regions)
            {
                wall.normal = turn(wall.normal);
                wall.point = turn(wall.point);
            }
            scene.g = turn(scene.g);
            FirstStep general(scene, kernels), planar(scene, nscd::planar(kernels, axis));
            ASSERT_TRUE(nscd::isInPlane(planar.list, axis));
            ASSERT_FALSE(nscd::isInPlane(planar.list, (axis + 1) % 3));
            for (int sweep = 0; sweep < 5; ++sweep)
            {
                const nscd::BlockRange all{nullptr, general.list.blocks.size()};
                for (nscd::SweepFunction nscd::SweepKernels::* f : {&nscd::SweepKernels::evaluate, &nscd::SweepKernels::sweep})
                {
                    const nscd::DefectSums a = (general.kernels.*f)(general.list.bodies.data(), general.list.blocks.data(), all);
                    const nscd::DefectSums b = (planar.kernels.*f)(planar.list.bodies.data(), planar.list.blocks.data(), all);
                    EXPECT_NEAR(a.sumSquares, b.sumSquares, 1e-10*a.sumSquares) << path;
                    EXPECT_NEAR(a.maxSquare, b.maxSquare, 1e-10*a.maxSquare) << path;
                    EXPECT_EQ(a.active, b.active) << path;
                    EXPECT_GT(a.active, 100.0);
                }
                expectSameBodies(general.list, planar.list, 1e-11);
            }
        }
    }
}

TEST(Skip, discsMoveAsInSpace)
{
    Scene scene = heap(2, 6, 6, radius, 0.6, 0.4);
    auto inSpace = scene.build();
    scene.grains.shape.emptyAxis = 1;
    auto inPlane = scene.build();
    for (int k = 0; k < 60; ++k)
    {
        step(inSpace, scene.g, deltaT);
        step(inPlane, scene.g, deltaT);
    }
    EXPECT_GT(inPlane.contacts().size(), 15u);
    for (std::size_t i = 0; i < scene.grains.size(); ++i)
    {
        ASSERT_NEAR((inSpace.grains().position[i] - inPlane.grains().position[i]).norm(), 0.0, 1e-5*radius);
        ASSERT_EQ(inPlane.grains().velocity[i][1], 0.0);
    }
}

TEST(Skip, whatLeavesThePlaneIsNotCutOff)
{
    Scene scene(2, 0.4, 0.0);
    scene.grains.shape.emptyAxis = 1;
    scene.addGrain(Vec3::Zero(), radius);
    scene.addGrain(Vec3(1.95, 0.5, 0)*radius, radius);
    scene.grains.velocity[0] = Vec3(1, 0, 0);
    auto dynamics = scene.build();
    step(dynamics, Vec3::Zero(), deltaT);
    EXPECT_LT(dynamics.grains().velocity[0][1], -0.05);
    EXPECT_GT(dynamics.grains().velocity[1][1], 0.05);
}

TEST(Skip, aListInOldMemoryIsTheSame)
{
    const FirstStep fresh(heap(3, 5, 5, radius, 0.6, 0.4), nscd::chooseKernels("auto"));
    FirstStep other(heap(3, 6, 4, radius, 0.5, 0.3), nscd::chooseKernels("auto"));
    const FirstStep again(heap(3, 5, 5, radius, 0.6, 0.4), nscd::chooseKernels("auto"), std::move(other.list));
    ASSERT_EQ(fresh.list.blocks.size(), again.list.blocks.size());
    for (std::size_t k = 0; k < fresh.list.blocks.size(); ++k)
    {
        ASSERT_EQ(std::memcmp(&fresh.list.blocks[k], &again.list.blocks[k], sizeof(nscd::ContactBlock)), 0) << "block " << k;
    }
    EXPECT_EQ(fresh.list.wall, again.list.wall);
    EXPECT_EQ(fresh.list.image, again.list.image);
    EXPECT_EQ(fresh.list.id, again.list.id);
    EXPECT_EQ(fresh.list.candidates, again.list.candidates);
    EXPECT_EQ(fresh.list.slotsOfWalls, again.list.slotsOfWalls);
    expectSameBodies(fresh.list, again.list, 0.0);
}
