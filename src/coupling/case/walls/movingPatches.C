// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Fitting poses to points.
#include "coupling/case/walls/movingPatches.H"

#include "coupling/base/vectorConversion.H"

#include "Time.H"

#include <Eigen/SVD>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// How far a point may be from where its patch's pose has it, over the patch's size.
constexpr scalar misfit = 1e-6;

nscd::Vec3 centroid(const pointField& points)
{
    nscd::Vec3 sum = nscd::Vec3::Zero();
    for (const point& x : points) sum += toVec3(x);
    return sum/std::max(points.size(), label(1));
}

nscd::WallPose rigidFit(const pointField& from, const pointField& to)
{
    const nscd::Vec3 start = centroid(from), end = centroid(to);
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    forAll(from, i) covariance += (toVec3(from[i]) - start)*(toVec3(to[i]) - end).transpose();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d sides = Eigen::Matrix3d::Identity();
    sides(2, 2) = (svd.matrixV()*svd.matrixU().transpose()).determinant() < 0 ? -1 : 1;
    nscd::WallPose pose = nscd::WallPose::Identity();
    pose.linear() = svd.matrixV()*sides*svd.matrixU().transpose();
    pose.translation() = end - pose.linear()*start;
    return pose;
}

bool isFlat(const polyPatch& patch)
{
    if (patch.empty()) return true;
    const vector normal = patch.faceNormals()[0];
    const scalar size = boundBox(patch.localPoints(), false).mag();
    for (const point& x : patch.localPoints())
    {
        if (mag((x - patch.localPoints()[0]) & normal) > misfit*size) return false;
    }
    return true;
}

} // namespace


MovingPatches::MovingPatches(const polyMesh& mesh, const labelList& patches)
:
    mesh_(mesh),
    now_(mesh.time().value()),
    next_(now_)
{
    for (const label patchi : patches) patches_.push_back(patchNow(patchi));
}


MovingPatches::Patch MovingPatches::patchNow(label index) const
{
    const polyPatch& patch = mesh_.boundaryMesh()[index];
    const boundBox box(patch.localPoints(), false);
    return {index, patch.localPoints(), box, box.mag(), isFlat(patch)};
}


void MovingPatches::follow(scalar time)
{
    now_ = next_;
    next_ = time;
    for (Patch& patch : patches_)
    {
        patch.now = patch.next;
        const pointField& points = mesh_.boundaryMesh()[patch.index].localPoints();
        if (points != patch.start) patch.next = fitted(patch, points);
        else patch.next = nscd::WallPose::Identity();
    }
}


nscd::WallPose MovingPatches::fitted(const Patch& patch, const pointField& points) const
{
    const nscd::WallPose pose = rigidFit(patch.start, points);
    scalar worst = 0;
    forAll(points, i) worst = max(worst, (pose*toVec3(patch.start[i]) - toVec3(points[i])).norm());
    if (worst <= misfit*patch.size) return pose;
    if (slidesInItself(patch, points)) return nscd::WallPose::Identity();
    FatalErrorInFunction
        << "patch " << mesh_.boundaryMesh()[patch.index].name() << " of the moving mesh changes its shape by time " << next_
        << ": grains need walls that move as rigid bodies, or flat ones whose points stay where the wall was at the start"
        << exit(FatalError);
    return pose;
}


/// As the sides of a cylinder that a piston moves in do, when they are flat: the wall is where it was.
bool MovingPatches::slidesInItself(const Patch& patch, const pointField& points) const
{
    if (!patch.isFlat || points.size() < 3) return false;
    const vector normal = mesh_.boundaryMesh()[patch.index].faceNormals()[0];
    const scalar slack = misfit*patch.size;
    boundBox reach(patch.startBox);
    reach.inflate(misfit);
    forAll(points, i)
    {
        if (mag((points[i] - patch.start[0]) & normal) > slack || !reach.contains(points[i])) return false;
    }
    return true;
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
