// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a scene does not need is left out, and nothing else changes by it: solves without contacts, sweeps over isolated pairs, spins
// without friction, the third direction of discs, memory of a list built anew.
#include "unit/nscd/scenes/heaps.hpp"

#include "nscd/contacts/contactGeometry.hpp"
#include "nscd/kernels/sweepKernels.hpp"
#include "nscd/solvers/contactSolver.hpp"
#include "nscd/solvers/help/isolatedPairs.hpp"
#include "nscd/step/contactStep.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <map>

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

    /// As if the first blocks held isolated contacts.
    nscd::SolveReport solve(std::size_t isolatedBlocks)
    {
        nscd::ContactProblem problem
        {
            list.bodies, list.blocks, list.awake, list.interfaceBlock, list.halo, kernels, true, deltaT, gravity*deltaT, 2*radius, list.position
        };
        return nscd::solveBesideIsolated(problem, isolatedBlocks, tight(), nscd::solveNlgs);
    }
};

/// Pairs that collide, grains that hit a floor, and a triple, all far from one another.
Scene scattered()
{
    Scene scene(3, 0.4, 0.0);
    for (int k = 0; k < 30; ++k)
    {
        const Vec3 x(k*0.1, 0, 1.0);
        scene.addGrain(x, radius);
        scene.addGrain(x + Vec3(0.3, 0.2, 1.98).normalized()*1.905*radius, 0.9*radius);
        scene.grains.velocity[2*k] = Vec3(0.1, 0.05*k, 1.0);
        scene.grains.omega[2*k] = Vec3(3, 2, 0.1*k);
    }
    for (int k = 0; k < 5; ++k)
    {
        scene.addGrain(Vec3(k*0.1, 1, 1.0001*radius), radius);
        scene.grains.velocity.back() = Vec3(0.2, 0, -0.3);
    }
    for (int k = 0; k < 3; ++k) scene.addGrain(Vec3(k*1.99*radius, 2, 1.0), radius);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    return scene;
}

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

TEST(Skip, isolatedContactsAreThoseWhoseGrainsHaveNoOther)
{
    const FirstStep step(scattered(), nscd::chooseKernels("auto"));
    std::map<int, int> number;
    std::size_t isolated = 0;
    const auto grains = [&](std::size_t slot)
    {
        const nscd::ContactBlock& block = step.list.blocks[slot/nscd::blockLanes];
        std::vector<int> bodies{block.a[slot % nscd::blockLanes]};
        if (step.list.wall[slot] < 0) bodies.push_back(block.b[slot % nscd::blockLanes]);
        return bodies;
    };
    for (std::size_t slot = 0; slot < step.list.slots(); ++slot)
    {
        if (!step.list.isUsed(slot)) continue;
        for (int body : grains(slot)) ++number[body];
    }
    for (std::size_t slot = 0; slot < step.list.slots(); ++slot)
    {
        if (!step.list.isUsed(slot)) continue;
        bool isAlone = true;
        for (int body : grains(slot)) isAlone = isAlone && number[body] == 1;
        EXPECT_EQ(slot/nscd::blockLanes < step.list.isolatedBlocks, isAlone);
        isolated += isAlone;
    }
    EXPECT_EQ(isolated, 35u);
    EXPECT_EQ(step.list.candidates, 37u);
}

TEST(Skip, isolatedContactsGetTheSameImpulsesAsBySweeps)
{
    FirstStep apart(scattered(), nscd::chooseKernels("auto")), swept(scattered(), nscd::chooseKernels("auto"));
    const nscd::SolveReport one = apart.solve(apart.list.isolatedBlocks), other = swept.solve(0);
    EXPECT_EQ(one.isolated, 35u);
    EXPECT_EQ(other.isolated, 0u);
    EXPECT_EQ(one.contacts, other.contacts);
    EXPECT_TRUE(one.converged && other.converged);
    expectSameBodies(apart.list, swept.list, 1e-14);
    EXPECT_EQ(apart.list.awake, swept.list.awake);
}

TEST(Skip, pairsAloneTakeNoSweep)
{
    Scene scene = scattered();
    Scene pairs(3, 0.4, 0.0);
    for (std::size_t i = 0; i < 60; ++i)
    {
        pairs.addGrain(scene.grains.position[i], scene.grains.radius[i]);
        pairs.grains.velocity[i] = scene.grains.velocity[i];
    }
    auto dynamics = pairs.build();
    const nscd::StepReport report = step(dynamics, pairs.g, deltaT);
    EXPECT_EQ(report.solve.sweeps, 0);
    EXPECT_EQ(report.solve.isolated, 30u);
    EXPECT_EQ(report.solve.contacts, 30u);
    EXPECT_EQ(dynamics.contacts().size(), 30u);
    for (const nscd::LoadedContact& c : dynamics.contacts()) EXPECT_GE(c.gap, -1e-9*radius);
}

TEST(Skip, heldGrainsJoinNothing)
{
    Scene scene(3, 0.4, 0.0);
    scene.addGrain(Vec3::Zero(), radius);
    scene.grains.isFixed[0] = 1;
    for (const Vec3& n : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(-Vec3::UnitX())})
    {
        scene.addGrain(2*radius*n, radius);
        scene.grains.velocity.back() = -0.5*n;
    }
    auto dynamics = scene.build();
    const nscd::StepReport report = step(dynamics, Vec3::Zero(), deltaT);
    EXPECT_EQ(report.solve.isolated, 3u);
    EXPECT_EQ(report.solve.sweeps, 0);
    for (std::size_t i = 1; i < 4; ++i) EXPECT_NEAR(dynamics.grains().velocity[i].norm(), 0.0, 1e-12);
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
