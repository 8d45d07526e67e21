// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grids by octave of size, filled by counting sort.
#include "pairSearch.hpp"

#include "invalidValue.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace nscd
{

namespace
{

using Cell = std::array<int, 3>;
using Image = std::array<signed char, 3>;

/// One uniform grid and the bodies in it, cell by cell.
struct Grid
{
    Vec3 lower;
    Vec3 cellSize;
    Cell count;
    std::vector<int> cellStart;
    std::vector<int> members;
    std::vector<Vec3> memberPosition;
    std::vector<double> memberSize;

    Cell cellOf(const Vec3& x) const
    {
        Cell cell;
        for (int k = 0; k < 3; ++k)
        {
            const double index = std::floor((x[k] - lower[k])/cellSize[k]);
            cell[k] = static_cast<int>(std::min<double>(count[k] - 1, std::max(0.0, index)));
        }
        return cell;
    }

    int linear(const Cell& c) const { return (c[2]*count[1] + c[1])*count[0] + c[0]; }
};

/// Cells at least `minimum` wide, and not many more of them than bodies.
void sizeCells(Grid& grid, const Eigen::AlignedBox3d& extent, const PeriodicBox& box, double minimum, std::size_t bodies)
{
    double width = minimum;
    for (;;)
    {
        double cells = 1.0;
        for (int k = 0; k < 3; ++k)
        {
            const double length = box.isPeriodic(k) ? box.length[k] : extent.sizes()[k];
            grid.lower[k] = box.isPeriodic(k) ? box.lower[k] : extent.min()[k];
            const double count = std::max(1.0, std::floor(length/width));
            cells *= count;
            grid.count[k] = static_cast<int>(std::min(count, 2e6));
            grid.cellSize[k] = std::max(length/count, std::numeric_limits<double>::min());
            if (!box.isPeriodic(k)) grid.cellSize[k] = std::max(grid.cellSize[k], width);
        }
        if (cells <= 8.0*bodies + 64.0) return;
        width *= 1.26;
    }
}

Grid buildGrid
(
    const std::vector<Vec3>& position, const std::vector<double>& size, const std::vector<int>& bodies,
    const PeriodicBox& box
)
{
    Grid grid;
    Eigen::AlignedBox3d extent;
    double maxSize = 0.0;
    for (int i : bodies)
    {
        extent.extend(position[i]);
        maxSize = std::max(maxSize, size[i]);
    }
    sizeCells(grid, extent, box, 2.0*maxSize, bodies.size());

    std::vector<int> cellOfBody(bodies.size());
    grid.cellStart.assign(static_cast<std::size_t>(grid.count[0])*grid.count[1]*grid.count[2] + 1, 0);
    for (std::size_t m = 0; m < bodies.size(); ++m)
    {
        cellOfBody[m] = grid.linear(grid.cellOf(position[bodies[m]]));
        ++grid.cellStart[cellOfBody[m] + 1];
    }
    std::partial_sum(grid.cellStart.begin(), grid.cellStart.end(), grid.cellStart.begin());

    std::vector<int> next(grid.cellStart.begin(), grid.cellStart.end() - 1);
    grid.members.resize(bodies.size());
    grid.memberPosition.resize(bodies.size());
    grid.memberSize.resize(bodies.size());
    for (std::size_t m = 0; m < bodies.size(); ++m)
    {
        const int place = next[cellOfBody[m]]++;
        grid.members[place] = bodies[m];
        grid.memberPosition[place] = position[bodies[m]];
        grid.memberSize[place] = size[bodies[m]];
    }
    return grid;
}

/// Steps from a cell by an offset; false where the grid ends. `image` receives the shift in periods.
bool neighborCell(const Grid& grid, const PeriodicBox& box, const Cell& cell, const Cell& offset, Cell& neighbor, Image& image)
{
    for (int k = 0; k < 3; ++k)
    {
        neighbor[k] = cell[k] + offset[k];
        image[k] = 0;
        if (neighbor[k] >= 0 && neighbor[k] < grid.count[k]) continue;
        if (!box.isPeriodic(k)) return false;
        image[k] = neighbor[k] < 0 ? -1 : 1;
        neighbor[k] -= image[k]*grid.count[k];
    }
    return true;
}

Vec3 shift(const PeriodicBox& box, const Image& image)
{
    return Vec3(image[0]*box.length[0], image[1]*box.length[1], image[2]*box.length[2]);
}

void addPair(std::vector<BodyPair>& pairs, int i, int j, const Image& image)
{
    if (i < j) pairs.push_back({i, j, image});
    else pairs.push_back({j, i, {static_cast<signed char>(-image[0]), static_cast<signed char>(-image[1]), static_cast<signed char>(-image[2])}});
}

/// Pairs of body i with the members first..last of a grid cell.
void pairWithMembers
(
    const Grid& grid, int first, int last, int i, const Vec3& x, double size, const Image& image, std::vector<BodyPair>& pairs
)
{
    for (int m = first; m < last; ++m)
    {
        const double reach = size + grid.memberSize[m];
        if ((x - grid.memberPosition[m]).squaredNorm() < reach*reach && grid.members[m] != i)
        {
            addPair(pairs, i, grid.members[m], image);
        }
    }
}

/// Half of the 26 neighbors: each pair of cells is visited once.
std::vector<Cell> forwardOffsets()
{
    std::vector<Cell> offsets;
    for (int dz = -1; dz <= 1; ++dz)
    {
        for (int dy = -1; dy <= 1; ++dy)
        {
            for (int dx = -1; dx <= 1; ++dx)
            {
                if (dz > 0 || (dz == 0 && (dy > 0 || (dy == 0 && dx > 0)))) offsets.push_back({dx, dy, dz});
            }
        }
    }
    return offsets;
}

void pairsWithinGrid(const Grid& grid, const PeriodicBox& box, std::vector<BodyPair>& pairs)
{
    static const std::vector<Cell> offsets = forwardOffsets();
    Cell cell;
    int first = 0;
    for (cell[2] = 0; cell[2] < grid.count[2]; ++cell[2])
    for (cell[1] = 0; cell[1] < grid.count[1]; ++cell[1])
    for (cell[0] = 0; cell[0] < grid.count[0]; ++cell[0])
    {
        const int last = grid.cellStart[grid.linear(cell) + 1];
        if (first == last) continue;
        for (int m = first; m < last; ++m)
        {
            pairWithMembers(grid, m + 1, last, grid.members[m], grid.memberPosition[m], grid.memberSize[m], {0, 0, 0}, pairs);
        }
        for (const Cell& offset : offsets)
        {
            Cell neighbor;
            Image image;
            if (!neighborCell(grid, box, cell, offset, neighbor, image)) continue;
            const int n = grid.linear(neighbor);
            if (grid.cellStart[n] == grid.cellStart[n + 1]) continue;
            const Vec3 back = shift(box, image);
            for (int m = first; m < last; ++m)
            {
                pairWithMembers
                (
                    grid, grid.cellStart[n], grid.cellStart[n + 1], grid.members[m],
                    grid.memberPosition[m] - back, grid.memberSize[m], image, pairs
                );
            }
        }
        first = last;
    }
}

void pairsWithCoarser(const Grid& fine, const Grid& coarse, const PeriodicBox& box, std::vector<BodyPair>& pairs)
{
    for (std::size_t m = 0; m < fine.members.size(); ++m)
    {
        const Cell cell = coarse.cellOf(fine.memberPosition[m]);
        for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
        {
            Cell neighbor;
            Image image;
            if (!neighborCell(coarse, box, cell, {dx, dy, dz}, neighbor, image)) continue;
            const int n = coarse.linear(neighbor);
            pairWithMembers
            (
                coarse, coarse.cellStart[n], coarse.cellStart[n + 1], fine.members[m],
                fine.memberPosition[m] - shift(box, image), fine.memberSize[m], image, pairs
            );
        }
    }
}

/// Groups bodies by octave of size, finest first; empty octaves are left out.
std::vector<std::vector<int>> groupByOctave(const std::vector<double>& size)
{
    const double smallest = *std::min_element(size.begin(), size.end());
    std::vector<std::vector<int>> groups;
    for (std::size_t i = 0; i < size.size(); ++i)
    {
        const std::size_t octave = static_cast<std::size_t>(std::floor(std::log2(size[i]/smallest)));
        if (octave >= groups.size()) groups.resize(octave + 1);
        groups[octave].push_back(static_cast<int>(i));
    }
    groups.erase(std::remove_if(groups.begin(), groups.end(), [](const auto& g) { return g.empty(); }), groups.end());
    return groups;
}

/// Orders pairs by their first body, keeping the order of discovery within one.
std::vector<BodyPair> sortByFirst(const std::vector<BodyPair>& pairs, std::size_t bodies)
{
    std::vector<std::size_t> next(bodies + 1, 0);
    for (const BodyPair& pair : pairs) ++next[pair.a + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<BodyPair> sorted(pairs.size());
    for (const BodyPair& pair : pairs) sorted[next[pair.a]++] = pair;
    return sorted;
}

} // namespace

std::vector<BodyPair> findPairs
(
    const std::vector<Vec3>& position, const std::vector<double>& size, const PeriodicBox& box, double maxRadius
)
{
    for (int k = 0; k < 3; ++k)
    {
        if (box.isPeriodic(k) && box.length[k] < 2.0*maxRadius*(1.0 - 1e-9))
        {
            throw invalidValue("period along axis " + std::to_string(k), box.length[k], "at least the largest grain's diameter");
        }
    }
    std::vector<BodyPair> pairs;
    if (position.empty()) return pairs;
    pairs.reserve(6*position.size());

    std::vector<Grid> grids;
    for (const auto& group : groupByOctave(size)) grids.push_back(buildGrid(position, size, group, box));
    for (std::size_t level = 0; level < grids.size(); ++level)
    {
        pairsWithinGrid(grids[level], box, pairs);
        for (std::size_t coarser = level + 1; coarser < grids.size(); ++coarser)
        {
            pairsWithCoarser(grids[level], grids[coarser], box, pairs);
        }
    }
    return sortByFirst(pairs, position.size());
}

} // namespace nscd
