// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Finding overlaps.
#include "nscd/search/overlaps.hpp"

#include "nscd/search/pairSearch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace nscd
{

namespace
{

using Cell = std::array<long, 3>;

/// Grains sorted into about as many equal cubes as there are grains.
class GrainBins
{
public:
    explicit GrainBins(const Grains& grains)
    {
        for (const Vec3& x : grains.position) bounds_.extend(x);
        const double meanRadius = grains.size()
            ? std::accumulate(grains.radius.begin(), grains.radius.end(), 0.0)/grains.size() : 1.0;
        const Vec3 extent = bounds_.isEmpty() ? Vec3::Zero() : Vec3(bounds_.sizes());
        const double perGrain = extent.prod()/std::max<std::size_t>(1, grains.size());
        size_ = std::max(2*meanRadius, std::cbrt(perGrain));
        // Grains in a line, or one far away, would have many more cubes.
        const double most = 4.0*grains.size() + 64.0;
        while ((extent.array()/size_ + 1.0).prod() > most) size_ *= 1.26;
        for (int k = 0; k < 3; ++k) count_[k] = 1 + static_cast<long>(extent[k]/size_);
        sort(grains);
    }

    /// Calls visit(grain) for all grains whose centers may lie in a box.
    template<class Visit>
    void forEachIn(const Eigen::AlignedBox3d& box, const Visit& visit) const
    {
        if (bounds_.isEmpty() || !bounds_.intersects(box)) return;
        const Cell first = cellOf(box.min());
        const Cell last = cellOf(box.max());
        for (long k = first[2]; k <= last[2]; ++k)
        {
            for (long j = first[1]; j <= last[1]; ++j)
            {
                const std::size_t row = index({0, j, k});
                for (std::size_t s = start_[row + first[0]]; s < start_[row + last[0] + 1]; ++s) visit(order_[s]);
            }
        }
    }

private:
    Cell cellOf(const Vec3& x) const
    {
        Cell cell;
        for (int k = 0; k < 3; ++k)
        {
            const double c = std::floor((x[k] - bounds_.min()[k])/size_);
            cell[k] = static_cast<long>(std::min(std::max(c, 0.0), double(count_[k] - 1)));
        }
        return cell;
    }

    std::size_t index(const Cell& cell) const { return (cell[2]*count_[1] + cell[1])*count_[0] + cell[0]; }

    void sort(const Grains& grains)
    {
        start_.assign(count_[0]*count_[1]*count_[2] + 1, 0);
        for (const Vec3& x : grains.position) ++start_[index(cellOf(x)) + 1];
        for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
        std::vector<std::size_t> next = start_;
        order_.resize(grains.size());
        for (std::size_t i = 0; i < grains.size(); ++i) order_[next[index(cellOf(grains.position[i]))]++] = i;
    }

    Eigen::AlignedBox3d bounds_;
    double size_ = 1.0;
    Cell count_ = {1, 1, 1};
    std::vector<std::size_t> start_;
    std::vector<std::size_t> order_;
};

Overlap overlapOf(const Grains& grains, const BodyPair& pair, const PeriodicBox& box)
{
    Vec3 difference = grains.position[pair.a] - grains.position[pair.b];
    for (int k = 0; k < 3; ++k) difference[k] -= pair.image[k]*box.length[k];
    const double ra = grains.radius[pair.a], rb = grains.radius[pair.b], distance = difference.norm();
    return {std::size_t(pair.a), pair.b, (ra + rb - distance)/(2*std::min(ra, rb)), distance < 1e-10*(ra + rb)};
}

} // namespace

std::vector<Overlap> grainOverlaps(const Grains& grains, const PeriodicBox& box, double maxShare)
{
    std::vector<Overlap> found;
    if (grains.size() == 0) return found;
    const double maxRadius = *std::max_element(grains.radius.begin(), grains.radius.end());
    const std::vector<int> bodyOf = bodyOfGrains(grains);
    PairSearch().findInPieces(grains.position, grains.radius, box, maxRadius, [&](const std::vector<BodyPair>& pairs)
    {
        for (const BodyPair& pair : pairs)
        {
            if (!bodyOf.empty() && bodyOf[pair.a] >= 0 && bodyOf[pair.a] == bodyOf[pair.b]) continue;
            const Overlap overlap = overlapOf(grains, pair, box);
            const bool areFixed = grains.isFixed[pair.a] && grains.isFixed[pair.b];
            if (overlap.isCoincident || (overlap.share > maxShare && !areFixed)) found.push_back(overlap);
        }
        return found.size() < mostOverlaps;
    });
    return found;
}

std::vector<Overlap> wallOverlaps(const Grains& grains, const Walls& walls, double maxShare)
{
    std::vector<Overlap> found;
    if (grains.size() == 0) return found;
    const GrainBins bins(grains);
    const double maxRadius = *std::max_element(grains.radius.begin(), grains.radius.end());
    for (std::size_t w = 0; w < walls.regions.size() && found.size() < mostOverlaps; ++w)
    {
        const WallRegion& region = walls.regions[w];
        const bool isPlane = region.edges.empty();
        const auto check = [&](std::size_t i)
        {
            const double distance = nearestPoint(walls, static_cast<int>(w), grains.position[i]).distance;
            const double share = (grains.radius[i] - distance)/(2*grains.radius[i]);
            // Behind a bounded wall lies another part of the domain; behind a plane lies nothing.
            const bool isBehind = distance < 0 && !isPlane;
            if (share > maxShare && !isBehind && !grains.isFixed[i]) found.push_back({i, -1 - long(w), share, false});
        };
        if (isPlane)
        {
            for (std::size_t i = 0; i < grains.size(); ++i) check(i);
            continue;
        }
        Eigen::AlignedBox3d box = moved(bounds(region), walls.patches[region.patch].pose);
        box.min().array() -= maxRadius;
        box.max().array() += maxRadius;
        bins.forEachIn(box, check);
    }
    return found;
}

} // namespace nscd
