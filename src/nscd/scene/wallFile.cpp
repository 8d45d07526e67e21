// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Legacy VTK.
#include "nscd/scene/wallFile.hpp"

namespace nscd
{

namespace
{

/// Ends of the loops that a region's edges make, one after the other: a loop ends where the next edge does not begin.
std::vector<std::size_t> loopEnds(const WallRegion& region)
{
    std::vector<std::size_t> ends;
    for (std::size_t k = 0; k < region.edges.size(); ++k)
    {
        if (k + 1 == region.edges.size() || region.edges[k].end != region.edges[k + 1].start) ends.push_back(k + 1);
    }
    return ends;
}

} // namespace

void writeVtk(std::ostream& os, const Walls& walls, int patch)
{
    std::size_t points = 0, loops = 0;
    const auto forEachRegion = [&](const auto& visit)
    {
        for (const WallRegion& region : walls.regions)
        {
            if (region.patch == patch && !region.edges.empty()) visit(region);
        }
    };
    forEachRegion([&](const WallRegion& region) { points += region.edges.size(); loops += loopEnds(region).size(); });

    os << "# vtk DataFile Version 3.0\n" << walls.patches[patch].name << "\nASCII\nDATASET POLYDATA\nPOINTS " << points << " double\n";
    os.precision(10);
    forEachRegion([&](const WallRegion& region)
    {
        for (const WallEdge& edge : region.edges) os << (walls.patches[patch].pose*edge.start).transpose() << '\n';
    });
    os << "POLYGONS " << loops << ' ' << loops + points << '\n';
    std::size_t next = 0;
    forEachRegion([&](const WallRegion& region)
    {
        std::size_t begin = 0;
        for (std::size_t end : loopEnds(region))
        {
            os << end - begin;
            for (; begin < end; ++begin) os << ' ' << next++;
            os << '\n';
        }
    });
}

} // namespace nscd
