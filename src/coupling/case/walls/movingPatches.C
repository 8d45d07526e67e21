// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Fitting poses to points.
#include "coupling/case/walls/movingPatches.H"

#include "coupling/base/vectorConversion.H"

#include "PstreamReduceOps.H"
#include "Time.H"
#include "pointIOField.H"

#include <Eigen/SVD>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// How far a point may be from where its patch's pose has it, over the patch's size.
constexpr scalar misfit = 1e-6;

/// On all ranks.
point meanOf(const pointField& points, label nPoints)
{
    return returnReduce(sum(points), sumOp<point>())/scalar(max(nPoints, label(1)));
}

Eigen::Matrix3d covarianceOf(const pointField& from, const point& start, const pointField& to, const point& end)
{
    tensor sum = Zero;
    forAll(from, i) sum += (from[i] - start)*(to[i] - end);
    reduce(sum, sumOp<tensor>());
    Eigen::Matrix3d covariance;
    for (direction row = 0; row < 3; ++row)
    {
        for (direction column = 0; column < 3; ++column) covariance(row, column) = sum(row, column);
    }
    return covariance;
}

nscd::WallPose rigidFit(const Eigen::Matrix3d& covariance, const nscd::Vec3& start, const nscd::Vec3& end)
{
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d sides = Eigen::Matrix3d::Identity();
    sides(2, 2) = (svd.matrixV()*svd.matrixU().transpose()).determinant() < 0 ? -1 : 1;
    nscd::WallPose pose = nscd::WallPose::Identity();
    pose.linear() = svd.matrixV()*sides*svd.matrixU().transpose();
    pose.translation() = end - pose.linear()*start;
    return pose;
}

/// Of a patch whose points all lie in one plane through `center`; zero of others.
vector flatNormal(const polyPatch& patch, const pointField& rest, const pointField& own, const point& center, scalar size)
{
    vector area = Zero;
    for (const face& f : patch) area += f.areaNormal(rest);
    reduce(area, sumOp<vector>());
    // Of a closed surface, or none, nothing is left.
    if (mag(area) <= misfit*sqr(size)) return Zero;
    const vector normal = area/mag(area);
    scalar off = 0;
    for (const point& x : own) off = max(off, mag((x - center) & normal));
    return returnReduce(off, maxOp<scalar>()) <= misfit*size ? normal : vector(Zero);
}

} // namespace


pointField pointsAtRest(const polyMesh& mesh)
{
    IOobject file("points", mesh.facesInstance(), polyMesh::meshSubDir, mesh, IOobject::MUST_READ, IOobject::NO_WRITE, false);
    const bool isThere = returnReduce(file.typeHeaderOk<pointIOField>(true), andOp<bool>());
    if (!isThere) return mesh.points();
    const pointIOField points(file);
    return returnReduce(points.size() == mesh.nPoints(), andOp<bool>()) ? pointField(points) : mesh.points();
}


MovingPatches::MovingPatches(const polyMesh& mesh, const labelList& patches, const pointField& rest)
:
    mesh_(mesh),
    now_(mesh.time().value()),
    next_(now_)
{
    for (const label patchi : patches)
    {
        patches_.push_back(patchAtRest(patchi, rest));
        patches_.back().next = poseNow(patches_.back());
    }
}


MovingPatches::Patch MovingPatches::patchAtRest(label index, const pointField& rest) const
{
    const polyPatch& patch = mesh_.boundaryMesh()[index];
    Patch result;
    result.index = index;
    result.start = pointField(rest, patch.meshPoints());
    result.nPoints = returnReduce(result.start.size(), sumOp<label>());
    result.center = meanOf(result.start, result.nPoints);
    result.startBox = boundBox(result.start, true);
    result.size = result.nPoints > 0 ? result.startBox.mag() : 0;
    result.normal = flatNormal(patch, rest, result.start, result.center, result.size);
    return result;
}


void MovingPatches::follow(scalar time)
{
    now_ = next_;
    next_ = time;
    for (Patch& patch : patches_)
    {
        patch.now = patch.next;
        patch.next = poseNow(patch);
    }
}


nscd::WallPose MovingPatches::poseNow(const Patch& patch) const
{
    const pointField& points = mesh_.boundaryMesh()[patch.index].localPoints();
    const bool hasMoved = returnReduce(points != patch.start, orOp<bool>());
    return hasMoved ? fitted(patch, points) : nscd::WallPose::Identity();
}


nscd::WallPose MovingPatches::fitted(const Patch& patch, const pointField& points) const
{
    const point center = meanOf(points, patch.nPoints);
    const nscd::WallPose pose = rigidFit(covarianceOf(patch.start, patch.center, points, center), toVec3(patch.center), toVec3(center));
    scalar worst = 0;
    forAll(points, i) worst = max(worst, (pose*toVec3(patch.start[i]) - toVec3(points[i])).norm());
    if (returnReduce(worst, maxOp<scalar>()) <= misfit*patch.size) return pose;
    if (slidesInItself(patch, points)) return nscd::WallPose::Identity();
    FatalErrorInFunction
        << "patch " << mesh_.boundaryMesh()[patch.index].name() << " of the moving mesh changes its shape from constant/polyMesh by time " << next_
        << ": grains need walls that move as rigid bodies, or flat ones whose points stay where the wall was at the start"
        << exit(FatalError);
    return pose;
}


/// As the sides of a cylinder that a piston moves in do, when they are flat: the wall is where it was.
bool MovingPatches::slidesInItself(const Patch& patch, const pointField& points) const
{
    if (patch.normal == vector(Zero) || patch.nPoints < 3) return false;
    boundBox reach(patch.startBox);
    reach.inflate(misfit);
    bool staysThere = true;
    for (const point& x : points) staysThere = staysThere && mag((x - patch.center) & patch.normal) <= misfit*patch.size && reach.contains(x);
    return returnReduce(staysThere, andOp<bool>());
}


nscd::WallPose MovingPatches::pose(std::size_t k, scalar time) const
{
    const Patch& patch = patches_[k];
    // Before the first step there is one pose, whatever the time.
    if (next_ == now_) return patch.next;
    const scalar slack = 1e-6*(next_ - now_) + SMALL*mag(next_);
    if (mag(time - next_) <= slack) return patch.next;
    if (mag(time - now_) <= slack) return patch.now;
    FatalErrorInFunction
        << "patch " << mesh_.boundaryMesh()[patch.index].name() << " of the moving mesh is asked for at time " << time << ", and is known at "
        << now_ << " and " << next_ << exit(FatalError);
    return patch.next;
}


nscd::WallMotion motionOf(std::shared_ptr<const MovingPatches> patches, std::size_t k)
{
    return [patches = std::move(patches), k](double time) { return patches->pose(k, time); };
}

} // namespace nscdCoupling
} // namespace Foam
