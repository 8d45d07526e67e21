// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Free velocities, warm start, forces and motion.
#include "contactStep.hpp"

#include "clumpMotion.hpp"
#include "contactSolver.hpp"
#include "freeRotation.hpp"
#include "invalidValue.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

/// A bias that no velocity reaches: keeps far candidates out without an infinity.
constexpr double unreachable = 1e30;

void setBody(Body& body, const Vec3& v, double invMass, const Vec3& s, double invSpin)
{
    for (int k = 0; k < 3; ++k)
    {
        body.v[k] = v[k];
        body.s[k] = s[k];
    }
    body.invMass = invMass;
    body.invSpin = invSpin;
}

} // namespace

void setFreeVelocities(ContactList& list, const Grains& grains, const ExternalForces& forces, double deltaT, const GrainSleep& sleep)
{
    const double kappa = grains.shape.inertiaFactor();
    for (int body = 0; body < list.owned(); ++body)
    {
        const int i = list.grainOf[body];
        const Vec3 spin = grains.radius[i]*grains.omega[i];
        if (grains.isFixed[i] || sleep.isAsleep(i))
        {
            setBody(list.bodies[body], grains.velocity[i], 0.0, spin, 0.0);
            continue;
        }
        const double mass = grains.mass[i];
        const double effectiveMass = forces.implicitDrag.empty() ? mass : mass + forces.implicitDrag[i]*deltaT;
        Vec3 momentum = mass*grains.velocity[i];
        if (!forces.force.empty()) momentum += deltaT*forces.force[i];
        const double spinDrag = forces.implicitSpinDrag.empty() ? 0.0 : forces.implicitSpinDrag[i];
        const double effectiveInertia = kappa*mass + spinDrag*deltaT/(grains.radius[i]*grains.radius[i]);
        Vec3 s = kappa*mass/effectiveInertia*spin;
        if (!forces.torque.empty()) s += deltaT*forces.torque[i]/(effectiveInertia*grains.radius[i]);
        if (!momentum.allFinite() || !s.allFinite() || !(effectiveMass > 0.0))
        {
            throw invalidValue("force on grain " + std::to_string(grains.id[i]), "not finite", "finite forces and drag >= 0");
        }
        setBody(list.bodies[body], momentum/effectiveMass, 1.0/effectiveMass, s, 1.0/effectiveInertia);
    }
    setBody(list.bodies.back(), Vec3::Zero(), 0.0, Vec3::Zero(), 0.0);
    list.halo.giveBodies(list.bodies);
}

bool isInPlane(const ContactList& list, int axis)
{
    const int p = (axis + 1) % 3, q = (axis + 2) % 3;
    const auto moves = [=](const Body& body) { return body.v[axis] != 0.0 || body.s[p] != 0.0 || body.s[q] != 0.0; };
    const auto isElsewhere = [&](const Vec3& x) { return x[axis] != list.position.front()[axis]; };
    return std::none_of(list.bodies.begin(), list.bodies.end(), moves) && std::none_of(list.position.begin(), list.position.end(), isElsewhere);
}

void prepareSlots(ContactList& list, const SweepKernels& kernels, double deltaT, double deadBand, double impulseScale)
{
    const LawOfStep law{deltaT, deadBand, unreachable};
    list.awake.clear();
    const std::size_t blocks = list.clumps.empty() ? list.blocks.size() : list.clumps.firstBlock;
    for (std::size_t k = 0; k < blocks; ++k)
    {
        if (kernels.setLaws(list.bodies.data(), list.blocks[k], &list.gap[k*blockLanes], law)) list.awake.push_back(static_cast<std::uint32_t>(k));
    }
    if (!list.cohesion.empty()) applyCohesion(list, deltaT, deadBand);
    kernels.startWarm(list.bodies.data(), list.blocks.data(), {list.awake.data(), list.awake.size()}, impulseScale);
    if (!list.rolling.empty()) startRolling(list, impulseScale);
    if (!list.clumps.empty()) prepareClumpSlots(list, deltaT, deadBand, unreachable, impulseScale);
    list.halo.takeVelocities(list.bodies);
}

void addWallForce(const ContactList& list, const Scene& scene, std::size_t slot, const Vec3& onGrain, std::vector<Vec3>& wall)
{
    const std::size_t patch = scene.walls.regions[list.wall[slot]].patch;
    const int a = list.blocks[slot/blockLanes].a[slot % blockLanes];
    const Vec3 point = list.position[a] - (list.radius[a] + list.gap[slot])*normal(list, slot);
    wall[patch] -= onGrain;
    wall[scene.walls.patches.size() + patch] -= (point - scene.walls.patches[patch].torquePoint).cross(onGrain);
}

ContactForces sumContactForces(const ContactList& list, BlockRange loaded, const Scene& scene, double deltaT)
{
    std::vector<Vec3> force(list.bodies.size(), Vec3::Zero()), torque = force;
    const std::size_t patches = scene.walls.patches.size();
    std::vector<Vec3> wall(2*patches, Vec3::Zero());  // forces, then torques: summed over ranks together
    const auto addLane = [&](const ContactBlock& block, int lane, std::size_t slot)
    {
        const Vec3 onA = Vec3(block.r[0][lane], block.r[1][lane], block.r[2][lane])/deltaT;
        if (onA == Vec3::Zero()) return;
        const Vec3 moment = Vec3(block.n[0][lane], block.n[1][lane], block.n[2][lane]).cross(onA);
        const int a = block.a[lane], b = block.b[lane], region = list.wall[slot];
        force[a] += onA;
        torque[a] -= list.radius[a]*moment;
        if (region >= 0)
        {
            addWallForce(list, scene, slot, onA, wall);
            return;
        }
        force[b] -= onA;
        torque[b] -= list.radius[b]*moment;
    };
    for (std::size_t k = 0; k < loaded.count; ++k)
    {
        for (int lane = 0; lane < blockLanes; ++lane) addLane(list.blocks[loaded[k]], lane, loaded[k]*blockLanes + lane);
    }
    if (!list.cohesion.empty()) addCohesionForces(list, scene, deltaT, force, wall);
    if (!list.rolling.empty()) addRollingTorques(list, scene, deltaT, torque, wall);
    list.halo.take(force);
    list.halo.take(torque);
    if (!wall.empty()) list.halo.sum(wall.front().data(), 3*static_cast<int>(wall.size()));

    const auto middle = wall.begin() + static_cast<std::ptrdiff_t>(patches);
    force.resize(list.owned());
    torque.resize(list.owned());
    return {std::move(force), std::move(torque), {wall.begin(), middle}, {middle, wall.end()}};
}

void giveToGrains(const ContactForces& onBodies, const std::vector<int>& grainOf, ContactForces& onGrains)
{
    for (std::size_t body = 0; body < grainOf.size(); ++body)
    {
        onGrains.force[grainOf[body]] = onBodies.force[body];
        onGrains.torque[grainOf[body]] = onBodies.torque[body];
    }
    onGrains.wall = onBodies.wall;
    onGrains.wallTorque = onBodies.wallTorque;
}

bool coversMotion(const ContactList& list, double deltaT, bool areWallsCovered)
{
    bool isCovered = areWallsCovered;
    for (int body = 0; body < list.owned() && isCovered; ++body)
    {
        const Vec3 travel = list.position[body] - list.positionAtBuild[body] + deltaT*Vec3(list.bodies[body].v);
        isCovered = travel.squaredNorm() <= list.reach[body]*list.reach[body];
    }
    return !list.halo.any(!isCovered);
}

void copyVelocities(const ContactList& list, Grains& grains)
{
    for (int body = 0; body < list.owned(); ++body)
    {
        const int i = list.grainOf[body];
        grains.velocity[i] = Vec3(list.bodies[body].v);
        grains.omega[i] = Vec3(list.bodies[body].s)/grains.radius[i];
    }
    if (!list.clumps.empty()) copyClumpVelocities(list, grains.clumps);
}

double moveGrains(ContactList& list, Grains& grains, const PeriodicBox& box, double deltaT, bool isRotating)
{
    double largest2 = 0.0;
    for (int body = 0; body < list.owned(); ++body)
    {
        const int i = list.grainOf[body];
        const Vec3 dx = deltaT*Vec3(list.bodies[body].v);
        largest2 = std::max(largest2, dx.squaredNorm());
        list.position[body] += dx;
        grains.position[i] = box.wrap(list.position[body]);
        if (!isRotating) continue;
        const Vec3 turn = deltaT*Vec3(list.bodies[body].s)/grains.radius[i];
        if (turn != Vec3::Zero()) grains.orientation[i] = (rotationBy(turn)*grains.orientation[i]).normalized();
    }
    if (!list.clumps.empty()) moveClumps(list, grains, box, deltaT);
    list.halo.give(list.position);
    return std::sqrt(list.halo.max(largest2));
}

OverlapStatistics measureOverlap(const ContactList& list)
{
    using Lanes = Eigen::Array<double, blockLanes, 1>;
    const auto lanes = [](const double* first) { return Eigen::Map<const Lanes>(first); };
    Lanes deepest = Lanes::Zero(), deepestLoaded = Lanes::Zero(), sum = Lanes::Zero(), count = Lanes::Zero();
    for (std::size_t k = 0; k < list.blocks.size(); ++k)
    {
        const ContactBlock& block = list.blocks[k];
        const Lanes depth = (-lanes(&list.gap[k*blockLanes])).max(0.0);
        const Lanes isLoaded = (lanes(block.r[0]).abs() + lanes(block.r[1]).abs() + lanes(block.r[2]).abs() > 0.0).cast<double>();
        deepest = deepest.max(depth);
        deepestLoaded = deepestLoaded.max(depth*isLoaded);
        sum += depth*isLoaded;
        count += isLoaded;
    }
    double sums[2] = {sum.sum(), count.sum()}, maxima[2] = {deepest.maxCoeff(), deepestLoaded.maxCoeff()};
    list.halo.sum(sums, 2);
    list.halo.max(maxima, 2);
    return {maxima[0], maxima[1], sums[1] > 0.0 ? sums[0]/sums[1] : 0.0};
}

bool setRestitutionBias(ContactList& list, const std::vector<Body>& freeBodies, double threshold, double deadBand)
{
    bool anyRebound = false;
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (!list.isUsed(slot)) continue;
        ContactBlock& block = list.blocks[slot/blockLanes];
        const int lane = slot % blockLanes;
        const Vec3 n = normal(list, slot);
        const bool isLoaded = impulse(list, slot).dot(n) > 0.0;
        const bool isClosed = isLoaded || list.gap[slot] <= deadBand;
        const double approach = -n.dot(Vec3(freeBodies[block.a[lane]].v) - Vec3(freeBodies[block.b[lane]].v));
        // Newton's law holds for closed contacts that part in the free motion too (u_n >= -e u_n^- < 0): only then does e = 1
        // keep the energy, r.(u + u^-) = 0 contact by contact. What parts in truth has r = 0.
        const bool isRebounding = isClosed && list.restitution[slot] > 0.0 && std::abs(approach) > threshold;
        // Open contacts have no say in a shock: the next step's gap rule keeps them apart.
        block.bias[lane] = isRebounding ? -list.restitution[slot]*approach : isClosed ? 0.0 : unreachable;
        anyRebound = anyRebound || isRebounding;
    }
    return list.halo.any(anyRebound);
}

} // namespace nscd
