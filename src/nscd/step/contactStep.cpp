// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Free velocities, warm start, forces and motion.
#include "nscd/step/contactStep.hpp"

#include "nscd/base/freeRotation.hpp"
#include "nscd/base/invalidValue.hpp"
#include "nscd/contacts/generalSlots.hpp"
#include "nscd/contacts/strays.hpp"
#include "nscd/contacts/wallForce.hpp"
#include "nscd/kernels/blockPrefetch.hpp"
#include "nscd/step/generalMotion.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

using Lanes = Eigen::Array<double, blockLanes, 1>;

Eigen::Map<const Lanes> lanes(const double* first) { return Eigen::Map<const Lanes>(first); }

/// Bodies are sorted in space, grains as their user numbers them: what the bodies ahead will need of theirs is asked for early.
constexpr int grainsAhead = 12;

template<class... Arrays>
void fetchAhead(const ContactList& list, int body, const Arrays&... ofGrains)
{
    if (body + grainsAhead >= list.owned()) return;
    const int i = list.grainOf[body + grainsAhead];
    (__builtin_prefetch(&ofGrains[i]), ...);
}

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

/// Whether no contact of the block carries an impulse, nor may get one.
bool isIdle(const ContactBlock& block)
{
    const auto isOut = [](double bias) { return bias >= unreachable; };
    const auto isZero = [](double component) { return component == 0.0; };
    return std::all_of(block.bias, block.bias + blockLanes, isOut) && std::all_of(&block.r[0][0], &block.r[0][0] + 3*blockLanes, isZero);
}

} // namespace

void setFreeVelocities(ContactList& list, const Grains& grains, const ExternalForces& forces, double deltaT, const GrainSleep& sleep)
{
    const double kappa = grains.shape.inertiaFactor();
    const std::vector<Vec3>& forceOf = forces.force.empty() ? grains.velocity : forces.force;
    for (int body = 0; body < list.owned(); ++body)
    {
        fetchAhead(list, body, grains.velocity, grains.omega, grains.mass, forceOf);
        const int i = list.grainOf[body];
        const double radius = list.radius[body];
        const Vec3 spin = radius*grains.omega[i];
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
        const double effectiveInertia = kappa*mass + spinDrag*deltaT/(radius*radius);
        Vec3 s = kappa*mass/effectiveInertia*spin;
        if (!forces.torque.empty()) s += deltaT*forces.torque[i]/(effectiveInertia*radius);
        if (!momentum.allFinite() || !s.allFinite() || !(effectiveMass > 0.0))
        {
            throw invalidValue("force on grain " + std::to_string(grains.id[i]), "not finite", "finite forces and drag >= 0");
        }
        setBody(list.bodies[body], momentum/effectiveMass, 1.0/effectiveMass, s, 1.0/effectiveInertia);
    }
    setBody(list.bodies.back(), Vec3::Zero(), 0.0, Vec3::Zero(), 0.0);
    list.halo.giveBodies(list.bodies);
}

void keepVelocities(const ContactList& list, std::vector<Vec3>& velocity)
{
    velocity.resize(static_cast<std::size_t>(list.owned()));
    for (std::size_t body = 0; body < velocity.size(); ++body) velocity[body] = Vec3(list.bodies[body].v);
}

void setFalls(const ContactList& list, const std::vector<Vec3>& ofGrains, const std::vector<Vec3>& freeVelocity, std::vector<double>& fall)
{
    fall.assign(ofGrains.size(), 0.0);
    for (int body = 0; body < list.owned(); ++body)
    {
        const int i = list.grainOf[body];
        const Vec3 byAll = Vec3(list.bodies[body].v) - ofGrains[i], byForces = freeVelocity[body] - ofGrains[i];
        fall[i] = std::sqrt(std::min(byAll.squaredNorm(), byForces.squaredNorm()));
    }
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
    const std::size_t blocks = list.general.empty() ? list.blocks.size() : list.general.firstBlock;
    for (std::size_t k = 0; k < blocks; ++k)
    {
        prefetch(list.bodies.data(), list.blocks.data(), {nullptr, blocks}, k);
        if (kernels.setLaws(list.bodies.data(), list.blocks[k], &list.gap[k*blockLanes], law)) list.awake.push_back(static_cast<std::uint32_t>(k));
    }
    if (!list.general.empty()) setGeneralLaws(list, deltaT, deadBand, unreachable);
    list.laws.giveKnown(list, deltaT, deadBand);
    kernels.startWarm(list.bodies.data(), list.blocks.data(), {list.awake.data(), list.awake.size()}, impulseScale);
    if (!list.general.empty()) startGeneralSlots(list, impulseScale);
    list.laws.startWarm(list, impulseScale);
    list.halo.takeVelocities(list.bodies);
    list.general.takeVelocities();
}

ContactForces& ContactForceSum::operator()(const ContactList& list, BlockRange loaded, const Scene& scene, double deltaT)
{
    // Bodies of unit mobility, at rest: their velocities are the sums of impulses, their spins those of moments over the radius.
    constexpr Body unit = {{0.0, 0.0, 0.0}, 1.0, {0.0, 0.0, 0.0}, 1.0};
    impulses_.assign(list.bodies.size(), Body());
    std::fill_n(impulses_.begin(), list.firstWallBody(), unit);
    give_(impulses_.data(), list.blocks.data(), loaded);
    std::vector<Vec3>&force = sums_.force, &torque = sums_.torque;
    force.assign(list.bodies.size(), Vec3::Zero());
    torque.assign(list.bodies.size(), Vec3::Zero());
    for (int body = 0; body < list.firstWallBody(); ++body)
    {
        force[body] = Vec3(impulses_[body].v)/deltaT;
        torque[body] = list.radius[body]*Vec3(impulses_[body].s)/deltaT;
    }

    const std::size_t patches = scene.walls.patches.size();
    std::vector<Vec3> wall(2*patches, Vec3::Zero());  // forces, then torques: summed over ranks together
    for (std::size_t k = 0; k < loaded.count; ++k)
    for (std::size_t slot = loaded[k]*blockLanes; slot < (loaded[k] + 1)*blockLanes; ++slot)
    {
        if (list.wall[slot] >= 0) addWallForce(list, scene, slot, impulse(list, slot)/deltaT, wall);
    }
    ContactSums sums{force, torque, wall};
    list.laws.addForces(list, scene, deltaT, sums);
    list.halo.take(force);
    list.halo.take(torque);
    if (!wall.empty()) list.halo.sum(wall.front().data(), 3*static_cast<int>(wall.size()));

    const auto middle = wall.begin() + static_cast<std::ptrdiff_t>(patches);
    force.resize(list.owned());
    torque.resize(list.owned());
    sums_.wall.assign(wall.begin(), middle);
    sums_.wallTorque.assign(middle, wall.end());
    return sums_;
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
    return !list.halo.any(!areWallsCovered || !findStrays(list, deltaT, 0).empty());
}

void copyVelocities(const ContactList& list, Grains& grains)
{
    for (int body = 0; body < list.owned(); ++body)
    {
        fetchAhead(list, body, grains.velocity, grains.omega);
        const int i = list.grainOf[body];
        grains.velocity[i] = Vec3(list.bodies[body].v);
        grains.omega[i] = Vec3(list.bodies[body].s)/list.radius[body];
    }
    if (!list.general.empty()) copyGeneralVelocities(list, grains);
}

double moveGrains(ContactList& list, Grains& grains, const PeriodicBox& box, double deltaT, bool isRotating)
{
    double largest2 = 0.0;
    list.age += deltaT;
    for (int body = 0; body < list.owned(); ++body)
    {
        fetchAhead(list, body, grains.position, grains.orientation);
        const int i = list.grainOf[body];
        const Vec3 dx = deltaT*Vec3(list.bodies[body].v);
        largest2 = std::max(largest2, dx.squaredNorm());
        list.position[body] += dx;
        grains.position[i] = box.wrap(list.position[body]);
        if (!isRotating) continue;
        const Vec3 turn = deltaT*Vec3(list.bodies[body].s)/list.radius[body];
        if (turn != Vec3::Zero()) grains.orientation[i] = (rotationBy(turn)*grains.orientation[i]).normalized();
    }
    if (!list.general.empty()) moveGeneral(list, grains, box, deltaT);
    list.halo.give(list.position);
    return std::sqrt(list.halo.max(largest2));
}

OverlapStatistics measureOverlap(const ContactList& list)
{
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
    // Open contacts have no say in a shock: the next step's gap rule keeps them apart.
    for (ContactBlock& block : list.blocks) std::fill_n(block.bias, blockLanes, unreachable);
    forEachAwakeSlot(list, [&](std::size_t slot)
    {
        if (!list.isUsed(slot)) return;
        ContactBlock& block = list.blocks[slot/blockLanes];
        const int lane = slot % blockLanes;
        const Vec3 n = normal(list, slot);
        const bool isInShock = isClosed(list, slot, deadBand);
        const double approach = -n.dot(Vec3(freeBodies[block.a[lane]].v) - Vec3(freeBodies[block.b[lane]].v));
        // Newton's law holds for closed contacts that part in the free motion too (u_n >= -e u_n^- < 0): only then does e = 1
        // keep the energy, r.(u + u^-) = 0 contact by contact. What parts in truth has r = 0.
        const bool isRebounding = isInShock && list.restitution[slot] > 0.0 && std::abs(approach) > threshold;
        block.bias[lane] = isRebounding ? -list.restitution[slot]*approach : isInShock ? 0.0 : unreachable;
        anyRebound = anyRebound || isRebounding;
    });
    return list.halo.any(anyRebound);
}

void leaveOutIdle(ContactList& list)
{
    const auto isLeftOut = [&](std::uint32_t k) { return isIdle(list.blocks[k]); };
    list.awake.erase(std::remove_if(list.awake.begin(), list.awake.end(), isLeftOut), list.awake.end());
}

} // namespace nscd
