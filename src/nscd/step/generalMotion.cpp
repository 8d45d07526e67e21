// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Free velocities and motion of clumps.
#include "nscd/step/generalMotion.hpp"

#include "nscd/base/freeRotation.hpp"
#include "nscd/base/invalidValue.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

/// What acts on a clump from outside: sums over its members.
struct OuterForces
{
    Vec3 force = Vec3::Zero();     ///< [N]
    Vec3 torque = Vec3::Zero();    ///< [N m]
    double drag = 0.0;             ///< implicit [kg/s]
    double spinDrag = 0.0;         ///< implicit [N m s]

    void add(const ExternalForces& from, int grain)
    {
        if (!from.force.empty()) force += from.force[grain];
        if (!from.torque.empty()) torque += from.torque[grain];
        if (!from.implicitDrag.empty()) drag += from.implicitDrag[grain];
        if (!from.implicitSpinDrag.empty()) spinDrag += from.implicitSpinDrag[grain];
    }
};

void checkFinite(const OuterForces& outer, std::size_t clump)
{
    const bool isFinite = outer.force.allFinite() && outer.torque.allFinite() && outer.drag >= 0.0 && std::isfinite(outer.drag)
        && outer.spinDrag >= 0.0 && std::isfinite(outer.spinDrag);
    if (!isFinite) throw invalidValue("force on clump " + std::to_string(clump), "not finite", "finite forces and drag >= 0");
}

/// Where there is an empty axis nothing moves along it, or turns about another, by round-off.
void flatten(const GrainShape& shape, Vec3& v, Vec3& omega)
{
    if (shape.emptyAxis < 0) return;
    const Vec3 axis = Vec3::Unit(shape.emptyAxis);
    v = v.cwiseProduct(Vec3::Ones() - axis);
    omega = omega.cwiseProduct(axis);
}

/// The spin drag C acts along the turn of the free body: with w its midpoint spin, (J + dt C) w_free = J w, and the momentum is what that leaves.
void setFreeBody(GeneralBody& body, const Grains& grains, std::size_t c, const OuterForces& outer, double deltaT)
{
    const Clumps& clumps = grains.clumps;
    const ClumpShape& shape = clumps.shapeOf(c);
    const double mass = shape.mass + deltaT*outer.drag;
    body.invMass = 1.0/mass;
    body.v = body.freeV = outer.drag > 0.0 ? Vec3((shape.mass*clumps.velocity[c] + deltaT*outer.force)/mass)
                                           : Vec3(clumps.velocity[c] + deltaT/shape.mass*outer.force);
    body.inertia = grains.shape.dimensions == 2 ? shape.inertia : worldInertia(clumps, c);
    body.invInertia = body.inertia.inverse();
    body.freeMomentum = clumps.angularMomentum[c] + deltaT*outer.torque;
    body.freeOmega = midpointSpin(clumps.orientation[c], shape.inertia, body.freeMomentum, deltaT);
    if (outer.spinDrag > 0.0)
    {
        body.invInertia = (body.inertia + deltaT*outer.spinDrag*Eigen::Matrix3d::Identity()).inverse();
        body.freeOmega = body.invInertia*(body.inertia*body.freeOmega);
        body.freeMomentum -= deltaT*outer.spinDrag*body.freeOmega;
    }
    body.omega = body.freeOmega;
}

/// What moves as if it were part of a wall at rest.
void hold(GeneralBody& body)
{
    body.v = body.freeV = body.omega = body.freeOmega = body.freeMomentum = Vec3::Zero();
    body.invMass = 0.0;
    body.inertia = body.invInertia = Eigen::Matrix3d::Zero();
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

/// Ghosts' members stand off as their owners' do.
void giveArms(ContactList& list)
{
    if (!list.halo.isParallel()) return;
    std::vector<Vec3> arm(list.halo.bodies(), Vec3::Zero());
    for (std::size_t k = 0; k < list.general.ownMembers; ++k) arm[list.general.members[k].body] = list.general.members[k].arm;
    list.halo.give(arm);
    for (std::size_t k = list.general.ownMembers; k < list.general.members.size(); ++k)
    {
        GeneralMember& member = list.general.members[k];
        member.arm = arm[member.body];
    }
}

} // namespace

void checkGeneralBodies
(
    const Grains& grains, const PeriodicBox& box, const ContactSettings& settings, const Materials& materials
)
{
    checkClumps(grains, box);
    if (grains.clumps.empty()) return;
    if (settings.solver != "NLGS") throw invalidValue("contact solver", settings.solver, "NLGS where there are clumps");
    for (const ContactLawRow* law : lawsInUse(materials))
    {
        if (!law->isOfClumps) throw invalidValue(law->words, "set", "none where there are clumps");
    }
}

void setFreeGeneral(ContactList& list, const Grains& grains, const ExternalForces& forces, double deltaT, const GrainSleep& sleep)
{
    const Clumps& clumps = grains.clumps;
    std::vector<OuterForces> outer(list.general.own());
    for (std::size_t k = 0; k < list.general.ownMembers; ++k)
    {
        GeneralMember& member = list.general.members[k];
        outer[member.owner].add(forces, list.grainOf[member.body]);
        member.arm = clumps.orientation[list.general.clumpOf[member.owner]]*member.center;
    }
    for (std::size_t k = 0; k < list.general.own(); ++k)
    {
        const int clump = list.general.clumpOf[k];
        checkFinite(outer[k], clump);
        flatten(grains.shape, outer[k].force, outer[k].torque);
        if (sleep.isAsleep(clumps.firstMember[clump])) hold(list.general.bodies[k]);
        else setFreeBody(list.general.bodies[k], grains, clump, outer[k], deltaT);
    }
    list.general.giveBodies();
    giveArms(list);
    // No kernel moves members; whoever compares the masses of bodies finds those of clumps.
    for (const GeneralMember& member : list.general.members)
    {
        list.bodies[member.body].invMass = list.general.bodies[member.owner].invMass;
        list.bodies[member.body].invSpin = 0.0;
    }
    takeGeneralVelocities(list, grains.shape);
}

void takeGeneralVelocities(ContactList& list, const GrainShape& shape)
{
    for (GeneralBody& body : list.general.bodies) flatten(shape, body.v, body.omega);
    for (const GeneralMember& member : list.general.members)
    {
        const GeneralBody& owner = list.general.bodies[member.owner];
        setMotion(list.bodies[member.body], owner.v, owner.omega, member.arm, list.radius[member.body]);
    }
}

void mirrorFreeGeneral(const ContactList& list, std::vector<Body>& bodies)
{
    for (const GeneralMember& member : list.general.members)
    {
        const GeneralBody& owner = list.general.bodies[member.owner];
        setMotion(bodies[member.body], owner.freeV, owner.freeOmega, member.arm, list.radius[member.body]);
    }
}

void putMembers(ContactList& list, Grains& grains, const PeriodicBox& box)
{
    const Clumps& clumps = grains.clumps;
    for (std::size_t k = 0; k < list.general.ownMembers; ++k)
    {
        const GeneralMember& member = list.general.members[k];
        const int grain = list.grainOf[member.body];
        const int clump = list.general.clumpOf[member.owner];
        const Vec3 target = clumps.position[clump] + clumps.orientation[clump]*member.center;
        Vec3& position = list.position[member.body];
        position += box.nearestImage(target - position);
        grains.position[grain] = box.wrap(target);
        grains.orientation[grain] = clumps.orientation[clump];
    }
}

void moveGeneral(ContactList& list, Grains& grains, const PeriodicBox& box, double deltaT)
{
    for (std::size_t k = 0; k < list.general.own(); ++k)
    {
        displace(grains, list.general.clumpOf[k], deltaT*list.general.bodies[k].v, deltaT*list.general.bodies[k].omega, box);
    }
    putMembers(list, grains, box);
}

void displace(Grains& grains, std::size_t clump, const Vec3& shift, const Vec3& turn, const PeriodicBox& box)
{
    Clumps& clumps = grains.clumps;
    clumps.position[clump] = box.wrap(clumps.position[clump] + shift);
    if (turn == Vec3::Zero()) return;
    clumps.orientation[clump] = (rotationBy(turn)*clumps.orientation[clump]).normalized();
}

void copyGeneralVelocities(const ContactList& list, Grains& grains)
{
    Clumps& clumps = grains.clumps;
    for (std::size_t k = 0; k < list.general.own(); ++k)
    {
        const GeneralBody& body = list.general.bodies[k];
        const int clump = list.general.clumpOf[k];
        clumps.velocity[clump] = body.v;
        clumps.angularMomentum[clump] = body.freeMomentum + body.inertia*(body.omega - body.freeOmega);
    }
}

} // namespace nscd
