// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The contact sweep four lanes at a time, for processors with AVX2 and FMA.
#if defined(__x86_64__)
#pragma GCC target("avx2,fma")
#include <immintrin.h>
#endif

#include "sweepKernel.hpp"
#include "sweepKernels.hpp"

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
    static Real tiny() { return _mm256_set1_pd(1e-300); }
    static Real load(const double* p) { return _mm256_loadu_pd(p); }
    static void store(double* p, Real x) { _mm256_storeu_pd(p, x); }
    static Real max(Real a, Real b) { return _mm256_max_pd(a, b); }
    static Real sqrt(Real a) { return _mm256_sqrt_pd(a); }
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

    static void transpose(Real& a, Real& b, Real& c, Real& d)
    {
        const Real ab0 = _mm256_unpacklo_pd(a, b), ab1 = _mm256_unpackhi_pd(a, b);
        const Real cd0 = _mm256_unpacklo_pd(c, d), cd1 = _mm256_unpackhi_pd(c, d);
        a = _mm256_permute2f128_pd(ab0, cd0, 0x20);
        b = _mm256_permute2f128_pd(ab1, cd1, 0x20);
        c = _mm256_permute2f128_pd(ab0, cd0, 0x31);
        d = _mm256_permute2f128_pd(ab1, cd1, 0x31);
    }

    static void loadBodies(const Body* bodies, const std::int32_t* index, Real (&x)[8])
    {
        for (int l = 0; l < lanes; ++l)
        {
            const double* body = bodies[index[l]].v;
            x[l] = _mm256_load_pd(body);
            x[4 + l] = _mm256_load_pd(body + 4);
        }
        transpose(x[0], x[1], x[2], x[3]);
        transpose(x[4], x[5], x[6], x[7]);
    }

    static void storeBodies(Body* bodies, const std::int32_t* index, Real (&x)[8])
    {
        transpose(x[0], x[1], x[2], x[3]);
        transpose(x[4], x[5], x[6], x[7]);
        for (int l = 0; l < lanes; ++l)
        {
            double* body = bodies[index[l]].v;
            _mm256_store_pd(body, x[l]);
            _mm256_store_pd(body + 4, x[4 + l]);
        }
    }
};

} // namespace

SweepKernels avx2Kernels() { return makeKernels<Avx2Lanes>("AVX2"); }

} // namespace nscd
#else
namespace nscd { SweepKernels avx2Kernels() { return portableKernels(); } }
#endif
