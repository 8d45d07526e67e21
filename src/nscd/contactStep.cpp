// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Free velocities, warm start, forces and motion.
#include "contactStep.hpp"

#include "contactSolver.hpp"
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

/// Turns last step's impulse into this step's tangent plane and friction disc.
Vec3 warmStart(const Vec3& r, const Vec3& n, double friction)
{
    const double rn = r.dot(n);
    if (!(rn > 0.0)) return Vec3::Zero();
    const Vec3 t = r - rn*n;
    const double size = t.norm();
    return rn*n + (size > friction*rn ? Vec3(t*(friction*rn/size)) : t);
}

/// Sets W and bias of a block's slots. Returns whether the block can matter in this step.
bool setLaws(ContactList& list, std::size_t k, double deltaT, double deadBand)
{
    ContactBlock& block = list.blocks[k];
    bool isAwake = false;
    for (int lane = 0; lane < blockLanes; ++lane)
    {
        const std::size_t slot = k*blockLanes + lane;
        if (!list.isUsed(slot)) continue;
        const Body& a = list.bodies[block.a[lane]];
        const Body& b = list.bodies[block.b[lane]];
        const double wn = a.invMass + b.invMass;
        block.invWn[lane] = 1.0/wn;
        block.invWt[lane] = 1.0/(wn + a.invSpin + b.invSpin);
        // A gap beyond the band may close to nothing, not to the band's edge: there, noise would open the contact again.
        block.bias[lane] = list.gap[slot] <= deadBand ? 0.0
            : list.gap[slot] < unreachable*deltaT ? list.gap[slot]/deltaT : unreachable;
        double un = 0.0;
        for (int axis = 0; axis < 3; ++axis) un += (a.v[axis] - b.v[axis])*block.n[axis][lane];
        isAwake = isAwake || block.bias[lane] == 0.0 || un + block.bias[lane] < 0.0 || impulse(list, slot) != Vec3::Zero();
    }
    return isAwake;
}

/// Gives a slot the impulse it carried in the last step, if any.
void startWarm(ContactList& list, std::size_t slot, double impulseScale)
{
    const Vec3 old = impulse(list, slot);
    if (!list.isUsed(slot) || old == Vec3::Zero()) return;
    ContactBlock& block = list.blocks[slot/blockLanes];
    const int lane = slot % blockLanes;
    const Vec3 n = normal(list, slot);
    const Vec3 r = warmStart(impulseScale*old, n, block.friction[lane]);
    setImpulse(list, slot, r);
    applyImpulse(list.bodies[block.a[lane]], list.bodies[block.b[lane]], n.data(), r.data());
}

} // namespace

void setFreeVelocities(ContactList& list, const Grains& grains, const ExternalForces& forces, double deltaT)
{
    const double kappa = grains.shape.inertiaFactor();
    for (int body = 0; body < list.owned(); ++body)
    {
        const int i = list.grainOf[body];
        const Vec3 spin = grains.radius[i]*grains.omega[i];
        if (grains.isFixed[i])
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

void prepareSlots(ContactList& list, double deltaT, double deadBand, double impulseScale)
{
    list.awake.clear();
    for (std::size_t k = 0; k < list.blocks.size(); ++k)
    {
        if (setLaws(list, k, deltaT, deadBand)) list.awake.push_back(static_cast<std::uint32_t>(k));
    }
    if (!list.cohesion.empty()) applyCohesion(list, deltaT, deadBand);
    for (std::uint32_t k : list.awake)
    {
        for (int lane = 0; lane < blockLanes; ++lane) startWarm(list, k*blockLanes + lane, impulseScale);
    }
    if (!list.rolling.empty()) startRolling(list, impulseScale);
    list.halo.takeVelocities(list.bodies);
}

ContactForces sumContactForces(const ContactList& list, const Scene& scene, double deltaT)
{
    std::vector<Vec3> force(list.bodies.size(), Vec3::Zero()), torque = force;
    std::vector<Vec3> wall(scene.walls.patches.size(), Vec3::Zero());
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (!list.isUsed(slot)) continue;
        const Vec3 r = impulse(list, slot);
        if (r == Vec3::Zero()) continue;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const Vec3 onA = r/deltaT;
        const Vec3 moment = normal(list, slot).cross(onA);
        const int a = block.a[slot % blockLanes], b = block.b[slot % blockLanes];
        force[a] += onA;
        torque[a] -= list.radius[a]*moment;
        if (list.wall[slot] >= 0)
        {
            wall[scene.walls.regions[list.wall[slot]].patch] -= onA;
            continue;
        }
        force[b] -= onA;
        torque[b] -= list.radius[b]*moment;
    }
    if (!list.cohesion.empty()) addCohesionForces(list, scene, deltaT, force, wall);
    if (!list.rolling.empty()) addRollingTorques(list, deltaT, torque);
    list.halo.take(force);
    list.halo.take(torque);
    if (!wall.empty()) list.halo.sum(wall.front().data(), 3*static_cast<int>(wall.size()));

    ContactForces sums{std::vector<Vec3>(list.owned()), std::vector<Vec3>(list.owned()), std::move(wall)};
    for (int body = 0; body < list.owned(); ++body)
    {
        sums.force[list.grainOf[body]] = force[body];
        sums.torque[list.grainOf[body]] = torque[body];
    }
    return sums;
}

bool coversMotion(const ContactList& list, double deltaT)
{
    bool isCovered = true;
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
        const double angle = turn.norm();
        if (angle > 0.0)
        {
            const Quaternion rotation(Eigen::AngleAxisd(angle, turn/angle));
            grains.orientation[i] = (rotation*grains.orientation[i]).normalized();
        }
    }
    list.halo.give(list.position);
    return std::sqrt(list.halo.max(largest2));
}

OverlapStatistics measureOverlap(const ContactList& list, double diameter)
{
    double deepest = 0.0, sums[2] = {0.0, 0.0};
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (!list.isUsed(slot) || impulse(list, slot) == Vec3::Zero()) continue;
        const double depth = std::max(0.0, -list.gap[slot])/diameter;
        deepest = std::max(deepest, depth);
        sums[0] += depth;
        sums[1] += 1.0;
    }
    list.halo.sumAndMax(sums, deepest);
    return {deepest, sums[1] > 0.0 ? sums[0]/sums[1] : 0.0};
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
