// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The contact sweep eight lanes at a time, for processors with AVX-512.
// Tested by tests/unit/nscd/kernels/sweepKernelsTest.cpp
#if defined(__x86_64__)
#pragma GCC target("avx512f,avx512dq,avx512vl,avx2,fma")
// GCC 12 warns of the deliberately undefined operand inside its own intrinsics (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <immintrin.h>
#endif

#include "nscd/kernels/sweepKernel.hpp"
#include "nscd/kernels/sweepKernels.hpp"

#if defined(__x86_64__)
namespace nscd
{
namespace
{

struct Avx512Lanes
{
    using Real = __m512d;
    static constexpr int lanes = 8;

    static Real zero() { return _mm512_setzero_pd(); }
    static Real one() { return _mm512_set1_pd(1.0); }
    static Real all(double a) { return _mm512_set1_pd(a); }
    static Real min(Real a, Real b) { return _mm512_min_pd(a, b); }
    static Real tiny() { return _mm512_set1_pd(1e-300); }
    static Real load(const double* p) { return _mm512_loadu_pd(p); }
    static void store(double* p, Real x) { _mm512_storeu_pd(p, x); }
    static Real max(Real a, Real b) { return _mm512_max_pd(a, b); }
    static Real sqrt(Real a) { return _mm512_sqrt_pd(a); }
    template<class Mask>
    static Real select(Mask mask, Real a, Real b) { return mask ? a : b; }

    /// Transposes eight rows of eight; its own inverse.
    static void transpose(Real (&x)[8])
    {
        Real t[8], u[8];
        for (int k = 0; k < 8; k += 2)
        {
            t[k] = _mm512_unpacklo_pd(x[k], x[k + 1]);
            t[k + 1] = _mm512_unpackhi_pd(x[k], x[k + 1]);
        }
        for (int k = 0; k < 8; k += 4)
        {
            for (int m = 0; m < 2; ++m)
            {
                u[k + m] = _mm512_shuffle_f64x2(t[k + m], t[k + 2 + m], 0x88);
                u[k + 2 + m] = _mm512_shuffle_f64x2(t[k + m], t[k + 2 + m], 0xdd);
            }
        }
        for (int m = 0; m < 4; ++m)
        {
            x[m] = _mm512_shuffle_f64x2(u[m], u[4 + m], 0x88);
            x[4 + m] = _mm512_shuffle_f64x2(u[m], u[4 + m], 0xdd);
        }
    }

    static void loadRelative(const Body* bodies, const std::int32_t* a, const std::int32_t* b, Relative<Avx512Lanes>& relative)
    {
        const Real sign = _mm512_setr_pd(-1, -1, -1, 1, 1, 1, 1, 1);
        Real x[8];
        for (int l = 0; l < lanes; ++l) x[l] = _mm512_load_pd(bodies[a[l]].v) + sign*_mm512_load_pd(bodies[b[l]].v);
        transpose(x);
        relative = {{x[0], x[1], x[2]}, x[3], {x[4], x[5], x[6]}, x[7]};
    }

    static bool isAnyPositive(Real x) { return _mm512_cmp_pd_mask(x, zero(), _CMP_GT_OQ) != 0; }

    static void loadTurning(const Body* bodies, const std::int32_t* a, const std::int32_t* b, const double* shareA, const double* shareB, Turning<Avx512Lanes>& turning)
    {
        __m256d row[8];
        for (int l = 0; l < lanes; ++l) row[l] = _mm256_set1_pd(shareA[l])*_mm256_load_pd(bodies[a[l]].s) - _mm256_set1_pd(shareB[l])*_mm256_load_pd(bodies[b[l]].s);
        Real x[4];
        for (int l = 0; l < 4; ++l) x[l] = _mm512_insertf64x4(_mm512_castpd256_pd512(row[l]), row[l + 4], 1);
        const Real xz01 = _mm512_unpacklo_pd(x[0], x[1]), yc01 = _mm512_unpackhi_pd(x[0], x[1]);
        const Real xz23 = _mm512_unpacklo_pd(x[2], x[3]), yc23 = _mm512_unpackhi_pd(x[2], x[3]);
        const __m512i first = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13), second = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
        turning.w[0] = _mm512_permutex2var_pd(xz01, first, xz23);
        turning.w[1] = _mm512_permutex2var_pd(yc01, first, yc23);
        turning.w[2] = _mm512_permutex2var_pd(xz01, second, xz23);
        turning.coupling = _mm512_permutex2var_pd(yc01, second, yc23);
    }

    /// Rows of four of the columns x, y, z, 0.
    static void rows(Real x, Real y, Real z, __m256d (&row)[8])
    {
        const Real xy0 = _mm512_unpacklo_pd(x, y), xy1 = _mm512_unpackhi_pd(x, y);
        const Real z0 = _mm512_unpacklo_pd(z, zero()), z1 = _mm512_unpackhi_pd(z, zero());
        const __m512i first = _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11), second = _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15);
        const Real r02 = _mm512_permutex2var_pd(xy0, first, z0), r13 = _mm512_permutex2var_pd(xy1, first, z1);
        const Real r46 = _mm512_permutex2var_pd(xy0, second, z0), r57 = _mm512_permutex2var_pd(xy1, second, z1);
        row[0] = _mm512_castpd512_pd256(r02);
        row[1] = _mm512_castpd512_pd256(r13);
        row[2] = _mm512_extractf64x4_pd(r02, 1);
        row[3] = _mm512_extractf64x4_pd(r13, 1);
        row[4] = _mm512_castpd512_pd256(r46);
        row[5] = _mm512_castpd512_pd256(r57);
        row[6] = _mm512_extractf64x4_pd(r46, 1);
        row[7] = _mm512_extractf64x4_pd(r57, 1);
    }

    static void add(double* row, double mobility, __m256d p) { _mm256_store_pd(row, _mm256_load_pd(row) + _mm256_set1_pd(mobility)*p); }
    static void subtract(double* row, double mobility, __m256d p) { _mm256_store_pd(row, _mm256_load_pd(row) - _mm256_set1_pd(mobility)*p); }

    template<bool hasSpin>
    __attribute__((always_inline)) static void push(Body* bodies, const std::int32_t* a, const std::int32_t* b, Real dx, Real dy, Real dz, Real mx, Real my, Real mz)
    {
        __m256d d[8], m[8];
        rows(dx, dy, dz, d);
        if (hasSpin) rows(mx, my, mz, m);
        for (int l = 0; l < lanes; ++l)
        {
            Body& bodyA = bodies[a[l]];
            Body& bodyB = bodies[b[l]];
            add(bodyA.v, bodyA.invMass, d[l]);
            subtract(bodyB.v, bodyB.invMass, d[l]);
            if (!hasSpin) continue;
            add(bodyA.s, bodyA.invSpin, m[l]);
            add(bodyB.s, bodyB.invSpin, m[l]);
        }
    }

    using Vector = LaneVector<Avx512Lanes>;

    __attribute__((always_inline)) static void pushTurning
    (
        Body* bodies, const std::int32_t* a, const std::int32_t* b, const double* shareA, const double* shareB, const Vector& d, const Vector& m, const Vector& q
    )
    {
        __m256d v[8], s[8], t[8];
        rows(d.x, d.y, d.z, v);
        rows(m.x, m.y, m.z, s);
        rows(q.x, q.y, q.z, t);
        for (int l = 0; l < lanes; ++l)
        {
            Body& bodyA = bodies[a[l]];
            Body& bodyB = bodies[b[l]];
            add(bodyA.v, bodyA.invMass, v[l]);
            subtract(bodyB.v, bodyB.invMass, v[l]);
            add(bodyA.s, bodyA.invSpin, s[l] + _mm256_set1_pd(shareA[l])*t[l]);
            add(bodyB.s, bodyB.invSpin, s[l] - _mm256_set1_pd(shareB[l])*t[l]);
        }
    }
};

} // namespace

SweepKernels avx512Kernels() { return makeKernels<Avx512Lanes>("AVX512"); }

} // namespace nscd
#else
namespace nscd { SweepKernels avx512Kernels() { return portableKernels(); } }
#endif
