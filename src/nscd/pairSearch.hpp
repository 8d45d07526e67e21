// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Linked-cell search for pairs of bodies nearer than the sum of their effective radii.
#pragma once

#include "periodicBox.hpp"

#include <array>
#include <vector>

namespace nscd
{

struct BodyPair
{
    int a;                             ///< a < b, or a == b never
    int b;
    std::array<signed char, 3> image;  ///< shift of b in periods: its image is at x_b + image*length
};

/// All pairs with |x_a - x_b - image*length| < size_a + size_b.
/// Method:   one grid per octave of size; a body looks in its own grid (half stencil) and in the coarser ones.
/// Shapes:   position [n], size [n]; result ordered by a
/// Errors:   std::invalid_argument if a period is shorter than twice the largest radius given
std::vector<BodyPair> findPairs
(
    const std::vector<Vec3>& position, const std::vector<double>& size, const PeriodicBox& box, double maxRadius
);

} // namespace nscd
