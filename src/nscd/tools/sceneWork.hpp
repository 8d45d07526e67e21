// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a scene asks of the method, in words.
#pragma once

#include "nscd/scene/contactSettings.hpp"
#include "nscd/scene/grains.hpp"
#include "nscd/scene/materials.hpp"

#include <string>

namespace nscd
{

/// The work chosen for all steps of a scene, for logs: vector path, laws, kernel, passes.
/// Errors: std::invalid_argument for a vector path that this processor lacks
std::string describeWork(const Materials& materials, const GrainShape& shape, const ContactSettings& settings);

} // namespace nscd
