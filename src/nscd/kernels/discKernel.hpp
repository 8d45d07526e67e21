// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The local solution of discs in a plane: one tangential direction, one spin. Included as sweepKernel.hpp is.
// Tested by tests/unit/nscd/scenes/skipTest.cpp
#pragma once

#include "nscd/kernels/laneBodies.hpp"

namespace nscd
{
namespace
{

/// As solveLanes() where nothing moves along `axis` e, and n and r have no component along it. The plane's axes p, q follow e, so that t = e x n =
/// (-n_q, n_p) and u_t = t.v - s: p_t = max(-mu p_n, min(mu p_n, r_t - u_t/W_tt)), without a root. Spins change by -(p_t - r_t)/(kappa m).
template<class V, int axis, bool isUpdate>
__attribute__((always_inline)) inline void solveDiscLanes(Body* bodies, ContactBlock& block, int first, LaneSums<V>& sums)
{
    using Real = typename V::Real;
    constexpr int p = (axis + 1) % 3, q = (axis + 2) % 3;

    Relative<V> relative;
    V::loadRelative(bodies, block.a + first, block.b + first, relative);

    const Real np = V::load(block.n[p] + first), nq = V::load(block.n[q] + first);
    const Real rp = V::load(block.r[p] + first), rq = V::load(block.r[q] + first);
    const Real un = relative.v[p]*np + relative.v[q]*nq;
    const Real ut = relative.v[q]*np - relative.v[p]*nq - relative.s[axis];
    const Real rn = rp*np + rq*nq, rt = rq*np - rp*nq;
    const Real pn = V::max(V::zero(), rn - (un + V::load(block.bias + first))*V::load(block.invWn + first));
    const Real limit = V::load(block.friction + first)*(isUpdate ? pn : V::max(V::zero(), rn));
    const Real pt = V::max(-limit, V::min(limit, rt - ut*V::load(block.invWt + first)));

    const Real dn = pn - rn, dt = pt - rt, wn = relative.mass, wt = wn + relative.spin;
    const Real defect2 = wn*wn*(dn*dn) + wt*wt*(dt*dt);
    const Real isActive = V::select(V::max(pn, rn) > V::zero(), V::one(), V::zero());
    sums.add(defect2, isActive);
    if (!isUpdate)
    {
        sums.work += wn*(rn*dn) + wt*(rt*dt);
        return;
    }

    const Real newP = pn*np - pt*nq, newQ = pn*nq + pt*np;
    V::store(block.r[p] + first, newP);
    V::store(block.r[q] + first, newQ);
    Real d[3];
    d[p] = newP - rp;
    d[q] = newQ - rq;
    d[axis] = V::zero();
    V::template push<false>(bodies, block.a + first, block.b + first, d[0], d[1], d[2], V::zero(), V::zero(), V::zero());
    double turn[V::lanes];
    V::store(turn, -dt);
    for (int l = 0; l < V::lanes; ++l)
    {
        Body& a = bodies[block.a[first + l]];
        Body& b = bodies[block.b[first + l]];
        a.s[axis] += a.invSpin*turn[l];
        b.s[axis] += b.invSpin*turn[l];
    }
}

} // namespace
} // namespace nscd
