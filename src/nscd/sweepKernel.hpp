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

/// Impulses d on A, -d on B: velocities.
template<class Real>
inline void addVelocities(Real (&A)[8], Real (&B)[8], Real dx, Real dy, Real dz)
{
    A[0] += A[3]*dx;
    A[1] += A[3]*dy;
    A[2] += A[3]*dz;
    B[0] -= B[3]*dx;
    B[1] -= B[3]*dy;
    B[2] -= B[3]*dz;
}

/// Impulses d on A, -d on B, at contacts with normal n: velocities and spins s = R omega.
template<class Real>
inline void addImpulses(Real (&A)[8], Real (&B)[8], Real nx, Real ny, Real nz, Real dx, Real dy, Real dz)
{
    addVelocities(A, B, dx, dy, dz);
    const Real mx = ny*dz - nz*dy, my = nz*dx - nx*dz, mz = nx*dy - ny*dx;
    A[4] -= A[7]*mx;
    A[5] -= A[7]*my;
    A[6] -= A[7]*mz;
    B[4] -= B[7]*mx;
    B[5] -= B[7]*my;
    B[6] -= B[7]*mz;
}

/// Local solution of one contact per lane (grains.md section 1): with own impulse r, relative velocity u at the contact,
/// p_n = max(0, r_n - (u_n + b)/W_nn), p_t = Proj_{mu p_n}(r_t - u_t/W_tt). Exact, since W is diagonal for spheres and discs.
/// An evaluation bounds friction by mu r_n as the natural map does, a sweep by the new mu p_n.
template<class V, bool isFrictional, bool isUpdate>
inline void solveLanes(Body* bodies, ContactBlock& block, int first, typename V::Real& sum2, typename V::Real& max2, typename V::Real& active)
{
    using Real = typename V::Real;

    Real A[8], B[8];
    V::loadBodies(bodies, block.a + first, A);
    V::loadBodies(bodies, block.b + first, B);

    const Real nx = V::load(block.n[0] + first), ny = V::load(block.n[1] + first), nz = V::load(block.n[2] + first);
    const Real rx = V::load(block.r[0] + first), ry = V::load(block.r[1] + first), rz = V::load(block.r[2] + first);
    const Real wn = A[3] + B[3];

    Real ux = A[0] - B[0], uy = A[1] - B[1], uz = A[2] - B[2];
    if (isFrictional)
    {
        const Real sx = A[4] + B[4], sy = A[5] + B[5], sz = A[6] + B[6];
        ux -= sy*nz - sz*ny;
        uy -= sz*nx - sx*nz;
        uz -= sx*ny - sy*nx;
    }
    const Real un = ux*nx + uy*ny + uz*nz;
    const Real rn = rx*nx + ry*ny + rz*nz;
    const Real pn = V::max(V::zero(), rn - (un + V::load(block.bias + first))*V::load(block.invWn + first));

    const Real dn = pn - rn;
    Real defect2 = wn*dn*(wn*dn);
    Real px = pn*nx, py = pn*ny, pz = pn*nz;
    if (isFrictional)
    {
        const Real invWt = V::load(block.invWt + first);
        const Real qx = rx - rn*nx - (ux - un*nx)*invWt;
        const Real qy = ry - rn*ny - (uy - un*ny)*invWt;
        const Real qz = rz - rn*nz - (uz - un*nz)*invWt;
        const Real limit = V::load(block.friction + first)*(isUpdate ? pn : V::max(V::zero(), rn));
        const Real q2 = qx*qx + qy*qy + qz*qz;
        const Real scale = V::select(q2 > limit*limit, limit/V::sqrt(V::max(q2, V::tiny())), V::one());
        px += scale*qx;
        py += scale*qy;
        pz += scale*qz;
        const Real wt = wn + A[7] + B[7];
        const Real tx = scale*qx - (rx - rn*nx), ty = scale*qy - (ry - rn*ny), tz = scale*qz - (rz - rn*nz);
        defect2 += wt*wt*(tx*tx + ty*ty + tz*tz);
    }
    const Real isActive = V::select(V::max(pn, rn) > V::zero(), V::one(), V::zero());
    sum2 += defect2*isActive;
    max2 = V::max(max2, defect2);
    active += isActive;
    if (!isUpdate) return;

    const Real dx = px - rx, dy = py - ry, dz = pz - rz;
    if (isFrictional) addImpulses(A, B, nx, ny, nz, dx, dy, dz);
    else addVelocities(A, B, dx, dy, dz);
    V::store(block.r[0] + first, px);
    V::store(block.r[1] + first, py);
    V::store(block.r[2] + first, pz);
    V::storeBodies(bodies, block.a + first, A);
    V::storeBodies(bodies, block.b + first, B);
}

template<class V, bool isFrictional, bool isUpdate>
DefectSums passOverBlocks(Body* bodies, ContactBlock* blocks, BlockRange range)
{
    typename V::Real sum2 = V::zero(), max2 = V::zero(), active = V::zero();
    for (std::size_t k = 0; k < range.count; ++k)
    {
        if (k + 2 < range.count) V::prefetch(bodies, blocks[range[k + 2]]);
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

    Real A[8], B[8];
    V::loadBodies(bodies, block.a + first, A);
    V::loadBodies(bodies, block.b + first, B);

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
    addImpulses(A, B, nx, ny, nz, dx, dy, dz);
    V::storeBodies(bodies, block.a + first, A);
    V::storeBodies(bodies, block.b + first, B);

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
        if (k + 2 < range.count) V::prefetch(bodies, blocks[range[k + 2]]);
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
