// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Run-time choice of the vector path.
#include "nscd/kernels/sweepKernels.hpp"

#include "nscd/base/invalidValue.hpp"

#include <string>

namespace nscd
{

namespace
{

bool hasAvx2()
{
#if defined(__x86_64__)
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
    return false;
#endif
}

bool hasAvx512()
{
#if defined(__x86_64__)
    return hasAvx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
#else
    return false;
#endif
}

} // namespace

SweepKernels chooseKernels(const char* vectorPath)
{
    const std::string path = vectorPath;
    if (path == "portable") return portableKernels();
    if (path == "auto") return hasAvx512() ? avx512Kernels() : hasAvx2() ? avx2Kernels() : portableKernels();
    if (path == "AVX2" && hasAvx2()) return avx2Kernels();
    if (path == "AVX512" && hasAvx512()) return avx512Kernels();
    throw invalidValue("vectorPath", path, "auto, portable, AVX2, AVX512, the last two only on processors that have them");
}

SweepKernels normalOnly(SweepKernels kernels)
{
    kernels.sweep = kernels.sweepFrictionless;
    kernels.sweepOn = kernels.sweepOnFrictionless;
    kernels.evaluate = kernels.evaluateFrictionless;
    kernels.replaceImpulses = kernels.replaceFrictionless;
    kernels.startWarm = kernels.startWarmFrictionless;
    return kernels;
}

SweepKernels held(SweepKernels kernels)
{
    kernels.sweep = kernels.sweepHeld;
    kernels.sweepOn = kernels.sweepOnHeld;
    kernels.evaluate = kernels.evaluateHeld;
    return kernels;
}

SweepKernels planar(SweepKernels kernels, int axis)
{
    kernels.sweep = kernels.sweepDiscs[axis];
    kernels.sweepOn = kernels.sweepOnDiscs[axis];
    kernels.evaluate = kernels.evaluateDiscs[axis];
    return kernels;
}

} // namespace nscd
