// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains in a file that ParaView opens as it is; contacts: nscd/tools/contactFiles.hpp.
#pragma once

#include "nscd/scene/grains.hpp"

#include <string>
#include <vector>

namespace nscdGrains
{

/// Grains as points: d, U, omega, fContact (net contact force, N), id, material.
/// Errors: std::runtime_error where the file cannot be written
void writeGrainsVtp(const std::string& path, double time, const nscd::Grains& grains, const std::vector<nscd::Vec3>& contactForce);

} // namespace nscdGrains
