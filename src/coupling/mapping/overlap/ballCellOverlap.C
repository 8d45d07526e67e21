// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Exact overlap of a ball or, in 2D, a disc with the cells of a mesh.
#include "coupling/mapping/overlap/ballCellOverlap.H"
#include "coupling/mapping/overlap/ballFaceExcess.H"

#include "closures/sphereOverlap.hpp"

#include <cmath>

namespace Foam
{
namespace nscdCoupling
{
namespace
{

// Below this distance from a face, over the radius, the center's side is a matter of round-off.
constexpr scalar onFace = 1e-10;

// Shares are good to some 1e-15; a share beyond [0, 1] by more than this tells that a side was taken wrongly.
constexpr scalar roundOff = 1e-13;

// Two images of one cell are a period apart, never this little (over the radius).
constexpr scalar sameImage = 1e-6;

// Along which axes the mid-plane of a two-dimensional mesh extends, so that the empty axis points to the viewer.
Eigen::Vector2d onPlane(const Vec3& x, const int emptyAxis)
{
    return {x[(emptyAxis + 1) % 3], x[(emptyAxis + 2) % 3]};
}

} // namespace

BallCellOverlap::BallCellOverlap(const MappingMesh& mesh, const bool areDiscs)
:
    mesh_(mesh),
    areDiscs_(areDiscs),
    reachedOf_(mesh.nCells(), 0)
{}

bool BallCellOverlap::isCrossed(const label face, const Vec3& center) const
{
    return mesh_.faceBox[face].squaredExteriorDistance(center) < radius_*radius_;
}

// An edge of a 2D mesh, drawn out along the empty axis beyond the ball.
std::array<Vec3, 4> BallCellOverlap::strip(const FacePiece& piece) const
{
    const Vec3 along = 2*radius_*Vec3::Unit(mesh_.emptyAxis);
    const Vec3& a = mesh_.vertices[piece.firstVertex];
    const Vec3& b = mesh_.vertices[piece.firstVertex + 1];
    return {a - along, b - along, b + along, a + along};
}

scalar BallCellOverlap::pieceExcess(const FacePiece& piece, const Vec3& center) const
{
    const Vec3* v = &mesh_.vertices[piece.firstVertex];
    if (!mesh_.is2D()) return ballFaceExcess(center, radius_, v, piece.nVertices, piece.normal);
    if (!areDiscs_) return ballFaceExcess(center, radius_, strip(piece).data(), 4, piece.normal);
    return discEdgeExcess(onPlane(center, mesh_.emptyAxis), radius_, onPlane(v[0], mesh_.emptyAxis), onPlane(v[1], mesh_.emptyAxis));
}

scalar BallCellOverlap::excess(const label face, const Vec3& center)
{
    scalar sum = 0;
    for (label pieceI = mesh_.pieceStart[face]; pieceI < mesh_.pieceStart[face + 1]; ++pieceI)
    {
        const FacePiece& piece = mesh_.pieces[pieceI];
        const scalar height = piece.offset - piece.normal.dot(center);
        if (std::abs(height) >= radius_)
        {
            continue;
        }
        centerOnFace_ = centerOnFace_ || std::abs(height) < onFace*radius_;
        sum += pieceExcess(piece, center);
    }
    return sum;
}

// A strip without end fills the solid angle 2 theta, theta the angle of its edge: Q = E + 2/3 R^3 theta, and 0 where the center lies on it.
scalar BallCellOverlap::pieceCone(const FacePiece& piece, const Vec3& center) const
{
    const Vec3* v = &mesh_.vertices[piece.firstVertex];
    if (!mesh_.is2D()) return closures::ballFaceContribution(center, radius_, v, piece.nVertices, piece.normal);
    const Eigen::Vector2d c = onPlane(center, mesh_.emptyAxis), a = onPlane(v[0], mesh_.emptyAxis), b = onPlane(v[1], mesh_.emptyAxis);
    if (areDiscs_) return closures::discEdgeContribution(c, radius_, a, b);
    const scalar height = std::abs(piece.offset - piece.normal.dot(center));
    if (height < onFace*radius_) return 0;
    const Eigen::Vector2d p = a - c, q = b - c;
    const scalar angle = std::atan2(p[0]*q[1] - p[1]*q[0], p.dot(q));
    return 2.0/3*radius_*radius_*radius_*angle + (height < radius_ ? pieceExcess(piece, center) : 0);
}

scalar BallCellOverlap::coneVolume(const label face, const Vec3& center) const
{
    scalar sum = 0;
    for (label pieceI = mesh_.pieceStart[face]; pieceI < mesh_.pieceStart[face + 1]; ++pieceI)
    {
        sum += pieceCone(mesh_.pieces[pieceI], center);
    }
    return sum;
}

label BallCellOverlap::findOrReach(const label cell, const Vec3& center)
{
    const label newest = reachedOf_[cell];
    const bool isReached = newest < label(reached_.size()) && reached_[newest].cell == cell;
    for (label k = isReached ? newest : -1; k >= 0; k = reached_[k].sameCell)
    {
        if ((reached_[k].center - center).squaredNorm() < sqr(sameImage*radius_))
        {
            return k;
        }
    }
    reached_.push_back({cell, isReached ? newest : -1, center, 0});
    reachedOf_[cell] = label(reached_.size()) - 1;
    return reachedOf_[cell];
}

void BallCellOverlap::crossFaces(const label reachedI)
{
    const label cell = reached_[reachedI].cell;
    const Vec3 center = reached_[reachedI].center;
    for (label k = mesh_.cellFaceStart[cell]; k < mesh_.cellFaceStart[cell + 1]; ++k)
    {
        const CellFace& cellFace = mesh_.cellFaces[k];
        if (!isCrossed(cellFace.face, center))
        {
            continue;
        }
        if (cellFace.neighbor == beyondHalo)
        {
            stopBeyondHalo(center);
        }
        label otherI = -1;
        if (cellFace.neighbor >= 0)
        {
            otherI = findOrReach(cellFace.neighbor, center + mesh_.shifts[cellFace.shift]);
            if (otherI < reachedI)
            {
                continue;  // done from the other side
            }
        }
        const scalar volume = cellFace.sign*excess(cellFace.face, center);
        reached_[reachedI].volume += volume;
        if (otherI >= 0)
        {
            reached_[otherI].volume -= volume;
        }
    }
}

void BallCellOverlap::reachCells(const Vec3& center, const label cell)
{
    centerOnFace_ = false;
    reached_.clear();
    reached_.push_back({cell, -1, center, ballVolume_});
    reachedOf_[cell] = 0;
    for (std::size_t k = 0; k < reached_.size(); ++k)
    {
        crossFaces(label(k));
    }
}

void BallCellOverlap::sumCones()
{
    for (Reached& reached : reached_)
    {
        reached.volume = 0;
        for (label k = mesh_.cellFaceStart[reached.cell]; k < mesh_.cellFaceStart[reached.cell + 1]; ++k)
        {
            const CellFace& cellFace = mesh_.cellFaces[k];
            reached.volume += cellFace.sign*coneVolume(cellFace.face, reached.center);
        }
    }
}

bool BallCellOverlap::isTrusted() const
{
    for (const Reached& reached : reached_)
    {
        if (reached.volume < -roundOff*ballVolume_ || reached.volume > (1 + roundOff)*ballVolume_)
        {
            return false;
        }
    }
    return !centerOnFace_;
}

scalar BallCellOverlap::collect(std::vector<CellShare>& shares) const
{
    scalar sum = 0;
    for (std::size_t k = 0; k < reached_.size(); ++k)
    {
        if (reachedOf_[reached_[k].cell] != label(k))
        {
            continue;  // counted with the newest image of the same cell
        }
        scalar volume = 0;
        for (label image = label(k); image >= 0; image = reached_[image].sameCell)
        {
            volume += reached_[image].volume;
        }
        if (volume > roundOff*ballVolume_)
        {
            shares.push_back({reached_[k].cell, volume/ballVolume_});
            sum += volume/ballVolume_;
        }
    }
    return sum;
}

scalar BallCellOverlap::appendShares
(
    const Vec3& center, const scalar radius, const label cell, std::vector<CellShare>& shares
)
{
    radius_ = radius;
    ballVolume_ = areDiscs_ ? M_PI*radius*radius : 4.0/3*M_PI*radius*radius*radius;
    reachCells(mesh_.inPlane(center), cell);
    if (!isTrusted())
    {
        sumCones();
    }
    return collect(shares);
}

} // namespace nscdCoupling
} // namespace Foam
