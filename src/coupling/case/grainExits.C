// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Finding and removing grains that left.
#include "grainExits.H"
#include "vectorConversion.H"

#include "PstreamCombineReduceOps.H"
#include "PstreamReduceOps.H"
#include "Tuple2.H"
#include "emptyPolyPatch.H"
#include "processorPolyPatch.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// A patch and how far it is; of two at the same distance the lower number wins, on all ranks.
using PatchDistance = Tuple2<scalar, label>;

PatchDistance nearestHere(const polyMesh& mesh, const point& position)
{
    PatchDistance nearest(GREAT, -1);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(patch) || isA<processorPolyPatch>(patch)) continue;
        for (const face& f : patch.localFaces())
        {
            const pointHit hit = f.nearestPoint(position, patch.localPoints());
            if (hit.distance() < nearest.first()) nearest = PatchDistance(hit.distance(), patch.index());
        }
    }
    return nearest;
}

struct KeepNearer
{
    void operator()(PatchDistance& a, const PatchDistance& b) const
    {
        if (b.first() < a.first() || (b.first() == a.first() && b.second() < a.second())) a = b;
    }
};

} // namespace


std::vector<std::size_t> findExited
(
    const nscd::Grains& grains, const labelUList& cells, const polyMesh& mesh, const PatchRoles& roles
)
{
    std::vector<std::size_t> exited;
    pointField positions;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        if (cells[i] >= 0) continue;
        exited.push_back(i);
        positions.append(toFoam(grains.position[i]));
    }
    if (!returnReduce(!positions.empty(), orOp<bool>())) return exited;
    const labelList patches = nearestPatches(mesh, positions);
    forAll(patches, k)
    {
        const std::size_t i = exited[k];
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


labelList nearestPatches(const polyMesh& mesh, const pointField& positions)
{
    List<pointField> perRank(Pstream::nProcs());
    perRank[Pstream::myProcNo()] = positions;
    Pstream::gatherList(perRank);
    Pstream::scatterList(perRank);
    List<PatchDistance> nearest;
    label firstOwn = 0;
    forAll(perRank, rank)
    {
        if (rank == Pstream::myProcNo()) firstOwn = nearest.size();
        for (const point& position : perRank[rank]) nearest.append(nearestHere(mesh, position));
    }
    Pstream::listCombineGather(nearest, KeepNearer());
    Pstream::listCombineScatter(nearest);

    labelList patches(positions.size());
    forAll(patches, i) patches[i] = nearest[firstOwn + i].second();
    return patches;
}


void eraseGrains(nscd::Grains& grains, const std::vector<std::size_t>& indices)
{
    eraseAt(grains.position, indices);
    eraseAt(grains.velocity, indices);
    eraseAt(grains.omega, indices);
    eraseAt(grains.orientation, indices);
    eraseAt(grains.radius, indices);
    eraseAt(grains.mass, indices);
    eraseAt(grains.material, indices);
    eraseAt(grains.id, indices);
    eraseAt(grains.isFixed, indices);
    grains.nOwned = grains.size();
}

} // namespace nscdCoupling
} // namespace Foam
