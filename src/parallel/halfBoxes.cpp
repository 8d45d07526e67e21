// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Boxes up the tree of ranks.
#include "parallel/halfBoxes.hpp"

#include "nscd/base/vec3.hpp"

#include <array>

namespace nscd
{

std::vector<HalfBoxes> boxesOfHalves(const RankTree& tree, Eigen::AlignedBox3d own)
{
    using Corners = std::array<double, 6>;
    std::vector<HalfBoxes> halves(tree.levels().size());
    for (std::size_t l = halves.size(); l-- > 0;)
    {
        const Vec3 a = own.min(), b = own.max();
        const Corners other = tellAcross(tree.levels()[l], Corners{a[0], a[1], a[2], b[0], b[1], b[2]});
        halves[l] = {own, Eigen::AlignedBox3d(Vec3(other.data()), Vec3(other.data() + 3))};
        own = own.merged(halves[l].other);
    }
    return halves;
}

} // namespace nscd
