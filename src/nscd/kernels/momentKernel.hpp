// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The sweep over contacts that bear moments besides impulses, written once for any number of lanes, as sweepKernel.hpp is.
// Tested by tests/unit/nscd/kernels/momentKernelTest.cpp
#pragma once

#include "nscd/kernels/laneBodies.hpp"
#include "nscd/kernels/laneVectors.hpp"
#include "nscd/kernels/mixingKernel.hpp"

namespace nscd
{
namespace
{

/// One contact per lane as both its tangential laws see it; what is turned is x cross n.
template<class V>
struct TangentialLaws
{
    using Real = typename V::Real;
    LaneVector<V> r, u;                   ///< tangential impulse, relative velocity
    LaneVector<V> q, w;                   ///< moment over R', R' omega, turned
    Real coupling;                        ///< c
    Real invWt, invWr, invWrOfSticking;   ///< the last one: of w where u is kept
    Real frictionLimit, momentLimit;
};

/// What a contact bears in its tangent plane, the moment turned.
template<class V>
struct TangentialPart
{
    LaneVector<V> r, q;
};

/// Laws of the tangent plane, which in turned variables couple by one number: u' = W_tt r - c q', w' = -c r + W_r q'.
/// Exact where the contact sticks; where it slides, one step of Gauss-Seidel between the two.
template<class V>
__attribute__((always_inline)) inline TangentialPart<V> solveTangential(const TangentialLaws<V>& at)
{
    using Real = typename V::Real;
    const LaneVector<V> sticking = inDisc(at.q - at.invWrOfSticking*(at.w + at.coupling*at.invWt*at.u), at.momentLimit);
    const LaneVector<V> stuck = at.r + at.invWt*(at.coupling*(sticking - at.q) - at.u);
    const Real excess = dot(stuck, stuck) - at.frictionLimit*at.frictionLimit;
    if (!V::isAnyPositive(excess)) return {stuck, sticking};

    const LaneVector<V> sliding = inDisc(at.r - at.invWt*at.u, at.frictionLimit);
    const LaneVector<V> besideSliding = inDisc(at.q - at.invWr*(at.w - at.coupling*(sliding - at.r)), at.momentLimit);
    const auto slides = excess > V::zero();
    return {select<V>(slides, sliding, stuck), select<V>(slides, besideSliding, sticking)};
}

/// 1/x where x > 0, else 0: what cannot move has no mobility, and stays.
template<class V>
__attribute__((always_inline)) inline typename V::Real inverse(typename V::Real x)
{
    return V::select(x > V::zero(), V::one()/V::max(x, V::tiny()), V::zero());
}

/// W_r = a^2/(kappa m_A) + b^2/(kappa m_B) from the sum of both 1/(kappa m) and c, for a + b = 1 and, at a wall, a = b = 1 and no mobility of B.
template<class V>
__attribute__((always_inline)) inline typename V::Real momentMobility(const LawBlock& moments, int first, typename V::Real spin, typename V::Real coupling)
{
    const typename V::Real a = V::load(moments.of[momentLaw::shareA] + first), b = V::load(moments.of[momentLaw::shareB] + first);
    return a*b*spin + (a - b)*coupling;
}

template<class V>
__attribute__((always_inline)) inline typename V::Real within(typename V::Real x, typename V::Real limit) { return V::max(-limit, V::min(limit, x)); }

/// Local solution of one contact per lane (src/nscd/method.md, "The contact law"): the normal impulse as without moments, which it does not feel; then
/// friction and the moment's tangential part together, and its part along the normal, which feels nothing else.
template<class V>
__attribute__((always_inline)) inline void solveMomentLanes(Body* bodies, ContactBlock& block, LawBlock& moments, int first, LaneSums<V>& sums)
{
    using Real = typename V::Real;
    Relative<V> relative;
    V::loadRelative(bodies, block.a + first, block.b + first, relative);
    const LaneVector<V> n = loadVector<V>(block.n, first), r = loadVector<V>(block.r, first), q = loadVector<V>(moments.q, first);
    const LaneVector<V> u = LaneVector<V>{relative.v[0], relative.v[1], relative.v[2]} - cross(LaneVector<V>{relative.s[0], relative.s[1], relative.s[2]}, n);
    const Real un = dot(u, n), rn = dot(r, n), wn = relative.mass, invWt = V::load(block.invWt + first);
    const Real pn = V::max(V::zero(), rn - (un + V::load(block.bias + first))*V::load(block.invWn + first)), dn = pn - rn;
    if (!V::isAnyPositive(V::max(pn, V::max(dot(r, r), dot(q, q))))) return;

    Turning<V> turning;
    V::loadTurning(bodies, block.a + first, block.b + first, moments.of[momentLaw::shareA] + first, moments.of[momentLaw::shareB] + first, turning);
    const LaneVector<V> w{turning.w[0], turning.w[1], turning.w[2]};
    const Real c = turning.coupling, wr = momentMobility<V>(moments, first, relative.spin, c), invWr = inverse<V>(wr);
    const TangentialLaws<V> at
    {
        r - rn*n, u - un*n, cross(q, n), cross(w, n), c, invWt, invWr, inverse<V>(wr - c*c*invWt),
        V::load(block.friction + first)*pn, V::load(moments.of[momentLaw::across] + first)*pn
    };
    const TangentialPart<V> solved = solveTangential<V>(at);
    const Real qn = dot(q, n), ofSpin = within<V>(qn - dot(w, n)*invWr, V::load(moments.of[momentLaw::along] + first)*pn);
    // What becomes zero is zero to the bit: sums of what there was and its change would not be.
    const LaneVector<V> newR = pn*n + solved.r, newQ = cross(n, solved.q) + ofSpin*n, dr = newR - r, dq = newQ - q;

    const Real wt = wn + relative.spin;
    const LaneVector<V> slip = solved.r - at.r;
    sums.add(wn*wn*(dn*dn) + wt*wt*dot(slip, slip), V::select(V::max(pn, rn) > V::zero(), V::one(), V::zero()));
    sums.addMoment(wr*wr*dot(dq, dq));

    storeVector<V>(block.r, first, newR);
    storeVector<V>(moments.q, first, newQ);
    V::pushTurning(bodies, block.a + first, block.b + first, moments.of[momentLaw::shareA] + first, moments.of[momentLaw::shareB] + first, dr, cross(dr, n), dq);
}

/// e = W_r |q - Proj(q - w/W_r)|, both parts.
template<class V>
__attribute__((always_inline)) inline void evaluateMomentLanes(const Body* bodies, const ContactBlock& block, const LawBlock& moments, int first, LaneSums<V>& sums)
{
    using Real = typename V::Real;
    const LaneVector<V> n = loadVector<V>(block.n, first), q = loadVector<V>(moments.q, first);
    const Real rn = V::max(V::zero(), dot(loadVector<V>(block.r, first), n));
    if (!V::isAnyPositive(V::max(rn, dot(q, q)))) return;

    Relative<V> relative;
    Turning<V> turning;
    V::loadRelative(bodies, block.a + first, block.b + first, relative);
    V::loadTurning(bodies, block.a + first, block.b + first, moments.of[momentLaw::shareA] + first, moments.of[momentLaw::shareB] + first, turning);
    const LaneVector<V> w{turning.w[0], turning.w[1], turning.w[2]};
    const Real wr = momentMobility<V>(moments, first, relative.spin, turning.coupling), invWr = inverse<V>(wr);
    const Real qn = dot(q, n), wOfSpin = dot(w, n);
    const LaneVector<V> qt = q - qn*n;
    const LaneVector<V> across = inDisc(qt - invWr*(w - wOfSpin*n), V::load(moments.of[momentLaw::across] + first)*rn) - qt;
    const Real along = within<V>(qn - wOfSpin*invWr, V::load(moments.of[momentLaw::along] + first)*rn) - qn;
    sums.addMoment(wr*wr*(dot(across, across) + along*along));
}

__attribute__((always_inline)) inline void prefetchMoments(const LawBlock* moments, BlockRange range, std::size_t k)
{
    if (k + blocksAhead >= range.count) return;
    const char* lines = reinterpret_cast<const char*>(&moments[range[k + blocksAhead]]);
    for (std::size_t line = 0; line < sizeof(LawBlock); line += 64) __builtin_prefetch(lines + line);
}

template<class V, class Solve>
inline DefectSums passOverMoments(const Body* bodies, const ContactBlock* blocks, const LawBlock* moments, BlockRange range, const Solve& solve)
{
    LaneSums<V> sums = {V::zero(), V::zero(), V::zero(), V::zero()};
    for (std::size_t k = 0; k < range.count; ++k)
    {
        prefetch(bodies, blocks, range, k);
        prefetchMoments(moments, range, k);
        solve(range[k], k, sums);
    }
    return sums.total();
}

template<class V>
DefectSums sweepMoments(Body* bodies, ContactBlock* blocks, LawBlock* moments, BlockRange range)
{
    return passOverMoments<V>(bodies, blocks, moments, range, [=](std::size_t block, std::size_t, LaneSums<V>& sums) __attribute__((always_inline))
    {
        for (int first = 0; first < blockLanes; first += V::lanes) solveMomentLanes<V>(bodies, blocks[block], moments[block], first, sums);
    });
}

template<class V>
DefectSums sweepMomentsOn(Body* bodies, ContactBlock* blocks, LawBlock* moments, BlockRange range, double* before, double* momentsBefore, double theta)
{
    const Lanes share = Lanes{} + theta;
    return passOverMoments<V>(bodies, blocks, moments, range, [=](std::size_t block, std::size_t k, LaneSums<V>& sums) __attribute__((always_inline))
    {
        extrapolateBlock(blocks[block].r, before + 3*k*blockLanes, share);
        extrapolateBlock(moments[block].q, momentsBefore + 3*k*blockLanes, share);
        for (int first = 0; first < blockLanes; first += V::lanes) solveMomentLanes<V>(bodies, blocks[block], moments[block], first, sums);
    });
}

template<class V>
DefectSums evaluateMoments(const Body* bodies, const ContactBlock* blocks, const LawBlock* moments, BlockRange range)
{
    return passOverMoments<V>(bodies, blocks, moments, range, [=](std::size_t block, std::size_t, LaneSums<V>& sums) __attribute__((always_inline))
    {
        for (int first = 0; first < blockLanes; first += V::lanes) evaluateMomentLanes<V>(bodies, blocks[block], moments[block], first, sums);
    });
}

} // namespace
} // namespace nscd
