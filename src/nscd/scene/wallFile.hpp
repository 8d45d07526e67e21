// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing walls where they are, for ParaView.
#pragma once

#include "nscd/scene/walls.hpp"

#include <ostream>

namespace nscd
{

/// Writes the finite regions of a patch at its present pose as polygons of a legacy VTK file (ASCII, POLYDATA); planes have no shape.
/// A region is written as the loops of its outline; holes as polygons of their own.
void writeVtk(std::ostream& os, const Walls& walls, int patch);

} // namespace nscd
