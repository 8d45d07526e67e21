// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Finds the cell of a point by walking from a cell nearby.
#include "coupling/base/vectorConversion.H"
#include "coupling/mapping/mesh/cellLocator.H"
#include "coupling/mapping/mesh/nearestBorder.H"

namespace Foam
{
namespace nscdCoupling
{
namespace
{

// A walk longer than this is slower than the octree.
constexpr int maxWalk = 30;

// Points this close to a face, relative to the line from the cell's center, lie on it: above round-off, below all that matters.
constexpr scalar onFace = 1e-12;

// Fraction of the line from the center at which it leaves through a triangle; 1 or more when it does not.
scalar leavesTriangle(const Vec3* v, const Vec3& center, const Vec3& line, const scalar sign)
{
    const Vec3 a = v[0] - center;
    const Vec3 b = v[1] - center;
    const Vec3 c = v[2] - center;
    const scalar weightA = sign*line.dot(b.cross(c));
    const scalar weightB = sign*line.dot(c.cross(a));
    const scalar weightC = sign*line.dot(a.cross(b));
    if (weightA < 0 || weightB < 0 || weightC < 0 || weightA + weightB + weightC <= 0)
    {
        return 1;
    }
    return sign*a.dot(b.cross(c))/(weightA + weightB + weightC);
}

// Halo cells, own cells that have neighbors there, and cells at a border that is not flat.
std::vector<label> cellsAtBorders(const MappingMesh& mesh)
{
    std::vector<label> cells;
    for (label cell = 0; cell < mesh.nCells(); ++cell)
    {
        bool isAtBorder = cell >= mesh.nOwnCells;
        for (label k = mesh.cellFaceStart[cell]; k < mesh.cellFaceStart[cell + 1]; ++k)
        {
            const CellFace& face = mesh.cellFaces[k];
            const bool isFlat = mesh.pieceStart[face.face + 1] - mesh.pieceStart[face.face] == 1;
            isAtBorder = isAtBorder || face.neighbor >= mesh.nOwnCells || (face.neighbor < 0 && !isFlat);
        }
        if (isAtBorder) cells.push_back(cell);
    }
    return cells;
}

std::vector<Eigen::AlignedBox3d> boxesOf(const std::vector<label>& cells, const MappingMesh& mesh)
{
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const label cell : cells)
    {
        Eigen::AlignedBox3d box;
        for (label k = mesh.cellFaceStart[cell]; k < mesh.cellFaceStart[cell + 1]; ++k)
        {
            box.extend(mesh.faceBox[mesh.cellFaces[k].face]);
        }
        boxes.push_back(box);
    }
    return boxes;
}

} // namespace

CellLocator::CellLocator(const MappingMesh& mappingMesh, const polyMesh& mesh)
:
    mesh_(mappingMesh),
    polyMesh_(mesh),
    middle_(mappingMesh.inPlane(toVec3(mesh.bounds().centre()))),
    cellsAtBorders_(cellsAtBorders(mappingMesh)),
    boxesAtBorders_(boxesOf(cellsAtBorders_, mappingMesh)),
    hasHalves_(slidesInHalves(mesh))
{
    if (Pstream::parRun())
    {
        mesh.tetBasePtIs();  // collective, so not to be left to the first search
    }
}

scalar CellLocator::exitFraction(const CellFace& cellFace, const Vec3& center, const Vec3& line) const
{
    const label first = mesh_.pieceStart[cellFace.face];
    const label end = mesh_.pieceStart[cellFace.face + 1];
    if (end - first == 1)
    {
        const FacePiece& piece = mesh_.pieces[first];
        const scalar along = cellFace.sign*piece.normal.dot(line);
        return along > 0 ? cellFace.sign*(piece.offset - piece.normal.dot(center))/along : 1;
    }
    scalar fraction = 1;
    for (label pieceI = first; pieceI < end; ++pieceI)
    {
        const Vec3* v = &mesh_.vertices[mesh_.pieces[pieceI].firstVertex];
        fraction = std::min(fraction, leavesTriangle(v, center, line, cellFace.sign));
    }
    return fraction;
}

const CellFace* CellLocator::exitFace(const label cell, const Vec3& x) const
{
    const Vec3& center = mesh_.cellCenter[cell];
    const Vec3 line = x - center;
    scalar nearest = 1 - onFace;
    const CellFace* exit = nullptr;
    for (label k = mesh_.cellFaceStart[cell]; k < mesh_.cellFaceStart[cell + 1]; ++k)
    {
        const scalar fraction = exitFraction(mesh_.cellFaces[k], center, line);
        if (fraction < nearest)
        {
            nearest = fraction;
            exit = &mesh_.cellFaces[k];
        }
    }
    return exit;
}

LocatedPoint CellLocator::walkThroughCyclic(const label start, const Vec3& x) const
{
    LocatedPoint at{start, x};
    for (int step = 0; step < maxWalk; ++step)
    {
        const CellFace* exit = exitFace(at.cell, at.position);
        if (!exit)
        {
            return at;
        }
        if (exit->neighbor == beyondHalo)
        {
            stopBeyondHalo(x);
        }
        if (exit->neighbor < 0)
        {
            break;
        }
        at.cell = exit->neighbor;
        at.position += mesh_.shifts[exit->shift];
    }
    return {-1, x};
}

label CellLocator::walk(const label start, const Vec3& x) const
{
    label cell = start;
    for (int step = 0; step < maxWalk; ++step)
    {
        const CellFace* exit = exitFace(cell, x);
        if (!exit)
        {
            return cell;
        }
        if (exit->neighbor < 0 || exit->shift != 0)
        {
            break;
        }
        cell = exit->neighbor;
    }
    return -1;
}

label CellLocator::search(const Vec3& x) const
{
    const label cell = polyMesh_.findCell(toFoam(x));
    if (cell >= 0)
    {
        // The octree splits warped faces along a diagonal, the mapping about their center: the walk settles the difference.
        const label settled = walk(cell, x);
        return settled >= 0 ? settled : cell;
    }
    if (const label atBorder = searchAtBorders(x); atBorder >= 0)
    {
        return atBorder;
    }
    // The octree may miss a point on the border of the mesh; one just inside of it starts a walk.
    const Vec3 inside = x + 1e-9*(middle_ - x);
    const label nearby = polyMesh_.findCell(toFoam(inside));
    return nearby >= 0 ? walk(nearby, x) : -1;
}

// The faces of two halves of a mesh that slide past each other are flat, and leave slivers between them: a point there belongs to the nearest
// face's cell, if no other border of the mesh is nearer.
label CellLocator::searchBetweenHalves(const Vec3& x) const
{
    if (!hasHalves_) return -1;
    const label face = nearestBorder(polyMesh_, toFoam(x)).face;
    if (face < 0) return -1;
    const label patch = polyMesh_.boundaryMesh().whichPatch(face);
    return isBetweenHalves(polyMesh_.boundaryMesh()[patch]) ? polyMesh_.faceOwner()[face] : -1;
}

// The octree knows nothing of halo cells, and it may miss a point of an own cell beside them or at the border of the mesh, behind a
// warped face or on a flat one. Own cells go first: else two ranks could send a grain to and fro for ever.
label CellLocator::searchAtBorders(const Vec3& x) const
{
    for (const bool isOwn : {true, false})
    {
        const auto holds = [&](const int k)
        {
            const label cell = cellsAtBorders_[k];
            return mesh_.isOwn(cell) == isOwn && !exitFace(cell, x);
        };
        const int found = boxesAtBorders_.find(Eigen::AlignedBox3d(x), holds);
        if (found >= 0) return cellsAtBorders_[found];
    }
    return -1;
}

label CellLocator::findInCells(const Vec3& position, const label guess) const
{
    const Vec3 x = mesh_.inPlane(position);
    const label cell = guess >= 0 && guess < mesh_.nCells() ? walk(guess, x) : -1;
    return cell >= 0 ? cell : search(x);
}

label CellLocator::find(const Vec3& position, const label guess) const
{
    const label cell = findInCells(position, guess);
    return cell >= 0 ? cell : searchBetweenHalves(mesh_.inPlane(position));
}

// A walk may end in a halo cell beside an own one that holds the point too.
label CellLocator::find(const Vec3& position, const label guess, label& nearby) const
{
    if (guess >= 0) return find(position, guess);
    label cell = nearby >= 0 ? walk(nearby, mesh_.inPlane(position)) : -1;
    if (!mesh_.isOwn(cell)) cell = find(position, -1);
    if (mesh_.isOwn(cell)) nearby = cell;
    return cell;
}

} // namespace nscdCoupling
} // namespace Foam
