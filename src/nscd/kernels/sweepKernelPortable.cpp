// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The contact sweep one lane at a time, for any processor.
// Tested by tests/unit/nscd/kernels/sweepKernelsTest.cpp
#include "nscd/kernels/sweepKernel.hpp"
#include "nscd/kernels/sweepKernels.hpp"

#include <cmath>

namespace nscd
{
namespace
{

/// Two numbers: a register of every x86-64, and of most other processors.
typedef double Pair __attribute__((vector_size(2*sizeof(double))));

struct PairLanes
{
    using Real = Pair;
    static constexpr int lanes = 2;

    static Real zero() { return Real{0.0, 0.0}; }
    static Real one() { return Real{1.0, 1.0}; }
    static Real all(double a) { return Real{a, a}; }
    static Real min(Real a, Real b) { return a < b ? a : b; }
    static Real tiny() { return Real{1e-300, 1e-300}; }
    static Real load(const double* p)
    {
        Real x;
        __builtin_memcpy(&x, p, sizeof x);
        return x;
    }
    static void store(double* p, Real x) { __builtin_memcpy(p, &x, sizeof x); }
#if defined(__SSE2__)
    static Real max(Real a, Real b) { return __builtin_ia32_maxpd(a, b); }
    static Real sqrt(Real a) { return __builtin_ia32_sqrtpd(a); }
#else
    static Real max(Real a, Real b) { return a > b ? a : b; }
    static Real sqrt(Real a) { return Real{std::sqrt(a[0]), std::sqrt(a[1])}; }
#endif
    template<class Mask>
    static Real select(Mask mask, Real a, Real b) { return mask ? a : b; }

    static Real low(Real a, Real b) { return __builtin_shufflevector(a, b, 0, 2); }
    static Real high(Real a, Real b) { return __builtin_shufflevector(a, b, 1, 3); }

    static void loadRelative(const Body* bodies, const std::int32_t* a, const std::int32_t* b, Relative<PairLanes>& relative)
    {
        Real xy[2], zm[2], sxy[2], szm[2];
        for (int l = 0; l < lanes; ++l)
        {
            const Body& bodyA = bodies[a[l]];
            const Body& bodyB = bodies[b[l]];
            xy[l] = load(bodyA.v) - load(bodyB.v);
            zm[l] = load(bodyA.v + 2) + Real{-1.0, 1.0}*load(bodyB.v + 2);
            sxy[l] = load(bodyA.s) + load(bodyB.s);
            szm[l] = load(bodyA.s + 2) + load(bodyB.s + 2);
        }
        relative = {{low(xy[0], xy[1]), high(xy[0], xy[1]), low(zm[0], zm[1])}, high(zm[0], zm[1]),
                    {low(sxy[0], sxy[1]), high(sxy[0], sxy[1]), low(szm[0], szm[1])}, high(szm[0], szm[1])};
    }

    static bool isAnyPositive(Real x) { return x[0] > 0.0 || x[1] > 0.0; }

    static void loadTurning(const Body* bodies, const std::int32_t* a, const std::int32_t* b, const double* shareA, const double* shareB, Turning<PairLanes>& turning)
    {
        Real xy[2], zm[2];
        for (int l = 0; l < lanes; ++l)
        {
            xy[l] = shareA[l]*load(bodies[a[l]].s) - shareB[l]*load(bodies[b[l]].s);
            zm[l] = shareA[l]*load(bodies[a[l]].s + 2) - shareB[l]*load(bodies[b[l]].s + 2);
        }
        turning = {{low(xy[0], xy[1]), high(xy[0], xy[1]), low(zm[0], zm[1])}, high(zm[0], zm[1])};
    }

    static void add(double* row, double mobility, Real xy, Real z)
    {
        store(row, load(row) + mobility*xy);
        store(row + 2, load(row + 2) + mobility*z);
    }

    template<bool hasSpin>
    __attribute__((always_inline)) static void push(Body* bodies, const std::int32_t* a, const std::int32_t* b, Real dx, Real dy, Real dz, Real mx, Real my, Real mz)
    {
        const Real dxy[2] = {low(dx, dy), high(dx, dy)}, dz0[2] = {low(dz, zero()), high(dz, zero())};
        const Real mxy[2] = {low(mx, my), high(mx, my)}, mz0[2] = {low(mz, zero()), high(mz, zero())};
        for (int l = 0; l < lanes; ++l)
        {
            Body& bodyA = bodies[a[l]];
            Body& bodyB = bodies[b[l]];
            add(bodyA.v, bodyA.invMass, dxy[l], dz0[l]);
            add(bodyB.v, -bodyB.invMass, dxy[l], dz0[l]);
            if (!hasSpin) continue;
            add(bodyA.s, bodyA.invSpin, mxy[l], mz0[l]);
            add(bodyB.s, bodyB.invSpin, mxy[l], mz0[l]);
        }
    }

    using Vector = LaneVector<PairLanes>;

    __attribute__((always_inline)) static void pushTurning
    (
        Body* bodies, const std::int32_t* a, const std::int32_t* b, const double* shareA, const double* shareB, const Vector& d, const Vector& m, const Vector& q
    )
    {
        push<true>(bodies, a, b, d.x, d.y, d.z, m.x, m.y, m.z);
        const Real xy[2] = {low(q.x, q.y), high(q.x, q.y)}, z0[2] = {low(q.z, zero()), high(q.z, zero())};
        for (int l = 0; l < lanes; ++l)
        {
            add(bodies[a[l]].s, bodies[a[l]].invSpin*shareA[l], xy[l], z0[l]);
            add(bodies[b[l]].s, -bodies[b[l]].invSpin*shareB[l], xy[l], z0[l]);
        }
    }
};

} // namespace

SweepKernels portableKernels() { return makeKernels<PairLanes>("portable"); }

} // namespace nscd
