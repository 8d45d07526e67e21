// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// One face after another.
#include "coupling/mapping/mesh/nearestBorder.H"

#include "emptyPolyPatch.H"
#include "processorPolyPatch.H"

namespace Foam
{
namespace nscdCoupling
{

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
            const scalar distance = weight*patch[k].nearestPoint(position, mesh.points()).distance();
            if (distance < nearest.distance) nearest = {distance, patch.start() + k};
        }
    }
    return nearest;
}

} // namespace nscdCoupling
} // namespace Foam
