// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Finding and removing grains that left.
#include "coupling/base/vectorConversion.H"
#include "coupling/case/walls/grainExits.H"
#include "coupling/mapping/mesh/nearestBorder.H"

#include "parallel/pointRouting.hpp"

#include "PstreamReduceOps.H"
#include "Tuple2.H"

#include <algorithm>
#include <map>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// A patch and how far it is; of two at the same distance the lower number wins, on all ranks.
using PatchDistance = Tuple2<scalar, label>;

using ::nscd::Vec3;

PatchDistance nearestHere(const polyMesh& mesh, const point& position, const scalarList& weights)
{
    const BorderFace nearest = nearestBorder(mesh, position, weights);
    return PatchDistance(nearest.distance, nearest.face < 0 ? -1 : mesh.boundaryMesh().whichPatch(nearest.face));
}

List<PatchDistance> nearestOfHere(const polyMesh& mesh, const pointField& positions, const scalarList& weights)
{
    List<PatchDistance> nearest;
    for (const point& position : positions) nearest.append(nearestHere(mesh, position, weights));
    return nearest;
}

/// Around the faces that nearestHere() looks at, and by `reach` beyond; empty where there are none.
Eigen::AlignedBox3d boxOfBoundary(const polyMesh& mesh, scalar reach)
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

/// What a rank says of a point that another one asked for.
struct Answer
{
    scalar distance;
    label patch;
    label index;  ///< of the point, there
};

/// Asks the ranks within `reach` of the points, and keeps what is nearer than was known. Collective.
void askWithin
(
    const polyMesh& mesh, scalar reach, const std::vector<Vec3>& points, const labelList& indices, const ::nscd::RankTree& tree,
    const scalarList& weights, List<PatchDistance>& nearest
)
{
    std::vector<Answer> answers;
    std::vector<int> askers;
    for (const ::nscd::RoutedPoint& asked : ::nscd::routePoints(tree, points, boxOfBoundary(mesh, reach)))
    {
        const PatchDistance found = nearestHere(mesh, point(asked.position[0], asked.position[1], asked.position[2]), weights);
        answers.push_back({found.first(), found.second(), asked.index});
        askers.push_back(asked.origin);
    }
    for (const Answer& answer : ::nscd::valuesOf<Answer>(tree.all().exchange(::nscd::messagesByRank(answers, askers))))
    {
        const PatchDistance found(answer.distance, answer.patch);
        PatchDistance& known = nearest[indices[answer.index]];
        if (found < known) known = found;
    }
}

/// Asks farther and farther ranks, until each point has a face that is nearer than all that were not asked.
List<PatchDistance> nearestOfRanks(const polyMesh& mesh, const pointField& positions, const ::nscd::RankTree& tree, const scalarList& weights)
{
    const ::nscd::Communicator& ranks = tree.all();
    List<PatchDistance> nearest(positions.size(), PatchDistance(GREAT, -1));
    scalar farthest = mesh.bounds().mag();
    for (const point& x : positions) farthest = max(farthest, mag(x - mesh.bounds().centre()) + mesh.bounds().mag());
    ranks.max(&farthest, 1);
    scalar unsure = 1;
    for (scalar reach = 0.01*mesh.bounds().mag(); unsure > 0 && reach < 4*farthest; reach *= 4)
    {
        std::vector<Vec3> points;
        labelList indices;
        forAll(positions, i)
        {
            if (nearest[i].first() <= 0.25*reach) continue;
            points.push_back(toVec3(positions[i]));
            indices.append(i);
        }
        unsure = scalar(points.size());
        ranks.sum(&unsure, 1);
        if (unsure > 0) askWithin(mesh, reach, points, indices, tree, weights, nearest);
    }
    return nearest;
}

/// Walls hold grains, exits do not: who is out near both has left by the exit, unless the wall is less than half as far.
scalarList exitsFirst(const PatchRoles& roles)
{
    scalarList weights(roles.role.size(), 2.0);
    forAll(weights, patch)
    {
        if (roles.role[patch] == PatchRole::exit) weights[patch] = 1.0;
    }
    return weights;
}

} // namespace


ExitedGrains findExited
(
    const nscd::Grains& grains, const labelUList& cells, const polyMesh& mesh, const PatchRoles& roles, const ::nscd::RankTree* tree
)
{
    ExitedGrains exited;
    pointField positions;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        if (cells[i] >= 0) continue;
        exited.grains.push_back(i);
        positions.append(toFoam(grains.position[i]));
    }
    if (!returnReduce(!positions.empty(), orOp<bool>())) return exited;
    exited.patches = nearestPatches(mesh, positions, tree, exitsFirst(roles));
    const labelList& patches = exited.patches;
    forAll(patches, k)
    {
        const std::size_t i = exited.grains[k];
        if (patches[k] >= 0 && roles.role[patches[k]] == PatchRole::exit) continue;
        const word patch = patches[k] < 0 ? word("none") : mesh.boundaryMesh()[patches[k]].name();
        FatalErrorInFunction
            << messageText
               (
                   "Grain ", label(grains.id[i]), " at ", positions[k], " with velocity ",
                   toFoam(grains.velocity[i]), " left the mesh near the patch ", patch, ", which is no exit."
               ).c_str()
            << exit(FatalError);
    }
    return exited;
}


labelList nearestPatches(const polyMesh& mesh, const pointField& positions, const ::nscd::RankTree* tree, const scalarList& weights)
{
    const List<PatchDistance> nearest = tree ? nearestOfRanks(mesh, positions, *tree, weights) : nearestOfHere(mesh, positions, weights);
    labelList patches(nearest.size());
    forAll(patches, i) patches[i] = nearest[i].second();
    return patches;
}


ExitedGrains withWholeClumps(const nscd::Grains& grains, const ExitedGrains& exited)
{
    const std::vector<int> clumpOf = nscd::clumpOfGrains(grains);
    if (clumpOf.empty()) return exited;
    std::map<std::size_t, label> patchOf;
    forAll(exited.patches, k)
    {
        const std::size_t grain = exited.grains[k];
        const int clump = clumpOf[grain];
        const std::size_t first = clump < 0 ? grain : grains.clumps.firstMember[clump];
        const std::size_t number = clump < 0 ? 1 : grains.clumps.shapeOf(clump).members.size();
        for (std::size_t i = first; i < first + number; ++i) patchOf.emplace(i, exited.patches[k]);
    }
    ExitedGrains all;
    for (const auto& [grain, patch] : patchOf)
    {
        all.grains.push_back(grain);
        all.patches.append(patch);
    }
    return all;
}


namespace
{

/// Those with their first member among the indices go; the others' members move up.
void eraseClumps(nscd::Clumps& clumps, const std::vector<std::size_t>& indices)
{
    std::vector<std::size_t> gone;
    for (std::size_t c = 0; c < clumps.size(); ++c)
    {
        const auto before = std::lower_bound(indices.begin(), indices.end(), std::size_t(clumps.firstMember[c]));
        if (before != indices.end() && *before == std::size_t(clumps.firstMember[c])) gone.push_back(c);
        clumps.firstMember[c] -= int(before - indices.begin());
    }
    eraseAt(clumps.shape, gone);
    eraseAt(clumps.firstMember, gone);
    eraseAt(clumps.position, gone);
    eraseAt(clumps.orientation, gone);
    eraseAt(clumps.velocity, gone);
    eraseAt(clumps.angularMomentum, gone);
}

} // namespace


void eraseGrains(nscd::Grains& grains, const std::vector<std::size_t>& indices)
{
    grains.forEachArray([&indices](auto& values) { eraseAt(values, indices); });
    grains.nOwned = grains.size();
    eraseClumps(grains.clumps, indices);
}

} // namespace nscdCoupling
} // namespace Foam
