// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Boxes up the tree of ranks, points down.
#include "parallel/pointRouting.hpp"

#include "parallel/halfBoxes.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace nscd
{

namespace
{

using Box = Eigen::AlignedBox3d;

bool lies(const RoutedPoint& point, const Box& box)
{
    return !box.isEmpty() && box.contains(Vec3(point.position.data()));
}

} // namespace

std::vector<RoutedPoint> routePoints(const RankTree& tree, const std::vector<Vec3>& points, const Eigen::AlignedBox3d& own)
{
    std::vector<RoutedPoint> here;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const Vec3& x = points[i];
        here.push_back({{x[0], x[1], x[2]}, tree.all().rank(), static_cast<int>(i)});
    }
    const std::vector<HalfBoxes> halves = boxesOfHalves(tree, own);
    for (std::size_t l = 0; l < halves.size(); ++l)
    {
        const auto isForOther = [&](const RoutedPoint& point) { return lies(point, halves[l].other); };
        const auto isAstray = [&](const RoutedPoint& point) { return !lies(point, halves[l].own); };
        std::vector<RoutedPoint> sent;
        std::copy_if(here.begin(), here.end(), std::back_inserter(sent), isForOther);
        here.erase(std::remove_if(here.begin(), here.end(), isAstray), here.end());
        const std::vector<RoutedPoint> arrived = sendAcross(tree.levels()[l], sent);
        here.insert(here.end(), arrived.begin(), arrived.end());
    }
    here.erase(std::remove_if(here.begin(), here.end(), [&](const RoutedPoint& p) { return !lies(p, own); }), here.end());
    const auto byOrigin = [](const RoutedPoint& a, const RoutedPoint& b)
    {
        return std::tie(a.origin, a.index) < std::tie(b.origin, b.index);
    };
    std::sort(here.begin(), here.end(), byOrigin);
    return here;
}

} // namespace nscd
