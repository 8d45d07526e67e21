// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Lays out a mesh for the mapping.
#include "coupling/base/vectorConversion.H"
#include "coupling/mapping/mesh/mappingMesh.H"
#include "coupling/mapping/mesh/meshHalo.H"

#include "cyclicAMIPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "emptyPolyPatch.H"
#include "processorPolyPatch.H"
#include "wedgePolyPatch.H"

namespace Foam
{
namespace nscdCoupling
{
namespace
{

// A face counts as planar below this ratio of warp to size: its volume error then is round-off.
constexpr scalar planarTolerance = 1e-13;

void findEmptyDirection(const fvMesh& mesh, MappingMesh& result)
{
    if (mesh.nGeometricD() == 3)
    {
        return;
    }
    if (mesh.nGeometricD() != 2)
    {
        FatalErrorInFunction
            << "grains need a mesh of two or three dimensions, this one has " << mesh.nGeometricD() << exit(FatalError);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
        if (mesh.geometricD()[axis] < 0)
        {
            result.emptyAxis = axis;
        }
    }
    const scalar lower = mesh.bounds().min()[result.emptyAxis];
    const scalar upper = mesh.bounds().max()[result.emptyAxis];
    result.midPlane = 0.5*(lower + upper);
    result.thickness = upper - lower;
}

bool isPlanar(const face& f, const pointField& points, const point& center, const vector& normal)
{
    scalar warp = 0;
    scalar size = 0;
    for (const label pointI : f)
    {
        const vector d = points[pointI] - center;
        warp = max(warp, mag(d & normal));
        size = max(size, mag(d));
    }
    return f.size() == 3 || warp <= planarTolerance*size;
}

bool isConvex(const face& f, const pointField& points, const vector& normal)
{
    forAll(f, k)
    {
        const point& corner = points[f[k]];
        const vector before = corner - points[f.prevLabel(k)];
        const vector after = points[f.nextLabel(k)] - corner;
        if (((before ^ after) & normal) < -planarTolerance*mag(before)*mag(after))
        {
            return false;
        }
    }
    return true;
}

void addPiece(MappingMesh& result, const Vec3& normal, const std::vector<Vec3>& corners)
{
    FacePiece piece;
    piece.normal = normal;
    piece.offset = normal.dot(corners.front());
    piece.firstVertex = label(result.vertices.size());
    piece.nVertices = label(corners.size());
    result.vertices.insert(result.vertices.end(), corners.begin(), corners.end());
    result.pieces.push_back(piece);
}

void addFan(MappingMesh& result, const face& f, const pointField& points, const Vec3& center)
{
    forAll(f, k)
    {
        const Vec3 a = toVec3(points[f[k]]);
        const Vec3 b = toVec3(points[f.nextLabel(k)]);
        const Vec3 area = (a - center).cross(b - center);
        if (area.norm() > 0)
        {
            addPiece(result, area.normalized(), {center, a, b});
        }
    }
}

void addPolygon(MappingMesh& result, const face& f, const pointField& points, const Vec3& normal)
{
    std::vector<Vec3> corners;
    for (const label pointI : f)
    {
        corners.push_back(toVec3(points[pointI]));
    }
    addPiece(result, normal, corners);
}

// In the mid-plane a face is the edge a-b with its owner on the left of a -> b seen from the tip of the empty axis.
void addEdge(MappingMesh& result, const face& f, const pointField& points, const Vec3& outOfOwner)
{
    Vec3 along = Vec3::Unit(result.emptyAxis).cross(outOfOwner);
    along[result.emptyAxis] = 0;
    const Vec3 center = result.inPlane(toVec3(f.centre(points)));
    Vec3 a = center;
    Vec3 b = center;
    for (const label pointI : f)
    {
        const Vec3 p = result.inPlane(toVec3(points[pointI]));
        a = p.dot(along) < a.dot(along) ? p : a;
        b = p.dot(along) > b.dot(along) ? p : b;
    }
    const Vec3 normal = (b - a).cross(Vec3::Unit(result.emptyAxis)).normalized();
    addPiece(result, normal, {a, b});
}

void addFacePieces(const fvMesh& mesh, const label faceI, const bool isEmpty, MappingMesh& result)
{
    if (isEmpty)
    {
        return;
    }
    const face& f = mesh.faces()[faceI];
    const point& center = mesh.faceCentres()[faceI];
    const vector normal = mesh.faceAreas()[faceI]/mag(mesh.faceAreas()[faceI]);
    if (result.is2D())
    {
        addEdge(result, f, mesh.points(), toVec3(normal));
    }
    else if (isPlanar(f, mesh.points(), center, normal) && isConvex(f, mesh.points(), normal))
    {
        addPolygon(result, f, mesh.points(), toVec3(normal));
    }
    else
    {
        addFan(result, f, mesh.points(), toVec3(center));
    }
}

std::vector<bool> findEmptyFaces(const polyMesh& mesh)
{
    std::vector<bool> isEmpty(mesh.nFaces(), false);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(patch))
        {
            std::fill_n(isEmpty.begin() + patch.start(), patch.size(), true);
        }
    }
    return isEmpty;
}

void addFaces(const fvMesh& mesh, const std::vector<bool>& isEmpty, MappingMesh& result)
{
    result.pieceStart.assign(1, 0);
    for (label faceI = 0; faceI < mesh.nFaces(); ++faceI)
    {
        const std::size_t firstVertex = result.vertices.size();
        addFacePieces(mesh, faceI, isEmpty[faceI], result);
        result.pieceStart.push_back(label(result.pieces.size()));
        Eigen::AlignedBox3d box;
        for (std::size_t k = firstVertex; k < result.vertices.size(); ++k)
        {
            box.extend(result.vertices[k]);
        }
        result.faceBox.push_back(box);
    }
}

void refuse(const polyPatch& patch, const char* reason)
{
    FatalErrorInFunction
        << "grains cannot be mapped through patch " << patch.name() << " of type " << patch.type() << ": " << reason
        << exit(FatalError);
}

Vec3 shiftThrough(const cyclicPolyPatch& patch)
{
    const vectorField difference(patch.neighbPatch().faceCentres() - patch.faceCentres());
    const vector shift = average(difference);
    const scalar scatter = max(mag(difference - shift));
    if (!patch.parallel() || scatter > 1e-6*(mag(shift) + SMALL))
    {
        refuse(patch, "only translational cyclic patches are supported");
    }
    return toVec3(shift);
}

// What lies behind each face of a border: cell and shift of a cyclic patch, else nothing; addHalo() sees to processor patches.
void connectCyclic(const polyMesh& mesh, std::vector<label>& behind, std::vector<label>& shiftOf, MappingMesh& result)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<wedgePolyPatch>(patch))
        {
            refuse(patch, "a wedge is not a box of grains; use a full mesh or a two-dimensional one");
        }
        const bool isProcessor = isA<processorPolyPatch>(patch);
        if (isProcessor && !Pstream::parRun())
        {
            refuse(patch, "the part of one processor of a decomposed case needs a parallel run");
        }
        if (!patch.coupled() || isProcessor)
        {
            continue;
        }
        // The halves of a mesh that slide past each other have no cells in common: what of a grain lies behind is put into its own half.
        if (isA<cyclicAMIPolyPatch>(patch) || patch.empty())
        {
            continue;
        }
        if (!isA<cyclicPolyPatch>(patch))
        {
            refuse(patch, "the only coupled patches supported are cyclic, cyclicAMI, processor and processorCyclic");
        }
        const cyclicPolyPatch& cyclic = refCast<const cyclicPolyPatch>(patch);
        result.shifts.push_back(shiftThrough(cyclic));
        forAll(patch, k)
        {
            behind[patch.start() + k] = cyclic.neighbPatch().faceCells()[k];
            shiftOf[patch.start() + k] = label(result.shifts.size()) - 1;
        }
    }
}

void addCells(const fvMesh& mesh, const std::vector<bool>& isEmpty, MappingMesh& result)
{
    std::vector<label> behind(mesh.nFaces(), domainBorder);
    std::vector<label> shiftOf(mesh.nFaces(), 0);
    connectCyclic(mesh, behind, shiftOf, result);

    result.cellFaceStart.assign(1, 0);
    for (label cellI = 0; cellI < mesh.nCells(); ++cellI)
    {
        for (const label faceI : mesh.cells()[cellI])
        {
            if (isEmpty[faceI])
            {
                continue;
            }
            const bool isOwner = mesh.faceOwner()[faceI] == cellI;
            const bool isInternal = mesh.isInternalFace(faceI);
            const label other = !isInternal ? behind[faceI]
                : isOwner ? mesh.faceNeighbour()[faceI] : mesh.faceOwner()[faceI];
            result.cellFaces.push_back({faceI, other, shiftOf[faceI], isOwner ? 1.0 : -1.0});
        }
        result.cellFaceStart.push_back(label(result.cellFaces.size()));
        result.cellCenter.push_back(result.inPlane(toVec3(mesh.cellCentres()[cellI])));
        result.cellVolume.push_back(mesh.cellVolumes()[cellI]);
    }
    result.nOwnCells = mesh.nCells();
}

} // namespace

CellHome MappingMesh::home(const label cell) const
{
    if (cell < 0)
    {
        return {-1, -1};
    }
    return cell < nOwnCells ? CellHome{Pstream::myProcNo(), cell} : haloHomes[cell - nOwnCells];
}

void stopBeyondHalo(const Vec3& position)
{
    FatalErrorInFunction
        << "the cells copied from other ranks do not reach as far as the grain at " << toFoam(position) << exit(FatalError);
}

MappingMesh makeMappingMesh(const fvMesh& mesh, const scalar reach)
{
    MappingMesh result;
    result.shifts.assign(1, Vec3::Zero());
    findEmptyDirection(mesh, result);
    const std::vector<bool> isEmpty = findEmptyFaces(mesh);
    addFaces(mesh, isEmpty, result);
    addCells(mesh, isEmpty, result);
    if (Pstream::parRun())
    {
        addHalo(mesh, reach, result);
    }
    return result;
}

} // namespace nscdCoupling
} // namespace Foam
