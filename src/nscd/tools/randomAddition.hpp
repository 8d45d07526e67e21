// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Random sequential addition: spheres put one after the other where they touch nothing, and left there.
// Tested by tests/unit/nscd/tools/fillingTest.cpp
#pragma once

#include "nscd/tools/fillingSpace.hpp"

namespace nscd
{

struct Spheres
{
    std::vector<Vec3> center;     ///< [m]
    std::vector<double> radius;   ///< [m]

    std::size_t size() const { return center.size(); }
};

/// Gives spheres places that are uniform in a space, clear of its obstacles, of `others` and of one another; the largest comes first, equal ones in
/// their order. Those that are to grow by a factor keep as far off `others` as they then must, and beside them off obstacles too: so that none
/// grows in a pocket that is too small for it. Sets their centers, and returns how many found a place: all, or those before one that found none in a hundred thousand tries.
/// Cost: about linear in the number up to a solid fraction of 0.3; the last ones of 0.37 take ten thousands of tries each
std::size_t addAtRandom(const FillingSpace& space, const Spheres& others, const RandomNumbers& random, Spheres& spheres, double growth = 1.0);

} // namespace nscd
