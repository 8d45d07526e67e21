// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Impulse and moment of one contact, and the pass over all.
#include "nscd/contacts/general/generalMoments.hpp"

#include "nscd/contacts/general/generalPair.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

using Eigen::Matrix3d;
using Directions = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;

/// Rounds of impulse and moment where the latter is at its limit: one is exact for spheres, and sweeps go on where these end.
constexpr int roundsAtLimit = 8;

Vec3 tangent(const Vec3& n)
{
    const Vec3 helper = std::abs(n[0]) < 0.6 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
    return n.cross(helper).normalized();
}

/// Along which a contact may bear a moment.
Directions directions(const MomentContact& contact)
{
    const Vec3 &n = contact.coulomb.n, t = tangent(n);
    Directions d(3, (contact.across > 0.0 ? 2 : 0) + (contact.along > 0.0 ? 1 : 0));
    if (contact.across > 0.0)
    {
        d.col(0) = t;
        d.col(1) = n.cross(t);
    }
    if (contact.along > 0.0) d.col(d.cols() - 1) = n;
    return d;
}

/// Both if the moment may be of any size.
BorneByContact withoutTurning(const MomentContact& contact, const Vec3& uFree, const Vec3& wFree)
{
    const Directions d = directions(contact);
    const Matrix3d& k = contact.moment.coupling;
    const Matrix3d hold = d*(d.transpose()*contact.moment.mobility*d).inverse()*d.transpose();
    GeneralContact held = contact.coulomb;
    held.w -= k*hold*k.transpose();
    held.inverse = held.w.inverse();
    const Vec3 r = solveCoulomb(held, uFree - k*(hold*wFree));
    return {r, -(hold*(wFree + k.transpose()*r))};
}

/// The larger of both mobilities in the tangent plane: with it a step of the moment's tangential part never goes too far.
double largestAcross(const Matrix3d& s, const Vec3& n)
{
    const Vec3 t = tangent(n), b = n.cross(t);
    const double tt = t.dot(s*t), bb = b.dot(s*b), tb = t.dot(s*b), half = 0.5*(tt - bb);
    return 0.5*(tt + bb) + std::sqrt(half*half + tb*tb);
}

/// One step towards the moment of an impulse that is held, first in the tangent plane.
Vec3 stepOfMoment(const MomentContact& contact, const Vec3& q, const Vec3& w, double rn)
{
    const Vec3& n = contact.coulomb.n;
    const Matrix3d& s = contact.moment.mobility;
    const Vec3 wt = w - n.dot(w)*n;
    const Vec3 moved = admissibleMoment(q - wt/largestAcross(s, n), n, contact.across*rn, contact.along*rn);
    const double turning = n.dot(w + s*(moved - q));
    return admissibleMoment(moved - turning/n.dot(s*n)*n, n, contact.across*rn, contact.along*rn);
}

/// R' times the relative angular velocity.
template<class Pair>
Vec3 turning(const Pair& pair, const LawBlock& law, double reducedRadius)
{
    const auto ofSide = [&](int owner, int body, int share)
    {
        return owner >= 0 ? Vec3(reducedRadius*pair.general.bodies[owner].omega) : Vec3(law.of[share][pair.lane]*Vec3(pair.bodies[body].s));
    };
    return ofSide(pair.slot.ownerA, pair.block.a[pair.lane], momentLaw::shareA) - ofSide(pair.slot.ownerB, pair.block.b[pair.lane], momentLaw::shareB);
}

void turn(const MovingContact& pair, const LawBlock& law, double reducedRadius, const Vec3& q)
{
    const auto give = [&](int owner, int body, int share, const Vec3& on)
    {
        if (owner >= 0)
        {
            GeneralBody& general = pair.general.bodies[owner];
            general.omega += general.invInertia*(reducedRadius*on);
            return;
        }
        Body& single = pair.bodies[body];
        for (int k = 0; k < 3; ++k) single.s[k] += single.invSpin*law.of[share][pair.lane]*on[k];
    };
    give(pair.slot.ownerA, pair.block.a[pair.lane], momentLaw::shareA, q);
    give(pair.slot.ownerB, pair.block.b[pair.lane], momentLaw::shareB, -q);
}

std::size_t slotBehind(const GeneralBodies& general, std::size_t block, int lane) { return (block - general.firstBlock)*blockLanes + lane; }

void add(DefectSums& sums, double square, bool isActive)
{
    sums.sumSquares += square;
    if (isActive) sums.active += 1.0;
    if (!(square <= sums.maxSquare)) sums.maxSquare = square;
}

/// Solves the contact of one lane.
void sweepLane(const MovingContact& pair, ContactBlock& block, LawBlock& law, const GeneralMoment& moment, DefectSums& sums)
{
    const int lane = pair.lane;
    const Vec3 r = inBlock(block.r, lane), q = inBlock(law.q, lane), u = pair.relativeVelocity();
    if (r == Vec3::Zero() && q == Vec3::Zero() && pair.n.dot(u) + block.bias[lane] >= 0.0) return;
    const Matrix3d &w = pair.slot.w, &k = moment.coupling;
    const MomentContact contact
    {
        {w, pair.slot.inverse, pair.n, block.bias[lane], block.friction[lane]}, moment, law.of[momentLaw::across][lane], law.of[momentLaw::along][lane]
    };
    const Vec3 uFree = u - w*r - k*q, wFree = turning(pair, law, moment.reducedRadius) - k.transpose()*r - moment.mobility*q;
    const BorneByContact next = solveWithMoment(contact, uFree, wFree, q);
    add(sums, (w*(next.r - r)).squaredNorm(), true);
    add(sums, (moment.mobility*(next.q - q)).squaredNorm(), false);
    pair.apply(next.r - r);
    turn(pair, law, moment.reducedRadius, next.q - q);
    setImpulse(block, lane, next.r);
    for (int axis = 0; axis < 3; ++axis) law.q[axis][lane] = next.q[axis];
}

/// The natural map of a contact's moment, squared, with half the trace of S in the tangent plane for its mobility there.
double naturalMap(const ConstContact& pair, const LawBlock& law, const GeneralMoment& moment)
{
    const int lane = pair.lane;
    const Vec3 &n = pair.n, q = inBlock(law.q, lane), w = turning(pair, law, moment.reducedRadius);
    const double rn = std::max(0.0, n.dot(inBlock(pair.block.r, lane)));
    const double sn = n.dot(moment.mobility*n), st = 0.5*(moment.mobility.trace() - sn), wn = n.dot(w);
    const Vec3 wanted = q - (w - wn*n)/st - wn/sn*n;
    const Vec3 miss = admissibleMoment(wanted, n, law.of[momentLaw::across][lane]*rn, law.of[momentLaw::along][lane]*rn) - q;
    const double along = n.dot(miss);
    return st*st*(miss - along*n).squaredNorm() + sn*sn*along*along;
}

} // namespace

Vec3 admissibleMoment(const Vec3& q, const Vec3& n, double across, double along)
{
    const double qn = n.dot(q);
    const Vec3 t = q - qn*n;
    const double size = t.norm();
    return (size > across ? Vec3(t*(across/size)) : t) + std::clamp(qn, -along, along)*n;
}

BorneByContact solveWithMoment(const MomentContact& contact, const Vec3& uFree, const Vec3& wFree, const Vec3& present)
{
    const GeneralContact& coulomb = contact.coulomb;
    if (!(contact.across > 0.0) && !(contact.along > 0.0)) return {solveCoulomb(coulomb, uFree), Vec3::Zero()};
    const Vec3& n = coulomb.n;
    const auto limited = [&](const Vec3& q, const Vec3& r)
    {
        const double rn = std::max(0.0, n.dot(r));
        return admissibleMoment(q, n, contact.across*rn, contact.along*rn);
    };
    BorneByContact borne = withoutTurning(contact, uFree, wFree);
    constexpr double roundOff = 1e-12;
    Vec3 q = limited(borne.q, borne.r);
    if ((q - borne.q).norm() <= roundOff*q.norm()) return borne;
    if (present != Vec3::Zero()) q = present;
    for (int round = 0; round < roundsAtLimit; ++round)
    {
        borne.r = solveCoulomb(coulomb, uFree + contact.moment.coupling*q);
        const Vec3 w = wFree + contact.moment.coupling.transpose()*borne.r + contact.moment.mobility*q;
        borne.q = stepOfMoment(contact, limited(q, borne.r), w, std::max(0.0, n.dot(borne.r)));
        if ((borne.q - q).norm() <= roundOff*q.norm()) break;
        q = borne.q;
    }
    return borne;
}

GeneralMoment makeMoment(const Body* bodies, const ContactBlock& block, int lane, const LawBlock& law, const GeneralBodies& general, const GeneralSlot& slot, double rA)
{
    const Vec3 n = inBlock(block.n, lane);
    GeneralMoment moment;
    const double reduced = moment.reducedRadius = law.of[momentLaw::shareA][lane]*rA;
    const auto addSide = [&](int owner, const Vec3& arm, int body, double share, double side)
    {
        if (owner >= 0)
        {
            moment.coupling -= reduced*crossMatrix(arm)*general.bodies[owner].invInertia;
            moment.mobility += reduced*reduced*general.bodies[owner].invInertia;
            return;
        }
        moment.coupling += side*share*bodies[body].invSpin*crossMatrix(n);
        moment.mobility += share*share*bodies[body].invSpin*Matrix3d::Identity();
    };
    addSide(slot.ownerA, slot.armA, block.a[lane], law.of[momentLaw::shareA][lane], 1.0);
    addSide(slot.ownerB, slot.armB, block.b[lane], law.of[momentLaw::shareB][lane], -1.0);
    return moment;
}

DefectSums sweepGeneralMoments(Body* bodies, ContactBlock* blocks, LawBlock* laws, GeneralBodies& general, BlockRange range)
{
    DefectSums sums{0.0, 0.0, 0.0};
    for (std::size_t k = 0; k < range.count; ++k)
    {
        ContactBlock& block = blocks[range[k]];
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            if (!isUsedLane(block, lane)) continue;
            const MovingContact pair(bodies, general, block, range[k], lane);
            sweepLane(pair, block, laws[range[k]], general.moments[slotBehind(general, range[k], lane)], sums);
        }
    }
    return sums;
}

DefectSums evaluateGeneralMoments(const Body* bodies, const std::vector<ContactBlock>& blocks, const std::vector<LawBlock>& laws, const GeneralBodies& general)
{
    DefectSums sums{0.0, 0.0, 0.0};
    for (std::size_t k = general.firstBlock; k < blocks.size(); ++k)
    {
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            if (!isUsedLane(blocks[k], lane)) continue;
            add(sums, naturalMap(ConstContact(bodies, general, blocks[k], k, lane), laws[k], general.moments[slotBehind(general, k, lane)]), false);
        }
    }
    return sums;
}

void giveGeneralMoment(Body* bodies, const ContactBlock* blocks, const LawBlock* laws, GeneralBodies& general, std::size_t slot, const Vec3& q)
{
    const std::size_t k = slot/blockLanes;
    const int lane = slot % blockLanes;
    turn(MovingContact(bodies, general, blocks[k], k, lane), laws[k], general.moments[slotBehind(general, k, lane)].reducedRadius, q);
}

} // namespace nscd
