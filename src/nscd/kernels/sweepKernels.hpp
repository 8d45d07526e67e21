// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The sweep kernels there are, and the choice among them.
#pragma once

#include "nscd/kernels/contactBlock.hpp"

namespace nscd
{

SweepKernels portableKernels();
SweepKernels avx2Kernels();
SweepKernels avx512Kernels();

/// The kernels of a vector path: auto takes the widest this processor has.
/// Errors: std::invalid_argument for an unknown name, or a path this processor lacks
SweepKernels chooseKernels(const char* vectorPath);

/// Those of a scene without friction, which know of no spins, in the place of all others.
SweepKernels normalOnly(SweepKernels kernels);

/// Those of friction that is held: the friction of a block is the bound itself [N s]. Impulses are not replaced by them.
SweepKernels held(SweepKernels kernels);

/// Those of discs in a plane, in the place of those of spheres, for steps in which nothing has a component out of it. `axis`: 0, 1 or 2.
SweepKernels planar(SweepKernels kernels, int axis);

} // namespace nscd
