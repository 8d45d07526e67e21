// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The contact sweep four lanes at a time, for processors with AVX2 and FMA.
// Tested by tests/unit/nscd/kernels/sweepKernelsTest.cpp
#if defined(__x86_64__)
#pragma GCC target("avx2,fma")
#include <immintrin.h>
#endif

#include "nscd/kernels/sweepKernel.hpp"
#include "nscd/kernels/sweepKernels.hpp"

#if defined(__x86_64__)
namespace nscd
{
namespace
{

struct Avx2Lanes
{
    using Real = __m256d;
    static constexpr int lanes = 4;

    static Real zero() { return _mm256_setzero_pd(); }
    static Real one() { return _mm256_set1_pd(1.0); }
    static Real all(double a) { return _mm256_set1_pd(a); }
    static Real min(Real a, Real b) { return _mm256_min_pd(a, b); }
    static Real tiny() { return _mm256_set1_pd(1e-300); }
    static Real load(const double* p) { return _mm256_loadu_pd(p); }
    static void store(double* p, Real x) { _mm256_storeu_pd(p, x); }
    static Real max(Real a, Real b) { return _mm256_max_pd(a, b); }
    static Real sqrt(Real a) { return _mm256_sqrt_pd(a); }
    template<class Mask>
    static Real select(Mask mask, Real a, Real b) { return mask ? a : b; }

    static void transpose(Real& a, Real& b, Real& c, Real& d)
    {
        const Real ab0 = _mm256_unpacklo_pd(a, b), ab1 = _mm256_unpackhi_pd(a, b);
        const Real cd0 = _mm256_unpacklo_pd(c, d), cd1 = _mm256_unpackhi_pd(c, d);
        a = _mm256_permute2f128_pd(ab0, cd0, 0x20);
        b = _mm256_permute2f128_pd(ab1, cd1, 0x20);
        c = _mm256_permute2f128_pd(ab0, cd0, 0x31);
        d = _mm256_permute2f128_pd(ab1, cd1, 0x31);
    }

    static void loadRelative(const Body* bodies, const std::int32_t* a, const std::int32_t* b, Relative<Avx2Lanes>& relative)
    {
        const Real sign = _mm256_setr_pd(-1, -1, -1, 1);
        Real v[4], s[4];
        for (int l = 0; l < lanes; ++l)
        {
            v[l] = _mm256_load_pd(bodies[a[l]].v) + sign*_mm256_load_pd(bodies[b[l]].v);
            s[l] = _mm256_load_pd(bodies[a[l]].s) + _mm256_load_pd(bodies[b[l]].s);
        }
        transpose(v[0], v[1], v[2], v[3]);
        transpose(s[0], s[1], s[2], s[3]);
        relative = {{v[0], v[1], v[2]}, v[3], {s[0], s[1], s[2]}, s[3]};
    }

    static bool isAnyPositive(Real x) { return _mm256_movemask_pd(_mm256_cmp_pd(x, zero(), _CMP_GT_OQ)) != 0; }

    static void loadTurning(const Body* bodies, const std::int32_t* a, const std::int32_t* b, const double* shareA, const double* shareB, Turning<Avx2Lanes>& turning)
    {
        Real w[4];
        for (int l = 0; l < lanes; ++l) w[l] = _mm256_set1_pd(shareA[l])*_mm256_load_pd(bodies[a[l]].s) - _mm256_set1_pd(shareB[l])*_mm256_load_pd(bodies[b[l]].s);
        transpose(w[0], w[1], w[2], w[3]);
        turning = {{w[0], w[1], w[2]}, w[3]};
    }

    template<bool hasSpin>
    __attribute__((always_inline)) static void push(Body* bodies, const std::int32_t* a, const std::int32_t* b, Real dx, Real dy, Real dz, Real mx, Real my, Real mz)
    {
        Real d[4] = {dx, dy, dz, zero()}, m[4] = {mx, my, mz, zero()};
        transpose(d[0], d[1], d[2], d[3]);
        transpose(m[0], m[1], m[2], m[3]);
        for (int l = 0; l < lanes; ++l)
        {
            Body& bodyA = bodies[a[l]];
            Body& bodyB = bodies[b[l]];
            _mm256_store_pd(bodyA.v, _mm256_load_pd(bodyA.v) + _mm256_set1_pd(bodyA.invMass)*d[l]);
            _mm256_store_pd(bodyB.v, _mm256_load_pd(bodyB.v) - _mm256_set1_pd(bodyB.invMass)*d[l]);
            if (!hasSpin) continue;
            _mm256_store_pd(bodyA.s, _mm256_load_pd(bodyA.s) + _mm256_set1_pd(bodyA.invSpin)*m[l]);
            _mm256_store_pd(bodyB.s, _mm256_load_pd(bodyB.s) + _mm256_set1_pd(bodyB.invSpin)*m[l]);
        }
    }

    using Vector = LaneVector<Avx2Lanes>;

    __attribute__((always_inline)) static void pushTurning
    (
        Body* bodies, const std::int32_t* a, const std::int32_t* b, const double* shareA, const double* shareB, const Vector& d, const Vector& m, const Vector& q
    )
    {
        Real v[4] = {d.x, d.y, d.z, zero()}, s[4] = {m.x, m.y, m.z, zero()}, t[4] = {q.x, q.y, q.z, zero()};
        transpose(v[0], v[1], v[2], v[3]);
        transpose(s[0], s[1], s[2], s[3]);
        transpose(t[0], t[1], t[2], t[3]);
        for (int l = 0; l < lanes; ++l)
        {
            Body& bodyA = bodies[a[l]];
            Body& bodyB = bodies[b[l]];
            _mm256_store_pd(bodyA.v, _mm256_load_pd(bodyA.v) + _mm256_set1_pd(bodyA.invMass)*v[l]);
            _mm256_store_pd(bodyB.v, _mm256_load_pd(bodyB.v) - _mm256_set1_pd(bodyB.invMass)*v[l]);
            _mm256_store_pd(bodyA.s, _mm256_load_pd(bodyA.s) + _mm256_set1_pd(bodyA.invSpin)*(s[l] + _mm256_set1_pd(shareA[l])*t[l]));
            _mm256_store_pd(bodyB.s, _mm256_load_pd(bodyB.s) + _mm256_set1_pd(bodyB.invSpin)*(s[l] - _mm256_set1_pd(shareB[l])*t[l]));
        }
    }
};

} // namespace

SweepKernels avx2Kernels() { return makeKernels<Avx2Lanes>("AVX2"); }

} // namespace nscd
#else
namespace nscd { SweepKernels avx2Kernels() { return portableKernels(); } }
#endif
