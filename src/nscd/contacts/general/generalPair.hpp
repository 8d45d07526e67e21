// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The two bodies of a contact with a general one: their relative motion at it, and what pushes them.
// Tested by tests/unit/nscd/contacts/general/generalSweepTest.cpp, tests/unit/nscd/contacts/general/generalMomentsTest.cpp
#pragma once

#include "nscd/contacts/general/generalBodies.hpp"
#include "nscd/kernels/contactBlock.hpp"

namespace nscd
{

inline Vec3 inBlock(const double (&x)[3][blockLanes], int lane) { return Vec3(x[0][lane], x[1][lane], x[2][lane]); }

inline void setImpulse(ContactBlock& block, int lane, const Vec3& r)
{
    for (int k = 0; k < 3; ++k) block.r[k][lane] = r[k];
}

/// The two bodies of a contact, each a general one or not. Single grains have their contact at -+R n: with s = R omega, radii drop out.
template<class BodyPointer, class GeneralReference>
struct GeneralPair
{
    BodyPointer bodies;
    GeneralReference general;
    const ContactBlock& block;
    int lane;
    const GeneralSlot& slot;
    Vec3 n;

    GeneralPair(BodyPointer allBodies, GeneralReference allGeneral, const ContactBlock& ofBlock, std::size_t number, int ofLane)
    :
        bodies(allBodies),
        general(allGeneral),
        block(ofBlock),
        lane(ofLane),
        slot(allGeneral.slots[(number - allGeneral.firstBlock)*blockLanes + ofLane]),
        n(inBlock(ofBlock.n, ofLane))
    {}

    Vec3 velocity(int owner, const Vec3& arm, int body, double side) const
    {
        if (owner >= 0) return general.bodies[owner].v + general.bodies[owner].omega.cross(arm);
        return Vec3(bodies[body].v) - side*Vec3(bodies[body].s).cross(n);
    }

    Vec3 relativeVelocity() const
    {
        return velocity(slot.ownerA, slot.armA, block.a[lane], 1.0) - velocity(slot.ownerB, slot.armB, block.b[lane], -1.0);
    }

    /// Changes the velocities of one body by an impulse on it.
    void push(int owner, const Vec3& arm, int body, double side, const Vec3& impulse) const
    {
        if (owner >= 0)
        {
            GeneralBody& c = general.bodies[owner];
            c.v += c.invMass*impulse;
            c.omega += c.invInertia*arm.cross(impulse);
            return;
        }
        Body& b = bodies[body];
        const Vec3 moment = side*n.cross(impulse);
        for (int k = 0; k < 3; ++k)
        {
            b.v[k] += b.invMass*impulse[k];
            b.s[k] -= b.invSpin*moment[k];
        }
    }

    void apply(const Vec3& impulse) const
    {
        push(slot.ownerA, slot.armA, block.a[lane], 1.0, impulse);
        push(slot.ownerB, slot.armB, block.b[lane], -1.0, -impulse);
    }
};

using MovingContact = GeneralPair<Body*, GeneralBodies&>;
using ConstContact = GeneralPair<const Body*, const GeneralBodies&>;

inline bool isUsedLane(const ContactBlock& block, int lane) { return block.invWn[lane] > 0.0; }

} // namespace nscd
