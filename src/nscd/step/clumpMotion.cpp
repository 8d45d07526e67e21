// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Free velocities and motion of clumps.
#include "nscd/step/clumpMotion.hpp"

#include "nscd/base/freeRotation.hpp"
#include "nscd/base/invalidValue.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

void refuseDrag(const Grains& grains, const std::vector<double>& drag, int grain)
{
    if (drag.empty() || drag[grain] == 0.0) return;
    throw invalidValue("implicit drag on grain " + std::to_string(grains.id[grain]), drag[grain], "0 for members of clumps");
}

/// Where there is an empty axis nothing moves along it, or turns about another, by round-off.
void flatten(const GrainShape& shape, Vec3& v, Vec3& omega)
{
    if (shape.emptyAxis < 0) return;
    const Vec3 axis = Vec3::Unit(shape.emptyAxis);
    v = v.cwiseProduct(Vec3::Ones() - axis);
    omega = omega.cwiseProduct(axis);
}

void setMotion(Body& body, const Vec3& v, const Vec3& omega, const Vec3& arm, double radius)
{
    const Vec3 x = v + omega.cross(arm), s = radius*omega;
    for (int k = 0; k < 3; ++k)
    {
        body.v[k] = x[k];
        body.s[k] = s[k];
    }
}

} // namespace

void measureClumps(const Clumps& clumps, double (&extremes)[2])
{
    for (std::size_t c = 0; c < clumps.size(); ++c)
    {
        extremes[0] = std::max(extremes[0], clumps.shapeOf(c).mass);
        extremes[1] = std::max(extremes[1], 1.0/clumps.shapeOf(c).mass);
    }
}

void setFreeClumps(ContactList& list, const Grains& grains, const ExternalForces& forces, double deltaT)
{
    const Clumps& clumps = grains.clumps;
    std::vector<Vec3> force(clumps.size(), Vec3::Zero()), torque = force;
    for (ClumpMember& member : list.clumps.members)
    {
        const int grain = list.grainOf[member.body];
        refuseDrag(grains, forces.implicitDrag, grain);
        refuseDrag(grains, forces.implicitSpinDrag, grain);
        if (!forces.force.empty()) force[member.clump] += forces.force[grain];
        if (!forces.torque.empty()) torque[member.clump] += forces.torque[grain];
        member.arm = clumps.orientation[member.clump]*member.center;
    }
    for (std::size_t c = 0; c < clumps.size(); ++c)
    {
        ClumpBody& body = list.clumps.bodies[c];
        const ClumpShape& shape = clumps.shapeOf(c);
        body.invMass = 1.0/shape.mass;
        body.inertia = grains.shape.dimensions == 2 ? shape.inertia : worldInertia(clumps, c);
        body.invInertia = body.inertia.inverse();
        flatten(grains.shape, force[c], torque[c]);
        body.freeMomentum = clumps.angularMomentum[c] + deltaT*torque[c];
        body.v = body.freeV = clumps.velocity[c] + deltaT/shape.mass*force[c];
        body.omega = body.freeOmega = midpointSpin(clumps.orientation[c], shape.inertia, body.freeMomentum, deltaT);
    }
    // No kernel moves members; whoever compares the masses of bodies finds those of clumps.
    for (const ClumpMember& member : list.clumps.members)
    {
        list.bodies[member.body].invMass = list.clumps.bodies[member.clump].invMass;
        list.bodies[member.body].invSpin = 0.0;
    }
    takeClumpVelocities(list, grains.shape);
}

void takeClumpVelocities(ContactList& list, const GrainShape& shape)
{
    for (ClumpBody& clump : list.clumps.bodies) flatten(shape, clump.v, clump.omega);
    for (const ClumpMember& member : list.clumps.members)
    {
        const ClumpBody& clump = list.clumps.bodies[member.clump];
        setMotion(list.bodies[member.body], clump.v, clump.omega, member.arm, list.radius[member.body]);
    }
}

void mirrorFreeClumps(const ContactList& list, std::vector<Body>& bodies)
{
    for (const ClumpMember& member : list.clumps.members)
    {
        const ClumpBody& clump = list.clumps.bodies[member.clump];
        setMotion(bodies[member.body], clump.freeV, clump.freeOmega, member.arm, list.radius[member.body]);
    }
}

void putMembers(ContactList& list, Grains& grains, const PeriodicBox& box)
{
    const Clumps& clumps = grains.clumps;
    for (const ClumpMember& member : list.clumps.members)
    {
        const int grain = list.grainOf[member.body];
        const Vec3 target = clumps.position[member.clump] + clumps.orientation[member.clump]*member.center;
        Vec3& position = list.position[member.body];
        position += box.nearestImage(target - position);
        grains.position[grain] = box.wrap(target);
        grains.orientation[grain] = clumps.orientation[member.clump];
    }
}

void moveClumps(ContactList& list, Grains& grains, const PeriodicBox& box, double deltaT)
{
    Clumps& clumps = grains.clumps;
    for (std::size_t c = 0; c < clumps.size(); ++c)
    {
        const ClumpBody& body = list.clumps.bodies[c];
        clumps.position[c] = box.wrap(clumps.position[c] + deltaT*body.v);
        if (body.omega == Vec3::Zero()) continue;
        clumps.orientation[c] = (rotationBy(deltaT*body.omega)*clumps.orientation[c]).normalized();
    }
    putMembers(list, grains, box);
}

void copyClumpVelocities(const ContactList& list, Clumps& clumps)
{
    for (std::size_t c = 0; c < clumps.size(); ++c)
    {
        const ClumpBody& body = list.clumps.bodies[c];
        clumps.velocity[c] = body.v;
        clumps.angularMomentum[c] = body.freeMomentum + body.inertia*(body.omega - body.freeOmega);
    }
}

} // namespace nscd
