// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Vectors of space with a number per lane in each component. In an anonymous namespace, as laneBodies.hpp is.
// Tested by tests/unit/nscd/kernels/momentKernelTest.cpp
#pragma once

#include "nscd/kernels/contactBlock.hpp"

namespace nscd
{
namespace
{

template<class V>
struct LaneVector
{
    using Real = typename V::Real;
    Real x, y, z;
};

template<class V>
__attribute__((always_inline)) inline LaneVector<V> operator+(const LaneVector<V>& a, const LaneVector<V>& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

template<class V>
__attribute__((always_inline)) inline LaneVector<V> operator-(const LaneVector<V>& a, const LaneVector<V>& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

template<class V>
__attribute__((always_inline)) inline LaneVector<V> operator*(typename LaneVector<V>::Real a, const LaneVector<V>& b) { return {a*b.x, a*b.y, a*b.z}; }

template<class V>
__attribute__((always_inline)) inline typename V::Real dot(const LaneVector<V>& a, const LaneVector<V>& b) { return a.x*b.x + a.y*b.y + a.z*b.z; }

template<class V>
__attribute__((always_inline)) inline LaneVector<V> cross(const LaneVector<V>& a, const LaneVector<V>& b)
{
    return {a.y*b.z - a.z*b.y, a.z*b.x - a.x*b.z, a.x*b.y - a.y*b.x};
}

template<class V, class Mask>
__attribute__((always_inline)) inline LaneVector<V> select(Mask mask, const LaneVector<V>& a, const LaneVector<V>& b)
{
    return {V::select(mask, a.x, b.x), V::select(mask, a.y, b.y), V::select(mask, a.z, b.z)};
}

/// Scaled to the length of a limit where longer.
template<class V>
__attribute__((always_inline)) inline LaneVector<V> inDisc(const LaneVector<V>& x, typename LaneVector<V>::Real limit)
{
    const auto x2 = dot(x, x);
    return V::select(x2 > limit*limit, limit/V::sqrt(V::max(x2, V::tiny())), V::one())*x;
}

template<class V>
__attribute__((always_inline)) inline LaneVector<V> loadVector(const double (&of)[3][blockLanes], int first)
{
    return {V::load(of[0] + first), V::load(of[1] + first), V::load(of[2] + first)};
}

template<class V>
__attribute__((always_inline)) inline void storeVector(double (&of)[3][blockLanes], int first, const LaneVector<V>& x)
{
    V::store(of[0] + first, x.x);
    V::store(of[1] + first, x.y);
    V::store(of[2] + first, x.z);
}

} // namespace
} // namespace nscd
