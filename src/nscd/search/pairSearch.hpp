// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Linked-cell search for pairs of bodies nearer than the sum of their effective radii.
#pragma once

#include "nscd/base/periodicBox.hpp"
#include "nscd/search/cellGrid.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace nscd
{

struct BodyPair
{
    int a;                             ///< a < b, or a == b never
    int b;
    std::array<signed char, 3> image;  ///< shift of b in periods: its image is at x_b + image*length
};

/// Finds pairs again and again, and keeps its memory meanwhile.
/// Method:   one grid per octave of size; a body looks in its own grid (half stencil) and, row by row of its sphere, in the finer ones.
class PairSearch
{
public:
    /// All pairs with |x_a - x_b - image*length| < size_a + size_b.
    /// Shapes:   position [n], size [n]; result ordered by a, valid until the next call
    /// Errors:   std::invalid_argument if a period is shorter than twice the largest radius given, or where there are more than `mostPairs`
    const std::vector<BodyPair>& find
    (
        const std::vector<Vec3>& position, const std::vector<double>& size, const PeriodicBox& box, double maxRadius,
        std::size_t mostPairs = std::numeric_limits<std::size_t>::max()
    );

    /// Takes some pairs; false: no more are wanted.
    using TakePairs = std::function<bool(const std::vector<BodyPair>&)>;

    /// The same pairs in no order, a few thousand at a time, for scenes that may have more of them than memory holds.
    /// Errors:   as find
    void findInPieces
    (
        const std::vector<Vec3>& position, const std::vector<double>& size, const PeriodicBox& box, double maxRadius, const TakePairs& take
    );

    /// Holds bodies for around().
    void fill(const std::vector<Vec3>& position, const std::vector<double>& size, const PeriodicBox& box);
    /// Those of them with |x - x_b - image*length| < size + size_b, as b of pairs with a = -1; until the next call.
    const std::vector<BodyPair>& around(const Vec3& x, double size, const PeriodicBox& box);

private:
    void groupByOctave(const std::vector<double>& size);
    template<class IsEnough>
    void lookUp(const std::vector<Vec3>& position, const std::vector<double>& size, const PeriodicBox& box, const IsEnough& isEnough);

    std::vector<CellGrid> grids_;   ///< finest first
    std::vector<BodyPair> found_, sorted_;
    std::vector<std::uint32_t> next_;
};

/// The same, once.
std::vector<BodyPair> findPairs
(
    const std::vector<Vec3>& position, const std::vector<double>& size, const PeriodicBox& box, double maxRadius
);

} // namespace nscd
