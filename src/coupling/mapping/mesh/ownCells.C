// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The own cells of a rank in the form in which other ranks get them.
#include "coupling/base/vectorConversion.H"
#include "coupling/mapping/mesh/ownCells.H"

#include "processorCyclicPolyPatch.H"
#include "syncTools.H"

namespace Foam
{
namespace nscdCoupling
{
namespace
{

Vec3 shiftThrough(const processorPolyPatch& patch)
{
    if (!isA<processorCyclicPolyPatch>(patch) || patch.empty())
    {
        return Vec3::Zero();
    }
    const vectorField difference(patch.neighbFaceCentres() - patch.faceCentres());
    const vector shift = average(difference);
    const bool isTurned = max(mag(patch.neighbFaceAreas() + patch.faceAreas())/mag(patch.faceAreas())) > 1e-6;
    if (isTurned || max(mag(difference - shift)) > 1e-6*(mag(shift) + SMALL))
    {
        FatalErrorInFunction
            << "grains cannot be mapped through patch " << patch.name() << " of type " << patch.type()
            << ": only translational cyclic patches are supported" << exit(FatalError);
    }
    return toVec3(shift);
}

} // namespace

FacesBehind findFacesBehind(const fvMesh& mesh)
{
    const label nInternal = mesh.nInternalFaces();
    labelList cells(mesh.nBoundaryFaces(), -1);
    labelList faces(mesh.nBoundaryFaces(), -1);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        forAll(patch, k)
        {
            cells[patch.start() + k - nInternal] = patch.faceCells()[k];
            faces[patch.start() + k - nInternal] = patch.start() + k;
        }
    }
    syncTools::swapBoundaryFaceList(mesh, cells);
    syncTools::swapBoundaryFaceList(mesh, faces);
    FacesBehind behind;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const processorPolyPatch* processor = isA<processorPolyPatch>(patch);
        if (!processor)
        {
            continue;
        }
        const Vec3 shift = shiftThrough(*processor);
        const label other = processor->neighbProcNo();
        const bool isNamedHere = processor->owner() || isA<processorCyclicPolyPatch>(patch);
        forAll(patch, k)
        {
            const label faceI = patch.start() + k;
            const FaceName name = isNamedHere
                ? FaceName{Pstream::myProcNo(), faceI} : FaceName{other, faces[faceI - nInternal]};
            behind[faceI] = {{other, cells[faceI - nInternal]}, name, shift};
        }
    }
    return behind;
}

CopiedCell OwnCells::copy(const label cell) const
{
    CopiedCell result{{Pstream::myProcNo(), cell}, mesh_.cellCenter[cell], mesh_.cellVolume[cell], {}};
    for (label k = mesh_.cellFaceStart[cell]; k < mesh_.cellFaceStart[cell + 1]; ++k)
    {
        result.faces.push_back(copy(mesh_.cellFaces[k]));
    }
    return result;
}

CopiedFace OwnCells::copy(const CellFace& cellFace) const
{
    CopiedFace result;
    result.name = {Pstream::myProcNo(), cellFace.face};
    result.behind = {cellFace.neighbor < 0 ? -1 : Pstream::myProcNo(), cellFace.neighbor};
    result.shift = mesh_.shifts[cellFace.shift];
    result.sign = cellFace.sign;
    const auto across = behind_.find(cellFace.face);
    if (across != behind_.end())
    {
        result.name = across->second.name;
        result.behind = across->second.cell;
        result.shift = across->second.shift;
    }
    for (label pieceI = mesh_.pieceStart[cellFace.face]; pieceI < mesh_.pieceStart[cellFace.face + 1]; ++pieceI)
    {
        FacePiece piece = mesh_.pieces[pieceI];
        const auto first = mesh_.vertices.begin() + piece.firstVertex;
        piece.firstVertex = label(result.vertices.size());
        result.vertices.insert(result.vertices.end(), first, first + piece.nVertices);
        result.pieces.push_back(piece);
    }
    return result;
}

} // namespace nscdCoupling
} // namespace Foam
