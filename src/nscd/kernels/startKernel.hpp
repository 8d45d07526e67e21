// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a step does to all contacts before the first sweep and after the last one, written once for any number of lanes, as the sweep is.
#pragma once

#include "nscd/kernels/laneBodies.hpp"

namespace nscd
{
namespace
{

/// Sets W and bias of some lanes. Adds one to `awake` in lanes that can matter in this step: closed, closing, or loaded.
template<class V>
inline void setLaneLaws(const Body* bodies, ContactBlock& block, const double* gap, const LawOfStep& law, int first, typename V::Real& awake)
{
    using Real = typename V::Real;

    Relative<V> relative;
    V::loadRelative(bodies, block.a + first, block.b + first, relative);
    const Real wn = relative.mass, wt = wn + relative.spin;
    // Unused lanes have two bodies without mobility.
    const auto isUsed = wn > V::zero();
    V::store(block.invWn + first, V::select(isUsed, V::one()/V::max(wn, V::tiny()), V::zero()));
    V::store(block.invWt + first, V::select(isUsed, V::one()/V::max(wt, V::tiny()), V::zero()));

    // A gap beyond the band may close to nothing, not to the band's edge: there, noise would open the contact again.
    const Real g = V::load(gap + first);
    const Real open = V::min(g, V::all(law.unreachable*law.deltaT))/V::all(law.deltaT);  // a gap may be the largest number there is
    const Real bias = V::select(g > V::all(law.deadBand), open, V::zero());
    V::store(block.bias + first, bias);

    const Real nx = V::load(block.n[0] + first), ny = V::load(block.n[1] + first), nz = V::load(block.n[2] + first);
    const Real un = relative.v[0]*nx + relative.v[1]*ny + relative.v[2]*nz;
    const Real rx = V::load(block.r[0] + first), ry = V::load(block.r[1] + first), rz = V::load(block.r[2] + first);
    const Real size = V::max(V::max(V::max(rx, -rx), V::max(ry, -ry)), V::max(rz, -rz));
    const Real isClosing = V::select(V::zero() > un + bias, V::one(), V::select(bias > V::zero(), V::zero(), V::one()));
    const Real isLoaded = V::select(size > V::zero(), V::one(), V::zero());
    awake += V::select(isUsed, V::max(isClosing, isLoaded), V::zero());
}

template<class V>
bool setLaws(const Body* bodies, ContactBlock& block, const double* gap, const LawOfStep& law)
{
    typename V::Real awake = V::zero();
    for (int first = 0; first < blockLanes; first += V::lanes) setLaneLaws<V>(bodies, block, gap, law, first, awake);
    double count[V::lanes];
    V::store(count, awake);
    for (double c : count)
    {
        if (c > 0.0) return true;
    }
    return false;
}

/// Turns last step's impulses into this step's tangent planes and friction discs, and gives them to the bodies.
template<class V, bool isFrictional>
inline void startLanes(Body* bodies, ContactBlock& block, double scale, int first)
{
    using Real = typename V::Real;

    const Real nx = V::load(block.n[0] + first), ny = V::load(block.n[1] + first), nz = V::load(block.n[2] + first);
    Real px = V::all(scale)*V::load(block.r[0] + first);
    Real py = V::all(scale)*V::load(block.r[1] + first);
    Real pz = V::all(scale)*V::load(block.r[2] + first);
    admitImpulses<V, isFrictional>(nx, ny, nz, V::load(block.friction + first), px, py, pz);
    V::store(block.r[0] + first, px);
    V::store(block.r[1] + first, py);
    V::store(block.r[2] + first, pz);
    applyImpulses<V, isFrictional>(bodies, block, first, nx, ny, nz, px, py, pz);
}

template<class V, bool isFrictional>
void startWarm(Body* bodies, ContactBlock* blocks, BlockRange range, double scale)
{
    for (std::size_t k = 0; k < range.count; ++k)
    {
        prefetch(bodies, blocks, range, k);
        for (int first = 0; first < blockLanes; first += V::lanes) startLanes<V, isFrictional>(bodies, blocks[range[k]], scale, first);
    }
}

template<class V>
void giveImpulses(Body* bodies, const ContactBlock* blocks, BlockRange range)
{
    for (std::size_t k = 0; k < range.count; ++k)
    {
        prefetch(bodies, blocks, range, k);
        const ContactBlock& block = blocks[range[k]];
        for (int first = 0; first < blockLanes; first += V::lanes)
        {
            const auto component = [first](const double (&x)[blockLanes]) { return V::load(x + first); };
            applyImpulses<V, true>(bodies, block, first, component(block.n[0]), component(block.n[1]), component(block.n[2]),
                                   component(block.r[0]), component(block.r[1]), component(block.r[2]));
        }
    }
}

} // namespace
} // namespace nscd
