// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// One face after another, and one rank after another.
#include "coupling/base/vectorConversion.H"
#include "coupling/mapping/mesh/nearestBorder.H"

#include "parallel/pointRouting.hpp"

#include "cyclicAMIPolyPatch.H"
#include "emptyPolyPatch.H"
#include "processorPolyPatch.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

using ::nscd::Vec3;

/// What a rank says of a point that another one asked for.
struct Answer
{
    BorderOfRanks border;
    label index;  ///< of the point, there
};

BorderOfRanks nearestHere(const polyMesh& mesh, const point& position, const scalarList& weights)
{
    const BorderFace nearest = nearestBorder(mesh, position, weights);
    if (nearest.face < 0) return BorderOfRanks();
    return {nearest.distance, mesh.boundaryMesh().whichPatch(nearest.face), Pstream::myProcNo(), mesh.faceOwner()[nearest.face]};
}

/// Around the faces that nearestHere() looks at, and by `reach` beyond; empty where there are none.
Eigen::AlignedBox3d boxOfBorder(const polyMesh& mesh, scalar reach)
{
    Eigen::AlignedBox3d box;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (!isBorder(patch)) continue;
        for (const point& x : patch.localPoints()) box.extend(toVec3(x));
    }
    const Vec3 more = Vec3::Constant(reach);
    return box.isEmpty() ? box : Eigen::AlignedBox3d(box.min() - more, box.max() + more);
}

/// Asks the ranks within `reach` of the points, and keeps what is nearer than was known. Answers come by ascending rank. Collective.
void askWithin
(
    const polyMesh& mesh, scalar reach, const std::vector<Vec3>& points, const labelList& indices, const ::nscd::RankTree& tree,
    const scalarList& weights, std::vector<BorderOfRanks>& nearest
)
{
    std::vector<Answer> answers;
    std::vector<int> askers;
    for (const ::nscd::RoutedPoint& asked : ::nscd::routePoints(tree, points, boxOfBorder(mesh, reach)))
    {
        answers.push_back({nearestHere(mesh, point(asked.position[0], asked.position[1], asked.position[2]), weights), asked.index});
        askers.push_back(asked.origin);
    }
    for (const Answer& answer : ::nscd::valuesOf<Answer>(tree.all().exchange(::nscd::messagesByRank(answers, askers))))
    {
        BorderOfRanks& known = nearest[indices[answer.index]];
        if (answer.border.isNearerThan(known)) known = answer.border;
    }
}

/// Below the distance to a face: that to the box around it, less round-off.
scalar leastDistance(const face& f, const pointField& points, const point& x)
{
    point low(points[f[0]]), high(low);
    for (const label pointI : f)
    {
        low = min(low, points[pointI]);
        high = max(high, points[pointI]);
    }
    return (1 - 1e-9)*mag(max(max(low - x, x - high), point::zero));
}

scalar farthestFrom(const polyMesh& mesh, const std::vector<Vec3>& points, const ::nscd::Communicator& ranks)
{
    scalar farthest = mesh.bounds().mag();
    for (const Vec3& x : points) farthest = max(farthest, mag(toFoam(x) - mesh.bounds().centre()) + mesh.bounds().mag());
    ranks.max(&farthest, 1);
    return farthest;
}

} // namespace


bool isBetweenHalves(const polyPatch& patch) { return isA<cyclicAMIPolyPatch>(patch); }


bool slidesInHalves(const polyMesh& mesh)
{
    for (const polyPatch& patch : mesh.boundaryMesh()) if (isBetweenHalves(patch)) return true;
    return false;
}


bool isBorder(const polyPatch& patch)
{
    return !isA<emptyPolyPatch>(patch) && !isA<processorPolyPatch>(patch);
}


BorderFace nearestBorder(const polyMesh& mesh, const point& position, const scalarList& weights)
{
    BorderFace nearest;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (!isBorder(patch)) continue;
        const scalar weight = weights.empty() ? 1 : weights[patch.index()];
        forAll(patch, k)
        {
            if (weight*leastDistance(patch[k], mesh.points(), position) > nearest.distance) continue;
            const scalar distance = weight*patch[k].nearestPoint(position, mesh.points()).distance();
            if (distance < nearest.distance) nearest = {distance, patch.start() + k};
        }
    }
    return nearest;
}


// Asks farther and farther ranks, until each point has a face that is nearer than all that were not asked.
std::vector<BorderOfRanks> nearestBorders
(
    const polyMesh& mesh, const std::vector<Vec3>& points, const ::nscd::RankTree& tree, const scalarList& weights
)
{
    const ::nscd::Communicator& ranks = tree.all();
    std::vector<BorderOfRanks> nearest(points.size());
    const scalar farthest = farthestFrom(mesh, points, ranks);
    scalar unsure = 1;
    for (scalar reach = 0.01*mesh.bounds().mag(); unsure > 0 && reach < 4*farthest; reach *= 4)
    {
        std::vector<Vec3> asked;
        labelList indices;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            if (nearest[i].distance <= 0.25*reach) continue;
            asked.push_back(points[i]);
            indices.append(label(i));
        }
        unsure = scalar(asked.size());
        ranks.sum(&unsure, 1);
        if (unsure > 0) askWithin(mesh, reach, asked, indices, tree, weights, nearest);
    }
    return nearest;
}

} // namespace nscdCoupling
} // namespace Foam
