// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Joining the straight runs of outlines.
#include "coupling/case/walls/regionOutline.H"

#include <unordered_map>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// The one edge that leaves a point, or -1 where several do.
using NextEdge = std::unordered_map<label, label>;

NextEdge nextEdges(const std::vector<DirectedEdge>& outline)
{
    NextEdge next;
    for (std::size_t e = 0; e < outline.size(); ++e)
    {
        const auto added = next.emplace(outline[e].from, label(e));
        if (!added.second) added.first->second = -1;
    }
    return next;
}

bool isStraight(const vector& a, const vector& b)
{
    return mag(a ^ b) <= 1e-6*mag(a)*mag(b) && (a & b) > 0;
}

} // namespace


std::vector<DirectedEdge> joinStraightRuns(const std::vector<DirectedEdge>& outline, const pointField& points)
{
    const NextEdge next = nextEdges(outline);
    const auto along = [&](const DirectedEdge& edge) { return vector(points[edge.to] - points[edge.from]); };

    // An edge goes on a run if the edge before it points the same way.
    std::vector<char> goesOn(outline.size(), 0);
    for (const DirectedEdge& edge : outline)
    {
        const label after = next.at(edge.to);
        if (after >= 0) goesOn[after] = isStraight(along(edge), along(outline[after]));
    }

    std::vector<DirectedEdge> joined;
    for (std::size_t e = 0; e < outline.size(); ++e)
    {
        if (goesOn[e]) continue;
        DirectedEdge run = outline[e];
        for (label after = next.at(run.to); after >= 0 && goesOn[after]; after = next.at(run.to))
        {
            // Against the whole run, so that a gentle bend of many edges is not taken for a line.
            if (!isStraight(along(run), along(outline[after])))
            {
                joined.push_back(run);
                run = outline[after];
            }
            else
            {
                run.to = outline[after].to;
            }
        }
        joined.push_back(run);
    }
    return joined;
}

} // namespace nscdCoupling
} // namespace Foam
