// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Gathering patches, with the points numbered over all ranks.
#include "coupling/case/walls/gatheredPatch.H"
#include "coupling/case/walls/gatheredLists.H"

#include "ListOps.H"
#include "PstreamReduceOps.H"
#include "globalIndex.H"
#include "globalMeshData.H"
#include "labelIOList.H"

#include <algorithm>
#include <numeric>

namespace Foam
{
namespace nscdCoupling
{

labelList facesOfWholeMesh(const polyMesh& mesh)
{
    const labelIOList addressing
    (
        IOobject
        (
            "faceProcAddressing", mesh.facesInstance(), polyMesh::meshSubDir, mesh,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    );
    if (!returnReduce(addressing.size() == mesh.nFaces(), andOp<bool>())) return labelList();
    labelList wholeFace(addressing.size());
    // Numbers there start at 1, negative for faces that were turned round.
    std::transform(addressing.begin(), addressing.end(), wholeFace.begin(), [](label number) { return mag(number) - 1; });
    return wholeFace;
}


GatheredPatch gatherPatch(const polyMesh& mesh, const pointField& points, const polyPatch& patch, const labelUList& wholeFace)
{
    labelList pointNumber, ownPoints;
    mesh.globalData().mergePoints(patch.meshPoints(), patch.meshPointMap(), pointNumber, ownPoints);
    faceList ownFaces(patch.localFaces());
    for (face& f : ownFaces) inplaceRenumber(pointNumber, f);
    labelList ownOrder;
    if (!wholeFace.empty()) ownOrder = SubList<label>(wholeFace, patch.size(), patch.start());

    GatheredPatch whole;
    whole.points = gathered<point>(pointField(points, ownPoints));
    whole.faces = gathered<face>(ownFaces);
    const labelList order = gathered<label>(ownOrder);
    if (order.size() != whole.faces.size()) return whole;

    labelList sorted(identity(order.size()));
    std::sort(sorted.begin(), sorted.end(), [&](label a, label b) { return order[a] < order[b]; });
    whole.faces = faceList(UIndirectList<face>(whole.faces, sorted));
    return whole;
}

} // namespace nscdCoupling
} // namespace Foam
