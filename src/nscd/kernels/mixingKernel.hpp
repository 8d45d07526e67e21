// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The passes over memory of an Anderson mixing and of momentum; included by one translation unit per instruction set, as the sweep is, for the
// compiler to vectorize over the lanes.
// Tested by tests/unit/nscd/kernels/sweepKernelsTest.cpp, tests/unit/nscd/solvers/help/andersonAccelerationTest.cpp
#pragma once

#include "nscd/kernels/contactBlock.hpp"

// Lanes never cross a translation unit, so that how they would be returned does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace nscd
{
namespace
{

/// One number for each lane, in as many registers as the instruction set needs.
typedef double Lanes __attribute__((vector_size(blockLanes*sizeof(double))));
typedef float HalfLanes __attribute__((vector_size(blockLanes*sizeof(float))));

inline Lanes loadLanes(const double* p)
{
    Lanes x;
    __builtin_memcpy(&x, p, sizeof x);
    return x;
}

inline Lanes loadLanes(const float* p)
{
    HalfLanes x;
    __builtin_memcpy(&x, p, sizeof x);
    return __builtin_convertvector(x, Lanes);
}

inline void storeLanes(double* p, const Lanes& x) { __builtin_memcpy(p, &x, sizeof x); }

inline void storeLanes(float* p, const Lanes& x)
{
    const HalfLanes rounded = __builtin_convertvector(x, HalfLanes);
    __builtin_memcpy(p, &rounded, sizeof rounded);
}

inline double sumLanes(const Lanes& x)
{
    double sum = 0.0;
    for (int l = 0; l < blockLanes; ++l) sum += x[l];
    return sum;
}

/// Moves the history of eight lanes on, and adds what their newest differences give.
inline void addLaneDifferences
(
    const Lanes& now, const Lanes& weight, const double* start, std::size_t at, const MixingHistory& history,
    Lanes (&gram)[mixingDepth], Lanes (&projection)[mixingDepth]
)
{
    const Lanes f = now - loadLanes(start + at);
    const Lanes df = f - loadLanes(history.defect + at);
    storeLanes(history.imageDifference[history.newest] + at, now - loadLanes(history.image + at));
    storeLanes(history.defectDifference[history.newest] + at, df);
    storeLanes(history.defect + at, f);
    storeLanes(history.image + at, now);
    for (int column = 0; column < history.stored; ++column)
    {
        const Lanes old = loadLanes(history.defectDifference[column] + at);
        gram[column] += weight*df*old;
        projection[column] += weight*f*old;
    }
}

inline MixingSums addDifferences(const ContactBlock* blocks, BlockRange range, const double* start, const MixingHistory& history)
{
    Lanes gram[mixingDepth] = {}, projection[mixingDepth] = {};
    for (std::size_t k = 0; k < range.count; ++k)
    {
        const ContactBlock& block = blocks[range[k]];
        const Lanes tiny = Lanes{} + 1e-300, invWn = loadLanes(block.invWn);
        const Lanes weight = 1.0/(invWn > tiny ? invWn : tiny);
        for (int m = 0; m < 3; ++m)
        {
            addLaneDifferences(loadLanes(block.r[m]), weight, start, (3*k + m)*blockLanes, history, gram, projection);
        }
    }
    MixingSums sums;
    for (int column = 0; column < mixingDepth; ++column)
    {
        sums.gram(column) = sumLanes(gram[column]);
        sums.projection(column) = sumLanes(projection[column]);
    }
    return sums;
}

inline void extrapolateLanes(double* x, double* before, const Lanes& theta)
{
    const Lanes now = loadLanes(x);
    storeLanes(x, now + theta*(now - loadLanes(before)));
    storeLanes(before, now);
}

inline void extrapolateBlock(double (&r)[3][blockLanes], double* before, const Lanes& theta)
{
    for (int m = 0; m < 3; ++m) extrapolateLanes(r[m], before + m*blockLanes, theta);
}

inline void extrapolateImpulses(ContactBlock* blocks, BlockRange range, double* before, double theta)
{
    const Lanes share = Lanes{} + theta;
    for (std::size_t k = 0; k < range.count; ++k) extrapolateBlock(blocks[range[k]].r, before + 3*k*blockLanes, share);
}

static_assert(sizeof(Body) == sizeof(Lanes), "a body is eight numbers, of which two stay");

inline void extrapolateBodies(Body* bodies, Body* before, std::size_t count, double theta)
{
    const Lanes share = Lanes{} + theta;
    for (std::size_t i = 0; i < count; ++i) extrapolateLanes(bodies[i].v, before[i].v, share);
}

} // namespace
} // namespace nscd
