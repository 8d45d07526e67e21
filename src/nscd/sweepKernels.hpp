// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The sweep kernels there are, and the choice among them.
#pragma once

#include "contactBlock.hpp"

namespace nscd
{

SweepKernels portableKernels();
SweepKernels avx2Kernels();
SweepKernels avx512Kernels();

/// The kernels of a vector path: auto takes the widest this processor has.
/// Errors: std::invalid_argument for an unknown name, or a path this processor lacks
SweepKernels chooseKernels(const char* vectorPath);

} // namespace nscd
