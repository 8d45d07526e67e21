// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of the poses of patches: a mesh that turns and shifts, a side that slides in itself, a wall that bends.
#include "boxMesh.H"

#include "coupling/base/vectorConversion.H"
#include "coupling/case/walls/movingPatches.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;
using Vec3 = ::nscd::Vec3;

namespace
{

const labelList allSides = {0, 1, 2, 3, 4, 5};

void moveTo(BoxMesh& box, const pointField& start, const std::function<point(const point&)>& place)
{
    pointField points(start);
    for (point& x : points) x = place(x);
    ++box.time();
    box.mesh().movePoints(points);
}

::nscd::WallPose turnedAndShifted(scalar angle)
{
    ::nscd::WallPose pose = ::nscd::WallPose::Identity();
    pose.rotate(Eigen::AngleAxisd(angle, Vec3(1, 2, 2)/3));
    pose.pretranslate(Vec3(0.1, -0.2, 0.3)*angle);
    return pose;
}

TEST(MovingPatches, haveThePosesOfAMeshThatMovesAsOne)
{
    BoxMesh box;
    const pointField start(box.mesh().points());
    MovingPatches patches(box.mesh(), allSides, start);
    EXPECT_EQ(patches.pose(0, 17).matrix(), Eigen::Matrix4d::Identity()) << "before the first step, whatever the time";
    for (const scalar angle : {0.3, 2.0})
    {
        const ::nscd::WallPose pose = turnedAndShifted(angle);
        moveTo(box, start, [&](const point& x) { return toFoam(pose*toVec3(x)); });
        patches.follow(box.time().value());
        for (std::size_t k = 0; k < 6; ++k) EXPECT_LT((patches.pose(k, box.time().value()).matrix() - pose.matrix()).norm(), 1e-13) << k;
    }
    const scalar before = box.time().value() - box.time().deltaTValue();
    EXPECT_LT((patches.pose(3, before).matrix() - turnedAndShifted(0.3).matrix()).norm(), 1e-13);
    EXPECT_THROW(patches.pose(3, before - 1), error);
}

TEST(MovingPatches, stayWhereTheirPointsSlideInThem)
{
    BoxMesh box;
    const pointField start(box.mesh().points());
    MovingPatches patches(box.mesh(), allSides, start);
    // A piston: the upper side comes down, and the sides are pressed.
    moveTo(box, start, [](const point& x) { return point(x.x(), x.y(), 0.8*x.z()); });
    patches.follow(box.time().value());
    const scalar now = box.time().value();
    for (label patchi = 0; patchi < 6; ++patchi)
    {
        const bool isPiston = box.mesh().boundaryMesh()[patchi].faceNormals()[0].z() > 0.5;
        const Vec3 expected = isPiston ? Vec3(0, 0, -0.2) : Vec3::Zero();
        EXPECT_LT((patches.pose(std::size_t(patchi), now).translation() - expected).norm(), 1e-13) << patchi;
    }
    // Out of where it was: the sides end before the cells do.
    moveTo(box, start, [](const point& x) { return point(x.x(), x.y(), 1.2*x.z()); });
    EXPECT_THROW(patches.follow(box.time().value()), error);
}

TEST(MovingPatches, refuseAWallThatBends)
{
    BoxMesh box;
    const pointField start(box.mesh().points());
    MovingPatches patches(box.mesh(), allSides, start);
    moveTo(box, start, [](const point& x) { return point(x.x(), x.y(), x.z() + 0.05*x.x()*x.y()); });
    EXPECT_THROW(patches.follow(box.time().value()), error);
}

} // namespace
