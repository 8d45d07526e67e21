// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The pass over contacts of clumps.
#include "nscd/contacts/clumps/clumpContacts.hpp"

#include "nscd/contacts/clumps/clumpVisits.hpp"
#include "nscd/contacts/clumps/generalContact.hpp"
#include "nscd/contacts/contactList.hpp"
#include "nscd/scene/clumps.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

Vec3 inBlock(const double (&x)[3][blockLanes], int lane) { return Vec3(x[0][lane], x[1][lane], x[2][lane]); }

void setImpulse(ContactBlock& block, int lane, const Vec3& r)
{
    for (int k = 0; k < 3; ++k) block.r[k][lane] = r[k];
}

/// The two bodies of a contact, each a clump or not. Single grains have their contact at -+R n: with s = R omega, radii drop out.
template<class BodyPointer, class ClumpReference>
struct Contact
{
    BodyPointer bodies;
    ClumpReference clumps;
    const ContactBlock& block;
    int lane;
    const ClumpSlot& slot;
    Vec3 n;

    Contact(BodyPointer allBodies, ClumpReference allClumps, const ContactBlock& ofBlock, std::size_t number, int ofLane)
    :
        bodies(allBodies),
        clumps(allClumps),
        block(ofBlock),
        lane(ofLane),
        slot(allClumps.slots[(number - allClumps.firstBlock)*blockLanes + ofLane]),
        n(inBlock(ofBlock.n, ofLane))
    {}

    Vec3 velocity(int clump, const Vec3& arm, int body, double side) const
    {
        if (clump >= 0) return clumps.bodies[clump].v + clumps.bodies[clump].omega.cross(arm);
        return Vec3(bodies[body].v) - side*Vec3(bodies[body].s).cross(n);
    }

    Vec3 relativeVelocity() const
    {
        return velocity(slot.clumpA, slot.armA, block.a[lane], 1.0) - velocity(slot.clumpB, slot.armB, block.b[lane], -1.0);
    }

    /// Changes the velocities of one body by an impulse on it.
    void push(int clump, const Vec3& arm, int body, double side, const Vec3& impulse) const
    {
        if (clump >= 0)
        {
            ClumpBody& c = clumps.bodies[clump];
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
        push(slot.clumpA, slot.armA, block.a[lane], 1.0, impulse);
        push(slot.clumpB, slot.armB, block.b[lane], -1.0, -impulse);
    }
};

using MovingContact = Contact<Body*, ClumpList&>;
using ConstContact = Contact<const Body*, const ClumpList&>;

bool isUsedLane(const ContactBlock& block, int lane) { return block.invWn[lane] > 0.0; }

/// Delassus operator of one side.
Eigen::Matrix3d mobility(const ContactList& list, int clump, const Vec3& arm, int body, const Vec3& n)
{
    const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
    if (clump < 0) return list.bodies[body].invMass*one + list.bodies[body].invSpin*(one - n*n.transpose());
    const Eigen::Matrix3d cross = crossMatrix(arm);
    return list.clumps.bodies[clump].invMass*one - cross*list.clumps.bodies[clump].invInertia*cross;
}

/// Clump, if any, and arm of a contact with a body whose surface it touches at `side` R n from the body's center.
void setSide(const ContactList& list, int body, const Vec3& toContact, int& clump, Vec3& arm)
{
    const int member = body < list.owned() ? list.clumps.memberOf[body] : -1;
    clump = member >= 0 ? list.clumps.members[member].clump : -1;
    arm = member >= 0 ? Vec3(list.clumps.members[member].arm + list.radius[body]*toContact) : Vec3(Vec3::Zero());
}

void setOperator(ContactList& list, std::size_t slot)
{
    ContactBlock& block = list.blocks[slot/blockLanes];
    const int lane = slot % blockLanes;
    ClumpSlot& contact = list.clumps.slots[slot - list.clumps.firstBlock*blockLanes];
    const Vec3 n = inBlock(block.n, lane);
    setSide(list, block.a[lane], -n, contact.clumpA, contact.armA);
    setSide(list, block.b[lane], n, contact.clumpB, contact.armB);
    contact.w = mobility(list, contact.clumpA, contact.armA, block.a[lane], n)
              + mobility(list, contact.clumpB, contact.armB, block.b[lane], n);
    contact.inverse = contact.w.inverse();
    const double wn = n.dot(contact.w*n);
    block.invWn[lane] = 1.0/wn;
    block.invWt[lane] = 2.0/(contact.w.trace() - wn);
}

/// Without attraction, its tangential part in the tangent plane and the friction disc.
Vec3 admissible(const Vec3& r, const Vec3& n, double friction)
{
    const double rn = std::max(0.0, n.dot(r));
    const Vec3 t = r - n.dot(r)*n;
    const double size = t.norm(), limit = friction*rn;
    return rn*n + (size > limit ? Vec3(t*(limit/size)) : t);
}

/// Natural map of one contact in velocity units, squared.
double naturalMap(const ContactBlock& block, int lane, const Vec3& n, const Vec3& r, const Vec3& u)
{
    const double rn = n.dot(r), un = n.dot(u);
    const double normal = (rn - std::max(0.0, rn - (un + block.bias[lane])*block.invWn[lane]))/block.invWn[lane];
    const Vec3 rt = r - rn*n;
    Vec3 q = rt - (u - un*n)*block.invWt[lane];
    const double limit = block.friction[lane]*std::max(0.0, rn), size = q.norm();
    if (size > limit) q *= limit/size;
    return normal*normal + (rt - q).squaredNorm()/(block.invWt[lane]*block.invWt[lane]);
}

/// Impulse of a contact with all others held, from its present impulse and relative velocity.
template<class AnyContact>
Vec3 solved(const AnyContact& contact, const Vec3& r, const Vec3& u)
{
    const ClumpSlot& slot = contact.slot;
    const ContactBlock& block = contact.block;
    return solveCoulomb({slot.w, slot.inverse, contact.n, block.bias[contact.lane], block.friction[contact.lane]}, u - slot.w*r);
}

void add(DefectSums& sums, double defect2, bool isActive)
{
    if (isActive)
    {
        sums.sumSquares += defect2;
        sums.active += 1.0;
    }
    if (!(defect2 <= sums.maxSquare)) sums.maxSquare = defect2;
}

} // namespace

void prepareClumpSlots(ContactList& list, double deltaT, double deadBand, double unreachable, double impulseScale)
{
    for (std::size_t k = list.clumps.firstBlock; k < list.blocks.size(); ++k)
    {
        ContactBlock& block = list.blocks[k];
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            const std::size_t slot = k*blockLanes + lane;
            if (!list.isUsed(slot)) continue;
            setOperator(list, slot);
            block.bias[lane] = list.gap[slot] > deadBand ? std::min(list.gap[slot], unreachable*deltaT)/deltaT : 0.0;
            setImpulse(block, lane, admissible(impulseScale*inBlock(block.r, lane), inBlock(block.n, lane), block.friction[lane]));
        }
        // Closing is judged by the free motion, so all blocks come before any impulse.
        if (isClumpBlockActive(list.bodies.data(), list.blocks.data(), list.clumps, k)) list.awake.push_back(static_cast<std::uint32_t>(k));
    }
    for (std::size_t k = list.clumps.firstBlock; k < list.blocks.size(); ++k)
    {
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            if (!isUsedLane(list.blocks[k], lane)) continue;
            MovingContact(list.bodies.data(), list.clumps, list.blocks[k], k, lane).apply(inBlock(list.blocks[k].r, lane));
        }
    }
}

DefectSums sweepClumps(Body* bodies, ContactBlock* blocks, ClumpList& clumps, BlockRange range)
{
    DefectSums sums{0.0, 0.0, 0.0};
    for (std::size_t k = 0; k < range.count; ++k)
    {
        ContactBlock& block = blocks[range[k]];
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            if (!isUsedLane(block, lane)) continue;
            const MovingContact contact(bodies, clumps, block, range[k], lane);
            const Vec3 r = inBlock(block.r, lane), u = contact.relativeVelocity();
            if (r == Vec3::Zero() && contact.n.dot(u) + block.bias[lane] >= 0.0) continue;
            const Vec3 change = solved(contact, r, u) - r;
            add(sums, (contact.slot.w*change).squaredNorm(), true);
            contact.apply(change);
            setImpulse(block, lane, r + change);
        }
    }
    return sums;
}

DefectSums evaluateClumps(const Body* bodies, const std::vector<ContactBlock>& blocks, const ClumpList& clumps)
{
    DefectSums sums{0.0, 0.0, 0.0};
    for (std::size_t k = clumps.firstBlock; k < blocks.size(); ++k)
    {
        const ContactBlock& block = blocks[k];
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            if (!isUsedLane(block, lane)) continue;
            const ConstContact contact(bodies, clumps, block, k, lane);
            const Vec3 r = inBlock(block.r, lane), u = contact.relativeVelocity();
            const bool isActive = contact.n.dot(r) > 0.0 || contact.n.dot(u) + block.bias[lane] < 0.0;
            add(sums, naturalMap(block, lane, contact.n, r, u), isActive);
        }
    }
    return sums;
}

void replaceClumpImpulses(Body* bodies, ContactBlock* blocks, ClumpList& clumps, BlockRange range, double* target)
{
    for (std::size_t k = 0; k < range.count; ++k)
    {
        ContactBlock& block = blocks[range[k]];
        double* values = target + 3*blockLanes*k;
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            if (!isUsedLane(block, lane)) continue;
            const MovingContact contact(bodies, clumps, block, range[k], lane);
            const Vec3 wanted(values[lane], values[blockLanes + lane], values[2*blockLanes + lane]);
            const Vec3 p = admissible(wanted, contact.n, block.friction[lane]);
            contact.apply(p - inBlock(block.r, lane));
            setImpulse(block, lane, p);
            for (int axis = 0; axis < 3; ++axis) values[axis*blockLanes + lane] = p[axis];
        }
    }
}

ClumpChange clumpChange(const Body* bodies, const ContactBlock* blocks, const ClumpList& clumps, std::size_t slot)
{
    const ConstContact contact(bodies, clumps, blocks[slot/blockLanes], slot/blockLanes, slot % blockLanes);
    const Vec3 r = inBlock(contact.block.r, contact.lane);
    const Vec3 change = solved(contact, r, contact.relativeVelocity()) - r;
    return {change, (contact.slot.w*change).norm()};
}

void applyClumpChange(Body* bodies, ContactBlock* blocks, ClumpList& clumps, std::size_t slot, const Vec3& change)
{
    ContactBlock& block = blocks[slot/blockLanes];
    const MovingContact contact(bodies, clumps, block, slot/blockLanes, slot % blockLanes);
    contact.apply(change);
    setImpulse(block, contact.lane, inBlock(block.r, contact.lane) + change);
}

bool isClumpBlockActive(const Body* bodies, const ContactBlock* blocks, const ClumpList& clumps, std::size_t k)
{
    const ContactBlock& block = blocks[k];
    for (int lane = 0; lane < blockLanes; ++lane)
    {
        if (!isUsedLane(block, lane)) continue;
        if (!(block.bias[lane] > 0.0) || inBlock(block.r, lane) != Vec3::Zero()) return true;
        const ConstContact contact(bodies, clumps, block, k, lane);
        if (contact.n.dot(contact.relativeVelocity()) + block.bias[lane] < 0.0) return true;
    }
    return false;
}

} // namespace nscd
