// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What all passes over contacts share, for any number of lanes: relative velocities, the friction cone, moving the bodies.
// Everything is in an anonymous namespace, so that no function built for a wider set can leak into the portable program.
// Tested by tests/unit/nscd/kernels/sweepKernelsTest.cpp
#pragma once

#include "nscd/kernels/blockPrefetch.hpp"
#include "nscd/kernels/laneVectors.hpp"

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

/// Relative spin of A and B in the shares that a moment has of them.
template<class V>
struct Turning
{
    using Real = typename V::Real;
    Real w[3];       ///< a s_A - b s_B
    Real coupling;   ///< a/(kappa m_A) - b/(kappa m_B)
};

/// DefectSums of the contacts that each lane passes over.
template<class V>
struct LaneSums
{
    using Real = typename V::Real;
    Real squares, max, active, work;

    __attribute__((always_inline)) void add(Real defect2, Real isActive)
    {
        squares += defect2*isActive;
        max = V::max(max, defect2);
        active += isActive;
    }

    /// A defect of a contact that has been counted.
    __attribute__((always_inline)) void addMoment(Real defect2)
    {
        squares += defect2;
        max = V::max(max, defect2);
    }

    DefectSums total() const
    {
        double sums[V::lanes], maxima[V::lanes], counts[V::lanes], works[V::lanes];
        V::store(sums, squares);
        V::store(maxima, max);
        V::store(counts, active);
        V::store(works, work);
        DefectSums total = {0.0, 0.0, 0.0};
        for (int l = 0; l < V::lanes; ++l)
        {
            total.sumSquares += sums[l];
            total.active += counts[l];
            total.work += works[l];
            if (!(maxima[l] <= total.maxSquare)) total.maxSquare = maxima[l];
        }
        return total;
    }
};

/// Moves the bodies of each lane by impulses d on A, -d on B at contacts with normal n: v by d/m, s = R omega by -(n x d)/(kappa m).
/// Always inlined, as is `push`: where GCC calls a function with vectors it leaves their upper halves set behind it, and the scalar code
/// of the rest of a step then takes a fifth longer.
template<class V, bool isFrictional>
__attribute__((always_inline)) inline void applyImpulses
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

/// Makes impulses admissible: cuts attraction off and scales the tangential part into the friction disc.
template<class V, bool isFrictional>
inline void admitImpulses
(
    typename V::Real nx, typename V::Real ny, typename V::Real nz, typename V::Real friction,
    typename V::Real& px, typename V::Real& py, typename V::Real& pz
)
{
    using Real = typename V::Real;
    const Real qn = px*nx + py*ny + pz*nz;
    const Real pn = V::max(V::zero(), qn);
    if (!isFrictional)
    {
        px = pn*nx;
        py = pn*ny;
        pz = pn*nz;
        return;
    }
    const Real tx = px - qn*nx, ty = py - qn*ny, tz = pz - qn*nz;
    const Real limit = friction*pn;
    const Real t2 = tx*tx + ty*ty + tz*tz;
    const Real scale = V::select(t2 > limit*limit, limit/V::sqrt(V::max(t2, V::tiny())), V::one());
    px = pn*nx + scale*tx;
    py = pn*ny + scale*ty;
    pz = pn*nz + scale*tz;
}

} // namespace
} // namespace nscd
