// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The pass over contacts of general bodies.
#include "nscd/contacts/general/generalSweep.hpp"

#include "nscd/contacts/general/generalContact.hpp"
#include "nscd/contacts/general/generalPair.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

/// Natural map of one contact in velocity units: squared, and its work with the impulse.
struct Defect
{
    double square;   ///< [m2/s2]
    double work;     ///< [J]
};

Defect naturalMap(const ContactBlock& block, int lane, const Vec3& n, const Vec3& r, const Vec3& u, bool isFrictionHeld)
{
    const double rn = n.dot(r), un = n.dot(u);
    const double normal = (std::max(0.0, rn - (un + block.bias[lane])*block.invWn[lane]) - rn)/block.invWn[lane];
    const Vec3 rt = r - rn*n;
    Vec3 q = rt - (u - un*n)*block.invWt[lane];
    const double limit = block.friction[lane]*(isFrictionHeld ? 1.0 : std::max(0.0, rn)), size = q.norm();
    if (size > limit) q *= limit/size;
    const Vec3 tangential = (q - rt)/block.invWt[lane];
    return {normal*normal + tangential.squaredNorm(), rn*normal + rt.dot(tangential)};
}

/// Impulse of a contact with all others held, from its present impulse and relative velocity.
template<class AnyContact>
Vec3 solved(const AnyContact& contact, const Vec3& r, const Vec3& u)
{
    const GeneralSlot& slot = contact.slot;
    const ContactBlock& block = contact.block;
    const GeneralContact local{slot.w, slot.inverse, contact.n, block.bias[contact.lane], block.friction[contact.lane]};
    return contact.general.isFrictionHeld ? approachTresca(local, r, u) : solveCoulomb(local, u - slot.w*r);
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

Vec3 admissible(const Vec3& r, const Vec3& n, double friction)
{
    const double rn = std::max(0.0, n.dot(r));
    const Vec3 t = r - n.dot(r)*n;
    const double size = t.norm(), limit = friction*rn;
    return rn*n + (size > limit ? Vec3(t*(limit/size)) : t);
}

void giveGeneralImpulses(Body* bodies, const ContactBlock* blocks, GeneralBodies& general, std::size_t k)
{
    for (int lane = 0; lane < blockLanes; ++lane)
    {
        if (!isUsedLane(blocks[k], lane)) continue;
        MovingContact(bodies, general, blocks[k], k, lane).apply(inBlock(blocks[k].r, lane));
    }
}

DefectSums sweepGeneral(Body* bodies, ContactBlock* blocks, GeneralBodies& general, BlockRange range)
{
    DefectSums sums{0.0, 0.0, 0.0};
    for (std::size_t k = 0; k < range.count; ++k)
    {
        ContactBlock& block = blocks[range[k]];
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            if (!isUsedLane(block, lane)) continue;
            const MovingContact contact(bodies, general, block, range[k], lane);
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

DefectSums evaluateGeneral(const Body* bodies, const std::vector<ContactBlock>& blocks, const GeneralBodies& general)
{
    DefectSums sums{0.0, 0.0, 0.0};
    for (std::size_t k = general.firstBlock; k < blocks.size(); ++k)
    {
        const ContactBlock& block = blocks[k];
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            if (!isUsedLane(block, lane)) continue;
            const ConstContact contact(bodies, general, block, k, lane);
            const Vec3 r = inBlock(block.r, lane), u = contact.relativeVelocity();
            const bool isActive = contact.n.dot(r) > 0.0 || contact.n.dot(u) + block.bias[lane] < 0.0;
            const Defect defect = naturalMap(block, lane, contact.n, r, u, general.isFrictionHeld);
            add(sums, defect.square, isActive);
            sums.work += defect.work;
        }
    }
    return sums;
}

void replaceGeneralImpulses(Body* bodies, ContactBlock* blocks, GeneralBodies& general, BlockRange range, double* target)
{
    for (std::size_t k = 0; k < range.count; ++k)
    {
        ContactBlock& block = blocks[range[k]];
        double* values = target + 3*blockLanes*k;
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            if (!isUsedLane(block, lane)) continue;
            const MovingContact contact(bodies, general, block, range[k], lane);
            const Vec3 wanted(values[lane], values[blockLanes + lane], values[2*blockLanes + lane]);
            const Vec3 p = admissible(wanted, contact.n, block.friction[lane]);
            contact.apply(p - inBlock(block.r, lane));
            setImpulse(block, lane, p);
            for (int axis = 0; axis < 3; ++axis) values[axis*blockLanes + lane] = p[axis];
        }
    }
}

GeneralChange generalChange(const Body* bodies, const ContactBlock* blocks, const GeneralBodies& general, std::size_t slot)
{
    const ConstContact contact(bodies, general, blocks[slot/blockLanes], slot/blockLanes, slot % blockLanes);
    const Vec3 r = inBlock(contact.block.r, contact.lane);
    const Vec3 change = solved(contact, r, contact.relativeVelocity()) - r;
    return {change, (contact.slot.w*change).norm()};
}

void pushGeneral(Body* bodies, const ContactBlock* blocks, GeneralBodies& general, std::size_t slot, const Vec3& impulse)
{
    MovingContact(bodies, general, blocks[slot/blockLanes], slot/blockLanes, slot % blockLanes).apply(impulse);
}

void applyGeneralChange(Body* bodies, ContactBlock* blocks, GeneralBodies& general, std::size_t slot, const Vec3& change)
{
    ContactBlock& block = blocks[slot/blockLanes];
    const MovingContact contact(bodies, general, block, slot/blockLanes, slot % blockLanes);
    contact.apply(change);
    setImpulse(block, contact.lane, inBlock(block.r, contact.lane) + change);
}

bool isGeneralBlockActive(const Body* bodies, const ContactBlock* blocks, const GeneralBodies& general, std::size_t k)
{
    const ContactBlock& block = blocks[k];
    for (int lane = 0; lane < blockLanes; ++lane)
    {
        if (!isUsedLane(block, lane)) continue;
        if (!(block.bias[lane] > 0.0) || inBlock(block.r, lane) != Vec3::Zero()) return true;
        const ConstContact contact(bodies, general, block, k, lane);
        if (contact.n.dot(contact.relativeVelocity()) + block.bias[lane] < 0.0) return true;
    }
    return false;
}

} // namespace nscd
