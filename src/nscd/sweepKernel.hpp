// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The contact sweep, written once for any number of lanes; included by one translation unit per instruction set.
// Everything is in an anonymous namespace, so that no function built for a wider set can leak into the portable program.
#pragma once

#include "contactBlock.hpp"
#include "mixingKernel.hpp"

namespace nscd
{
namespace
{

/// What a contact needs to know of its two bodies, one number per lane.
template<class V>
struct Relative
{
    using Real = typename V::Real;
    Real v[3];    ///< of A minus that of B
    Real mass;    ///< sum of 1/m
    Real s[3];    ///< sum of the spin variables
    Real spin;    ///< sum of 1/(kappa m)
};

/// Moves the bodies of each lane by impulses d on A, -d on B at contacts with normal n: v by d/m, s = R omega by -(n x d)/(kappa m).
template<class V, bool isFrictional>
inline void applyImpulses
(
    Body* bodies, const ContactBlock& block, int first,
    typename V::Real nx, typename V::Real ny, typename V::Real nz, typename V::Real dx, typename V::Real dy, typename V::Real dz
)
{
    using Real = typename V::Real;
    if (isFrictional)
    {
        const Real mx = nz*dy - ny*dz, my = nx*dz - nz*dx, mz = ny*dx - nx*dy;
        V::template push<true>(bodies, block.a + first, block.b + first, dx, dy, dz, mx, my, mz);
    }
    else V::template push<false>(bodies, block.a + first, block.b + first, dx, dy, dz, V::zero(), V::zero(), V::zero());
}

/// Local solution of one contact per lane (grains.md section 1): with own impulse r, relative velocity u at the contact,
/// p_n = max(0, r_n - (u_n + b)/W_nn), p_t = Proj_{mu p_n}(r_t - u_t/W_tt). Exact, since W is diagonal for spheres and discs.
/// An evaluation bounds friction by mu r_n as the natural map does, a sweep by the new mu p_n.
template<class V, bool isFrictional, bool isUpdate>
inline void solveLanes(Body* bodies, ContactBlock& block, int first, typename V::Real& sum2, typename V::Real& max2, typename V::Real& active)
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
        const Real limit = V::load(block.friction + first)*bound;
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
    }
    const Real isActive = V::select(V::max(pn, rn) > V::zero(), V::one(), V::zero());
    sum2 += defect2*isActive;
    max2 = V::max(max2, defect2);
    active += isActive;
    if (!isUpdate) return;

    V::store(block.r[0] + first, px);
    V::store(block.r[1] + first, py);
    V::store(block.r[2] + first, pz);
    applyImpulses<V, isFrictional>(bodies, block, first, nx, ny, nz, dx, dy, dz);
}

/// Blocks and bodies that a pass will come to are asked for this many blocks ahead: without, a pass over more than the caches hold
/// takes a third longer.
constexpr std::size_t blocksAhead = 12, bodiesAhead = 6;

inline void prefetch(const Body* bodies, const ContactBlock* blocks, BlockRange range, std::size_t k)
{
    if (k + blocksAhead < range.count)
    {
        const char* lines = reinterpret_cast<const char*>(&blocks[range[k + blocksAhead]]);
        for (std::size_t line = 0; line < sizeof(ContactBlock); line += 64) __builtin_prefetch(lines + line);
    }
    if (k + bodiesAhead < range.count)
    {
        const ContactBlock& block = blocks[range[k + bodiesAhead]];
        for (int l = 0; l < blockLanes; ++l) __builtin_prefetch(bodies + block.b[l]);
    }
}

template<class V, bool isFrictional, bool isUpdate>
DefectSums passOverBlocks(Body* bodies, ContactBlock* blocks, BlockRange range)
{
    typename V::Real sum2 = V::zero(), max2 = V::zero(), active = V::zero();
    for (std::size_t k = 0; k < range.count; ++k)
    {
        prefetch(bodies, blocks, range, k);
        for (int first = 0; first < blockLanes; first += V::lanes)
        {
            solveLanes<V, isFrictional, isUpdate>(bodies, blocks[range[k]], first, sum2, max2, active);
        }
    }
    double sums[V::lanes], maxima[V::lanes], counts[V::lanes];
    V::store(sums, sum2);
    V::store(maxima, max2);
    V::store(counts, active);
    DefectSums total = {0.0, 0.0, 0.0};
    for (int l = 0; l < V::lanes; ++l)
    {
        total.sumSquares += sums[l];
        total.active += counts[l];
        if (!(maxima[l] <= total.maxSquare)) total.maxSquare = maxima[l];
    }
    return total;
}

template<class V>
inline void replaceLanes(Body* bodies, ContactBlock& block, int first, double* target)
{
    using Real = typename V::Real;

    const Real nx = V::load(block.n[0] + first), ny = V::load(block.n[1] + first), nz = V::load(block.n[2] + first);
    Real px = V::load(target + first), py = V::load(target + blockLanes + first), pz = V::load(target + 2*blockLanes + first);
    const Real qn = px*nx + py*ny + pz*nz;
    const Real pn = V::max(V::zero(), qn);
    const Real tx = px - qn*nx, ty = py - qn*ny, tz = pz - qn*nz;
    const Real limit = V::load(block.friction + first)*pn;
    const Real t2 = tx*tx + ty*ty + tz*tz;
    const Real scale = V::select(t2 > limit*limit, limit/V::sqrt(V::max(t2, V::tiny())), V::one());
    px = pn*nx + scale*tx;
    py = pn*ny + scale*ty;
    pz = pn*nz + scale*tz;
    const Real dx = px - V::load(block.r[0] + first), dy = py - V::load(block.r[1] + first), dz = pz - V::load(block.r[2] + first);
    applyImpulses<V, true>(bodies, block, first, nx, ny, nz, dx, dy, dz);

    const Real p[3] = {px, py, pz};
    for (int k = 0; k < 3; ++k)
    {
        V::store(block.r[k] + first, p[k]);
        V::store(target + k*blockLanes + first, p[k]);
    }
}

template<class V>
void replaceImpulses(Body* bodies, ContactBlock* blocks, BlockRange range, double* target)
{
    for (std::size_t k = 0; k < range.count; ++k)
    {
        prefetch(bodies, blocks, range, k);
        for (int first = 0; first < blockLanes; first += V::lanes)
        {
            replaceLanes<V>(bodies, blocks[range[k]], first, target + k*3*blockLanes);
        }
    }
}

template<class V>
constexpr SweepKernels makeKernels(const char* name)
{
    return {name, V::lanes, passOverBlocks<V, true, true>, passOverBlocks<V, false, true>,
            passOverBlocks<V, true, false>, passOverBlocks<V, false, false>, replaceImpulses<V>, addDifferences};
}

} // namespace
} // namespace nscd
