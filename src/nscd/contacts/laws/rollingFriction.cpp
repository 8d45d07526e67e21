// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The pass over rolling contacts.
#include "nscd/contacts/laws/rollingFriction.hpp"

#include "nscd/contacts/contactList.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

Vec3 inDisc(const Vec3& x, double radius)
{
    const double size = x.norm();
    return size > radius ? Vec3(x*(radius/size)) : x;
}

double within(double x, double limit) { return std::max(-limit, std::min(limit, x)); }

/// One contact as its rolling law sees it.
struct Rolling
{
    Vec3 n;
    Vec3 q;        ///< [N s]
    Vec3 w;        ///< [m/s]
    double rn;     ///< >= 0 [N s]
    double wr;     ///< W_r [1/kg]
    double rollingLimit;
    double spinningLimit;

    Rolling(const Body& a, const Body& b, const ContactBlock& block, int lane, const RollingSlot& slot)
    :
        n(block.n[0][lane], block.n[1][lane], block.n[2][lane]),
        q(slot.q),
        w(slot.shareA*Vec3(a.s) - slot.shareB*Vec3(b.s)),
        rn(std::max(0.0, n.dot(Vec3(block.r[0][lane], block.r[1][lane], block.r[2][lane])))),
        wr(slot.shareA*slot.shareA*a.invSpin + slot.shareB*slot.shareB*b.invSpin),
        rollingLimit(slot.rolling*rn),
        spinningLimit(slot.spinning*rn)
    {}

    bool isIdle() const { return !(wr > 0.0); }
    Vec3 tangential(const Vec3& x) const { return x - n.dot(x)*n; }
    double spinning() const { return within(n.dot(q) - n.dot(w)/wr, spinningLimit); }
};

/// Changes of a contact's tangential impulse and of its rolling impulse, the latter turned: x' = x cross n.
struct TangentialChange
{
    Vec3 impulse;
    Vec3 turned;
};

/// In the turned variables the two laws couple by one number: u' = W_tt r - c q', w' = -c r + W_r q'.
/// Exact where the contact sticks; where it slides, one step of Gauss-Seidel between the two.
TangentialChange solveTangential
(
    const Body& a, const Body& b, const ContactBlock& block, int lane, const RollingSlot& slot, const Rolling& law
)
{
    const Vec3 rt = law.tangential(Vec3(block.r[0][lane], block.r[1][lane], block.r[2][lane]));
    const Vec3 u = law.tangential(Vec3(a.v) - Vec3(b.v)) - (Vec3(a.s) + Vec3(b.s)).cross(law.n);
    const double wt = a.invMass + b.invMass + a.invSpin + b.invSpin;
    const double c = slot.shareA*a.invSpin - slot.shareB*b.invSpin;
    const double frictionLimit = block.friction[lane]*law.rn;
    const Vec3 turnedQ = law.q.cross(law.n), turnedW = law.w.cross(law.n);

    const Vec3 sticking = inDisc(turnedQ - (turnedW + c/wt*u)/(law.wr - c*c/wt), law.rollingLimit);
    const Vec3 change = (c*(sticking - turnedQ) - u)/wt;
    if ((rt + change).norm() <= frictionLimit) return {change, sticking - turnedQ};

    const Vec3 slide = inDisc(rt - u/wt, frictionLimit) - rt;
    return {slide, inDisc(turnedQ - (turnedW - c*slide)/law.wr, law.rollingLimit) - turnedQ};
}

void add(double (&to)[3], const Vec3& change)
{
    for (int k = 0; k < 3; ++k) to[k] += change[k];
}

void applyRolling(Body& a, Body& b, const RollingSlot& slot, const Vec3& change)
{
    add(a.s, a.invSpin*slot.shareA*change);
    add(b.s, -b.invSpin*slot.shareB*change);
}

void applyTangential(Body& a, Body& b, ContactBlock& block, int lane, const Vec3& n, const Vec3& change)
{
    const Vec3 moment = n.cross(change);
    for (int k = 0; k < 3; ++k) block.r[k][lane] += change[k];
    add(a.v, a.invMass*change);
    add(b.v, -b.invMass*change);
    add(a.s, -a.invSpin*moment);
    add(b.s, -b.invSpin*moment);
}

/// Squared velocity defect.
double solveSlot(Body& a, Body& b, ContactBlock& block, int lane, RollingSlot& slot)
{
    const Rolling law(a, b, block, lane, slot);
    if (law.isIdle()) return 0.0;
    const TangentialChange change = solveTangential(a, b, block, lane, slot, law);
    const Vec3 dq = law.n.cross(change.turned) + (law.spinning() - law.n.dot(law.q))*law.n;
    const double wt = a.invMass + b.invMass + a.invSpin + b.invSpin;
    applyTangential(a, b, block, lane, law.n, change.impulse);
    applyRolling(a, b, slot, dq);
    add(slot.q, dq);
    return wt*wt*change.impulse.squaredNorm() + law.wr*law.wr*dq.squaredNorm();
}

double defect(const Body& a, const Body& b, const ContactBlock& block, int lane, const RollingSlot& slot)
{
    const Rolling law(a, b, block, lane, slot);
    if (law.isIdle()) return 0.0;
    const Vec3 q = law.tangential(law.q);
    const Vec3 rolling = inDisc(q - law.tangential(law.w)/law.wr, law.rollingLimit) - q;
    const double spinning = law.spinning() - law.n.dot(law.q);
    return law.wr*law.wr*(rolling.squaredNorm() + spinning*spinning);
}

bool isPressed(const ContactBlock& block, int lane)
{
    return block.n[0][lane]*block.r[0][lane] + block.n[1][lane]*block.r[1][lane] + block.n[2][lane]*block.r[2][lane] > 0.0;
}

/// Sums visit(block, lane, slot), a squared defect, over the slots of a range that bear something.
template<class Blocks, class Slots, class Visit>
DefectSums sumOverSlots(Blocks* blocks, Slots& slots, BlockRange range, const Visit& visit)
{
    DefectSums sums{0.0, 0.0, 0.0};
    for (std::size_t k = 0; k < range.count; ++k)
    {
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            auto& slot = slots[range[k]*blockLanes + lane];
            if (!slot.isUsed() || (!slot.isLoaded() && !isPressed(blocks[range[k]], lane))) continue;
            const double defect2 = visit(blocks[range[k]], lane, slot);
            sums.sumSquares += defect2;
            sums.maxSquare = std::max(sums.maxSquare, defect2);
        }
    }
    return sums;
}

} // namespace

void RollingFriction::set(std::size_t slot, const ContactPair& pair, double radiusA, double radiusB)
{
    RollingSlot& rolling = slots_[slot] = RollingSlot();
    rolling.rolling = pair.rollingFriction;
    rolling.spinning = pair.spinningFriction;
    rolling.shareB = radiusB > 0.0 ? radiusA/(radiusA + radiusB) : 1.0;
    rolling.shareA = radiusB > 0.0 ? 1.0 - rolling.shareB : 1.0;
}

DefectSums RollingFriction::sweep(Body* bodies, ContactBlock* blocks, BlockRange range)
{
    return sumOverSlots(blocks, slots_, range, [&](ContactBlock& block, int lane, RollingSlot& slot)
    {
        return solveSlot(bodies[block.a[lane]], bodies[block.b[lane]], block, lane, slot);
    });
}

DefectSums RollingFriction::evaluate(const Body* bodies, const ContactBlock* blocks, BlockRange range) const
{
    return sumOverSlots(blocks, slots_, range, [&](const ContactBlock& block, int lane, const RollingSlot& slot)
    {
        return defect(bodies[block.a[lane]], bodies[block.b[lane]], block, lane, slot);
    });
}

void RollingFriction::startWarm(ContactList& list, double scale)
{
    for (std::size_t k = 0; k < slots_.size(); ++k)
    {
        RollingSlot& slot = slots_[k];
        if (!slot.isLoaded()) continue;
        const ContactBlock& block = list.blocks[k/blockLanes];
        const int lane = k % blockLanes;
        Body& a = list.bodies[block.a[lane]];
        Body& b = list.bodies[block.b[lane]];
        const Rolling law(a, b, block, lane, slot);
        const Vec3 q = inDisc(scale*law.tangential(law.q), law.rollingLimit) + within(scale*law.n.dot(law.q), law.spinningLimit)*law.n;
        std::copy_n(q.data(), 3, slot.q);
        applyRolling(a, b, slot, q);
    }
}

void RollingFriction::setImpulse(std::size_t slot, const Vec3& q) { std::copy_n(q.data(), 3, slots_[slot].q); }

Vec3 RollingFriction::moment(const ContactList& list, std::size_t slot) const
{
    return list.radius[list.blocks[slot/blockLanes].a[slot % blockLanes]]*slots_[slot].shareA*Vec3(slots_[slot].q);
}

void RollingFriction::addForces(const ContactList& list, const Scene& scene, double deltaT, ContactSums& sums) const
{
    for (std::size_t slot = 0; slot < slots_.size(); ++slot)
    {
        if (!slots_[slot].isLoaded()) continue;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const Vec3 onA = moment(list, slot)/deltaT;
        sums.torque[block.a[slot % blockLanes]] += onA;
        sums.torque[block.b[slot % blockLanes]] -= onA;
        if (list.wall[slot] >= 0) sums.wall[scene.walls.patches.size() + scene.walls.regions[list.wall[slot]].patch] -= onA;
    }
}

} // namespace nscd
