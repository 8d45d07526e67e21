// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The contact sweep, written once for any number of lanes; included by one translation unit per instruction set.
// Everything is in an anonymous namespace, so that no function built for a wider set can leak into the portable program.
// Tested by tests/unit/nscd/kernels/sweepKernelsTest.cpp
#pragma once

#include "nscd/kernels/discKernel.hpp"
#include "nscd/kernels/mixingKernel.hpp"
#include "nscd/kernels/momentKernel.hpp"
#include "nscd/kernels/startKernel.hpp"

namespace nscd
{
namespace
{

/// Local solution of one contact per lane (src/nscd/method.md, "The contact law"): with own impulse r, relative velocity u at the contact,
/// p_n = max(0, r_n - (u_n + b)/W_nn), p_t = Proj_{mu p_n}(r_t - u_t/W_tt). Exact, since W is diagonal for spheres and discs.
/// An evaluation bounds friction by mu r_n as the natural map does, a sweep by the new mu p_n. Held, the block's friction is the bound itself [N s], whatever
/// presses (Tresca's law). Always inlined: called, its sums would go through memory.
template<class V, bool isFrictional, bool isUpdate, bool isHeld = false>
__attribute__((always_inline)) inline void solveLanes(Body* bodies, ContactBlock& block, int first, LaneSums<V>& sums)
{
    using Real = typename V::Real;

    Relative<V> relative;
    V::loadRelative(bodies, block.a + first, block.b + first, relative);

    const Real nx = V::load(block.n[0] + first), ny = V::load(block.n[1] + first), nz = V::load(block.n[2] + first);
    const Real rx = V::load(block.r[0] + first), ry = V::load(block.r[1] + first), rz = V::load(block.r[2] + first);
    const Real wn = relative.mass;

    Real ux = relative.v[0], uy = relative.v[1], uz = relative.v[2];
    if (isFrictional)
    {
        const Real sx = relative.s[0], sy = relative.s[1], sz = relative.s[2];
        ux -= sy*nz - sz*ny;
        uy -= sz*nx - sx*nz;
        uz -= sx*ny - sy*nx;
    }
    const Real un = ux*nx + uy*ny + uz*nz;
    const Real rn = rx*nx + ry*ny + rz*nz;
    const Real pn = V::max(V::zero(), rn - (un + V::load(block.bias + first))*V::load(block.invWn + first));

    const Real dn = pn - rn;
    Real defect2 = wn*wn*(dn*dn);
    Real px = pn*nx, py = pn*ny, pz = pn*nz;
    if (isFrictional)
    {
        const Real invWt = V::load(block.invWt + first);
        const Real qn = rn - un*invWt;
        const Real qx = rx - ux*invWt - qn*nx, qy = ry - uy*invWt - qn*ny, qz = rz - uz*invWt - qn*nz;
        const Real bound = isUpdate ? pn : V::max(V::zero(), rn);
        const Real friction = V::load(block.friction + first);
        const Real limit = isHeld ? friction : friction*bound;
        const Real q2 = qx*qx + qy*qy + qz*qz;
        const Real scale = V::select(q2 > limit*limit, limit/V::sqrt(V::max(q2, V::tiny())), V::one());
        px += scale*qx;
        py += scale*qy;
        pz += scale*qz;
    }
    const Real dx = px - rx, dy = py - ry, dz = pz - rz;
    if (isFrictional)
    {
        const Real wt = wn + relative.spin;
        const Real tangential2 = dx*dx + dy*dy + dz*dz - dn*dn;
        defect2 += wt*wt*V::max(V::zero(), tangential2);
        if (!isUpdate) sums.work += wt*(rx*dx + ry*dy + rz*dz - rn*dn);
    }
    const Real isActive = V::select(V::max(pn, rn) > V::zero(), V::one(), V::zero());
    sums.add(defect2, isActive);
    if (!isUpdate)
    {
        sums.work += wn*(rn*dn);
        return;
    }

    V::store(block.r[0] + first, px);
    V::store(block.r[1] + first, py);
    V::store(block.r[2] + first, pz);
    applyImpulses<V, isFrictional>(bodies, block, first, nx, ny, nz, dx, dy, dz);
}

/// The local solutions that a pass can be made of.
template<bool isFrictional>
struct Spheres
{
    template<class V, bool isUpdate>
    __attribute__((always_inline)) static void solve(Body* bodies, ContactBlock& block, int first, LaneSums<V>& sums)
    {
        solveLanes<V, isFrictional, isUpdate>(bodies, block, first, sums);
    }
};

/// Friction within bounds that do not depend on what presses.
struct HeldSpheres
{
    template<class V, bool isUpdate>
    __attribute__((always_inline)) static void solve(Body* bodies, ContactBlock& block, int first, LaneSums<V>& sums)
    {
        solveLanes<V, true, isUpdate, true>(bodies, block, first, sums);
    }
};

template<int axis>
struct Discs
{
    template<class V, bool isUpdate>
    __attribute__((always_inline)) static void solve(Body* bodies, ContactBlock& block, int first, LaneSums<V>& sums)
    {
        solveDiscLanes<V, axis, isUpdate>(bodies, block, first, sums);
    }
};

/// `prepare` is called with each block and its number before the block is solved.
template<class V, class Local, bool isUpdate, class Prepare>
inline DefectSums passOver(Body* bodies, ContactBlock* blocks, BlockRange range, const Prepare& prepare)
{
    LaneSums<V> sums = {V::zero(), V::zero(), V::zero(), V::zero()};
    for (std::size_t k = 0; k < range.count; ++k)
    {
        prefetch(bodies, blocks, range, k);
        ContactBlock& block = blocks[range[k]];
        prepare(block, k);
        for (int first = 0; first < blockLanes; first += V::lanes) Local::template solve<V, isUpdate>(bodies, block, first, sums);
    }
    return sums.total();
}

template<class V, class Local, bool isUpdate>
DefectSums passOverBlocks(Body* bodies, ContactBlock* blocks, BlockRange range)
{
    return passOver<V, Local, isUpdate>(bodies, blocks, range, [](ContactBlock&, std::size_t) {});
}

template<class V, class Local>
DefectSums sweepOn(Body* bodies, ContactBlock* blocks, BlockRange range, double* before, double theta)
{
    const Lanes share = Lanes{} + theta;
    return passOver<V, Local, true>(bodies, blocks, range, [=](ContactBlock& block, std::size_t k) { extrapolateBlock(block.r, before + 3*k*blockLanes, share); });
}

template<class V, bool isFrictional>
inline void replaceLanes(Body* bodies, ContactBlock& block, int first, double* target)
{
    using Real = typename V::Real;

    const Real nx = V::load(block.n[0] + first), ny = V::load(block.n[1] + first), nz = V::load(block.n[2] + first);
    Real px = V::load(target + first), py = V::load(target + blockLanes + first), pz = V::load(target + 2*blockLanes + first);
    admitImpulses<V, isFrictional>(nx, ny, nz, V::load(block.friction + first), px, py, pz);
    const Real dx = px - V::load(block.r[0] + first), dy = py - V::load(block.r[1] + first), dz = pz - V::load(block.r[2] + first);
    applyImpulses<V, isFrictional>(bodies, block, first, nx, ny, nz, dx, dy, dz);

    const Real p[3] = {px, py, pz};
    for (int k = 0; k < 3; ++k)
    {
        V::store(block.r[k] + first, p[k]);
        V::store(target + k*blockLanes + first, p[k]);
    }
}

template<class V, bool isFrictional>
void replaceImpulses(Body* bodies, ContactBlock* blocks, BlockRange range, double* target)
{
    for (std::size_t k = 0; k < range.count; ++k)
    {
        prefetch(bodies, blocks, range, k);
        for (int first = 0; first < blockLanes; first += V::lanes)
        {
            replaceLanes<V, isFrictional>(bodies, blocks[range[k]], first, target + k*3*blockLanes);
        }
    }
}

template<class V>
constexpr SweepKernels makeKernels(const char* name)
{
    return {name, V::lanes, passOverBlocks<V, Spheres<true>, true>, passOverBlocks<V, Spheres<false>, true>,
            sweepOn<V, Spheres<true>>, sweepOn<V, Spheres<false>>, passOverBlocks<V, Spheres<true>, false>, passOverBlocks<V, Spheres<false>, false>,
            replaceImpulses<V, true>, replaceImpulses<V, false>, addDifferences, extrapolateImpulses, extrapolateBodies, setLaws<V>, startWarm<V, true>, startWarm<V, false>, giveImpulses<V>,
            {passOverBlocks<V, Discs<0>, true>, passOverBlocks<V, Discs<1>, true>, passOverBlocks<V, Discs<2>, true>},
            {sweepOn<V, Discs<0>>, sweepOn<V, Discs<1>>, sweepOn<V, Discs<2>>},
            {passOverBlocks<V, Discs<0>, false>, passOverBlocks<V, Discs<1>, false>, passOverBlocks<V, Discs<2>, false>},
            passOverBlocks<V, HeldSpheres, true>, sweepOn<V, HeldSpheres>, passOverBlocks<V, HeldSpheres, false>,
            sweepMoments<V>, sweepMomentsOn<V>, evaluateMoments<V>};
}

} // namespace
} // namespace nscd
