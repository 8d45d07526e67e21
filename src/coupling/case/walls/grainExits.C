// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Finding and removing grains that left.
#include "coupling/base/vectorConversion.H"
#include "coupling/case/walls/grainExits.H"
#include "coupling/mapping/mesh/nearestBorder.H"

#include "PstreamReduceOps.H"

#include <algorithm>
#include <map>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

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
    labelList patches;
    if (!tree)
    {
        for (const point& x : positions)
        {
            const label face = nearestBorder(mesh, x, weights).face;
            patches.append(face < 0 ? -1 : mesh.boundaryMesh().whichPatch(face));
        }
        return patches;
    }
    std::vector<::nscd::Vec3> points;
    for (const point& x : positions) points.push_back(toVec3(x));
    for (const BorderOfRanks& nearest : nearestBorders(mesh, points, *tree, weights)) patches.append(nearest.patch);
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
