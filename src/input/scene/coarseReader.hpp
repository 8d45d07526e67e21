// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading how many real grains a body of a source stands for: `coarseGraining 5;`.
#pragma once

#include "input/scene/scene.hpp"

namespace input
{

/// Diameter of a source's bodies over that of the real grains that each stands for; 1 where the keyword is not there. Takes note in the scene
/// that it is. Diameters and numbers of a source are those of real grains, for its readers to convert.
/// Errors: InputError for numbers below 1 or above 1000; in a program without coarse grains the keyword stays unknown
double readCoarseGraining(const CheckedEntries& given, const Surroundings& around, Scene& scene);

/// Bodies that so many real grains fill whole.
/// Errors: InputError where they fill none, and for the keyword of the number
std::int64_t bodiesOf(long realGrains, double coarseGraining, const Surroundings& around, const CheckedEntries& given, const std::string& keyword);

} // namespace input
