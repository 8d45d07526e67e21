// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The contact sweep eight lanes at a time, for processors with AVX-512.
#if defined(__x86_64__)
#pragma GCC target("avx512f,avx512dq,avx512vl,avx2,fma")
// GCC 12 warns of the deliberately undefined operand inside its own intrinsics (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <immintrin.h>
#endif

#include "sweepKernel.hpp"
#include "sweepKernels.hpp"

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
    static Real tiny() { return _mm512_set1_pd(1e-300); }
    static Real load(const double* p) { return _mm512_loadu_pd(p); }
    static void store(double* p, Real x) { _mm512_storeu_pd(p, x); }
    static Real max(Real a, Real b) { return _mm512_max_pd(a, b); }
    static Real sqrt(Real a) { return _mm512_sqrt_pd(a); }
    template<class Mask>
    static Real select(Mask mask, Real a, Real b) { return mask ? a : b; }

    static void prefetch(const Body* bodies, const ContactBlock& block)
    {
        for (int l = 0; l < blockLanes; ++l)
        {
            __builtin_prefetch(bodies + block.a[l]);
            __builtin_prefetch(bodies + block.b[l]);
        }
    }

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

    static void loadBodies(const Body* bodies, const std::int32_t* index, Real (&x)[8])
    {
        for (int l = 0; l < lanes; ++l) x[l] = _mm512_load_pd(bodies[index[l]].v);
        transpose(x);
    }

    static void storeBodies(Body* bodies, const std::int32_t* index, Real (&x)[8])
    {
        transpose(x);
        for (int l = 0; l < lanes; ++l) _mm512_store_pd(bodies[index[l]].v, x[l]);
    }
};

} // namespace

SweepKernels avx512Kernels() { return makeKernels<Avx512Lanes>("AVX512"); }

} // namespace nscd
#else
namespace nscd { SweepKernels avx512Kernels() { return portableKernels(); } }
#endif
